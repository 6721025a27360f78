/// Bodies that meet during a run.

#include "Warnings.hpp"

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <random>

namespace Rhegma
{
namespace Test
{

namespace
{

const std::string meeting = "Bodies > Stone: it and Bodies > Plate approach each other at ";

/// The plate, and a small one somewhere around it. \param lower its lower corner [m] \param velocity [m/s]
Teuchos::RCP<Teuchos::ParameterList> plateAndStone(const Reals& lower, const Reals& velocity, double end)
{
  const auto scene = steelPlate(-4.0, 5.0, 0.1, pair(0.0, 0.0), pair(1.0, 1.0));
  Teuchos::ParameterList& stone = scene->sublist("Bodies").sublist("Stone");
  stone.set<std::string>("Material", "Steel");
  stone.set<std::string>("Shape", "Box");
  stone.set("Lower Corner", lower);
  stone.set("Upper Corner", pair(lower[0] + 0.3, lower[1] + 0.3));
  stone.set("Velocity", velocity);
  scene->sublist("Time").set("Final Time", end);
  return scene;
}

/// Whether the stone comes within a distance of the plate, by its positions at many times.
bool comesNear(const Reals& lower, const Reals& velocity, double end, double distance)
{
  constexpr int times = 20000;
  for (int k = 0; k <= times; ++k)
  {
    bool near = true;
    for (int d = 0; d < 2; ++d)
    {
      const double x = lower[d] + velocity[d] * end * k / times;
      near = near && x < 1.0 + distance && x + 0.3 > -distance;
    }
    if (near)
      return true;
  }
  return false;
}

} // namespace

/// Stones from anywhere around the plate, in any direction; those that pass it within a tenth of a cell more
/// or less than a cell are left out.
TEST(Meetings, AreSaidWhereBodiesComeWithinTwoCells)
{
  const char* const given = std::getenv("RHEGMA_SEED");
  const unsigned seed = given != nullptr ? std::strtoul(given, nullptr, 10) : std::random_device{}();
  std::cout << "seed " << seed << '\n';
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> turn(0.0, 2.0 * M_PI), part(0.0, 1.0);
  constexpr double end = 1e-2;
  int met = 0, passed = 0;
  for (int k = 0; k < 24; ++k)
  {
    const double place = turn(random), aim = place + M_PI + 0.8 * (part(random) - 0.5);
    const Reals lower = pair(0.35 + 2.4 * std::cos(place), 0.35 + 2.4 * std::sin(place));
    const double speed = 200.0 * part(random);
    const Reals velocity = pair(speed * std::cos(aim), speed * std::sin(aim));
    if (comesNear(lower, velocity, end, 0.19) != comesNear(lower, velocity, end, 0.21))
      continue;
    const bool meets = comesNear(lower, velocity, end, 0.2);
    ++(meets ? met : passed);
    EXPECT_EQ(say(warningsOf(plateAndStone(lower, velocity, end)), meeting), meets)
        << lower[0] << ", " << lower[1] << " with " << velocity[0] << ", " << velocity[1] << " m/s";
  }
  EXPECT_GT(met, 0);
  EXPECT_GT(passed, 0);
}

TEST(Meetings, HaveTimesAndSpeed)
{
  const auto scene = plateAndStone(pair(1.5, 0.3), pair(-100.0, 0.0), 0.01);
  EXPECT_TRUE(say(warningsOf(scene),
                  meeting +
                      "100 m/s and meet at about t = 5 ms. Bodies have no contact law: once they are less "
                      "than one to two cells (100 mm) apart, from about t = 3 ms on, they share"));
  const auto shorter = plateAndStone(pair(1.5, 0.3), pair(-100.0, 0.0), 0.0045);
  EXPECT_TRUE(say(warningsOf(shorter), meeting + "100 m/s. Bodies have no contact law"));
}

TEST(Meetings, OfBondedBodiesAreMeant)
{
  const auto scene = plateAndStone(pair(1.5, 0.3), pair(-100.0, 0.0), 0.01);
  scene->sublist("Bodies").sublist("Stone").set<std::string>("Bonded To", "Plate");
  EXPECT_FALSE(say(warningsOf(scene), meeting));
}

/// A roller that a support moves as a whole, and one that it holds; a grip that moves an end of a body does
/// not move the body.
TEST(Meetings, OfBodiesThatSupportsMove)
{
  for (const bool all : {true, false})
  {
    const auto scene = plateAndStone(pair(1.5, 0.3), pair(0.0, 0.0), 0.01);
    hold(*scene, "Roller", pair(1.45, 0.25), pair(all ? 1.85 : 1.6, 0.65), pair(-100.0, 0.0));
    EXPECT_EQ(say(warningsOf(scene), meeting + "100 m/s"), all);
  }
  const auto held = plateAndStone(pair(1.5, 0.3), pair(-100.0, 0.0), 0.01);
  hold(*held, "Roller", pair(1.45, 0.25), pair(1.85, 0.65));
  EXPECT_FALSE(say(warningsOf(held), meeting));
}

} // namespace Test
} // namespace Rhegma
