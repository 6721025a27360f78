/// Stress intensities of inclined cracks at random positions in their cells, against the closed form.

#include "Pi.hpp"
#include "Simulation.hpp"
#include "packages/energy_release/InclinedPlate.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <iomanip>
#include <random>

using namespace Rhegma;
using namespace Rhegma::Test;

namespace
{

using Rhegma::Test::pi;
constexpr double halfLength = 5e-3, load = 1e6, cell = halfLength / 8.0;
const ElasticSolid solid{1200.0, 3e9, 0.33};

/// A square of 6 half lengths whose boundary has that displacement; 8 cells a half length.
Teuchos::RCP<Teuchos::ParameterList> plate(const InclinedCrack& crack)
{
  const auto scene = Teuchos::rcp(new Teuchos::ParameterList(inclinedPlate(crack, 3.0 * halfLength, cell)));
  scene->sublist("Time").set("Final Time", 1e-3);
  scene->sublist("Time").set("CFL", 0.8);
  Teuchos::ParameterList& damping = scene->sublist("Damping");
  damping.set("Stop When Settled", true);
  damping.set("Settled Drift", 1e-5);
  return scene;
}

struct Errors
{
  std::vector<double> values;
  double mean() const
  {
    double sum = 0.0;
    for (const double v : values)
      sum += v;
    return sum / values.size();
  }
  double rms() const
  {
    double sum = 0.0;
    for (const double v : values)
      sum += v * v;
    return std::sqrt(sum / values.size());
  }
  double largest() const
  {
    double most = 0.0;
    for (const double v : values)
      most = std::max(most, std::fabs(v));
    return most;
  }
  void print(const std::string& name, const std::string& unit) const
  {
    std::cout << std::fixed << std::setprecision(2) << name << ": mean " << mean() << " " << unit << ", rms "
              << rms() << ", largest " << largest() << " of " << values.size() << " tips\n";
  }
};

} // namespace

/// Requirement for every tip: K within 1 %, the direction of the largest hoop stress within 0.5 degrees, at 8
/// cells a half length. Without springs behind the fronts (Cracks > Front Springs) the crack of the cells is
/// longer or shorter by up to half a cell an end, and 1.2 % and 1.3 degrees are reached.
TEST(InclinedCracks, MeetTheClosedForm)
{
  std::mt19937 random(20);
  std::uniform_real_distribution<double> angle(0.0, pi), turn(-pi / 3.0, pi / 3.0), shift(-0.5, 0.5);
  Errors intensity, direction, release, length;
  for (int k = 0; k < 16; ++k)
  {
    const double a = angle(random), b = turn(random);
    const double x = cell * shift(random), y = cell * shift(random);
    const InclinedCrack crack = pulled(solid, halfLength, load, a, b, x, y);
    Simulation simulation(Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD)), plate(crack));
    simulation.initialize();
    simulation.sampleEvery(1e-5, {});
    simulation.advance(1e-3);
    EXPECT_TRUE(simulation.settled());
    const double K = std::hypot(crack.modeI(), crack.modeII());
    const double ratio = crack.modeI() / crack.modeII();
    const double kink =
        360.0 / pi *
        std::atan(0.25 * (ratio - std::copysign(std::sqrt(ratio * ratio + 8.0), crack.modeII())));
    const nlohmann::json report = simulation.report();
    ASSERT_EQ(report["cracks"][0]["fronts"].size(), 2u);
    for (const auto& front : report["cracks"][0]["fronts"])
    {
      const double found = std::hypot(front["K_I"].get<double>(), front["K_II"].get<double>());
      intensity.values.push_back(100.0 * (found / K - 1.0));
      direction.values.push_back(front["kink_angle"].get<double>() - kink);
      length.values.push_back(front["tip_offset"].get<double>() / cell);
      release.values.push_back(100.0 * (found / std::sqrt(solid.young * front["G_J"].get<double>()) - 1.0));
    }
  }
  intensity.print("K against the closed form", "%");
  release.print("K against the root of E' J", "%");
  direction.print("kink against the closed form", "degrees");
  length.print("tip of the cells ahead of the front", "cells");
  EXPECT_LT(intensity.largest(), 1.0);
  EXPECT_LT(direction.largest(), 0.5);
  // The quadrature of both: (cell / inner)^2 / 24 of the singular products, twice for the square.
  EXPECT_LT(release.largest(), 1.0);
}
