#pragma once
/// The motion of nodes in the integrals around a front.

#include "state/State.hpp"

namespace Rhegma::energy_release
{

/// The velocity of nodes that strains the particles [m/s]. With MUSL and USF that is a mean of the particles'
/// own. The velocity that the solve gives a node that a box just reaches, with a mass proportional to the
/// square of the overlap and a force proportional to the overlap, is arbitrary, and so is its slope in a box
/// that has moved since. Zero in equilibrium, where nodes have the displacement of a step as a velocity until
/// particles have it.
template <int D>
struct NodalVelocity
{
  View<double * [Nodes<D>::motionWidth]> motion;
  View<double * [Nodes<D>::projectionWidth]> projection;
  bool byMotion = true, atRest = false;

  NodalVelocity() = default;
  explicit NodalVelocity(const State<D>& state)
      : motion(state.mesh.nodes.motion),
        projection(state.mesh.nodes.projection),
        byMotion(state.method.scheme == UpdateScheme::Usl),
        atRest(state.method.equilibrium())
  {
  }

  KOKKOS_INLINE_FUNCTION double operator()(int node, int axis) const
  {
    return atRest ? 0.0 : byMotion ? motion(node, axis) : projection(node, axis);
  }
};

/// With USL, the velocity and acceleration of a node that boxes reach by round-off only are arbitrary: a node
/// with less mass than this [kg] is left out, which changes a sum by less than 1e-10 of what neighbours
/// contribute. 0 with other schemes.
template <int D>
double lightestNode(const State<D>& state)
{
  constexpr double leastFraction = 1e-20; // of a full cell
  if (state.method.scheme != UpdateScheme::Usl)
    return 0.0;
  double mass = D == 2 ? state.method.thickness : 1.0;
  for (int d = 0; d < D; ++d)
    mass *= state.mesh.grid.spacing;
  double density = 0.0;
  for (const Properties& material : state.materials.properties)
    density = material.density > density ? material.density : density;
  return leastFraction * density * mass;
}

} // namespace Rhegma::energy_release
