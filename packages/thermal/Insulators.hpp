#pragma once
/// Particles that conduct nothing and share nodes with some that do (MeetingMaterials.hpp).

#include "thermal/HeatNodes.hpp"
#include "thermal/ParticleFlux.hpp"

namespace Rhegma::thermal
{

/// Whether a particle touches nodes with conductors.
template <int D, class Connect>
KOKKOS_INLINE_FUNCTION bool isNextToConductor(const Connect& connect, const HeatNodes<D>& nodes, int p)
{
  bool any = false;
  connect.visit(p, [&](int node, double weight, const double*)
                { any = any || (HeatNodes<D>::touches(weight) && nodes.conductsAt(node)); });
  return any;
}

/// Whether a particle is an insulator next to a conductor of another material: it has no flux and no
/// gradient, as the temperature of its nodes is that of the conductor.
template <int D, class Connect>
KOKKOS_INLINE_FUNCTION bool isLeftOut(const Connect& connect, const HeatNodes<D>& nodes,
                                      const ParticleFlux<D>& conducts, int p)
{
  return nodes.meets.extent(0) > 0 && !(conducts.conductivity(p) > 0.0) &&
         isNextToConductor(connect, nodes, p);
}

} // namespace Rhegma::thermal
