/// Release of nodes next to a front, on a few nodes made by hand.

#include "cracks/HoldingForce.hpp"
#include "cracks/Release.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace Rhegma::cracks
{

namespace
{

/// Cells of 1 m, some nodes in a column at x = 0, all with two fields of 1 kg; a crack along x with one front
/// that has advanced, and a step of 0.5 s, in which springs of 2 N/m are stable.
template <int D>
struct Column
{
  State<D> state;
  Surroundings surroundings;
  View<double * [NodalSpring<D>::size]> rows;
  typename View<double * [NodalSpring<D>::size]>::HostMirror copy;
  NodalSprings<D> springs;

  explicit Column(const std::vector<double>& force, bool passed = true)
      : rows("springs", force.size()),
        springs{BorrowedView<double * [NodalSpring<D>::size]>(rows.data(), force.size()),
                View<int*>("front", force.size())}
  {
    const int count = static_cast<int>(force.size());
    state.clock.dt = 0.5;
    state.method.thickness = 1.0;
    state.mesh.grid.spacing = state.mesh.grid.inverse = 1.0;
    state.mesh.grid.numNodes = count;
    for (int d = 0; d < D; ++d)
    {
      state.mesh.grid.whole[d] = state.mesh.grid.origin[d] = 0.0;
      state.mesh.grid.cells[d] = d == 1 ? count : 1;
      state.mesh.grid.stride[d] = d == 1 ? 1 : count;
      state.mesh.grid.axisOrder[d] = d == 1 ? D - 1 : d == 0 ? 0 : 1;
    }
    state.mesh.nodes.reserve(count, count);
    state.mesh.nodes.numEnriched = state.mesh.nodes.numOfCracks = count;
    state.mesh.nodes.parent = View<int*>("parent", count);
    state.mesh.nodes.active = View<int*>("active", count);
    CrackSet<D>& set = state.cracks;
    set.nodeSide = View<int*>("side", count);
    set.normal = View<double* [D]>("normal", 1);
    set.spring = View<double * [D + 1]>("spring", count);
    surroundings.nearest = View<std::uint64_t*>("nearest", count);
    surroundings.stamp = 7;
    CrackFront<D> front;
    front.position[0] = 1.0;
    front.grown = true;
    set.cracks.resize(1);
    set.fronts.push_back(front);
    fill(force, passed);
  }

  /// \param force of each node on its upper field along y; the lower one has none [N]
  void fill(const std::vector<double>& force, bool passed)
  {
    const int count = static_cast<int>(force.size());
    Kokkos::View<const double*, Kokkos::HostSpace, Kokkos::MemoryUnmanaged> host(force.data(), force.size());
    const View<double*> up("force", count);
    Kokkos::deep_copy(up, host);
    const Nodes<D> nodes = state.mesh.nodes;
    const View<int*> side = state.cracks.nodeSide;
    const View<double* [D]> normal = state.cracks.normal;
    const NodalSprings<D> of = springs;
    const int front = passed ? 0 : noFront;
    Kokkos::parallel_for(
        "fill", Kokkos::RangePolicy<ExecSpace>(0, count), KOKKOS_LAMBDA(const int i) {
          nodes.parent(i) = nodes.active(i) = i;
          nodes.sums(i, Nodes<D>::massAt) = nodes.sums(count + i, Nodes<D>::massAt) = 1.0;
          nodes.sums(i, Nodes<D>::forceAt + 1) = up(i);
          side(i) = 1;
          normal(0, 1) = 1.0;
          of.front(i) = front;
          of(i).step() = 6;
        });
  }

  ReleaseBudget& budget() { return state.cracks.fronts[0].budget; }
  /// The spring of a node on the host, until the next one is requested.
  NodalSpring<D> spring(int node)
  {
    copy = onHost(rows);
    return {&copy(node, 0)};
  }
  double forceOn(int node) const
  {
    const auto sums = onHost(state.mesh.nodes.sums);
    return sums(node, Nodes<D>::forceAt + 1);
  }
};

const ToughnessAlong<2> eightJoules = [](const CrackSet<2>&, int) { return std::vector<double>{8.0}; };

} // namespace

/// 6 and 2 N on the upper fields, nothing on the lower: 3 and 1 N hold them together.
TEST(FrontSprings, TwoNodesOfAColumnDivideTheRequiredEnergy)
{
  Column<2> column({6.0, 2.0});
  column.budget().require(19.0);
  releasePassedNodes(column.state, column.surroundings, column.springs, eightJoules);
  EXPECT_EQ(column.budget().pending, 0.0);
  EXPECT_EQ(column.budget().released, 19.0);
  EXPECT_DOUBLE_EQ(column.spring(0).law().energy(), 14.25);
  EXPECT_DOUBLE_EQ(column.spring(1).law().energy(), 4.75);
  EXPECT_DOUBLE_EQ(column.spring(0).law().strength, 0.95 * 3.0);
  EXPECT_DOUBLE_EQ(column.spring(0).law().range, 10.0);
  EXPECT_EQ(column.spring(0).state(), SpringState::Releasing);
  // The forces are opposite and a twentieth less than what would hold the fields.
  EXPECT_DOUBLE_EQ(column.forceOn(0), 6.0 - 2.85);
  EXPECT_DOUBLE_EQ(column.forceOn(2), 2.85);
  EXPECT_DOUBLE_EQ(column.forceOn(1), 2.0 - 0.95);
  EXPECT_DOUBLE_EQ(column.forceOn(3), 0.95);
}

/// The opening counts from where the traction has its first value, and all of the energy is pending there.
TEST(FrontSprings, NothingIsDissipatedAtTheStart)
{
  Column<2> column({6.0});
  column.budget().require(19.0);
  releasePassedNodes(column.state, column.surroundings, column.springs, eightJoules);
  const NodalSpring<2> node = column.spring(0);
  const Vector<2> u = node.opening();
  EXPECT_DOUBLE_EQ(u[1], node.law().onset);
  EXPECT_DOUBLE_EQ(node.law().traction(u[1], node.largest()), 2.85);
  EXPECT_DOUBLE_EQ(node.pendingEnergy(u), 19.0);
}

/// A node whose faces are pushed together has no traction and is open; the energy remains pending for the
/// next one.
TEST(FrontSprings, PressedNodesGetNoEnergy)
{
  Column<2> column({-6.0});
  column.budget().require(19.0);
  releasePassedNodes(column.state, column.surroundings, column.springs, eightJoules);
  EXPECT_EQ(column.budget().pending, 19.0);
  EXPECT_EQ(column.spring(0).state(), SpringState::Open);
  EXPECT_EQ(column.forceOn(0), -6.0);
}

/// What a front does not pass stays bonded; without new faces a passed node gets the energy of a cell of the
/// last ones, 8 J.
TEST(FrontSprings, AdvectionReleasesTheEnergyOfACell)
{
  Column<2> bonded({6.0}, false), passed({6.0});
  for (Column<2>* column : {&bonded, &passed})
    releasePassedNodes(column->state, column->surroundings, column->springs, eightJoules);
  EXPECT_EQ(bonded.spring(0).state(), SpringState::Bonded);
  EXPECT_EQ(bonded.budget().released, 0.0);
  EXPECT_DOUBLE_EQ(passed.budget().advected, 8.0);
  EXPECT_DOUBLE_EQ(passed.spring(0).law().energy(), 8.0);
}

/// Of two nodes a front leaves one after it has opened half: it returns its pending energy once, a quarter of
/// its triangle.
TEST(FrontSprings, ANodeThatAFrontLeavesReturnsItsPendingEnergy)
{
  Column<3> column({6.0, 2.0}, false);
  const NodalSprings<3> springs = column.springs;
  Kokkos::parallel_for(
      "open", Kokkos::RangePolicy<ExecSpace>(0, 1), KOKKOS_LAMBDA(const int) {
        for (int n = 0; n < 2; ++n)
        {
          const NodalSpring<3> node = springs(n);
          node.release(CohesiveLaw{4.0, 3.0, 1.0}, Vector<3>{{0.0, 1.0, 0.0}});
          node.jump(1) = 1.5; // an opening of 2.5 m
          node.largest() = 2.5;
        }
        springs(1).step() = 7; // still has two fields
      });
  column.budget().require(12.0);
  column.budget().release(12.0);
  const NearestFront<3> frontOf(column.state.cracks);
  for (int twice = 0; twice < 2; ++twice)
  {
    returnPendingEnergy(column.state, column.springs, frontOf, 7);
    EXPECT_DOUBLE_EQ(column.budget().pending, 1.5);
    EXPECT_DOUBLE_EQ(column.budget().released, 10.5);
  }
  EXPECT_EQ(column.spring(0).state(), SpringState::Bonded);
  EXPECT_EQ(column.spring(1).state(), SpringState::Releasing);
}

/// 1 kg on either side and 0.5 s: 0.5 kg / dt^2, and nothing where a field has no mass.
TEST(FrontSprings, StableStiffnessIsThatOfTheReducedMass)
{
  Column<2> column({0.0, 0.0});
  const Nodes<2> nodes = column.state.mesh.nodes;
  Kokkos::parallel_for(
      "empty", Kokkos::RangePolicy<ExecSpace>(0, 1),
      KOKKOS_LAMBDA(const int) { nodes.sums(3, Nodes<2>::massAt) = 0.0; });
  const StableStiffness<2> stable(column.state);
  double first = 0.0, second = 0.0;
  Kokkos::parallel_reduce(
      "stable", Kokkos::RangePolicy<ExecSpace>(0, 1),
      KOKKOS_LAMBDA(const int, double& a, double& b) {
        a = stable(0);
        b = stable(1);
      },
      first, second);
  EXPECT_DOUBLE_EQ(first, 2.0);
  EXPECT_EQ(second, 0.0);
}

TEST(NearestFront, HasGrown)
{
  const std::vector<FrontPosition<2>> fronts{
      {{{0.0, 0.0}}, 0, false}, {{{2.0, 0.0}}, 0, true}, {{{0.5, 0.0}}, 1, true}};
  const auto nearest = [&](double x, int crack) {
    return nearestGrownFront<2>(fronts.data(), 3, {{x, 0.0}}, crack);
  };
  EXPECT_EQ(nearest(0.9, 0), noFront); // the nearest of its crack has not grown
  EXPECT_EQ(nearest(1.1, 0), 1);
  EXPECT_EQ(nearest(1.1, 1), 2);
  EXPECT_EQ(nearest(1.2, anyCrack), 2);
  EXPECT_EQ(nearest(1.3, anyCrack), 1);
}

/// Fronts of some cracks in a random order: the fronts of one crack that kernels visit are all that it has.
TEST(NearestFront, OfARandomSetIsTheSameInKernels)
{
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> at(0.0, 1.0);
  constexpr int numCracks = 5;
  CrackSet<2> set;
  set.cracks.resize(numCracks);
  NearestFront<2> frontOf;
  for (int round = 0; round < 3; ++round)
  {
    for (int k = 0; k < 4; ++k)
    {
      set.fronts.emplace_back();
      set.fronts.back().crack = std::uniform_int_distribution<int>(0, numCracks - 2)(engine);
    }
    for (CrackFront<2>& front : set.fronts)
    {
      front.position = {{at(engine), at(engine)}};
      front.grown = at(engine) < 0.7;
    }
    frontOf.update(set);
    const std::vector<FrontPosition<2>> all = frontPoints(set);
    for (int k = 0; k < 50; ++k)
      for (int crack = anyCrack; crack < numCracks; ++crack) // the last crack has no front
      {
        const Vector<2> x{{at(engine), at(engine)}};
        int found = 0;
        Kokkos::parallel_reduce(
            "test", Kokkos::RangePolicy<ExecSpace>(0, 1),
            KOKKOS_LAMBDA(const int, int& sum) { sum += frontOf(x, crack); }, found);
        EXPECT_EQ(found, nearestGrownFront(all.data(), static_cast<int>(all.size()), x, crack));
      }
  }
}

} // namespace Rhegma::cracks
