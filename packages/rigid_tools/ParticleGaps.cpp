/// Gaps between particles and a tool.

#include "rigid_tools/Separation.hpp"
#include "rigid_tools/ToolContacts.hpp"
#include "transfer/LocalSpacing.hpp"
#include "transfer/ParticleDomains.hpp"
#include "transfer/PressedNodes.hpp"

namespace Rhegma::rigid_tools
{

namespace
{

/// Step of the differences for normals [cells].
constexpr double normalStep = 1e-3;

/// Domains of listed particles.
template <int D>
struct PackedDomains
{
  View<double* [D]> centre;  ///< [m]
  View<double* [D][D]> edge; ///< edge vectors [m]
  View<int*> body;           ///< its number
};

template <int D>
PackedDomains<D> packDomains(const State<D>& state, const CellsNearTool<D>& near)
{
  const PackedDomains<D> packed{View<double* [D]>("rhegma::domainCentres", near.count),
                                View<double* [D][D]>("rhegma::domainEdges", near.count),
                                View<int*>("rhegma::domainBodies", near.count)};
  const ParticleDomains<D> domains = particleDomains(state);
  const auto position = state.particles.template real<D>(fields::position);
  const auto body = state.particles.integer(fields::body);
  const View<int*> particle = near.particle;
  Kokkos::parallel_for(
      "rhegma::packDomainsNearTool", Kokkos::RangePolicy<ExecSpace>(0, near.count),
      KOKKOS_LAMBDA(const int k) {
        const int p = particle(k);
        Vector<D> edges[D];
        domains.edgesOf(p, edges);
        for (int d = 0; d < D; ++d)
        {
          packed.centre(k, d) = position(p, d);
          for (int e = 0; e < D; ++e)
            packed.edge(k, e, d) = edges[e][d];
        }
        packed.body(k) = body(p);
      });
  return packed;
}

template <int D>
void reserve(ParticleGaps<D>& gaps, int count)
{
  if (static_cast<int>(gaps.gap.extent(0)) >= count)
    return;
  const int rows = 2 * count;
  gaps.particle = View<int*>("rhegma::particlesAtTool", rows);
  gaps.gap = View<double*>("rhegma::gapsToTool", rows);
  gaps.normal = View<double* [D]>("rhegma::normalsOfTool", rows);
  gaps.foot = View<double* [D]>("rhegma::feetOnTool", rows);
  gaps.spacing = View<double*>("rhegma::spacingAtTool", rows);
}

/// Separations of listed domains from a tool, on the host, because shapes are lists of parts and trees of
/// triangles.
template <int D>
struct HostGaps
{
  std::vector<Separation<D>> of; ///< of each domain
  std::vector<double> spacing;   ///< edge of the cells there [m]; below 0: too far from the tool
};

template <int D>
HostGaps<D> measureOnHost(const State<D>& state, const Tool<D>& tool, const std::vector<char>& touches,
                          const CellsNearTool<D>& near)
{
  const PackedDomains<D> packed = packDomains(state, near);
  const auto centre = onHost(packed.centre);
  const auto edge = onHost(packed.edge);
  const auto body = onHost(packed.body);
  const double coarse = state.mesh.grid.spacing;
  const bool refined = state.mesh.tree.refined();
  const ToolSurface<D> surface{tool.shape(), tool.placement(), normalStep * state.mesh.smallestSpacing()};
  HostGaps<D> gaps{std::vector<Separation<D>>(near.count), std::vector<double>(near.count, -1.0)};
  const auto measure = [&](const int k)
  {
    if (touches[body(k)] == 0)
      return;
    Vector<D> x, edges[D];
    double reach = 0.0;
    for (int e = 0; e < D; ++e)
    {
      x[e] = centre(k, e);
      for (int d = 0; d < D; ++d)
        edges[e][d] = edge(k, e, d);
      reach += 0.5 * norm(edges[e]);
    }
    if (surface.depth(x) < -(reach + 0.5 * coarse))
      return;
    const double cell = refined ? spacingAt(state, x) : coarse;
    gaps.of[k] = separate(surface, x, edges);
    if (gaps.of[k].gap < 0.5 * cell)
      gaps.spacing[k] = cell;
  };
  Kokkos::parallel_for("rhegma::measureGapsToTool",
                       Kokkos::RangePolicy<Kokkos::DefaultHostExecutionSpace>(0, near.count), measure);
  return gaps;
}

} // namespace

template <int D>
void measureGaps(const State<D>& state, const Tool<D>& tool, const std::vector<char>& touches,
                 const CellsNearTool<D>& near, ParticleGaps<D>& gaps)
{
  gaps.count = gaps.touching = 0;
  if (near.count == 0)
    return;
  const HostGaps<D> found = measureOnHost(state, tool, touches, near);
  const auto particle = onHost(near.particle);
  reserve(gaps, near.count);
  const auto hostParticle = Kokkos::create_mirror_view(gaps.particle);
  const auto gap = Kokkos::create_mirror_view(gaps.gap), cell = Kokkos::create_mirror_view(gaps.spacing);
  const auto normal = Kokkos::create_mirror_view(gaps.normal), foot = Kokkos::create_mirror_view(gaps.foot);
  for (int k = 0; k < near.count; ++k)
  {
    if (found.spacing[k] < 0.0)
      continue;
    const Separation<D>& one = found.of[k];
    const int at = gaps.count++;
    gaps.touching += one.gap <= stillClosed * found.spacing[k] ? 1 : 0;
    hostParticle(at) = particle(k);
    gap(at) = one.gap;
    cell(at) = found.spacing[k];
    for (int d = 0; d < D; ++d)
    {
      normal(at, d) = one.normal[d];
      foot(at, d) = one.foot[d];
    }
  }
  Kokkos::deep_copy(gaps.particle, hostParticle);
  Kokkos::deep_copy(gaps.gap, gap);
  Kokkos::deep_copy(gaps.spacing, cell);
  Kokkos::deep_copy(gaps.normal, normal);
  Kokkos::deep_copy(gaps.foot, foot);
}

template void measureGaps(const State<2>&, const Tool<2>&, const std::vector<char>&, const CellsNearTool<2>&,
                          ParticleGaps<2>&);
template void measureGaps(const State<3>&, const Tool<3>&, const std::vector<char>&, const CellsNearTool<3>&,
                          ParticleGaps<3>&);

} // namespace Rhegma::rigid_tools
