#include "sub_cycling/NearParticles.hpp"

#include "grid/BlockCells.hpp"
#include "state/Subdomain.hpp"

#include <algorithm>

namespace Rhegma::sub_cycling
{

namespace
{

using Range = Kokkos::RangePolicy<ExecSpace>;

/// Distance from refined cells, in lattice cells, within which all particles lie that `select` may need: a
/// particle on a node of a cell next to a refined one, one that shares a node with it, and one that shares a
/// node with that; each reaches through two cells at most.
constexpr int farthest = 7;

/// Whether a cell next to a refined one is no farther than that along the axes up to `axis`, given the same
/// for those before it.
template <int D>
View<char*> widen(const Grid<D>& grid, const View<char*>& given, int axis)
{
  View<char*> wide("rhegma::subcycling::nearRefined", grid.numNodes);
  Kokkos::parallel_for(
      "rhegma::subcycling::widen", Range(0, grid.numNodes), KOKKOS_LAMBDA(const int n) {
        int at[D];
        grid.nodeCoordinates(n, at);
        for (int k = -farthest; k <= farthest; ++k)
          if (at[axis] + k >= 0 && at[axis] + k < grid.cells[axis] && given(n + k * grid.stride[axis]) != 0)
            wide(n) = 1;
      });
  return wide;
}

/// The same where refined cells of other ranks may be as near.
template <int D>
View<char*> nearRefinedOfAllRanks(const State<D>& state)
{
  const Branches<D>& refined = state.mesh.subdomain->refined;
  const Grid<D>& grid = state.mesh.grid;
  View<char*> near("rhegma::subcycling::nearRefined", grid.numNodes);
  const auto host = Kokkos::create_mirror_view(near);
  constexpr int reach = farthest + 1;
  for (const auto& cell : refined.depth() > 0 ? refined.cells(0) : std::vector<typename Branches<D>::Cell>())
  {
    int low[D], high[D], at[D], all = 1;
    for (int d = 0; d < D; ++d)
    {
      low[d] = std::max(cell[d] - grid.before[d] - reach, 0);
      high[d] = std::min(cell[d] - grid.before[d] + reach, grid.cells[d] - 1);
      all *= std::max(high[d] - low[d] + 1, 0);
    }
    for (int k = 0; k < all; ++k)
    {
      int rest = k;
      for (int d = 0; d < D; ++d)
      {
        at[d] = low[d] + rest % (high[d] - low[d] + 1);
        rest /= high[d] - low[d] + 1;
      }
      host(grid.nodeIndex(at)) = 1;
    }
  }
  Kokkos::deep_copy(near, host);
  return near;
}

} // namespace

template <int D>
void NearParticles<D>::findInBlocks(const State<D>& state)
{
  const Grid<D> grid = state.mesh.grid;
  const bool changed = generation_ != state.mesh.tree.generation;
  if (changed)
  {
    near_ = state.mesh.subdomain ? nearRefinedOfAllRanks(state) : state.mesh.tree.nearRefined;
    for (int axis = 0; axis < D && !state.mesh.subdomain; ++axis)
      near_ = widen(grid, near_, axis);
    generation_ = state.mesh.tree.generation;
  }
  const View<int*> first = state.mesh.blocks.first;
  if (!changed && sorted_.data() == first.data())
    return;
  sorted_ = first;
  fit(inBlocks_, "rhegma::subcycling::inBlocks", state.particles.size());
  const View<char*> near = near_;
  const View<int*> inBlocks = inBlocks_;
  const View<int * [Blocks<D>::axes]> corner = state.mesh.blocks.corner;
  Kokkos::parallel_scan(
      "rhegma::subcycling::listNearBlocks", Range(0, state.mesh.blocks.numBlocks),
      KOKKOS_LAMBDA(const int b, int& at, const bool final) {
        // Until the next sort particles are no more than a cell outside of their block.
        if (!anyCellMarked(grid, near, corner, b, 1))
          return;
        for (int p = first(b); final && p < first(b + 1); ++p)
          inBlocks(at + p - first(b)) = p;
        at += first(b + 1) - first(b);
      },
      numInBlocks_);
}

template <int D>
void NearParticles<D>::find(const State<D>& state)
{
  findInBlocks(state);
  const Grid<D> grid = state.mesh.grid;
  fit(particle_, "rhegma::subcycling::candidate", state.particles.size());
  const View<char*> near = near_;
  const View<int*> candidate = particle_, inBlocks = inBlocks_;
  const auto position = state.particles.template real<D>(fields::position);
  Kokkos::parallel_scan(
      "rhegma::subcycling::findCandidates", Range(0, numInBlocks_),
      KOKKOS_LAMBDA(const int i, int& at, const bool final) {
        const int p = inBlocks(i);
        int cell[D];
        for (int d = 0; d < D; ++d)
          cell[d] = static_cast<int>(grid.inCells(position(p, d), d));
        if (near(grid.nodeIndex(cell)) == 0)
          return;
        if (final)
          candidate(at) = p;
        ++at;
      },
      count_);
}

template class NearParticles<2>;
template class NearParticles<3>;

} // namespace Rhegma::sub_cycling
