#include "archive/Archive.hpp"
#include "state/NodeNames.hpp"
#include "state/Subdomain.hpp"
#include "sub_cycling/FineParticles.hpp"

#include <algorithm>

namespace Rhegma::sub_cycling
{

namespace
{

/// Values of nodes by names, which any rank can find its nodes by.
template <int D>
struct NamedMeans
{
  std::vector<int> nodes;     ///< D numbers each
  std::vector<int> second;    ///< 1 for a second field
  std::vector<double> values; ///< D each [N]
};

/// The means of the last step, of nodes that are no other rank's. \param rows numbers of nodes
template <int D, class Mean>
NamedMeans<D> nameMeans(const Mean& mean, const NodeNames<D>& names, const View<char*>& ofOthers, int rows,
                        int last)
{
  NamedMeans<D> named;
  const auto value = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, mean.value);
  const auto renewed = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, mean.renewed);
  const auto foreign = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, ofOthers);
  for (int row = 0; row < 2 * rows; ++row)
    if (renewed(row) == last && (foreign.extent(0) == 0 || foreign(row % rows) == 0))
    {
      names.append(row % rows, named.nodes);
      named.second.push_back(row / rows);
      for (int d = 0; d < D; ++d)
        named.values.push_back(value(row, d));
    }
  return named;
}

std::vector<int> gatherOnAll(const Ranks& ranks, const std::vector<int>& own)
{
  const std::vector<double> all = ranks.gatherOnAll(std::vector<double>(own.begin(), own.end()));
  return std::vector<int>(all.begin(), all.end());
}

} // namespace

template <int D>
void FineParticles<D>::keep(const State<D>& state, Archive& archive)
{
  if (archive.loads())
    rememberNodes(state);
  else
    followNodes(state);
  for (int kind = 0; kind <= deepestLevel; ++kind)
  {
    const Archive::Group group(archive, "mean " + std::to_string(kind));
    keepMean(state, means_[kind], archive);
  }
}

/// Only values of the last step and of the cells as they are count.
template <int D>
void FineParticles<D>::keepMean(const State<D>& state, Mean& mean, Archive& archive)
{
  NamedMeans<D> named;
  if (!archive.loads() && mean.generation == state.mesh.tree.generation)
    named = nameMeans<D>(mean, NodeNames<D>(state), state.mesh.nodes.foreign, state.mesh.nodes.numLattice,
                         static_cast<int>(state.clock.step) - 1);
  archive.together("nodes", named.nodes, D);
  archive.together("second field", named.second);
  archive.together("value", named.values, D);
  if (!archive.loads())
    return;
  mean.generation = -1;
  if (!named.second.empty())
    placeMean(state, mean, named.nodes, named.second, named.values);
}

template <int D>
void FineParticles<D>::placeMean(const State<D>& state, Mean& mean, const std::vector<int>& nodes,
                                 const std::vector<int>& second, const std::vector<double>& values)
{
  const NodeNames<D> names(state);
  const int rows = state.mesh.nodes.numLattice;
  fit(mean.value, "rhegma::subcycling::meanForce", 2 * rows);
  fit(mean.renewed, "rhegma::subcycling::meanRenewed", 2 * rows);
  mean.generation = state.mesh.tree.generation;
  const auto value = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, mean.value);
  const auto renewed = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, mean.renewed);
  Kokkos::deep_copy(renewed, -2);
  for (std::size_t k = 0; k < second.size(); ++k)
  {
    const int node = names.find(nodes, D * k);
    if (node < 0 && state.ranks.many())
      continue; // another rank's
    if (node < 0)
      throw std::invalid_argument("\"nodes\" of mean forces names a node that is not there");
    const int row = node + second[k] * rows;
    renewed(row) = static_cast<int>(state.clock.step) - 1;
    for (int d = 0; d < D; ++d)
      value(row, d) = values[D * k + d];
  }
  Kokkos::deep_copy(mean.value, value);
  Kokkos::deep_copy(mean.renewed, renewed);
}

template <int D>
void FineParticles<D>::followNodes(const State<D>& state)
{
  if (!state.mesh.subdomain || state.mesh.subdomain == subdomain_)
    return;
  // Where cells change means begin anew, on one rank too.
  if (subdomain_ && subdomain_->refined == state.mesh.subdomain->refined)
  {
    const Grid<D> window = subdomain_->division.window(state.ranks.rank());
    const NodeNames<D> names(window, finePlace_);
    for (Mean& mean : means_)
    {
      if (mean.generation != nodesGeneration_)
        continue;
      const NamedMeans<D> own = nameMeans<D>(mean, names, subdomain_->halo.foreign(), names.size(),
                                             static_cast<int>(state.clock.step) - 1);
      placeMean(state, mean, gatherOnAll(state.ranks, own.nodes), gatherOnAll(state.ranks, own.second),
                state.ranks.gatherOnAll(own.values));
    }
  }
  rememberNodes(state);
}

template <int D>
void FineParticles<D>::rememberNodes(const State<D>& state)
{
  subdomain_ = state.mesh.subdomain;
  if (!subdomain_)
    return;
  nodesGeneration_ = state.mesh.tree.generation;
  finePlace_ = View<double* [D]>("rhegma::subcycling::finePlace", state.mesh.tree.numFine);
  if (state.mesh.tree.numFine > 0)
    Kokkos::deep_copy(finePlace_, Kokkos::subview(state.mesh.tree.finePlace,
                                                  std::make_pair(0, state.mesh.tree.numFine), Kokkos::ALL));
}

template void FineParticles<2>::keep(const State<2>&, Archive&);
template void FineParticles<3>::keep(const State<3>&, Archive&);
template void FineParticles<2>::followNodes(const State<2>&);
template void FineParticles<3>::followNodes(const State<3>&);

} // namespace Rhegma::sub_cycling
