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

/// Stones from anywhere around the plate, in any direction. Those that come within a cell share nodes with
/// the plate, those that stay two cells away do not; which of the others do depends on the lattice. Paths are
/// looked at in steps of half a cell, so that one that ends as it comes near may be missed.
TEST(Meetings, AreSaidWhereBodiesShareNodes)
{
  const char* const given = std::getenv("RHEGMA_SEED");
  const unsigned seed = given != nullptr ? std::strtoul(given, nullptr, 10) : std::random_device{}();
  std::cout << "seed " << seed << '\n';
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> turn(0.0, 2.0 * M_PI), part(0.0, 1.0);
  constexpr double end = 1e-2;
  int met = 0, passed = 0;
  for (int k = 0; k < 300; ++k)
  {
    const double place = turn(random), aim = place + M_PI + 0.8 * (part(random) - 0.5);
    const Reals lower = pair(0.35 + 2.4 * std::cos(place), 0.35 + 2.4 * std::sin(place));
    const double speed = 200.0 * part(random);
    const Reals velocity = pair(speed * std::cos(aim), speed * std::sin(aim));
    const bool meets = comesNear(lower, velocity, end, 0.05);
    if (meets != comesNear(lower, velocity, end, 0.2) ||
        meets != comesNear(lower, velocity, 0.95 * end, 0.05))
      continue;
    ++(meets ? met : passed);
    EXPECT_EQ(say(warningsOf(plateAndStone(lower, velocity, end)), meeting), meets)
        << lower[0] << ", " << lower[1] << " with " << velocity[0] << ", " << velocity[1] << " m/s";
  }
  EXPECT_GT(met, 0);
  EXPECT_GT(passed, 0);
}

/// From 1.525 m its first particles come into the cells next to the plate, below 1.1 m, in steps of half a
/// cell, 0.5 ms: after nine. Not in 2 ms.
TEST(Meetings, HaveTimesAndSpeed)
{
  EXPECT_TRUE(
      say(warningsOf(plateAndStone(pair(1.5, 0.3), pair(-100.0, 0.0), 0.01)),
          meeting + "100 m/s, and are less than one to two cells (100 mm) apart from about t = 4.5 ms on"));
  EXPECT_FALSE(say(warningsOf(plateAndStone(pair(1.5, 0.3), pair(-100.0, 0.0), 0.002)), meeting));
}

/// A stone in a hole of the plate, whose box lies in that of the plate; and both of one velocity.
TEST(Meetings, OfAStoneInAHole)
{
  for (const bool alone : {true, false})
  {
    const auto scene = plateAndStone(pair(0.35, 0.35), pair(-50.0, 20.0), 0.01);
    bore(*scene, pair(0.05, 0.05), pair(0.95, 0.95));
    if (!alone)
      scene->sublist("Bodies").sublist("Plate").set("Velocity", pair(-50.0, 20.0));
    EXPECT_EQ(say(warningsOf(scene), meeting + "53.85 m/s"), alone);
  }
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
