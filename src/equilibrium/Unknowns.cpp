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

void addCouplings(const std::vector<int>& rows, std::vector<std::vector<int>>& coupled)
{
  constexpr std::size_t most = 512; // then entries that occur twice are removed
  for (const int row : rows)
  {
    std::vector<int>& list = coupled[row];
    list.insert(list.end(), rows.begin(), rows.end());
    if (list.size() > most)
    {
      std::sort(list.begin(), list.end());
      list.erase(std::unique(list.begin(), list.end()), list.end());
    }
  }
}

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
  std::vector<std::vector<int>> coupled(graph.rows);
  std::vector<int> rows;
  forEachStencil(state, boxes, least,
                 [&](const std::vector<int>& nodes)
                 {
                   rows.clear();
                   for (const int n : nodes)
                     rows.push_back(graph.rowOf(n));
                   addCouplings(rows, coupled);
                 });
  for (const std::vector<int>& group : groups)
    addCouplings(group, coupled);
  for (int r = 0; r < graph.rows; ++r)
    coupled[r].push_back(r); // also where only particles of other ranks see it
  owners.sendCouplings(coupled);
  graph.first = View<int*>("rhegma::rowStarts", graph.rows + 1);
  for (int r = 0; r < graph.rows; ++r)
  {
    std::sort(coupled[r].begin(), coupled[r].end());
    coupled[r].erase(std::unique(coupled[r].begin(), coupled[r].end()), coupled[r].end());
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
template std::vector<Vector<2>> rowPositions(const State<2>&, const RowGraph&);
template std::vector<Vector<3>> rowPositions(const State<3>&, const RowGraph&);
template std::vector<double> rowMasses(const State<2>&, const RowGraph&);
template std::vector<double> rowMasses(const State<3>&, const RowGraph&);
template Held findHeld(const State<2>&, const RowGraph&);
template Held findHeld(const State<3>&, const RowGraph&);

} // namespace Rhegma::equilibrium
