#include "archive/Archive.hpp"
#include "mass_matrix/NodalSolve.hpp"
#include "state/NodeNames.hpp"

namespace Rhegma::mass_matrix
{

template <int D>
void NodalSolve<D>::keep(const State<D>& state, Archive& archive)
{
  archive("solves", count_.solves);
  archive("iterations", count_.iterations);
  archive("most_iterations", count_.mostIterations);
  archive("worst_residual", count_.worstResidual);
  if (!archive.loads() || !archive.sameOrder())
    keepByName(state, archive);
  if (!archive.sameOrder())
    return;
  archive("generation", generation_);
  archive("last_velocity", lastVelocity_);
  archive("last_acceleration", lastAcceleration_);
}

/// Where the next solves start, by the names of the nodes: for another order of them.
template <int D>
void NodalSolve<D>::keepByName(const State<D>& state, Archive& archive)
{
  const Archive::Group group(archive, "guesses");
  if (archive.loads())
    reserveGuesses(state);
  const NodeNames<D> names(state);
  const auto host = [](const auto& view)
  { return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, view); };
  const auto velocity = host(lastVelocity_), acceleration = host(lastAcceleration_);
  const auto foreign = host(state.mesh.nodes.foreign);
  const int count = state.mesh.nodes.numLattice;
  const int fields = static_cast<int>(velocity.extent(0)) >= 2 * count ? 2 : 1;
  for (int f = 0; f < 2; ++f)
  {
    std::vector<int> nodes;
    std::vector<double> values;
    for (int n = 0; n < count && f < fields && velocity.extent(0) > 0 && !archive.loads(); ++n)
    {
      const int m = n + f * count;
      bool any = false;
      for (int d = 0; d < D; ++d)
        any = any || velocity(m, d) != 0.0 || acceleration(m, d) != 0.0;
      if (!any || (foreign.extent(0) > 0 && foreign(n) != 0))
        continue;
      names.append(n, nodes);
      for (int d = 0; d < D; ++d)
        values.insert(values.end(), {velocity(m, d), acceleration(m, d)});
    }
    archive.together("nodes " + std::to_string(f), nodes, D);
    archive.together("values " + std::to_string(f), values, 2 * D);
    for (std::size_t k = 0; archive.loads() && f < fields && D * k < nodes.size(); ++k)
      if (const int n = names.find(nodes, D * k); n >= 0 && (k + 1) * 2 * D <= values.size())
        for (int d = 0; d < D; ++d)
        {
          velocity(n + f * count, d) = values[2 * (D * k + d)];
          acceleration(n + f * count, d) = values[2 * (D * k + d) + 1];
        }
  }
  if (!archive.loads())
    return;
  Kokkos::deep_copy(lastVelocity_, velocity);
  Kokkos::deep_copy(lastAcceleration_, acceleration);
  generation_ = state.mesh.tree.generation;
}

template void NodalSolve<2>::keep(const State<2>&, Archive&);
template void NodalSolve<3>::keep(const State<3>&, Archive&);

} // namespace Rhegma::mass_matrix
