#include "output/CellMesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace Rhegma
{

namespace
{

/// The order of corners that VTK and XDMF have.
constexpr int corners[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                               {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};

/// A leaf: coordinates of its lowest corner in the smallest cells from node 0, slowest axis first, and level.
template <int D>
using LeafKey = std::array<int, D + 1>;

/// The leaves in which the particles lie, each once, by position.
template <int D>
std::vector<LeafKey<D>> leavesWithParticles(const State<D>& state)
{
  const TreeSight<D> sight(state.mesh.grid, state.mesh.tree);
  const auto position = state.particles.template real<D>(fields::position);
  const double perCell = std::ldexp(1.0, state.mesh.tree.deepest);
  const View<int * [D + 1]> key("rhegma::leafKeys", state.particles.size());
  Kokkos::parallel_for(
      "rhegma::findLeaves", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p) {
        Vector<D> x;
        for (int d = 0; d < D; ++d)
          x[d] = position(p, d);
        const auto leaf = sight.leafAt(x);
        for (int d = 0; d < D; ++d)
          key(p, d) = static_cast<int>(std::lround(leaf.corner[sight.grid.axisOrder[d]] * perCell));
        key(p, D) = leaf.level;
      });
  const auto host = onHost(key);
  std::vector<LeafKey<D>> leaves(host.extent(0));
  for (std::size_t p = 0; p < leaves.size(); ++p)
    for (int k = 0; k <= D; ++k)
      leaves[p][k] = host(p, k);
  std::sort(leaves.begin(), leaves.end());
  leaves.erase(std::unique(leaves.begin(), leaves.end()), leaves.end());
  return leaves;
}

} // namespace

template <int D>
OutputMesh cellMesh(const State<D>& state)
{
  constexpr int perCell = D == 2 ? 4 : 8;
  const Grid<D>& grid = state.mesh.grid;
  const std::vector<LeafKey<D>> leaves = leavesWithParticles(state);
  std::map<std::array<int, D>, int> nodes;
  std::vector<std::array<int, D>> corner; // of one leaf after another
  DataSet level{"level", DataSet::Role::OnCells, 1, true, {}, {}};
  for (const LeafKey<D>& leaf : leaves)
  {
    const int edge = 1 << (state.mesh.tree.deepest - leaf[D]);
    for (int k = 0; k < perCell; ++k)
    {
      std::array<int, D> at;
      for (int d = 0; d < D; ++d)
        at[d] = leaf[d] + corners[k][grid.axisOrder[d]] * edge;
      nodes[at] = 0;
      corner.push_back(at);
    }
    level.whole.push_back(leaf[D]);
  }
  DataSet points{"points", DataSet::Role::Points, 3, false, std::vector<double>(3 * nodes.size(), 0.0), {}};
  int next = 0;
  for (auto& node : nodes)
  {
    for (int d = 0; d < D; ++d)
    {
      const int axis = grid.axisOrder[d];
      points.real[3 * next + axis] =
          grid.origin[axis] +
          std::ldexp(static_cast<double>(node.first[d]), -state.mesh.tree.deepest) * grid.spacing;
    }
    node.second = next++;
  }
  DataSet cells{"cells", DataSet::Role::Cells, perCell, true, {}, {}};
  for (const std::array<int, D>& at : corner)
    cells.whole.push_back(nodes.at(at));

  OutputMesh mesh{"leaves", D == 2 ? "Quadrilateral" : "Hexahedron", {}};
  mesh.data.push_back(std::move(points));
  mesh.data.push_back(std::move(cells));
  mesh.data.push_back(std::move(level));
  return mesh;
}

template OutputMesh cellMesh(const State<2>&);
template OutputMesh cellMesh(const State<3>&);

} // namespace Rhegma
