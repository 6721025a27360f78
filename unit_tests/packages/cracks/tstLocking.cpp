/// Cracked bodies of materials that hardly change their volume.

#include "src/plausibility/Warnings.hpp"

namespace Rhegma
{
namespace Test
{
namespace
{

/// A plate of 1 m by 1 m with a crack, in cells of 0.05 m: 10 for half its height.
/// \param levels of finer cells next to the front
Warnings saidOf(double poisson, const std::string& plane = "Strain", double cell = 0.05, int levels = 0)
{
  const auto scene = freePlate(cell);
  scene->sublist("Domain").set("Plane", plane);
  scene->sublist("Materials").sublist("Steel").set("Poisson Ratio", poisson);
  scene->sublist("Cracks").sublist("Notch").set("Points", Reals(std::vector<double>{-0.025, 0.5, 0.5, 0.5}));
  if (levels > 0)
    scene->sublist("Adaptivity").set("Maximum Level", levels).set("Front Cells", 2.0);
  pull(*scene, 1e5);
  return warningsOf(scene);
}

const std::string locks = "too few cells make bending too stiff";

} // namespace

/// K / G = 2 (1 + nu) / (3 (1 - 2 nu)) is 49.67 for 0.49: 0.16 of it over 10^2 is 7.9 %, 7.4 % of what is
/// larger by that.
TEST(Locking, IsSaidWithItsError)
{
  const Warnings said = saidOf(0.49);
  EXPECT_TRUE(
      say(said, "Materials > Steel: its bulk modulus is 49.67 times its shear modulus (Poisson ratio 0.49)"));
  EXPECT_TRUE(say(said, "Bodies > Plate half as thick as it, 10 cells, bend by some 7 % too little"));
  EXPECT_TRUE(say(said, "use 20 cells or more for half of the thickness"));
}

/// Cells that are fine next to the front only do not help what bends.
TEST(Locking, IsThatOfTheCellsOfMostOfTheBody)
{
  EXPECT_TRUE(
      say(saidOf(0.49, "Strain", 0.05, 2), "half as thick as it, 10 cells, bend by some 7 % too little"));
}

TEST(Locking, IsNotSaidWhereItIsSmall)
{
  EXPECT_FALSE(say(saidOf(0.3), locks));
  EXPECT_FALSE(say(saidOf(0.49, "Stress"), locks));
  EXPECT_FALSE(say(saidOf(0.49, "Strain", 0.02), locks));
}

} // namespace Test
} // namespace Rhegma
