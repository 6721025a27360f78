#include "parallel/Halo.hpp"

#include "parallel/NeighbourSums.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace Rhegma
{

namespace
{

using GlobalId = long long;

/// Nodes low .. high of the lattice along each axis, both included.
template <int D>
struct NodeBox
{
  int low[D], high[D];

  bool holds(const int (&at)[D]) const
  {
    bool in = true;
    for (int d = 0; d < D; ++d)
      in = in && at[d] >= low[d] && at[d] <= high[d];
    return in;
  }
};

template <int D>
NodeBox<D> windowNodes(const Division<D>& division, int rank)
{
  const CellBox<D> cells = division.windowCells(rank);
  NodeBox<D> box;
  std::copy_n(cells.low, D, box.low);
  std::copy_n(cells.high, D, box.high);
  return box;
}

/// Whether a position, in the smallest cells that there can be, is a cell or more inside the window of a
/// rank.
template <int D>
bool isInside(const Division<D>& division, int rank, const std::array<GlobalId, D>& position)
{
  const NodeBox<D> box = windowNodes(division, rank);
  bool in = true;
  for (int d = 0; d < D; ++d)
    in = in && position[d] >= GlobalId(box.low[d] + 1) << deepestLevel &&
         position[d] <= GlobalId(box.high[d] - 1) << deepestLevel;
  return in;
}

/// Nodes of refined cells by their positions, counted in the smallest cells that there can be from node 0 of
/// the whole lattice.
template <int D>
std::vector<std::array<GlobalId, D>> finePositions(const Division<D>& division, const Tree<D>& tree)
{
  const auto position = onHost(tree.finePosition);
  const double unit = std::ldexp(division.lattice.spacing, -deepestLevel);
  std::vector<std::array<GlobalId, D>> all(tree.numFine);
  for (int k = 0; k < tree.numFine; ++k)
    for (int d = 0; d < D; ++d)
      all[k][d] = std::lround((position(k, d) - division.lattice.whole[d]) / unit);
  return all;
}

/// Number of such a position, after those of the lattice's nodes.
template <int D>
GlobalId idOf(const Grid<D>& lattice, const std::array<GlobalId, D>& position)
{
  GlobalId id = 0;
  for (int d = 0; d < D; ++d)
    id = id * ((GlobalId(lattice.cells[d]) << deepestLevel) + 1) + position[d];
  return lattice.numNodes + id;
}

/// The shared nodes of a rank.
template <int D>
struct Shared
{
  std::vector<int> nodes;           ///< rows here
  std::vector<GlobalId> ids;        ///< their numbers on all ranks
  std::vector<std::vector<int>> of; ///< by rank: the nodes shared with it

  explicit Shared(int ranks) : of(ranks) {}

  /// \param has whether a rank has the node
  template <class Has>
  void offer(int row, GlobalId id, int rank, const Has& has)
  {
    bool any = false;
    for (int r = 0; r < static_cast<int>(of.size()); ++r)
      if (r != rank && has(r))
      {
        of[r].push_back(static_cast<int>(nodes.size()));
        any = true;
      }
    if (!any)
      return;
    nodes.push_back(row);
    ids.push_back(id);
  }
};

template <class T>
View<T*> onDevice(const std::string& label, const std::vector<T>& list)
{
  const View<T*> view(label, list.size());
  const auto host = Kokkos::create_mirror_view(view);
  std::copy(list.begin(), list.end(), host.data());
  Kokkos::deep_copy(view, host);
  return view;
}

} // namespace

template <int D>
Halo<D>::Halo(const Ranks& ranks, const Division<D>& division, const Tree<D>& tree)
{
  const int rank = ranks.rank();
  const Grid<D> window = division.window(rank);
  std::vector<NodeBox<D>> boxes;
  for (int r = 0; r < ranks.size(); ++r)
    boxes.push_back(windowNodes(division, r));
  Shared<D> shared(ranks.size());
  std::vector<char> foreign(window.numNodes + tree.numFine, 0);
  const auto isOwn = [&](const int(&at)[D])
  {
    int cell[D];
    for (int d = 0; d < D; ++d)
      cell[d] = std::clamp(at[d], gridMargin, division.lattice.cells[d] - gridMargin - 1);
    return division.ownerOf(cell) == rank;
  };
  for (int n = 0; n < window.numNodes; ++n)
  {
    int at[D];
    window.nodeCoordinates(n, at);
    for (int d = 0; d < D; ++d)
      at[d] += boxes[rank].low[d];
    const std::size_t before = shared.nodes.size();
    shared.offer(n, division.lattice.nodeIndex(at), rank, [&](int r) { return boxes[r].holds(at); });
    foreign[n] = shared.nodes.size() > before && !isOwn(at) ? 1 : 0;
  }
  int row = window.numNodes;
  for (const std::array<GlobalId, D>& position : finePositions(division, tree))
  {
    int at[D];
    for (int d = 0; d < D; ++d)
      at[d] = static_cast<int>(position[d] >> deepestLevel);
    foreign[row] = isOwn(at) ? 0 : 1;
    if (isInside<D>(division, rank, position))
      shared.offer(row, idOf<D>(division.lattice, position), rank,
                   [&](int r) { return isInside<D>(division, r, position); });
    ++row;
  }
  // Two ranks list their common nodes in the same order.
  for (std::vector<int>& list : shared.of)
    std::sort(list.begin(), list.end(), [&](int a, int b) { return shared.ids[a] < shared.ids[b]; });
  nodes_ = onDevice("rhegma::sharedNodes", shared.nodes);
  foreign_ = onDevice("rhegma::foreignNodes", foreign);
  sums_ = std::make_unique<NeighbourSums>(ranks, nodes_, shared.of);
}

template <int D>
Halo<D>::~Halo() = default;

template <int D>
void Halo<D>::sum(const SharedRows& rows, double* values, int width, int first, int count) const
{
  sums_->sum(rows, values, width, first, count);
}

template class Halo<2>;
template class Halo<3>;

} // namespace Rhegma
