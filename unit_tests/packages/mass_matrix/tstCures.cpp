/// What keeps runs with the mass matrix stable where the boundary cuts cells.

#include "SquareScene.hpp"

#include "state/EnergySums.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma
{
namespace Test
{

namespace
{

double energyOf(State<2>& state)
{
  measureEnergy(state);
  return state.energy.kinetic + state.energy.strain;
}

/// Random velocities, bodies at odd positions and angles to the lattice. \return the mean energy of the last
/// tenth of the steps over that of the second tenth: the mean, as kinetic and strain energy are half a step
/// apart and their sum wavers. A run that stops counts as one that grew without bound.
double growth(double lumpedFraction, double smallestNode, double rotation, const char* shape, int steps)
{
  Teuchos::ParameterList scene = squareScene("MUSL", shape, rotation);
  Teuchos::ParameterList& list = scene.sublist("Mass Matrix");
  list.set("Type", "Full");
  list.set("Lumped Fraction", lumpedFraction);
  list.set("Minimum Node Mass", smallestNode);
  list.set("Maximum Iterations", 2000);
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  State<2>& state = run.state();
  shake(state, 1e-6);
  double early = 0.0, late = 0.0;
  const int tenth = steps / 10;
  try
  {
    for (int k = 0; k < steps; ++k)
    {
      run.step(1e30, false);
      if (k / tenth == 1)
        early += energyOf(state);
      else if (k / tenth == 9)
        late += energyOf(state);
    }
  }
  catch (const RunError&)
  {
    return 1e300;
  }
  return std::isfinite(late) ? late / early : 1e300;
}

} // namespace

/// The cures (Lumped Fraction, Minimum Node Mass) hold the energy where it is; what FLIP keeps in motions
/// that the nodes do not see stays too, and the rest may only fall.
TEST(MassMatrix, IsStableOnCutCells)
{
  for (const char* shape : {"Linear", "GIMP"})
    for (const double rotation : {0.0, 17.0, 45.0})
      EXPECT_LT(growth(0.1, 0.1, rotation, shape, 300), 1.01) << shape << " at " << rotation << " degrees";
}

TEST(MassMatrix, NeedsItsCures)
{
  double worst = 0.0;
  for (const double rotation : {0.0, 17.0, 45.0})
    worst = std::max(worst, growth(0.0, 0.0, rotation, "GIMP", 200));
  EXPECT_GT(worst, 10.0);
}

} // namespace Test
} // namespace Rhegma
