/// Refinement that could make a run fail: many levels, corners and boundaries of bodies, two fronts close
/// together, cells that come and go with every step.

#include "Refined.hpp"
#include "state/EnergySums.hpp"

#include <cmath>
#include <cstdio>

namespace Rhegma
{
namespace Test
{

namespace
{

/// A block of 4 cells of 1 m that flies and vibrates.
template <int D>
Teuchos::ParameterList flyingBlock(double speed)
{
  Teuchos::ParameterList scene = emptyScene<D>(all<D>(-3.0), all<D>(9.0), 1.0, "MUSL", "GIMP");
  addMaterial(scene, "Neo-Hookean", 0.3);
  Teuchos::ParameterList& body = addBox<D>(scene, "Block", all<D>(0.0), all<D>(4.0));
  Vector<D> velocity = all<D>(speed);
  velocity[0] = -0.5 * speed;
  body.set("Velocity", array(velocity));
  return scene;
}

template <int D>
void addRegion(Teuchos::ParameterList& scene, const Vector<D>& lower, const Vector<D>& upper, int level)
{
  Teuchos::ParameterList& adaptivity = scene.sublist("Adaptivity");
  adaptivity.set("Maximum Level", level);
  adaptivity.set("Interval", 2);
  Teuchos::ParameterList& box = adaptivity.sublist("Box");
  box.set("Lower Corner", array(lower));
  box.set("Upper Corner", array(upper));
  box.set("Level", level);
}

/// Adds a smooth motion of its own, of 1 cm/s and waves of 8 m. \return its energy, as a fraction of all
template <int D>
double stir(State<D>& state)
{
  measureEnergy(state);
  const double before = state.energy.kinetic;
  const HostParticles<D> particles(state);
  for (int p = 0; p < particles.size; ++p)
    for (int d = 0; d < D; ++d)
      particles.velocity(p, d) +=
          0.01 * std::cos(0.25 * 3.14159265358979 * particles.position(p, (d + 1) % D));
  particles.store(state);
  measureEnergy(state);
  return (state.energy.kinetic - before) / state.energy.kinetic;
}

/// Fraction by which the energy of that motion oscillates: kinetic and strain energy belong to times half a
/// step apart, and no wave is faster than a dilatational one. \param dt longest step
double wavering(double dt)
{
  const double wave = std::sqrt(0.7 / (1.3 * 0.4)), frequency = 0.25 * 3.14159265358979 * wave;
  return 0.5 * frequency * dt;
}

struct Changes
{
  double energy = 0.0, momentum = 0.0; ///< largest changes, as fractions
  double dt = 0.0;                     ///< longest step [s]
  int fewest = 0, most = 0;
};

/// Runs some steps. \return the changes of energy (with that lost by merging) and of momentum
template <int D, class Between>
Changes largestChanges(Run<D>& run, int steps, const Between& between)
{
  State<D>& state = run.state();
  measureEnergy(state);
  const double energy = state.energy.kinetic + state.energy.strain;
  const Vector<D> momentum = state.sample.momentum;
  Changes changes;
  changes.fewest = changes.most = state.particles.size();
  double merged = 0.0;
  for (int k = 0; k < steps; ++k)
  {
    merged += between(k);
    run.step(1e30, false);
    measureEnergy(state);
    const double now =
        state.energy.kinetic + state.energy.strain + state.energy.merged + merged - state.energy.externalWork;
    changes.dt = std::max(changes.dt, state.clock.dt);
    changes.energy = std::max(changes.energy, std::fabs(now / energy - 1.0));
    changes.momentum = std::max(changes.momentum, norm(state.sample.momentum - momentum) / norm(momentum));
    changes.fewest = std::min(changes.fewest, state.particles.size());
    changes.most = std::max(changes.most, state.particles.size());
  }
  EXPECT_TRUE(std::isfinite(changes.energy));
  return changes;
}

const auto nothing = [](int) { return 0.0; };

/// A corner of the body lies in a refined corner of the cells, and leaves it.
template <int D>
void checkCorner(int level, int steps)
{
  Teuchos::ParameterList scene = flyingBlock<D>(0.3);
  const double edge = std::ldexp(1.0, 1 - level);
  addRegion(scene, all<D>(4.0 - edge), all<D>(4.0 + edge), level);
  Run<D> run(validated(scene));
  run.initialize();
  EXPECT_EQ(run.state().mesh.tree.deepest, level);
  const int before = run.state().particles.size();
  const double stirred = stir(run.state());
  const Changes changes = largestChanges(run, steps, nothing);
  std::printf(
      "%d levels at a corner in %dD: %d particles, %d to %d; energy by %.1e of %.1e, momentum by %.1e\n",
      level, D, before, changes.fewest, changes.most, changes.energy, stirred * wavering(changes.dt),
      changes.momentum);
  EXPECT_LT(changes.energy, stirred * wavering(changes.dt));
  EXPECT_LT(changes.momentum, 1e-12);
}

} // namespace

TEST(Robust, sixLevelsAtACornerIn2D) { checkCorner<2>(6, 300); }
TEST(Robust, fourLevelsAtACornerIn3D) { checkCorner<3>(4, 40); }

/// The block slides along a wall, in part refined, and vibrates. The wall stops what its nodes, half a cell
/// of the block's four, do towards it, and the energy oscillates.
TEST(Robust, refinedAtABoundary)
{
  Teuchos::ParameterList scene = flyingBlock<2>(-0.2);
  scene.sublist("Bodies").sublist("Block").set("Velocity", array(Vector<2>{{0.1, 0.0}}));
  addRegion<2>(scene, Vector<2>{{1.0, -3.0}}, Vector<2>{{2.5, 0.5}}, 3);
  Teuchos::ParameterList& wall = scene.sublist("Boundaries").sublist("Wall");
  wall.set("Type", "Symmetry");
  wall.set("Axis", "y");
  wall.set("Position", 0.0);
  wall.set("Side", "Lower");
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  State<2>& state = run.state();
  const double stirred = stir(state);
  const double energy = state.energy.kinetic + state.energy.strain, along = state.sample.momentum[0];
  double off = 0.0, drift = 0.0, lowest = 1.0, dt = 0.0;
  int most = 0, fewest = state.particles.size();
  while (state.clock.time < 15.0)
  {
    run.step(1e30, false);
    measureEnergy(state);
    dt = std::max(dt, state.clock.dt);
    const double now = state.energy.kinetic + state.energy.strain + state.energy.merged;
    off = std::max(off, std::fabs((now - state.energy.externalWork) / energy - 1.0));
    drift = std::max(drift, std::fabs(state.sample.momentum[0] / along - 1.0));
    const HostParticles<2> particles(state);
    for (int p = 0; p < particles.size; ++p)
      lowest = std::min(lowest, particles.position(p, 1));
    most = std::max(most, particles.size);
    fewest = std::min(fewest, particles.size);
  }
  std::printf(
      "at a wall: energy by %.1e, momentum along it by %.1e, lowest particle at %.4f m, %d to %d particles\n",
      off, drift, lowest, fewest, most);
  EXPECT_GT(most, fewest);
  EXPECT_LT(off, stirred * (wavering(dt) + 0.5 / 4.0));
  EXPECT_LT(drift, 1e-12);
  EXPECT_GT(lowest, 0.0);
}

/// Two cracks in line whose fronts are as close as cracks may be, 3 coarse cells, and a little more: what is
/// refined around them overlaps. Energies are known to half a step, and so to half of what loads give in one.
TEST(Robust, aroundTwoFrontsCloseTogether)
{
  for (const double apart : {3.05, 3.6})
  {
    Teuchos::ParameterList scene =
        emptyScene<2>(Vector<2>{{-2.0, -2.0}}, Vector<2>{{12.0, 10.0}}, 1.0, "MUSL", "GIMP");
    addMaterial(scene, "Linear Elastic", 0.3);
    addBox<2>(scene, "Plate", Vector<2>{{0.0, 0.0}}, Vector<2>{{10.0, 8.0}});
    scene.sublist("Adaptivity").set("Maximum Level", 3);
    for (const int end : {0, 1})
    {
      const double from = end == 0 ? -1.0 : 5.0 + 0.5 * apart, to = end == 0 ? 5.0 - 0.5 * apart : 11.0;
      scene.sublist("Cracks")
          .sublist("Crack " + std::to_string(end))
          .set("Points", Teuchos::Array<double>(Teuchos::tuple(from, 4.0, to, 4.0)));
      Teuchos::ParameterList& load = scene.sublist("Boundaries").sublist("Load " + std::to_string(end));
      load.set("Type", "Traction");
      load.set("Body", "Plate");
      load.set("From", array(Vector<2>{{0.0, 8.0 * end}}));
      load.set("To", array(Vector<2>{{10.0, 8.0 * end}}));
      load.set("Stress", array(Vector<2>{{0.0, end == 0 ? -1e-4 : 1e-4}}));
    }
    Rhegma::Run<2> run(validated(scene));
    run.initialize();
    State<2>& state = run.state();
    EXPECT_EQ(state.mesh.tree.deepest, 3);
    double most = 0.0; // work in a step
    for (int k = 0; k < 400; ++k)
    {
      const double before = state.energy.externalWork;
      run.step(1e30, false);
      most = std::max(most, std::fabs(state.energy.externalWork - before));
    }
    measureEnergy(state);
    const double energy = state.energy.kinetic + state.energy.strain;
    std::printf("fronts %.2f m apart: energy %.4e J, %.4e J from loads, no more than %.1e J in a step\n",
                apart, energy, state.energy.externalWork, most);
    EXPECT_GT(energy, 0.0);
    EXPECT_NEAR(energy, state.energy.externalWork, 0.5 * most);
  }
}

namespace
{

/// Cells are refined in one step and coarsened in the next, at a corner of the body and inside it in turn.
Changes toggled(bool on)
{
  Teuchos::ParameterList scene = flyingBlock<2>(0.02);
  addRegion<2>(scene, all<2>(8.0), all<2>(8.5), 2);
  scene.sublist("Adaptivity").set("Interval", 1000000);
  Run<2> run(validated(scene));
  run.initialize();
  State<2>& state = run.state();
  stir(state);
  const auto toggle = [&](int k)
  {
    Branches<2> branches(state.mesh.grid);
    const int at = gridMargin + 3 + (k % 4 < 2 ? 0 : 2); // the cell at the corner (0, 0), or at (2, 2)
    if (on && k % 2 == 0)
      for (int x = 0; x < 2; ++x)
        for (int y = 0; y < 2; ++y)
          branches.refine(1, {2 * at + x, 2 * at + y});
    branches.balance();
    buildTree(branches, state.mesh.tree);
    state.mesh.nodes.reserve(state.mesh.grid.numNodes + state.mesh.tree.numFine,
                             state.mesh.nodes.numEnriched);
    state.particles.sorted = false;
    return updateCells(state).lost;
  };
  const Changes changes = largestChanges(run, 400, toggle);
  std::printf("%s: %d to %d particles; energy by %.1e, momentum by %.1e\n", on ? "on and off" : "off",
              changes.fewest, changes.most, changes.energy, changes.momentum);
  return changes;
}

} // namespace

/// Energy swings with the length of the steps, of which every second one is shorter where cells come and go:
/// less than in coarse cells that stay.
TEST(Robust, onAndOffEveryStep)
{
  const Changes plain = toggled(false), changes = toggled(true);
  EXPECT_EQ(plain.most, plain.fewest);
  EXPECT_EQ(changes.fewest, plain.fewest);
  EXPECT_GT(changes.most, plain.most);
  EXPECT_LT(changes.momentum, 1e-12);
  EXPECT_LT(changes.energy, plain.energy);
}

/// Refined, coarsened, and refined again in the same positions: the numbers of nodes are those of before.
TEST(Robust, numbersOfNodesDoNotDependOnTheRun)
{
  Teuchos::ParameterList scene = flyingBlock<2>(0.0);
  addRegion<2>(scene, all<2>(1.0), all<2>(3.0), 2);
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  State<2>& state = run.state();
  const auto copy = [](const auto& view)
  {
    const auto host = Kokkos::create_mirror(view);
    Kokkos::deep_copy(host, view);
    return host;
  };
  const auto before = copy(state.mesh.tree.finePosition);
  const auto master = copy(state.mesh.tree.master);
  Branches<2> branches(state.mesh.grid);
  for (const int k : {7, 2, 5})
    branches.refine(0, {k, k});
  branches.balance();
  buildTree(branches, state.mesh.tree);
  Branches<2> again(state.mesh.grid);     // in another order
  const int first = 2 * (gridMargin + 4); // of level 1 in the box
  for (int x = first + 3; x >= first; --x)
    for (int y = first; y < first + 4; ++y)
      again.refine(1, {x, y});
  again.balance();
  buildTree(again, state.mesh.tree);
  ASSERT_EQ(state.mesh.tree.finePosition.extent(0), before.extent(0));
  ASSERT_EQ(state.mesh.tree.master.extent(0), master.extent(0));
  for (std::size_t n = 0; n < before.extent(0); ++n)
    for (int d = 0; d < 2; ++d)
      EXPECT_EQ(state.mesh.tree.finePosition(n, d), before(n, d));
  for (std::size_t l = 0; l < master.extent(0); ++l)
    for (int k = 0; k < 4; ++k)
      for (int m = 0; m < 2; ++m)
        EXPECT_EQ(state.mesh.tree.master(l, k, m), master(l, k, m));
}

} // namespace Test
} // namespace Rhegma
