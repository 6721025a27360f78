/// Where cracks run and how fast, whatever their angle to the cells.

#include "Pi.hpp"
#include "Simulation.hpp"
#include "packages/energy_release/InclinedPlate.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace Rhegma;
using namespace Rhegma::Test;

namespace
{

using Rhegma::Test::pi;
constexpr double halfLength = 5e-3, load = 1e6, cell = halfLength / 8.0, rest = 1.5e-4, end = 1.7e-4;

/// A square of 12 half lengths of the crack whose rim is moved so and held; damped until it is at rest, then
/// free to run.
Teuchos::RCP<Teuchos::ParameterList> plate(double angle, double turn, const std::string& toughness)
{
  const InclinedCrack crack =
      pulled({1200.0, 3e9, 0.33}, halfLength, load, angle, turn, 0.3 * cell, 0.2 * cell);
  const auto scene = Teuchos::rcp(new Teuchos::ParameterList(inclinedPlate(crack, 6.0 * halfLength, cell)));
  scene->sublist("Time").set("Final Time", end);
  scene->sublist("Time").set("CFL", 0.6);
  scene->sublist("Propagation").set("Toughness", toughness);
  scene->sublist("Propagation").set("Start Time", rest);
  scene->sublist("Damping").set("End Time", rest);
  return scene;
}

nlohmann::json run(double angle, double turn, const std::string& toughness)
{
  Simulation simulation(Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD)),
                        plate(angle, turn, toughness));
  simulation.initialize();
  simulation.sampleEvery(1e-6, {});
  simulation.advance(end);
  return simulation.report();
}

} // namespace

/// Asked for: straight within 2 degrees, speeds within 5 % of each other, whatever the angle to the cells.
TEST(Paths, OfOpeningCracksAreStraightAndAsFastAtEveryAngle)
{
  double slowest = 1e300, fastest = 0.0;
  for (const double degrees : {0.0, 15.0, 30.0, 45.0})
  {
    const nlohmann::json report = run(degrees * pi / 180.0, 0.0, "2.6*(1 + v/600)");
    double speed = 0.0;
    for (const auto& front : report["cracks"][0]["fronts"])
    {
      const double turn = front["turn"].get<double>();
      const int increments = front["increments"].get<int>();
      EXPECT_GE(increments, 12) << degrees;
      EXPECT_LT(std::fabs(turn), 2.0) << degrees;
      const double time = front["last_advance"].get<double>() - front["initiated"].get<double>();
      speed += 0.5 * (increments - 1) * cell / time;
      std::cout << degrees << " degrees to the cells: " << increments << " cells, off by " << turn
                << " degrees, " << (increments - 1) * cell / time << " m/s\n";
    }
    EXPECT_NEAR(report["propagation"]["dissipated_fraction"].get<double>(), 1.0, 0.02) << degrees;
    slowest = std::min(slowest, speed);
    fastest = std::max(fastest, speed);
  }
  std::cout << "speeds within " << 100.0 * (fastest / slowest - 1.0) << " %\n";
  EXPECT_LT(fastest / slowest, 1.05);
}

/// A crack pulled at an angle turns into the direction of the largest hoop stress; asked for: within 4
/// degrees.
TEST(Paths, OfInclinedCracksBeginAtTheKinkOfTheClosedForm)
{
  for (const double degrees : {45.0, 30.0})
  {
    const double angle = degrees * pi / 180.0, ratio = 1.0 / std::tan(angle);
    const double kink = 360.0 / pi * std::atan(0.25 * (ratio - std::sqrt(ratio * ratio + 8.0)));
    const nlohmann::json report = run(angle, -angle, "2*(1 + v/600)");
    for (const auto& front : report["cracks"][0]["fronts"])
    {
      std::cout << degrees << " degrees: kinks by " << front["first_turn"] << ", closed form " << kink
                << "\n";
      EXPECT_GE(front["increments"].get<int>(), 12);
      EXPECT_NEAR(front["first_turn"].get<double>(), kink, 4.0) << degrees;
    }
    EXPECT_NEAR(report["propagation"]["dissipated_fraction"].get<double>(), 1.0, 0.02) << degrees;
  }
}
