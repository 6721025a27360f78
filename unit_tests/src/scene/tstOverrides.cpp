#include "Scenes.hpp"

#include <Teuchos_Array.hpp>

using namespace Rhegma;
using namespace Rhegma::SceneTests;
using Reals = Teuchos::Array<double>;

namespace
{

void expectMistake(const std::string& text, const std::string& where, const std::vector<std::string>& pieces)
{
  expectOnly(read(goodScene(), {text}).errors, where, pieces);
}

} // namespace

TEST(SceneOverrides, ChangeAndAddParameters)
{
  const auto result =
      read(goodScene(), {"Time:Final Time=2", "Time:CFL = 0.1", "Bodies:Plate:Particles Per Cell=3",
                         "Output:Fields=false", "Domain:Plane=Stress"});
  ASSERT_TRUE(result.errors.empty()) << all(result.errors);
  EXPECT_EQ(result.list->sublist("Time").get<double>("Final Time"), 2.0);
  EXPECT_EQ(result.list->sublist("Time").get<double>("CFL"), 0.1);
  EXPECT_EQ(result.list->sublist("Bodies").sublist("Plate").get<int>("Particles Per Cell"), 3);
  EXPECT_FALSE(result.list->sublist("Output").get<bool>("Fields"));
  EXPECT_EQ(result.list->sublist("Domain").get<std::string>("Plane"), "Stress");
}

TEST(SceneOverrides, ArraysInThreeWritings)
{
  for (const std::string value : {"{1, -2}", "1,-2", " 1  -2 "})
  {
    const auto result = read(goodScene(), {"Bodies:Plate:Velocity=" + value});
    ASSERT_TRUE(result.errors.empty()) << all(result.errors);
    EXPECT_EQ(result.list->sublist("Bodies").sublist("Plate").get<Reals>("Velocity"),
              Reals(Teuchos::tuple(1.0, -2.0)));
  }
}

TEST(SceneOverrides, ValuesMayHoldColonsAndEqualSigns)
{
  const auto table = read(goodScene(), {"Boundaries:Pull:History=0:0, 1e-3:5"});
  ASSERT_TRUE(table.errors.empty()) << all(table.errors);
  EXPECT_EQ(table.list->sublist("Boundaries").sublist("Pull").get<std::string>("History"), "0:0, 1e-3:5");
  const auto expression = read(goodScene(), {"Boundaries:Pull:History=t<=1e-4 ? 1 : 0"});
  EXPECT_TRUE(expression.errors.empty()) << all(expression.errors);
}

TEST(SceneOverrides, FollowTheModelThatTheyChoose)
{
  const auto result =
      read(goodScene(), {"Materials:Steel:Model=J2 Plastic", "Materials:Steel:Yield Stress=1e8"});
  ASSERT_TRUE(result.errors.empty()) << all(result.errors);
  EXPECT_EQ(result.list->sublist("Materials").sublist("Steel").get<double>("Yield Stress"), 1e8);
}

TEST(SceneOverrides, ThatLeadNowhere)
{
  expectMistake("Tiem:Final Time=1", "Tiem", {"--set", "can't be applied", "\"Time\""});
  expectMistake("Time:Finl Time=1", "Time > Finl Time", {"can't be applied", "\"Final Time\""});
  expectMistake("Materials:Stel:Density=1", "Materials > Stel", {"can't be applied", "\"Steel\""});
  expectMistake("Materials:Steel:Hardening Modulus=1", "Materials > Steel > Hardening Modulus",
                {"can't be applied"});
  expectMistake("Time:CFL:Deeper=1", "Time > CFL", {"can't be applied"});
}

TEST(SceneOverrides, OfAParameterThatHasMoved)
{
  Section oven("Oven", "A section with a parameter that is elsewhere now.");
  oven.moved["Colour"] = "Paint > Colour";
  const SceneSchema schema = schemaOf({EffectEntry{oven, {}, {}, {}}});
  expectOnly(readSceneText(goodScene(), {"Oven:Colour=red"}, schema).errors, "Oven > Colour",
             {"--set", "\"Paint > Colour\""});
}

TEST(SceneOverrides, ThatLeadNowhereLeaveNoSectionBehind)
{
  Section strict("Strict", "Has something to give.");
  strict.real("Needed").meaning("Must be given.");
  const SceneSchema schema = schemaOf({EffectEntry{strict, {}, {}, {}}});
  expectOnly(readSceneText(goodScene(), {"Strict:Neded=1"}, schema).errors, "Strict > Neded", {"\"Needed\""});
  EXPECT_TRUE(readSceneText(goodScene(), {"Strict:Needed=1"}, schema).errors.empty());
}

TEST(SceneOverrides, OfAnotherForm)
{
  for (const std::string text : {"Time:CFL", "CFL=1", "=1", "", ":="})
  {
    const auto errors = read(goodScene(), {text}).errors;
    ASSERT_EQ(errors.size(), 1u) << text << "\n" << all(errors);
    EXPECT_NE(errors[0].message.find("--set '" + text + "'"), std::string::npos) << all(errors);
  }
}

TEST(SceneOverrides, WithAWrongValue)
{
  expectMistake("Time:CFL=fast", "Time > CFL", {"\"fast\"", "a real number"});
  expectMistake("Time:CFL=2", "Time > CFL", {"is 2", "at most 1"});
  expectMistake("Time:CFL=nan", "Time > CFL", {"not finite"});
  expectMistake("Output:Fields=maybe", "Output > Fields", {"true or false"});
  expectMistake("Time:Maximum Steps=1.5", "Time > Maximum Steps", {"a whole number"});
  expectMistake("Bodies:Plate:Velocity=1", "Bodies > Plate > Velocity", {"has 1 number;"});
}
