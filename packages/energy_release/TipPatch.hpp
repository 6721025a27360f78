#pragma once
/// Particles around a front with the sides on which they lie, and the displacement of nodes recovered from
/// them.

#include "energy_release/WholeNodes.hpp"
#include "state/State.hpp"

#include <map>
#include <set>
#include <utility>
#include <vector>

namespace Rhegma::energy_release
{

/// A particle near a front and the unbroken shape functions of the nodes around it.
struct PatchParticle
{
  static constexpr int capacity = stencilCapacity<2>;
  Vector<2> place;
  Vector<2> displacement;
  double mass;
  double density;
  double fromFront;   ///< distance from the nearest front of all [m]
  double force[2][2]; ///< -V0 tau; times the slope of a node's function: the force on the node [N m]
  int side;           ///< -1 or +1
  int count;
  int node[capacity];
  double weight[capacity];
  Vector<2> slope[capacity];
};

/// Particles within `radius` of a front, on the host: on every rank those of all. Their nodes have the
/// numbers of the whole lattice. Collective.
std::vector<PatchParticle> particlesAround(const State<2>& state, const CrackFront<2>& front, double radius);

/// Whether a node of the whole lattice lies behind a front, so that each side of the crack has its own value
/// there.
class SplitNodes
{
public:
  /// Collective. \param radius around the front of the nodes that will be asked for [m]
  SplitNodes(const State<2>& state, const CrackFront<2>& front, double radius);
  bool operator()(int node) const;

private:
  View<int*>::HostMirror side_;
  std::set<int> split_; ///< where there are several ranks
  bool many_;
  WholeNodes places_;
  CrackFront<2> front_;
};

/// This rank's own nodes within `radius` of a place along each axis, where there are several ranks.
std::vector<int> ownNodesAround(const State<2>& state, const Vector<2>& centre, double radius);

/// Displacement of nodes: of a node behind the front one for each side (-1, +1), of all others one (side 0).
using NodeDisplacement = std::map<std::pair<int, int>, Vector<2>>;

/// The mass matrix that displacement is recovered with, as in the effect Mass Matrix:
///
///     M = sum_p m_p [(1 - theta_p) diag(N_p) + theta_p N_p N_p^T],    M_eps = (1 - eps) M + eps diag(M 1)
///
/// \sa consistentMatrix, lumpedMatrix
struct RecoveryMatrix
{
  double lumpedShare;  ///< eps; with 1 the displacement is that of row sums
  double smallestNode; ///< theta is 0 for a particle that touches a lighter node, in shares of a full cell
  double radius;       ///< theta is 1 up to this distance from a front [m]
  double edge;         ///< and falls to 0 over this width beyond it [m]
  int terms;           ///< of the series about the row sums that stands for the inverse; 0: solved
  double radiusCells = 0.0; ///< of the radius beside what is in m, in cells as they are at the front
  double edgeCells = 0.0;   ///< of the edge
};

/// theta = 1. A node that a particle barely touches is found by extrapolation; the thousandth of row sums
/// bounds how far noise is blown up there, and moves well-covered nodes by as much of what lumping would.
RecoveryMatrix consistentMatrix();

/// Row sums: smears a crack's opening over a cell, which smaller cells do not mend.
RecoveryMatrix lumpedMatrix();

/// Least-squares nodal displacement of the particles, M_eps u = sum_p m_p N_p u_p.
/// \param fullCell volume of a cell [m3]. Throws std::runtime_error where M_eps can't be factored.
NodeDisplacement recoverDisplacement(const std::vector<PatchParticle>& particles, const SplitNodes& split,
                                     const RecoveryMatrix& choice, double fullCell);

} // namespace Rhegma::energy_release
