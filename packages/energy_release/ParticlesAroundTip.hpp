#pragma once
/// Particles around a front, with the sides on which they lie.

#include "state/State.hpp"

#include <vector>

namespace Rhegma::energy_release
{

/// A particle near a front and the unbroken shape functions of the nodes around it.
struct ParticleAroundTip
{
  static constexpr int capacity = stencilCapacity<2>;
  Vector<2> position;
  Vector<2> displacement;
  double mass;
  double density;
  double fromFront;   ///< distance from the nearest front of all [m]
  double force[2][2]; ///< -V0 tau; times the slope of a node's function: the force on the node [N m]
  int side;           ///< -1 or +1
  int count;
  int node[capacity];
  double weight[capacity];
  double slope[capacity][2][2]; ///< of component d of a displacement along axis e [1/m]
};

/// Particles within `radius` of a front, on the host: on every rank those of all. Their nodes have the
/// numbers of the whole lattice. Collective.
std::vector<ParticleAroundTip> particlesAround(const State<2>& state, const CrackFront<2>& front,
                                               double radius);

} // namespace Rhegma::energy_release
