/// A stretched plate with an edge crack that flies through the cells.

#include "../../src/step/Bodies.hpp"
#include "state/EnergySums.hpp"

#include "state/EnergySums.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma
{
namespace Test
{

namespace
{

constexpr double cell = 0.05, pull = 1e-3; ///< [m], [Pa] with E = 1 Pa

/// A plate of 1 m by 2 m, its crack across a third of its width, both ends pulled from the start.
Teuchos::ParameterList plate(const Vector<2>& velocity, bool springs)
{
  Teuchos::ParameterList scene = emptyScene<2>({{-3.0, -3.0}}, {{4.0, 5.0}}, cell, "MUSL", "GIMP");
  addMaterial(scene, "Linear Elastic", 0.3);
  addBox<2>(scene, "Plate", {{0.0, 0.0}}, {{1.0, 2.0}}).set("Velocity", array(velocity));
  for (const double y : {0.0, 2.0})
    scene.sublist("Boundaries")
        .sublist("End at " + std::to_string(y))
        .set("Type", "Traction")
        .set("Body", "Plate")
        .set("From", array<2>({{0.0, y}}))
        .set("To", array<2>({{1.0, y}}))
        .set("Stress", array<2>({{0.0, y > 0.0 ? pull : -pull}}))
        .set("History", "t < 4 ? t / 4 : 1");
  scene.sublist("Cracks")
      .set("Front Springs", springs)
      .sublist("Edge")
      .set("Points", Teuchos::Array<double>(Teuchos::tuple(0.0, 1.013, 0.345, 1.013)));
  return scene;
}

struct Flight
{
  double residual, strain, largestSprings; ///< [J]
};

Flight fly(const Vector<2>& velocity, bool springs)
{
  Rhegma::Run<2> run(validated(plate(velocity, springs)));
  run.initialize();
  EnergyBalance& energy = run.state().energy;
  measureEnergy(run.state());
  energy.start = energy.kinetic + energy.strain;
  Flight flight{0.0, 0.0, 0.0};
  while (run.state().clock.time < 12.0)
  {
    run.step(12.0, false);
    flight.largestSprings = std::max(flight.largestSprings, energy.springs);
  }
  measureEnergy(run.state());
  flight.residual = energy.residual();
  flight.strain = energy.strain;
  return flight;
}

} // namespace

/// Through one and a half cells along the crack in both directions, and across it, with half a cell behind it
/// when all of the load is on. The energy of the springs is lost when they are disabled, at most twice where
/// a growing load stretches them again; nothing else is lost, except the half per mille that the plate
/// without springs may leave as residual.
TEST(AdvectedFronts, MakeNoEnergy)
{
  const double speed = 0.00625; // waves travel at 1 m/s
  for (const Vector<2>& direction : {Vector<2>{{1.0, 0.0}}, Vector<2>{{-1.0, 0.0}}, Vector<2>{{0.0, 1.0}}})
  {
    const Flight sprung = fly(speed * direction, true), free = fly(speed * direction, false);
    const double tolerance = std::fabs(free.residual) + 5e-4 * free.strain;
    EXPECT_GT(sprung.largestSprings, 0.0);
    EXPECT_LE(sprung.residual, tolerance);
    EXPECT_GE(sprung.residual, -2.0 * sprung.largestSprings - tolerance);
  }
}

} // namespace Test
} // namespace Rhegma
