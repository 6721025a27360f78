#include "state/Subdomain.hpp"

#include "parallel/NeighbourSums.hpp"
#include "state/Migration.hpp"
#include "state/StepForce.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace Rhegma
{

namespace
{

/// Positions of particles begin .. end - 1.
template <int D>
std::vector<Vector<D>> positionsOf(const State<D>& state, long begin, long end)
{
  const auto position = onHost(state.particles.template real<D>(fields::position));
  std::vector<Vector<D>> positions;
  for (long p = begin; p < end; ++p)
  {
    Vector<D> x;
    for (int d = 0; d < D; ++d)
      x[d] = position(p, d);
    positions.push_back(x);
  }
  return positions;
}

/// Cost of particles begin .. end - 1: the substeps that their level may take. Empty where all costs are
/// equal.
template <int D>
std::vector<double> costsOf(const State<D>& state, long begin, long end)
{
  std::vector<double> costs;
  if (!state.particles.has(fields::level))
    return costs;
  const auto level = onHost(state.particles.integer(fields::level));
  for (long p = begin; p < end; ++p)
    costs.push_back(std::ldexp(1.0, level(p)));
  return costs;
}

/// The division of a run by positions and costs, with a margin that the rows coupled by its forces need.
/// Collective.
template <int D>
Division<D> divisionOf(const State<D>& state, const Grid<D>& lattice, long begin, long end)
{
  Division<D> division =
      divide(state.ranks, lattice, positionsOf(state, begin, end), costsOf(state, begin, end));
  for (const std::shared_ptr<StepForce<D>>& force : state.motion.stepForces)
    division.margin = std::max(division.margin, force->reach());
  return division;
}

/// Throws std::logic_error, on all ranks, where particles were lost or are on two of them.
template <int D>
void demandAllParticles(const State<D>& state)
{
  if (state.ranks.sum(state.particles.size()) != state.particles.ofAllRanks)
    throw std::logic_error("a particle is missing or is on two ranks");
}

/// Sets this rank's part of the lattice, with empty nodes.
template <int D>
void settle(State<D>& state, const Division<D>& division, const Branches<D>& refined)
{
  state.mesh.grid = division.window(state.ranks.rank());
  buildTree(refined.within(state.mesh.grid), state.mesh.tree); // caches of values by node are made anew
  state.mesh.subdomain = std::make_shared<Subdomain<D>>(state.ranks, division, refined, state.mesh.tree);
  state.mesh.nodes = Nodes<D>();
  state.mesh.nodes.reserve(state.mesh.grid.numNodes + state.mesh.tree.numFine, 0);
  state.mesh.nodes.foreign = state.mesh.subdomain->halo.foreign();
  state.particles.sorted = false;
  demandAllParticles(state);
}

} // namespace

template <int D>
Subdomain<D>::Subdomain(const Ranks& ranks, const Division<D>& cells, const Branches<D>& branches,
                        const Tree<D>& tree)
    : division(cells), refined(branches), halo(ranks, cells, tree)
{
  own.lattice = cells.lattice;
  own.rank = ranks.rank();
  own.boxes = View<int* [2][D]>("rhegma::parallel::boxes", own.rank + 1);
  const auto boxes = Kokkos::create_mirror_view(own.boxes);
  for (int r = 0; r <= own.rank; ++r)
    for (int d = 0; d < D; ++d)
    {
      boxes(r, 0, d) = cells.boxes[r].low[d];
      boxes(r, 1, d) = cells.boxes[r].high[d];
    }
  Kokkos::deep_copy(own.boxes, boxes);
}

template <int D>
void refineCells(State<D>& state, const Branches<D>& refined)
{
  if (!state.mesh.subdomain)
    buildTree(refined, state.mesh.tree);
  else
  {
    buildTree(refined.within(state.mesh.grid), state.mesh.tree);
    state.mesh.subdomain =
        std::make_shared<Subdomain<D>>(state.ranks, state.mesh.subdomain->division, refined, state.mesh.tree);
    state.mesh.nodes.foreign = state.mesh.subdomain->halo.foreign();
  }
  state.mesh.nodes.reserve(state.mesh.grid.numNodes + state.mesh.tree.numFine, state.mesh.nodes.numEnriched);
  state.particles.sorted = false;
}

template <int D>
Branches<D> refinedCells(const State<D>& state)
{
  return state.mesh.subdomain ? state.mesh.subdomain->refined : branchesOf(state.mesh.grid, state.mesh.tree);
}

template <int D>
void divideState(State<D>& state)
{
  if (!state.ranks.many())
    return;
  const Branches<D> refined = refinedCells(state);
  state.particles.ofAllRanks = state.particles.size();
  // All ranks have all particles; each handles a part of them during the division.
  const long n = state.particles.size(), rank = state.ranks.rank(), size = state.ranks.size();
  const long begin = n * rank / size, end = n * (rank + 1) / size;
  const Division<D> division = divisionOf(state, state.mesh.grid, begin, end);
  const std::vector<int> owner = ownersOf(state, division);
  std::vector<int> stay;
  for (std::size_t p = 0; p < owner.size(); ++p)
    if (owner[p] == state.ranks.rank())
      stay.push_back(static_cast<int>(p));
  keepParticles(state, stay);
  settle(state, division, refined);
}

template <int D>
void gatherLattice(State<D>& state)
{
  if (!state.mesh.subdomain)
    return;
  state.mesh.grid = wholeLattice(state);
  state.mesh.subdomain.reset();
  state.mesh.nodes = Nodes<D>();
}

template <int D>
void redivideState(State<D>& state)
{
  if (!state.mesh.subdomain)
    return;
  const Division<D> division =
      divisionOf(state, state.mesh.subdomain->division.lattice, 0, state.particles.size());
  sendParticles(state, ownersOf(state, division));
  settle(state, division, Branches<D>(state.mesh.subdomain->refined));
}

template <int D>
NodalFieldNodes<D> nodesOfFields(const State<D>& state)
{
  NodalFieldNodes<D> nodes;
  nodes.grid = state.mesh.grid;
  nodes.finePosition = state.mesh.tree.finePosition;
  nodes.foreign = state.mesh.nodes.foreign;
  if (state.mesh.subdomain)
  {
    nodes.refined = {state.mesh.subdomain, &state.mesh.subdomain->refined};
    nodes.division = {state.mesh.subdomain, &state.mesh.subdomain->division};
  }
  nodes.generation = state.mesh.tree.generation;
  nodes.perNode = state.cracks.dualField && !state.cracks.empty() ? 2 : 1;
  return nodes;
}

template <int D>
void moveNodalFields(State<D>& state)
{
  if (!state.mesh.nodalFields.empty())
    state.mesh.nodalFields.move(nodesOfFields(state), state.clock.step, state.ranks);
}

template <int D>
void useSharedNodes(State<D>& state)
{
  if (!state.mesh.subdomain)
    return;
  const auto active = onHost(state.mesh.nodes.active), shared = onHost(state.mesh.subdomain->halo.nodes());
  std::vector<char> used(state.mesh.grid.numNodes, 0);
  for (std::size_t i = 0; i < active.extent(0); ++i)
    used[active(i)] = 1;
  for (std::size_t i = 0; i < shared.extent(0); ++i)
    if (shared(i) < state.mesh.grid.numNodes) // all of refined cells are in use
      used[shared(i)] = 1;
  std::vector<int> list;
  for (int n = 0; n < state.mesh.grid.numNodes; ++n)
    if (used[n])
      list.push_back(n);
  state.mesh.nodes.active = View<int*>("rhegma::activeNodes", list.size());
  const auto host = Kokkos::create_mirror_view(state.mesh.nodes.active);
  std::copy(list.begin(), list.end(), host.data());
  Kokkos::deep_copy(state.mesh.nodes.active, host);
}

template <int D>
void sumOverRanks(const State<D>& state, SharedSums what)
{
  if (!state.mesh.subdomain)
    return;
  const Nodes<D>& nodes = state.mesh.nodes;
  if (what == SharedSums::MassAndMomentum)
    sumOverRanks(state, nodes.sums.data(), Nodes<D>::sumWidth, Nodes<D>::massAt, 1 + D);
  else if (what == SharedSums::Force)
    sumOverRanks(state, nodes.sums.data(), Nodes<D>::sumWidth, Nodes<D>::forceAt, D);
  else
    sumOverRanks(state, nodes.projection.data(), Nodes<D>::projectionWidth, 0, D);
}

template <int D>
SharedRows sharedRows(const State<D>& state, const View<int*>& rowOf)
{
  SharedRows rows;
  if (state.cracks.dualField && !state.cracks.empty())
    rows.enrichedField = state.cracks.enrichedField;
  rows.rowOf = rowOf;
  return rows;
}

template <int D>
void sumOverRanks(const State<D>& state, double* values, int width, int first, int count,
                  const View<int*>& rowOf)
{
  if (state.mesh.subdomain)
    state.mesh.subdomain->halo.sum(sharedRows(state, rowOf), values, width, first, count);
}

template <int D>
void sumOverRanks(const State<D>& state, const View<double*>& ofNodes)
{
  if (state.mesh.subdomain)
    state.mesh.subdomain->halo.sum({}, ofNodes.data(), 1, 0, 1);
}

template <int D>
void sumParts(const State<D>& state, double* values, int count)
{
  if (state.mesh.subdomain)
    state.ranks.sum(values, count);
}

template <int D>
void sumParts(const State<D>& state, const View<double*>& values)
{
  if (!state.mesh.subdomain)
    return;
  const auto host = onHost(values);
  state.ranks.sum(host.data(), static_cast<int>(host.extent(0)));
  Kokkos::deep_copy(values, host);
}

template <int D>
void maxParts(const State<D>& state, double* values, int count)
{
  if (state.mesh.subdomain)
    state.ranks.max(values, count);
}

template <int D>
const Grid<D>& wholeLattice(const State<D>& state)
{
  return state.mesh.subdomain ? state.mesh.subdomain->division.lattice : state.mesh.grid;
}

template void refineCells(State<2>&, const Branches<2>&);
template void refineCells(State<3>&, const Branches<3>&);
template Branches<2> refinedCells(const State<2>&);
template Branches<3> refinedCells(const State<3>&);
template void divideState(State<2>&);
template void divideState(State<3>&);
template void gatherLattice(State<2>&);
template void gatherLattice(State<3>&);
template void redivideState(State<2>&);
template void redivideState(State<3>&);
template NodalFieldNodes<2> nodesOfFields(const State<2>&);
template NodalFieldNodes<3> nodesOfFields(const State<3>&);
template void moveNodalFields(State<2>&);
template void moveNodalFields(State<3>&);
template void useSharedNodes(State<2>&);
template void useSharedNodes(State<3>&);
template SharedRows sharedRows(const State<2>&, const View<int*>&);
template SharedRows sharedRows(const State<3>&, const View<int*>&);
template void sumOverRanks(const State<2>&, SharedSums);
template void sumOverRanks(const State<3>&, SharedSums);
template void sumOverRanks(const State<2>&, double*, int, int, int, const View<int*>&);
template void sumOverRanks(const State<3>&, double*, int, int, int, const View<int*>&);
template void sumOverRanks(const State<2>&, const View<double*>&);
template void sumOverRanks(const State<3>&, const View<double*>&);
template void sumParts(const State<2>&, double*, int);
template void sumParts(const State<3>&, double*, int);
template void sumParts(const State<2>&, const View<double*>&);
template void sumParts(const State<3>&, const View<double*>&);
template void maxParts(const State<2>&, double*, int);
template void maxParts(const State<3>&, double*, int);
template const Grid<2>& wholeLattice(const State<2>&);
template const Grid<3>& wholeLattice(const State<3>&);
template struct Subdomain<2>;
template struct Subdomain<3>;

} // namespace Rhegma
