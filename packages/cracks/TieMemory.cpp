#include "cracks/TieMemory.hpp"

#include "archive/Archive.hpp"
#include "cracks/Cohesion.hpp"
#include "state/NodeNames.hpp"
#include "state/Subdomain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <vector>

namespace Rhegma::cracks
{

namespace
{

/// What a cohesive force would yet take [J]. \param row as of Cohesion.hpp
double yetToTake(const double* row)
{
  const double peak = row[cohesion::peak], range = row[cohesion::range], start = row[cohesion::start],
               reached = row[cohesion::reached];
  if (!(peak > 0.0) || !(range > 0.0))
    return 0.0;
  const double left = std::max(0.0, start + range - reached);
  return 0.5 * peak * left * left / range;
}

/// Gives energy back to the front nearest to a place that has grown.
template <int D>
void giveBack(State<D>& state, const Vector<D>& place, double energy)
{
  CrackFront<D>* nearest = nullptr;
  for (CrackFront<D>& front : state.cracks.fronts)
    if (front.grown && (nearest == nullptr || norm(front.position - place) < norm(nearest->position - place)))
      nearest = &front;
  if (nearest != nullptr)
    nearest->unspent += energy;
}

} // namespace

template <int D>
void TieMemory<D>::makeRoom(State<D>& state)
{
  const int rows = state.mesh.nodes.numLattice;
  if (state.mesh.subdomain && (generation_ != state.mesh.tree.generation || grid_.numNodes == 0))
  {
    moveToNewNodes(state);
    generation_ = state.mesh.tree.generation;
  }
  if (static_cast<int>(jump_.extent(0)) < rows)
  {
    Kokkos::resize(jump_, rows);
    Kokkos::resize(step_, rows);
    Kokkos::resize(stiffness_, rows);
    if (grows_)
      Kokkos::resize(cohesion_, rows);
    state.cracks.tie = View<double * [D + 1]>("rhegma::ties", rows);
  }
  if (generation_ != state.mesh.tree.generation)
  {
    carryOver(state);
    generation_ = state.mesh.tree.generation;
  }
}

template <int D>
void TieMemory<D>::moveToNewNodes(State<D>& state)
{
  const int width = D + 2 + D + (grows_ ? D + 4 : 0);
  std::vector<double> ties; // name of the node, step, stiffness, jump, cohesion; one after another
  {
    const auto host = [](const auto& view)
    { return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, view); };
    const auto jump = host(jump_);
    const auto step = host(step_);
    const auto stiffness = host(stiffness_);
    const auto cohesive = host(cohesion_);
    const auto foreign = host(foreign_);
    const NodeNames<D> names(grid_, finePlace_);
    double latest = 0.0;
    for (int n = 0; n < names.size(); ++n)
      latest = std::max(latest, static_cast<double>(step(n)));
    state.ranks.max(&latest, 1);
    for (int n = 0; n < names.size(); ++n)
    {
      if (step(n) == 0 || step(n) < latest || foreign(n) != 0)
        continue;
      for (const int place : names.of(n))
        ties.push_back(place);
      ties.insert(ties.end(), {double(step(n)), stiffness(n)});
      for (int d = 0; d < D; ++d)
        ties.push_back(jump(n, d));
      for (int i = 0; grows_ && i < D + 4; ++i)
        ties.push_back(cohesive(n, i));
    }
  }
  ties = state.ranks.gatherOnAll(ties);
  const int rows = state.mesh.nodes.numLattice;
  jump_ = View<double* [D]>("rhegma::tieJump", rows);
  step_ = View<int*>("rhegma::tieStep", rows);
  stiffness_ = View<double*>("rhegma::tieStiffness", rows);
  if (grows_)
    cohesion_ = View<double * [D + 4]>("rhegma::tieCohesion", rows);
  state.cracks.tie = View<double * [D + 1]>("rhegma::ties", rows);
  const auto jump = Kokkos::create_mirror_view(jump_);
  const auto step = Kokkos::create_mirror_view(step_);
  const auto stiffness = Kokkos::create_mirror_view(stiffness_);
  const auto cohesive = Kokkos::create_mirror_view(cohesion_);
  const NodeNames<D> names(state);
  std::vector<int> name(D);
  std::vector<double> kept(ties.size() / width, 0.0);
  for (std::size_t k = 0; k < ties.size(); k += width)
  {
    std::copy_n(ties.begin() + k, D, name.begin());
    const int n = names.find(name, 0);
    if (n < 0)
      continue;
    kept[k / width] = 1.0;
    const double* const tie = &ties[k + D];
    step(n) = static_cast<int>(tie[0]);
    stiffness(n) = tie[1];
    for (int d = 0; d < D; ++d)
      jump(n, d) = tie[2 + d];
    for (int i = 0; grows_ && i < D + 4; ++i)
      cohesive(n, i) = tie[2 + D + i];
  }
  Kokkos::deep_copy(jump_, jump);
  Kokkos::deep_copy(step_, step);
  Kokkos::deep_copy(stiffness_, stiffness);
  Kokkos::deep_copy(cohesion_, cohesive);
  state.ranks.max(kept.data(), static_cast<int>(kept.size()));
  const double unit = std::ldexp(state.mesh.grid.spacing, -deepestLevel);
  for (std::size_t k = 0; grows_ && k < kept.size(); ++k)
    if (kept[k] == 0.0)
    {
      Vector<D> place;
      for (int d = 0; d < D; ++d)
        place[d] = state.mesh.grid.whole[d] + ties[k * width + d] * unit;
      giveBack(state, place, yetToTake(&ties[k * width + D + 2 + D]));
    }
  grid_ = state.mesh.grid;
  foreign_ = state.mesh.nodes.foreign;
  finePlace_ = View<double* [D]>("rhegma::placesOfTies", state.mesh.tree.numFine);
  if (state.mesh.tree.numFine > 0)
    Kokkos::deep_copy(finePlace_, Kokkos::subview(state.mesh.tree.finePlace,
                                                  std::make_pair(0, state.mesh.tree.numFine), Kokkos::ALL));
}

template <int D>
void TieMemory<D>::carryOver(State<D>& state)
{
  using Key = std::array<long, D>;
  const double unit =
      std::ldexp(state.mesh.grid.spacing, -deepestLevel); // the smallest cells that there can be
  const int lattice = state.mesh.grid.numNodes;
  const auto jump = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, jump_);
  const auto step = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, step_);
  const auto stiffness = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, stiffness_);
  const auto cohesion = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, cohesion_);
  const auto keyOf = [&](const auto& place, int k)
  {
    Key key;
    for (int d = 0; d < D; ++d)
      key[d] = std::lround((place(k, d) - state.mesh.grid.origin[d]) / unit);
    return key;
  };
  struct Tie
  {
    Vector<D> jump;
    int step;
    double stiffness;
    double cohesion[D + 4];
    bool kept;
  };
  std::map<Key, Tie> ties;
  int latest = 0;
  for (int n = 0; n < static_cast<int>(step.extent(0)); ++n)
    latest = std::max(latest, step(n));
  const auto before = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, finePlace_);
  for (int k = 0; k < static_cast<int>(before.extent(0)); ++k)
  {
    const int n = lattice + k;
    if (step(n) == 0)
      continue;
    Tie& tie = ties[keyOf(before, k)];
    tie.step = step(n);
    tie.kept = false;
    tie.stiffness = stiffness(n);
    for (int i = 0; grows_ && i < D + 4; ++i)
      tie.cohesion[i] = cohesion(n, i);
    for (int d = 0; d < D; ++d)
      tie.jump[d] = jump(n, d);
  }
  const int fine = state.mesh.tree.numFine;
  finePlace_ = View<double* [D]>("rhegma::placesOfTies", fine);
  if (fine > 0)
    Kokkos::deep_copy(finePlace_,
                      Kokkos::subview(state.mesh.tree.finePlace, std::make_pair(0, fine), Kokkos::ALL));
  const auto after = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, finePlace_);
  for (int n = lattice; n < static_cast<int>(step.extent(0)); ++n)
  {
    step(n) = 0;
    stiffness(n) = 0.0;
    if (grows_)
      cohesion(n, cohesion::peak) = 0.0;
    if (n - lattice >= fine)
      continue;
    const auto found = ties.find(keyOf(after, n - lattice));
    if (found == ties.end())
      continue;
    found->second.kept = true;
    step(n) = found->second.step;
    stiffness(n) = found->second.stiffness;
    for (int i = 0; grows_ && i < D + 4; ++i)
      cohesion(n, i) = found->second.cohesion[i];
    for (int d = 0; d < D; ++d)
      jump(n, d) = found->second.jump[d];
  }
  for (const auto& [key, tie] : ties)
    if (grows_ && !tie.kept && tie.step == latest)
    {
      Vector<D> place;
      for (int d = 0; d < D; ++d)
        place[d] = state.mesh.grid.origin[d] + double(key[d]) * unit;
      giveBack(state, place, yetToTake(tie.cohesion));
    }
  Kokkos::deep_copy(jump_, jump);
  Kokkos::deep_copy(step_, step);
  Kokkos::deep_copy(stiffness_, stiffness);
  Kokkos::deep_copy(cohesion_, cohesion);
}

template <int D>
void TieMemory<D>::keep(State<D>& state, int step, Archive& archive)
{
  makeRoom(state);
  const NodeNames<D> names(state);
  const auto jump = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, jump_);
  const auto last = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, step_);
  const auto stiffness = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, stiffness_);
  const auto cohesion = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, cohesion_);
  const auto foreign = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.mesh.nodes.foreign);
  const auto isOwn = [&](int n) { return foreign.extent(0) == 0 || foreign(n) == 0; };
  std::vector<int> nodes;
  std::vector<double> jumps, stiffnesses, cohesions;
  for (int n = 0; n < state.mesh.nodes.numLattice && !archive.loads(); ++n)
    if (step > 0 && last(n) == step && isOwn(n))
    {
      names.append(n, nodes);
      for (int d = 0; d < D; ++d)
        jumps.push_back(jump(n, d));
      stiffnesses.push_back(stiffness(n));
      for (int k = 0; grows_ && k < D + 4; ++k)
        cohesions.push_back(cohesion(n, k));
    }
  archive.together("nodes", nodes, D);
  archive.together("jumps", jumps, D);
  archive.together("stiffnesses", stiffnesses);
  if (grows_)
    archive.together("cohesions", cohesions, D + 4);
  if (!archive.loads())
    return;
  for (std::size_t k = 0; k < std::min(nodes.size(), jumps.size()); k += D)
  {
    const int n = names.find(nodes, k);
    if (n < 0 && state.ranks.many())
      continue; // another rank's
    if (n < 0)
      throw std::invalid_argument("\"nodes\" of ties names a node that is not there");
    last(n) = step;
    for (int d = 0; d < D; ++d)
      jump(n, d) = jumps[k + d];
    stiffness(n) = k / D < stiffnesses.size() ? stiffnesses[k / D] : 0.0;
    for (std::size_t i = 0; grows_ && i < D + 4 && (k / D + 1) * (D + 4) <= cohesions.size(); ++i)
      cohesion(n, i) = cohesions[k / D * (D + 4) + i];
  }
  Kokkos::deep_copy(stiffness_, stiffness);
  Kokkos::deep_copy(cohesion_, cohesion);
  Kokkos::deep_copy(jump_, jump);
  Kokkos::deep_copy(step_, last);
}

template class TieMemory<2>;
template class TieMemory<3>;

} // namespace Rhegma::cracks
