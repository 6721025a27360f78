#include "boundary/TouchedNodes.hpp"

#include "grid/Tree.hpp"

#include <cmath>

namespace Rhegma
{

namespace
{

/// The nodes of the lattice, as if no cell were refined.
template <int D>
std::vector<Vector<D>> ofLattice(const State<D>& state)
{
  const Grid<D>& grid = state.mesh.grid;
  const auto position = onHost(state.particles.template real<D>(fields::position));
  const auto edge = onHost(state.particles.template real<D>(fields::edge));
  std::vector<Vector<D>> positions;
  std::vector<char> seen(grid.numNodes, 0);
  for (std::size_t p = 0; p < position.extent(0); ++p)
  {
    int first[D], count[D], all = 1;
    for (int d = 0; d < D; ++d)
    {
      // Functions that are averaged over the particle's box reach by half of it further.
      const double half = (grid.spacing + 0.5 * edge(p, d)) * (1.0 - 1e-9);
      first[d] = static_cast<int>(std::ceil(grid.inCells(position(p, d) - half, d)));
      count[d] = static_cast<int>(std::floor(grid.inCells(position(p, d) + half, d))) - first[d] + 1;
      all *= count[d];
    }
    for (int k = 0; k < all; ++k)
    {
      Vector<D> x;
      int rest = k, node = 0;
      for (int d = 0; d < D; ++d)
      {
        const int index = first[d] + rest % count[d];
        x[d] = grid.origin[d] + index * grid.spacing;
        node += index * grid.stride[d];
        rest /= count[d];
      }
      if (node < 0 || node >= grid.numNodes || seen[node] != 0)
        continue;
      seen[node] = 1;
      positions.push_back(x);
    }
  }
  return positions;
}

/// Marks the nodes of refined cells whose functions are not zero in some particle's box.
template <int D>
View<int*> marksOfFine(const State<D>& state)
{
  View<int*> mark("rhegma::touchedNodes", state.mesh.tree.numFine);
  const TreeSight<D> sight(state.mesh.grid, state.mesh.tree);
  const int numNodes = state.mesh.grid.numNodes;
  const bool boxes = state.method.shape == ShapeKind::Gimp;
  const auto position = state.particles.template real<D>(fields::position);
  BorrowedView<double* [D]> box;
  if (boxes)
    box = state.particles.template real<D>(fields::box);
  Kokkos::parallel_for(
      "rhegma::markTouchedNodes", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p) {
        Vector<D> x, half{};
        for (int d = 0; d < D; ++d)
        {
          x[d] = position(p, d);
          half[d] = boxes ? box(p, d) : 0.0;
        }
        sight.forEachNode(x, half,
                          [&](int node, double weight, const double*)
                          {
                            if (node >= numNodes && weight > 1e-12)
                              Kokkos::atomic_fetch_or(&mark(node - numNodes), 1);
                          });
      });
  return mark;
}

} // namespace

template <int D>
std::vector<Vector<D>> touchedNodes(const State<D>& state)
{
  std::vector<Vector<D>> positions = ofLattice(state);
  if (!state.mesh.tree.refined())
    return positions;
  const auto mark = onHost(marksOfFine(state));
  const auto fine = onHost(state.mesh.tree.finePosition);
  for (int n = 0; n < state.mesh.tree.numFine; ++n)
  {
    if (mark(n) == 0)
      continue;
    Vector<D> position;
    for (int d = 0; d < D; ++d)
      position[d] = fine(n, d);
    positions.push_back(position);
  }
  return positions;
}

template std::vector<Vector<2>> touchedNodes(const State<2>&);
template std::vector<Vector<3>> touchedNodes(const State<3>&);

} // namespace Rhegma
