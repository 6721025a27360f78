#include "cracks/SpringMemory.hpp"

#include "archive/Archive.hpp"
#include "state/NodeNames.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace Rhegma::cracks
{

namespace
{

template <class To, class From>
void copySprings(const To& to, const From& from)
{
  Kokkos::deep_copy(to.step, from.step);
  Kokkos::deep_copy(to.state, from.state);
  Kokkos::deep_copy(to.stiffness, from.stiffness);
  Kokkos::deep_copy(to.jump, from.jump);
  Kokkos::deep_copy(to.rows, from.rows);
}

template <int D>
NodalSprings<D, Kokkos::HostSpace> onHost(const NodalSprings<D>& springs)
{
  NodalSprings<D, Kokkos::HostSpace> host(springs.size(), springs.rows.extent(0) > 0);
  copySprings(host, springs);
  return host;
}

} // namespace

template <int D>
void SpringMemory<D>::fitToNodes(State<D>& state)
{
  const int nodes = state.mesh.nodes.numLattice;
  if (generation_ == state.mesh.tree.generation && springs_.size() == nodes)
    return;
  std::vector<double> rows = packed(state);
  if (state.mesh.subdomain)
    rows = state.ranks.gatherOnAll(rows);
  springs_ = NodalSprings<D>(nodes, grows_);
  state.cracks.spring = View<double * [D + 1]>("rhegma::springs", nodes);
  std::vector<double> found = unpack(state, rows);
  state.ranks.max(found.data(), static_cast<int>(found.size()));
  const double unit = std::ldexp(state.mesh.grid.spacing, -deepestLevel);
  const std::vector<FrontPoint<D>> fronts = frontPoints(state.cracks);
  for (std::size_t k = 0; k < found.size(); ++k)
  {
    const double* const row = &rows[k * width()];
    Vector<D> position;
    for (int d = 0; d < D; ++d)
      position[d] = state.mesh.grid.whole[d] + row[d] * unit;
    const int front = nearestGrownFront(fronts.data(), static_cast<int>(fronts.size()), position, anyCrack);
    if (found[k] == 0.0 && row[D] > 0.0 && front != noFront)
      state.cracks.fronts[front].budget.returnPending(row[D]);
  }
  generation_ = state.mesh.tree.generation;
  grid_ = state.mesh.grid;
  foreign_ = state.mesh.nodes.foreign;
  finePlace_ = View<double* [D]>("rhegma::positionsOfSprings", state.mesh.tree.numFine);
  if (state.mesh.tree.numFine > 0)
    Kokkos::deep_copy(finePlace_, Kokkos::subview(state.mesh.tree.finePlace,
                                                  std::make_pair(0, state.mesh.tree.numFine), Kokkos::ALL));
}

template <int D>
std::vector<double> SpringMemory<D>::packed(const State<D>& state) const
{
  std::vector<double> rows;
  const NodalSprings<D, Kokkos::HostSpace> springs = onHost(springs_);
  const auto foreign = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, foreign_);
  double latest = 0.0;
  for (int n = 0; n < springs.size(); ++n)
    latest = std::max(latest, static_cast<double>(springs.step(n)));
  state.ranks.max(&latest, 1);
  if (latest == 0.0)
    return rows;
  const NodeNames<D> names(grid_, finePlace_);
  for (int n = 0; n < springs.size(); ++n)
  {
    if (springs.step(n) < latest || (foreign.extent(0) > 0 && foreign(n) != 0))
      continue;
    for (const int coordinate : names.of(n))
      rows.push_back(coordinate);
    rows.insert(rows.end(), {springs.pendingEnergy(n), latest, static_cast<double>(springs.state(n)),
                             springs.stiffness(n)});
    for (int d = 0; d < D; ++d)
      rows.push_back(springs.jump(n, d));
    for (int k = 0; grows_ && k < D + 4; ++k)
      rows.push_back(springs.rows(n, k));
  }
  return rows;
}

template <int D>
std::vector<double> SpringMemory<D>::unpack(const State<D>& state, const std::vector<double>& rows)
{
  std::vector<double> found(rows.size() / width(), 0.0);
  if (rows.empty())
    return found;
  NodalSprings<D, Kokkos::HostSpace> springs = onHost(springs_);
  const NodeNames<D> names(state);
  std::vector<int> name(D);
  for (std::size_t k = 0; k < found.size(); ++k)
  {
    const double* const row = &rows[k * width()];
    std::copy_n(row, D, name.begin());
    const int n = names.find(name, 0);
    if (n < 0)
      continue;
    found[k] = 1.0;
    springs.step(n) = static_cast<int>(row[D + 1]);
    springs.state(n) = static_cast<SpringState>(static_cast<int>(row[D + 2]));
    springs.stiffness(n) = row[D + 3];
    for (int d = 0; d < D; ++d)
      springs.jump(n, d) = row[D + 4 + d];
    for (int i = 0; grows_ && i < D + 4; ++i)
      springs.rows(n, i) = row[2 * D + 4 + i];
  }
  copySprings(springs_, springs);
  return found;
}

template <int D>
void SpringMemory<D>::keep(State<D>& state, int step, Archive& archive)
{
  fitToNodes(state);
  std::vector<double> rows;
  if (!archive.loads() && step > 0)
    rows = packed(state);
  archive.together("springs", rows, width());
  if (!archive.loads())
    return;
  const std::vector<double> found = unpack(state, rows);
  if (!state.ranks.many() && std::find(found.begin(), found.end(), 0.0) != found.end())
    throw std::invalid_argument("\"springs\" names a node that is not there");
}

template class SpringMemory<2>;
template class SpringMemory<3>;

} // namespace Rhegma::cracks
