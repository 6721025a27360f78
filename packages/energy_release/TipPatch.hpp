#pragma once
/// Particles around a front with the sides on which they lie, and the displacement of nodes recovered from
/// them.

#include "state/State.hpp"

#include <map>
#include <utility>
#include <vector>

namespace Rhegma::energy_release
{

/// A particle near a front and the unbroken shape functions of the nodes around it.
struct PatchParticle
{
  static constexpr int capacity = 9;
  Vector<2> place;
  Vector<2> displacement;
  double mass;
  double force[2][2]; ///< -V0 tau; times the slope of a node's function: the force on the node [N m]
  int side;           ///< -1 or +1
  int count;
  int node[capacity];
  double weight[capacity];
  Vector<2> slope[capacity];
};

/// Particles within `radius` of a front, on the host.
std::vector<PatchParticle> particlesAround(const State<2>& state, const CrackFront<2>& front, double radius);

/// Whether a lattice node lies behind a front, so that each side of the crack has its own value there.
class SplitNodes
{
public:
  SplitNodes(const State<2>& state, const CrackFront<2>& front);
  bool operator()(int node) const;

private:
  View<int*>::HostMirror side_;
  Grid<2> grid_;
  CrackFront<2> front_;
};

/// Displacement of nodes: of a node behind the front one for each side (-1, +1), of all others one (side 0).
using NodeDisplacement = std::map<std::pair<int, int>, Vector<2>>;

enum class Projection
{
  Consistent, ///< M u = sum_p m_p N_p u_p, M_ij = sum_p m_p N_i N_j: exact for linear displacement
  Lumped ///< the same with row sums of M: smears a crack's opening, which does not improve with the cells
};

/// Least-squares nodal displacement of the particles. Throws std::runtime_error where M can't be factored.
NodeDisplacement recoverDisplacement(const std::vector<PatchParticle>& particles, const SplitNodes& split,
                                     Projection projection);

} // namespace Rhegma::energy_release
