/// What is said of numbers that no quantity has, and of what follows from them.

#include "Warnings.hpp"
#include "plausibility/Judges.hpp"

namespace Rhegma
{
namespace Test
{

TEST(Numbers, BeyondSenseAreNamedByTheirPath)
{
  Teuchos::ParameterList scene("Rhegma");
  scene.sublist("Domain").set("Thickness", 1e308);
  scene.sublist("Boundaries").sublist("Pull").set("Force", pair(0.0, 1e-40));
  scene.sublist("Boundaries").sublist("Hold").set("Value", pair(0.0, 1.0));
  scene.sublist("Reference").sublist("Any").set("Value", 1e300);
  const Messages said = judgeNumbers(scene);
  ASSERT_EQ(said.size(), 2u);
  EXPECT_EQ(said[0].find("Domain > Thickness is 1e+308, an implausible number"), 0u) << said[0];
  EXPECT_EQ(said[1].find("Boundaries > Pull > Force is 1e-40, an implausible number"), 0u) << said[1];
}

TEST(NonNumbers, AreNotPrinted)
{
  const Messages kept{"Domain > Thickness is 1e+308, an implausible number",
                      "Bodies > inf: the body is 1 mm thin", "Boundaries > Infinite nanny: it holds no node"};
  Messages all = kept;
  all.emplace_back("Domain > Thickness is 1e+308 m, inf times the largest body's 1 m");
  all.emplace_back("Boundaries > Pull: it strains the body by about -nan % (inf Pa)");
  all.emplace_back("Boundaries > Pull: it strains another by about inf %");
  const Messages said = withoutNonNumbers(all);
  ASSERT_EQ(said.size(), 4u);
  for (int k = 0; k < 3; ++k)
    EXPECT_EQ(said[k], kept[k]);
  EXPECT_EQ(said[3].find("Boundaries > Pull: its numbers are implausible"), 0u) << said[3];
}

TEST(FirstTen, AreFollowedByTheirNumber)
{
  EXPECT_EQ(firstTen(Messages(10, "Bodies > A: thin")).size(), 10u);
  const Messages said = firstTen(Messages(1000, "Bodies > A: thin"));
  ASSERT_EQ(said.size(), 11u);
  EXPECT_EQ(said.back(), "Bodies: 990 more warnings like the last");
}

/// No message of a scene, right up to the last, prints nan or inf.
TEST(NonNumbers, AreNotSaidOfAPlateWithSenselessNumbers)
{
  for (const double stress : {1e308, 1e200, 1e30})
  {
    const auto scene = freePlate();
    pull(*scene, stress);
    const Warnings said = warningsOf(scene);
    EXPECT_TRUE(say(said, "Boundaries > Pull > Stress is 1e+")) << stress;
    EXPECT_TRUE(say(said, "an implausible number")) << stress;
    EXPECT_EQ(withoutNonNumbers(said), said) << stress;
  }
}

TEST(Mass, ThatIsNoNumberIsRefused)
{
  const auto scene = freePlate();
  scene->sublist("Domain").set("Thickness", 1e308);
  pull(*scene, 1.0);
  const std::string said = refusal(scene);
  EXPECT_EQ(said.find("Domain > Thickness is 1e+308: the mass of the bodies is zero or not finite"), 0u)
      << said;
  EXPECT_NE(said.find("\nwarning: Domain > Thickness is 1e+308, an implausible number"), std::string::npos)
      << said;
}

/// Warnings are judged even if there is an error; each has its line.
TEST(Errors, AreFollowedByWarnings)
{
  const auto scene = freePlate();
  pull(*scene, 1.0).set("From", pair(5.0, 0.0));
  bore(*scene, pair(0.4, 0.4), pair(0.5, 0.9));
  const std::string said = refusal(scene);
  EXPECT_EQ(said.find("Boundaries > Pull"), 0u) << said;
  EXPECT_NE(said.find("\nwarning: Bodies > Plate > Operations > Bore: the hole is 100 mm thin"),
            std::string::npos)
      << said;
}

} // namespace Test
} // namespace Rhegma
