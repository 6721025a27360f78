#include "checkpoint/Archive.hpp"
#include "checkpoint/NodeNames.hpp"
#include "sub_cycling/FineParticles.hpp"

#include <algorithm>

namespace Rhegma::sub_cycling
{

template <int D>
void FineParticles<D>::keep(const State<D>& state, Archive& archive)
{
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
  const int rows = state.nodes.numLattice, last = static_cast<int>(state.step) - 1;
  const NodeNames<D> names(state);
  std::vector<int> nodes, second;
  std::vector<double> values;
  if (!archive.loads() && mean.generation == state.tree.generation)
  {
    const auto value = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, mean.value);
    const auto renewed = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, mean.renewed);
    const auto foreign = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.nodes.foreign);
    for (int row = 0; row < 2 * rows; ++row)
      if (renewed(row) == last && (foreign.extent(0) == 0 || foreign(row % rows) == 0))
      {
        names.append(row % rows, nodes);
        second.push_back(row / rows);
        for (int d = 0; d < D; ++d)
          values.push_back(value(row, d));
      }
  }
  archive.together("nodes", nodes, D);
  archive.together("second field", second);
  archive.together("value", values, D);
  if (!archive.loads() || second.empty())
    return;
  fit(mean.value, "rhegma::subcycling::meanForce", 2 * rows);
  fit(mean.renewed, "rhegma::subcycling::meanRenewed", 2 * rows);
  mean.generation = state.tree.generation;
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
    renewed(row) = last;
    for (int d = 0; d < D; ++d)
      value(row, d) = values[D * k + d];
  }
  Kokkos::deep_copy(mean.value, value);
  Kokkos::deep_copy(mean.renewed, renewed);
}

template void FineParticles<2>::keep(const State<2>&, Archive&);
template void FineParticles<3>::keep(const State<3>&, Archive&);

} // namespace Rhegma::sub_cycling
