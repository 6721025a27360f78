#include "equilibrium/Unknowns.hpp"

#include "equilibrium/RowOwners.hpp"
#include "state/Subdomain.hpp"
#include "transfer/ParticleViews.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace Rhegma::equilibrium
{

namespace
{

/// Edge of the finest cells at a node [m].
template <int D>
double edgeAt(const State<D>& state, int node)
{
  if (!state.mesh.tree.refined())
    return state.mesh.grid.spacing;
  const Nodes<D>& nodes = state.mesh.nodes;
  return std::ldexp(state.mesh.grid.spacing, -state.mesh.tree.nodeLevel(latticeNode(nodes, node)));
}

/// Calls use(rows) with the sorted rows of each particle's nodes, where they differ from those of the
/// particles just before it. \param least slope, as for `connectRows`
template <int D, class Use>
void forEachStencil(const State<D>& state, const ClippedBoxes<D>& boxes, double least, const Use& use)
{
  constexpr int remembered = 8;
  withStraining(state,
                [&](const auto& ofParticles)
                {
                  const auto connect = boxes.in(ofParticles);
                  std::vector<int> nodes, last[remembered];
                  int next = 0;
                  for (int p = 0; p < state.particles.size(); ++p)
                  {
                    nodes.clear();
                    connect.visitStraining(p,
                                           [&](int node, double weight, const auto& slopes)
                                           {
                                             const double edge = edgeAt(state, node);
                                             if (counts(weight, slopes.of, slopes.size, edge) &&
                                                 largestSlope(slopes.of, slopes.size, edge) >= least)
                                               nodes.push_back(node);
                                           });
                    std::sort(nodes.begin(), nodes.end());
                    if (std::find(last, last + remembered, nodes) != last + remembered)
                      continue;
                    last[next++ % remembered] = nodes;
                    use(nodes);
                  }
                });
}

/// Lists of rows that are coupled with one another.
class RowLists
{
public:
  /// \param rowOf the row of each element of the list
  template <class RowOf>
  void add(const std::vector<int>& list, const RowOf& rowOf)
  {
    for (const int of : list)
      rows_.push_back(rowOf(of));
    first_.push_back(rows_.size());
  }

  /// The rows that are in a list with each row, ascending, the row itself included.
  std::vector<std::vector<int>> couplings(int numRows) const
  {
    std::vector<std::size_t> begin(numRows + 1, 0);
    for (const int row : rows_)
      ++begin[row + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<int> lists(rows_.size()); // of each row
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    for (std::size_t list = 0; list + 1 < first_.size(); ++list)
      for (std::size_t k = first_[list]; k < first_[list + 1]; ++k)
        lists[next[rows_[k]]++] = static_cast<int>(list);
    std::vector<std::vector<int>> coupled(numRows);
    std::vector<int> seenBy(numRows, -1), found;
    for (int row = 0; row < numRows; ++row)
    {
      seenBy[row] = row;
      found.assign(1, row);
      for (std::size_t k = begin[row]; k < begin[row + 1]; ++k)
        for (std::size_t at = first_[lists[k]]; at < first_[lists[k] + 1]; ++at)
          if (seenBy[rows_[at]] != row)
          {
            seenBy[rows_[at]] = row;
            found.push_back(rows_[at]);
          }
      std::sort(found.begin(), found.end());
      coupled[row] = found;
    }
    return coupled;
  }

private:
  std::vector<int> rows_;
  std::vector<std::size_t> first_ = {0}; ///< of each list in `rows_`; one more at the end
};

} // namespace

template <int D>
RowGraph numberRows(const State<D>& state)
{
  RowGraph graph;
  const int nodes = static_cast<int>(state.mesh.nodes.sums.extent(0));
  graph.rowOf = View<int*>("rhegma::rowOfNode", nodes);
  const View<double*> used("rhegma::usedNodes", nodes);
  forEachStencil(state, ClippedBoxes<D>(), 0.0,
                 [&](const std::vector<int>& of)
                 {
                   for (const int n : of)
                     used(n) = 1.0;
                 });
  sumOverRanks(state, used.data(), 1, 0, 1);
  graph.rows = nodes - static_cast<int>(std::count(used.data(), used.data() + nodes, 0.0));
  graph.nodeOf = View<int*>("rhegma::nodeOfRow", graph.rows);
  for (int n = 0, row = 0; n < nodes; ++n)
  {
    graph.rowOf(n) = used(n) != 0.0 ? row : -1;
    if (used(n) != 0.0)
      graph.nodeOf(row++) = n;
  }
  return graph;
}

template <int D>
void connectRows(const State<D>& state, const Groups& groups, const ClippedBoxes<D>& boxes,
                 const RowOwners& owners, RowGraph& graph, double least)
{
  std::vector<std::vector<int>> coupled;
  {
    RowLists lists;
    forEachStencil(state, boxes, least,
                   [&](const std::vector<int>& nodes)
                   { lists.add(nodes, [&](int node) { return graph.rowOf(node); }); });
    for (const std::vector<int>& group : groups)
      lists.add(group, [](int row) { return row; });
    coupled = lists.couplings(graph.rows);
  }
  owners.sendCouplings(coupled);
  graph.first = View<int*>("rhegma::rowStarts", graph.rows + 1);
  for (int r = 0; r < graph.rows; ++r)
  {
    if (owners.ranks().many())
    {
      std::sort(coupled[r].begin(), coupled[r].end());
      coupled[r].erase(std::unique(coupled[r].begin(), coupled[r].end()), coupled[r].end());
    }
    graph.first(r + 1) = graph.first(r) + static_cast<int>(coupled[r].size());
  }
  graph.column = View<int*>("rhegma::columns", graph.first(graph.rows));
  for (int r = 0; r < graph.rows; ++r)
    std::copy(coupled[r].begin(), coupled[r].end(), graph.column.data() + graph.first(r));
}

std::pair<std::vector<int>, int> findPieces(const RowGraph& graph, const RowOwners& owners)
{
  std::vector<int> piece(graph.rows, -1), stack;
  int count = 0;
  for (int start = 0; start < graph.rows; ++start)
  {
    if (piece[start] >= 0)
      continue;
    stack.assign(1, start);
    piece[start] = count;
    while (!stack.empty())
    {
      const int row = stack.back();
      stack.pop_back();
      for (int k = graph.first(row); k < graph.first(row + 1); ++k)
        if (piece[graph.column(k)] < 0)
        {
          piece[graph.column(k)] = count;
          stack.push_back(graph.column(k));
        }
    }
    ++count;
  }
  return owners.joinPieces(piece, count);
}

template <int D>
std::pair<std::vector<int>, int> findPieces(const State<D>& state, const Groups& groups,
                                            const RowOwners& owners, const RowGraph& graph)
{
  std::vector<int> parent(graph.rows);
  std::iota(parent.begin(), parent.end(), 0);
  const auto first = [&](int row)
  {
    while (parent[row] != row)
      row = parent[row] = parent[parent[row]];
    return row;
  };
  const auto join = [&](int a, int b)
  {
    a = first(a);
    b = first(b);
    parent[std::max(a, b)] = std::min(a, b);
  };
  forEachStencil(state, ClippedBoxes<D>(), 0.0,
                 [&](const std::vector<int>& nodes)
                 {
                   for (const int node : nodes)
                     join(graph.rowOf(nodes.front()), graph.rowOf(node));
                 });
  for (const std::vector<int>& group : groups)
    for (const int row : group)
      join(group.front(), row);
  std::vector<int> piece(graph.rows);
  int count = 0;
  for (int r = 0; r < graph.rows; ++r)
    piece[r] = first(r) == r ? count++ : piece[first(r)];
  return owners.joinPieces(piece, count);
}

template <int D>
std::vector<Vector<D>> rowPositions(const State<D>& state, const RowGraph& graph)
{
  const NodePositions<D> positions = nodePositions(state);
  std::vector<Vector<D>> at(graph.rows);
  for (int r = 0; r < graph.rows; ++r)
    at[r] = positions(latticeNode(state.mesh.nodes, graph.nodeOf(r)));
  return at;
}

template <int D>
std::vector<double> rowMasses(const State<D>& state, const RowGraph& graph)
{
  std::vector<double> mass(graph.rows);
  for (int r = 0; r < graph.rows; ++r)
    mass[r] = state.mesh.nodes.sums(graph.nodeOf(r), Nodes<D>::massAt);
  return mass;
}

template <int D>
Held findHeld(const State<D>& state, const RowGraph& graph)
{
  Held held{std::vector<char>(D * graph.rows, 0), std::vector<double>(D * graph.rows, 0.0)};
  const NodePositions<D> positions = nodePositions(state);
  for (int r = 0; r < graph.rows; ++r)
  {
    const int lattice = latticeNode(state.mesh.nodes, graph.nodeOf(r));
    const Vector<D> x = positions(lattice);
    for (const NodeConstraint<D>& constraint : state.motion.constraints)
      if (constraint.appliesAt(x))
        for (int d = 0; d < D; ++d)
          if (constraint.holds[d])
          {
            held.is[D * r + d] = 1;
            held.change[D * r + d] = state.clock.dt * constraint.at(lattice, d);
          }
  }
  return held;
}

template RowGraph numberRows(const State<2>&);
template RowGraph numberRows(const State<3>&);
template void connectRows(const State<2>&, const Groups&, const ClippedBoxes<2>&, const RowOwners&, RowGraph&,
                          double);
template void connectRows(const State<3>&, const Groups&, const ClippedBoxes<3>&, const RowOwners&, RowGraph&,
                          double);
template std::pair<std::vector<int>, int> findPieces(const State<2>&, const Groups&, const RowOwners&,
                                                     const RowGraph&);
template std::pair<std::vector<int>, int> findPieces(const State<3>&, const Groups&, const RowOwners&,
                                                     const RowGraph&);
template std::vector<Vector<2>> rowPositions(const State<2>&, const RowGraph&);
template std::vector<Vector<3>> rowPositions(const State<3>&, const RowGraph&);
template std::vector<double> rowMasses(const State<2>&, const RowGraph&);
template std::vector<double> rowMasses(const State<3>&, const RowGraph&);
template Held findHeld(const State<2>&, const RowGraph&);
template Held findHeld(const State<3>&, const RowGraph&);

} // namespace Rhegma::equilibrium
