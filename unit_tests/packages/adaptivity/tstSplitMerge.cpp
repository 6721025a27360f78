/// Conservation in splitting and merging; the losses of merging are recorded.

#include "Refined.hpp"

#include "cracks/Junctions.hpp"
#include "state/Ancestry.hpp"
#include "state/EnergySums.hpp"

namespace Rhegma
{
namespace Test
{

namespace
{

/// Sums over all particles, each over the sum of its terms' sizes so that 1e-16 is round-off.
template <int D>
struct Sums
{
  double mass = 0.0, momentum[3] = {}, spin[3] = {}, energy = 0.0;
  double sizeOfMomentum = 0.0, sizeOfSpin = 0.0;

  explicit Sums(State<D>& state)
  {
    const HostParticles<D> particles(state);
    for (int p = 0; p < particles.size; ++p)
    {
      const double m = particles.mass(p);
      double x[3] = {}, v[3] = {};
      for (int d = 0; d < D; ++d)
      {
        x[d] = particles.position(p, d);
        v[d] = particles.velocity(p, d);
      }
      mass += m;
      for (int d = 0; d < 3; ++d)
      {
        const int e = (d + 1) % 3, f = (d + 2) % 3;
        momentum[d] += m * v[d];
        spin[d] += m * (x[e] * v[f] - x[f] * v[e]);
        sizeOfMomentum += m * std::fabs(v[d]);
        sizeOfSpin += m * (std::fabs(x[e] * v[f]) + std::fabs(x[f] * v[e]));
      }
    }
    measureEnergy(state);
    energy = state.energy.kinetic + state.energy.strain;
  }
};

/// Gives every particle a velocity and a deformation of its own, of the size of a tenth.
template <int D>
void shake(State<D>& state)
{
  const HostParticles<D> particles(state);
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> some(-0.1, 0.1);
  for (int p = 0; p < particles.size; ++p)
  {
    for (int d = 0; d < D; ++d)
      particles.velocity(p, d) = some(engine);
    for (int k = 0; k < D * D; ++k)
      particles.deformation(p, k) = (k % (D + 1) == 0 ? 1.0 : 0.0) + some(engine);
  }
  particles.store(state);
}

template <int D>
void setCells(State<D>& state, int level)
{
  Branches<D> branches(state.mesh.grid);
  std::array<int, D> cell;
  for (int l = 0; l < level; ++l)
    for (int k = 0; k < (1 << l); ++k)
    {
      for (int d = 0; d < D; ++d)
        cell[d] = (gridMargin + 5) * (1 << l) + k;
      branches.refine(l, cell);
    }
  branches.balance();
  buildTree(branches, state.mesh.tree);
  state.mesh.nodes.reserve(state.mesh.grid.numNodes + state.mesh.tree.numFine, 0);
}

template <int D>
void checkSplitting()
{
  Run<D> run = refinedCube<D>("GIMP", 4.0, all<D>(-3.0), all<D>(-2.0), 2);
  State<D>& state = run.state();
  shake(state);
  const Sums<D> before(state);
  const int particles = state.particles.size();
  setCells(state, 2);
  updateCells(state);
  const Sums<D> after(state);
  ASSERT_GT(state.particles.size(), particles);
  EXPECT_NEAR(after.mass, before.mass, 1e-13 * before.mass);
  for (int d = 0; d < 3; ++d)
  {
    EXPECT_NEAR(after.momentum[d], before.momentum[d], 1e-13 * before.sizeOfMomentum);
    EXPECT_NEAR(after.spin[d], before.spin[d], 1e-13 * before.sizeOfSpin);
  }
  EXPECT_NEAR(after.energy, before.energy, 1e-13 * before.energy);
}

/// Cells are refined and made whole again; in between every particle gets a velocity of its own.
template <int D>
void checkMerging()
{
  Run<D> run = refinedCube<D>("GIMP", 4.0, all<D>(-3.0), all<D>(-2.0), 2);
  State<D>& state = run.state();
  const int particles = state.particles.size();
  setCells(state, 2);
  updateCells(state);
  shake(state);
  const Sums<D> before(state);
  setCells(state, 0);
  const adaptivity::Merged merged = updateCells(state);
  const Sums<D> after(state);
  EXPECT_EQ(state.particles.size(), particles);
  EXPECT_GT(merged.families, 0);
  EXPECT_GT(merged.lost, 0.0);
  EXPECT_NEAR(after.mass, before.mass, 1e-13 * before.mass);
  for (int d = 0; d < 3; ++d)
    EXPECT_NEAR(after.momentum[d], before.momentum[d], 1e-13 * before.sizeOfMomentum);
  EXPECT_NEAR(after.energy + merged.lost, before.energy, 1e-12 * before.energy);
}

/// Energy of particles as heat and strain [J].
template <int D>
double internalEnergy(const State<D>& state)
{
  const auto energy = state.particles.scalar(fields::internalEnergy);
  const auto volume = state.particles.scalar(fields::volume);
  double sum = 0.0;
  Kokkos::parallel_reduce(
      "internalEnergy", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, double& all) { all += volume(p) * energy(p); }, sum);
  return sum;
}

/// Every part gets a mass, a volume and a heat of its own, as if it had burnt by a fraction of its own.
template <int D>
void burnUnlike(State<D>& state)
{
  const auto energy = state.particles.scalar(fields::internalEnergy);
  const auto volume = state.particles.scalar(fields::volume), mass = state.particles.scalar(fields::mass);
  Kokkos::parallel_for(
      "burnUnlike", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()), KOKKOS_LAMBDA(const int p) {
        const double left = 0.1 + 0.9 * ((7 * p) % 11) / 11.0;
        mass(p) *= left;
        volume(p) *= left;
        energy(p) += 100.0 / left;
      });
}

} // namespace

/// Quantities per volume are weighted by it: parts that have burnt by different fractions keep their heat.
TEST(SplitMerge, mergingKeepsTheHeatOfPartsThatBurntUnlike)
{
  Teuchos::ParameterList scene = refinedScene<2>("GIMP", 4.0, all<2>(-3.0), all<2>(-2.0), 2);
  scene.sublist("Materials").sublist("Solid").set("Specific Heat", 1.0);
  scene.sublist("Materials").sublist("Solid").set("Conductivity", 0.01);
  scene.sublist("Thermal").set("Initial Temperature", 300.0);
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  State<2>& state = run.state();
  setCells(state, 1);
  updateCells(state);
  burnUnlike(state);
  const double before = internalEnergy(state);
  setCells(state, 0);
  ASSERT_GT(updateCells(state).families, 0);
  EXPECT_NEAR(internalEnergy(state), before, 1e-13 * before);
}

TEST(SplitMerge, splittingKeepsEverythingIn2D) { checkSplitting<2>(); }
TEST(SplitMerge, splittingKeepsEverythingIn3D) { checkSplitting<3>(); }
TEST(SplitMerge, mergingKeepsMassAndMomentumAndRecordsTheRestIn2D) { checkMerging<2>(); }
TEST(SplitMerge, mergingKeepsMassAndMomentumAndRecordsTheRestIn3D) { checkMerging<3>(); }

/// Split and merged a thousand times: no drift, and particles are where they were.
TEST(SplitMerge, aThousandTimesOver)
{
  Rhegma::Run<2> run = refinedCube<2>("GIMP", 4.0, all<2>(-3.0), all<2>(-2.0), 2);
  State<2>& state = run.state();
  shake(state);
  const Sums<2> before(state);
  const int particles = state.particles.size();
  for (int k = 0; k < 1000; ++k)
  {
    setCells(state, 1 + k % 3);
    updateCells(state);
    ASSERT_GT(state.particles.size(), particles);
    setCells(state, 0);
    updateCells(state);
    ASSERT_EQ(state.particles.size(), particles);
  }
  const Sums<2> after(state);
  EXPECT_NEAR(after.mass, before.mass, 1e-12 * before.mass);
  for (int d = 0; d < 3; ++d)
  {
    EXPECT_NEAR(after.momentum[d], before.momentum[d], 1e-12 * before.sizeOfMomentum);
    EXPECT_NEAR(after.spin[d], before.spin[d], 1e-12 * before.sizeOfSpin);
  }
  EXPECT_NEAR(after.energy, before.energy, 1e-11 * before.energy);
}

/// Parts on two sides of a crack that has joined another stay apart: the side of that crack is a field in
/// addition to the side of the nearest crack.
TEST(SplitMerge, keepsPartsApartThatDifferInAWholeNumber)
{
  Rhegma::Run<2> run = refinedCube<2>("GIMP", 4.0, all<2>(-3.0), all<2>(-2.0), 2);
  State<2>& state = run.state();
  state.particles.add({cracks::otherSide, 1, "", "side of a crack", true});
  const auto host = [&](const std::string& name) { return onHost(state.particles.integer(name)); };
  setCells(state, 1);
  updateCells(state);
  const auto level = host(fields::level), from = host(fields::ancestor), part = host(fields::lineage);
  const auto side = host(cracks::otherSide);
  int apart = 0, together = 0;
  for (int p = 0; p < state.particles.size(); ++p)
  {
    // A crack through the middle of every other family.
    const bool cut = from(p) % 2 == 0;
    side(p) = cut && part(p) % 2 != 0 ? -1 : 1;
    if (level(p) == 1)
      (cut ? apart : together) += 1;
  }
  ASSERT_GT(apart, 0);
  ASSERT_GT(together, 0);
  Kokkos::deep_copy(state.particles.integer(cracks::otherSide), side);
  setCells(state, 0);
  const adaptivity::Merged merged = updateCells(state);
  EXPECT_EQ(merged.families, together / 4);
  const auto levelNow = host(fields::level), fromNow = host(fields::ancestor);
  int left = 0;
  for (int p = 0; p < state.particles.size(); ++p)
    if (levelNow(p) == 1)
    {
      EXPECT_EQ(fromNow(p) % 2, 0);
      ++left;
    }
  EXPECT_EQ(left, apart);
}

/// A family whose motion would be lost stays, and is counted.
TEST(SplitMerge, keepsFamiliesThatWouldLoseTooMuch)
{
  Rhegma::Run<2> run = refinedCube<2>("GIMP", 4.0, all<2>(-3.0), all<2>(-2.0), 2);
  State<2>& state = run.state();
  setCells(state, 1);
  updateCells(state);
  shake(state);
  const int particles = state.particles.size();
  setCells(state, 0);
  const adaptivity::Merged merged = updateCells(state, 0.01);
  EXPECT_EQ(merged.families, 0);
  EXPECT_GT(merged.kept, 0);
  EXPECT_EQ(state.particles.size(), particles);
}

} // namespace Test
} // namespace Rhegma
