#include "parallel/Halo.hpp"

#include <Tpetra_Export.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace Rhegma
{

namespace
{

using Map = Tpetra::Map<>;
using GlobalId = Map::global_ordinal_type;
using MultiVector = Tpetra::MultiVector<double>;
using Teuchos::RCP;
using Teuchos::rcp;

/// Nodes low .. high of the lattice along each axis, both included.
template <int D>
struct NodeBox
{
  int low[D], high[D];
};

template <int D>
NodeBox<D> windowNodes(const Division<D>& division, int rank)
{
  NodeBox<D> box;
  for (int d = 0; d < D; ++d)
  {
    box.low[d] = division.boxes[rank].low[d] - gridMargin;
    box.high[d] = division.boxes[rank].high[d] + gridMargin;
  }
  return box;
}

/// Whether a place, in the smallest cells that there can be, is a cell or more inside the window of a rank.
template <int D>
bool isInside(const Division<D>& division, int rank, const std::array<GlobalId, D>& place)
{
  const NodeBox<D> box = windowNodes(division, rank);
  bool in = true;
  for (int d = 0; d < D; ++d)
    in = in && place[d] >= GlobalId(box.low[d] + 1) << deepestLevel &&
         place[d] <= GlobalId(box.high[d] - 1) << deepestLevel;
  return in;
}

/// Whether a place is so for any rank but one.
template <int D>
bool isInsideAnother(const Division<D>& division, int rank, const std::array<GlobalId, D>& place)
{
  bool in = false;
  for (int r = 0; r < static_cast<int>(division.boxes.size()) && !in; ++r)
    in = r != rank && isInside<D>(division, r, place);
  return in;
}

/// Nodes of refined cells by their places, counted in the smallest cells that there can be from node 0 of the
/// whole lattice.
template <int D>
std::vector<std::array<GlobalId, D>> finePlaces(const Division<D>& division, const Tree<D>& tree)
{
  const auto place = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, tree.finePlace);
  const double unit = std::ldexp(division.lattice.spacing, -deepestLevel);
  std::vector<std::array<GlobalId, D>> all(tree.numFine);
  for (int k = 0; k < tree.numFine; ++k)
    for (int d = 0; d < D; ++d)
      all[k][d] = std::lround((place(k, d) - division.lattice.whole[d]) / unit);
  return all;
}

/// A number of such a place, past those of the lattice's nodes.
template <int D>
GlobalId idOf(const Grid<D>& lattice, const std::array<GlobalId, D>& place)
{
  GlobalId id = 0;
  for (int d = 0; d < D; ++d)
    id = id * ((GlobalId(lattice.cells[d]) << deepestLevel) + 1) + place[d];
  return lattice.numNodes + id;
}

template <int D>
RCP<const Map> makeMap(const std::vector<GlobalId>& ids, const Ranks& ranks)
{
  const auto none = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  return rcp(new Map(none, Teuchos::arrayViewFromVector(ids), 0, ranks.comm()));
}

} // namespace

template <int D>
class Halo<D>::Plan
{
public:
  Plan(const std::vector<GlobalId>& shared, const std::vector<GlobalId>& own, const Ranks& ranks)
      : sharedMap_(makeMap<D>(shared, ranks)), ownMap_(makeMap<D>(own, ranks)), exporter_(sharedMap_, ownMap_)
  {
  }

  void sum(const View<int*>& nodes, const SharedRows& rows, double* values, int width, int first, int count)
  {
    const int fields = rows.second.extent(0) > 0 ? 2 : 1, columns = fields * count;
    Vectors& vectors = vectorsOf(columns);
    {
      const auto shares = vectors.shared->getLocalViewDevice(Tpetra::Access::OverwriteAll);
      Kokkos::parallel_for(
          "rhegma::parallel::pack", Kokkos::RangePolicy<ExecSpace>(0, nodes.extent(0)),
          KOKKOS_LAMBDA(const int i) {
            for (int f = 0; f < fields; ++f)
            {
              const int row = rows(nodes(i), f);
              for (int c = 0; c < count; ++c)
                shares(i, f * count + c) =
                    row < 0 ? 0.0 : values[static_cast<std::size_t>(row) * width + first + c];
            }
          });
    }
    vectors.own->putScalar(0.0);
    vectors.own->doExport(*vectors.shared, exporter_, Tpetra::ADD);
    vectors.shared->doImport(*vectors.own, exporter_, Tpetra::INSERT);
    const auto sums = vectors.shared->getLocalViewDevice(Tpetra::Access::ReadOnly);
    Kokkos::parallel_for(
        "rhegma::parallel::unpack", Kokkos::RangePolicy<ExecSpace>(0, nodes.extent(0)),
        KOKKOS_LAMBDA(const int i) {
          for (int f = 0; f < fields; ++f)
          {
            const int row = rows(nodes(i), f);
            for (int c = 0; row >= 0 && c < count; ++c)
              values[static_cast<std::size_t>(row) * width + first + c] = sums(i, f * count + c);
          }
        });
  }

private:
  struct Vectors
  {
    RCP<MultiVector> shared, own;
  };

  Vectors& vectorsOf(int count)
  {
    Vectors& vectors = vectors_[count];
    if (vectors.shared.is_null())
      vectors = {rcp(new MultiVector(sharedMap_, count)), rcp(new MultiVector(ownMap_, count))};
    return vectors;
  }

  RCP<const Map> sharedMap_, ownMap_;
  Tpetra::Export<> exporter_;
  std::map<int, Vectors> vectors_; ///< by their number of columns
};

template <int D>
Halo<D>::Halo(const Ranks& ranks, const Division<D>& division, const Tree<D>& tree)
{
  const Grid<D> window = division.window(ranks.rank());
  const NodeBox<D> mine = windowNodes(division, ranks.rank());
  std::vector<char> shared(window.numNodes, 0);
  for (int r = 0; r < ranks.size(); ++r)
  {
    NodeBox<D> both = windowNodes(division, r);
    bool empty = r == ranks.rank();
    for (int d = 0; d < D; ++d)
    {
      both.low[d] = std::max(both.low[d], mine.low[d]);
      both.high[d] = std::min(both.high[d], mine.high[d]);
      empty = empty || both.low[d] > both.high[d];
    }
    if (empty)
      continue;
    for (int n = 0; n < window.numNodes; ++n)
    {
      int at[D];
      window.nodeCoordinates(n, at);
      bool in = true;
      for (int d = 0; d < D; ++d)
        in = in && at[d] + mine.low[d] >= both.low[d] && at[d] + mine.low[d] <= both.high[d];
      shared[n] = shared[n] || in;
    }
  }
  std::vector<int> nodes;
  std::vector<GlobalId> ids, own;
  std::vector<char> foreign(window.numNodes + tree.numFine, 0);
  for (int n = 0; n < window.numNodes; ++n)
  {
    if (!shared[n])
      continue;
    int at[D], cell[D];
    window.nodeCoordinates(n, at);
    for (int d = 0; d < D; ++d)
    {
      at[d] += mine.low[d];
      cell[d] = std::clamp(at[d], gridMargin, division.lattice.cells[d] - gridMargin - 1);
    }
    nodes.push_back(n);
    ids.push_back(division.lattice.nodeIndex(at));
    if (division.ownerOf(cell) == ranks.rank())
      own.push_back(ids.back());
    else
      foreign[n] = 1;
  }
  int row = window.numNodes;
  for (const std::array<GlobalId, D>& place : finePlaces(division, tree))
  {
    int cell[D];
    for (int d = 0; d < D; ++d)
      cell[d] = std::clamp(static_cast<int>(place[d] >> deepestLevel), gridMargin,
                           division.lattice.cells[d] - gridMargin - 1);
    const bool isOwn = division.ownerOf(cell) == ranks.rank();
    foreign[row] = isOwn ? 0 : 1;
    if (isInside<D>(division, ranks.rank(), place) && isInsideAnother<D>(division, ranks.rank(), place))
    {
      nodes.push_back(row);
      ids.push_back(idOf<D>(division.lattice, place));
      if (isOwn)
        own.push_back(ids.back());
    }
    ++row;
  }
  nodes_ = View<int*>("rhegma::sharedNodes", nodes.size());
  foreign_ = View<char*>("rhegma::foreignNodes", foreign.size());
  const auto hostNodes = Kokkos::create_mirror_view(nodes_);
  const auto hostForeign = Kokkos::create_mirror_view(foreign_);
  std::copy(nodes.begin(), nodes.end(), hostNodes.data());
  std::copy(foreign.begin(), foreign.end(), hostForeign.data());
  Kokkos::deep_copy(nodes_, hostNodes);
  Kokkos::deep_copy(foreign_, hostForeign);
  plan_ = std::make_unique<Plan>(ids, own, ranks);
}

template <int D>
Halo<D>::~Halo() = default;

template <int D>
void Halo<D>::sum(const SharedRows& rows, double* values, int width, int first, int count) const
{
  plan_->sum(nodes_, rows, values, width, first, count);
}

template class Halo<2>;
template class Halo<3>;

} // namespace Rhegma
