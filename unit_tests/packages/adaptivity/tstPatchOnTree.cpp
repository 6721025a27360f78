/// Patch tests on refined cells: the same stress everywhere gives no force on nodes inside the body, at rest
/// and after the body has drifted through the cells while its particles split and merge.

#include "Refined.hpp"

namespace Rhegma
{
namespace Test
{

namespace
{

constexpr double side = 6.0; // of the body, in cells of the lattice of 1 m
constexpr int drifts = 40;

/// The largest internal force on a node that is a cell of the lattice and more inside of the body, over the
/// largest stress (1 Pa) times a cell's face (1 m2).
template <int D>
double residual(State<D>& state, const Vector<D>& lower)
{
  clearNodes(state);
  scatter(state, ScatterWhat::Force);
  const auto sums = onHost(state.mesh.nodes.sums);
  const auto active = onHost(state.mesh.nodes.active);
  const NodePositions<D> positions = nodePositions(state);
  double largest = 0.0;
  int inside = 0, fine = 0;
  for (int i = 0; i < static_cast<int>(active.extent(0)); ++i)
  {
    const Vector<D> x = positions(active(i));
    bool in = true;
    for (int d = 0; d < D; ++d)
      in = in && x[d] - 1.0 >= lower[d] - 1e-9 && x[d] + 1.0 <= lower[d] + side + 1e-9;
    if (!in)
      continue;
    ++inside;
    fine += active(i) >= state.mesh.grid.numNodes ? 1 : 0;
    for (int d = 0; d < D; ++d)
      largest = std::max(largest, std::abs(sums(active(i), Nodes<D>::forceAt + d)));
  }
  EXPECT_GE(inside, D == 2 ? 16 : 64);
  EXPECT_GT(fine, 0);
  return largest;
}

template <int D>
void checkPatch(int level)
{
  Vector<D> lower = all<D>(2.0), upper = all<D>(4.0);
  upper[0] = 5.0;
  Run<D> run = refinedCube<D>("GIMP", side, lower, upper, level);
  State<D>& state = run.state();
  updateCells(state);
  setUniformStress(state);
  double worst = residual(state, all<D>(0.0));
  std::mt19937 engine(11);
  std::uniform_real_distribution<double> anywhere(-0.35, 0.35);
  Vector<D> corner = all<D>(0.0);
  int most = 0, least = state.particles.size();
  long merged = 0;
  for (int k = 0; k < drifts; ++k)
  {
    Vector<D> shift;
    for (int d = 0; d < D; ++d)
      shift[d] = anywhere(engine) + (corner[d] > 2.0 ? -0.5 : corner[d] < -2.0 ? 0.5 : 0.15);
    corner = corner + shift;
    moveBody(state, shift);
    merged += updateCells(state).families;
    most = std::max(most, state.particles.size());
    least = std::min(least, state.particles.size());
    worst = std::max(worst, residual(state, corner));
  }
  EXPECT_GT(merged, 100);
  EXPECT_GT(most, least);
  EXPECT_LT(worst, 1e-12);
}

} // namespace

TEST(PatchOnTree, noForceInsideIn2DOneLevel) { checkPatch<2>(1); }
TEST(PatchOnTree, noForceInsideIn2DTwoLevels) { checkPatch<2>(2); }
TEST(PatchOnTree, noForceInsideIn2DThreeLevels) { checkPatch<2>(3); }
TEST(PatchOnTree, noForceInsideIn3DOneLevel) { checkPatch<3>(1); }
TEST(PatchOnTree, noForceInsideIn3DTwoLevels) { checkPatch<3>(2); }

} // namespace Test
} // namespace Rhegma
