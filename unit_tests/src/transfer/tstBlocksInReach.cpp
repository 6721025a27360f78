// Particles and nodes in and around boxes.

#include "transfer/NearNodes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace Rhegma
{

namespace
{

/// Particles at random positions in a domain of 60 by 40 by 30 cells, in the order of blocks.
template <int D>
State<D> scattered(std::mt19937& engine)
{
  State<D> state;
  Vector<D> lower{}, upper{};
  for (int d = 0; d < D; ++d)
    upper[d] = d == 0 ? 60.0 : (d == 1 ? 40.0 : 30.0);
  state.mesh.grid = makeGrid<D>(lower, upper, 1.0);
  state.mesh.nodes.reserve(state.mesh.grid.numNodes, 0);
  state.particles.add({fields::position, D, "m", ""});
  state.particles.resize(5000);
  const auto position = state.particles.template real<D>(fields::position);
  for (int p = 0; p < state.particles.size(); ++p)
    for (int d = 0; d < D; ++d)
      position(p, d) = std::uniform_real_distribution<double>(0.0, upper[d])(engine);
  sortParticles(state.mesh.grid, state.particles, state.mesh.blocks, state.mesh.nodes.active);
  state.particles.sorted = true;
  return state;
}

template <int D>
Vector<D> positionOf(const State<D>& state, int p)
{
  const auto position = state.particles.template real<D>(fields::position);
  Vector<D> x;
  for (int d = 0; d < D; ++d)
    x[d] = position(p, d);
  return x;
}

/// Whether all particles in the box are listed, and none twice. Loops run on several threads: they count.
template <int D>
void expectAllIn(const State<D>& state, const BlocksInReach<D>& blocks, const AxisBox<D>& box)
{
  const View<int*> times("test::listed", state.particles.size());
  blocks.forEachParticle("test", [=](int p) { Kokkos::atomic_increment(&times(p)); });
  const auto listed = onHost(times);
  for (int p = 0; p < state.particles.size(); ++p)
  {
    EXPECT_LE(listed(p), 1) << p;
    EXPECT_TRUE(!box.holds(positionOf(state, p)) || listed(p) == 1) << p;
  }
}

template <int D>
class BlocksAround : public testing::Test
{
public:
  void listParticles()
  {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 engine(seed);
    State<D> state = scattered<D>(engine);
    BlocksInReach<D> blocks;
    std::uniform_real_distribution<double> reach(0.5, 8.0), shift(-0.9, 0.9);
    for (int k = 0; k < 20; ++k)
    {
      Vector<D> x = positionOf(state, std::uniform_int_distribution<int>(0, 4999)(engine));
      const double half = reach(engine);
      blocks.find(state, {boxAround(x, half)});
      expectAllIn(state, blocks, boxAround(x, half));
      EXPECT_LT(blocks.count(), state.mesh.blocks.numBlocks);
      // Particles and boxes that move a little keep the list.
      const auto position = state.particles.template real<D>(fields::position);
      for (int p = 0; p < state.particles.size(); ++p)
        position(p, 0) += 0.5 * shift(engine) / 20.0;
      x[0] += shift(engine);
      blocks.find(state, {boxAround(x, half)});
      expectAllIn(state, blocks, boxAround(x, half));
    }
    state.particles.sorted = false;
    blocks.find(state, {boxAround(Vector<D>{}, 1.0)});
    double number[1];
    blocks.sumOverParticles(
        "test", [](int, double(&sum)[1]) { sum[0] += 1.0; }, number);
    EXPECT_EQ(number[0], 5000.0);
  }

  void visitNodes()
  {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 engine(seed);
    const State<D> state = scattered<D>(engine);
    std::uniform_real_distribution<double> reach(0.5, 8.0);
    for (int k = 0; k < 10; ++k)
    {
      const Vector<D> x = positionOf(state, std::uniform_int_distribution<int>(0, 4999)(engine));
      const AxisBox<D> box = boxAround(x, reach(engine));
      const BoxNodes<D> nodes(state, box);
      const View<int*> times("test::visited", state.mesh.grid.numNodes);
      const View<double* [D]> places("test::places", state.mesh.grid.numNodes);
      forEachNodeIn("test", state, box,
                    [=](int n, const Vector<D>& at)
                    {
                      Kokkos::atomic_increment(&times(n));
                      for (int d = 0; d < D; ++d)
                        places(n, d) = at[d];
                    });
      const auto visited = onHost(times);
      const auto place = onHost(places);
      for (int n = 0; n < state.mesh.grid.numNodes; ++n)
      {
        const Vector<D> where = state.mesh.grid.nodePosition(n);
        EXPECT_LE(visited(n), 1) << n;
        if (visited(n) > 0)
        {
          EXPECT_TRUE(box.widened(1.0).holds(where)) << n;
          EXPECT_EQ(nodes.node(nodes.find(n)), n);
          for (int d = 0; d < D; ++d)
            EXPECT_EQ(place(n, d), where[d]);
        }
        EXPECT_TRUE(!box.holds(where) || visited(n) == 1) << n;
        EXPECT_TRUE(box.widened(1.0).holds(where) || nodes.find(n) == -1) << n;
      }
    }
  }

  /// Random nodes have enriched fields; the table has rows of earlier steps for others.
  void visitEnriched()
  {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 engine(seed);
    State<D> state = scattered<D>(engine);
    const int count = state.mesh.grid.numNodes, enriched = 400;
    state.mesh.nodes.reserve(count, enriched);
    state.mesh.nodes.numEnriched = state.mesh.nodes.numOfCracks = enriched;
    state.mesh.nodes.parent = View<int*>("test::parent", 2 * enriched);
    state.cracks.enrichedField = View<int*>("test::enriched", count);
    std::vector<int> numbers(count);
    for (int n = 0; n < count; ++n)
      numbers[n] = n;
    std::shuffle(numbers.begin(), numbers.end(), engine);
    for (int k = 0; k < count; ++k) // the first have fields, some had one, the others none
      state.cracks.enrichedField(numbers[k]) = k < enriched       ? count + k
                                               : k < 4 * enriched ? count + k % (2 * enriched)
                                                                  : -1;
    for (int k = 0; k < enriched; ++k)
      state.mesh.nodes.parent(k) = numbers[k];
    const Vector<D> middle = positionOf(state, 0);
    const AxisBox<D> box = boxAround(middle, 7.3);
    const View<int*> times("test::visited", count + enriched);
    forEachNodeIn("test", state, box, [=](int n, const Vector<D>&) { Kokkos::atomic_increment(&times(n)); });
    const auto visited = onHost(times);
    for (int k = 0; k < enriched; ++k)
      EXPECT_EQ(visited(count + k), box.holds(state.mesh.grid.nodePosition(numbers[k])) ? 1 : 0) << k;
  }
};

using In2D = BlocksAround<2>;
using In3D = BlocksAround<3>;

} // namespace

TEST_F(In2D, ListTheParticlesOfABox) { listParticles(); }
TEST_F(In3D, ListTheParticlesOfABox) { listParticles(); }
TEST_F(In2D, VisitTheNodesOfABox) { visitNodes(); }
TEST_F(In3D, VisitTheNodesOfABox) { visitNodes(); }
TEST_F(In2D, VisitTheEnrichedFieldsOfABox) { visitEnriched(); }
TEST_F(In3D, VisitTheEnrichedFieldsOfABox) { visitEnriched(); }

} // namespace Rhegma
