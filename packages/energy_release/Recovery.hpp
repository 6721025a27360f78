#pragma once
/// The displacement of nodes around a front, recovered from its particles.

#include "energy_release/ParticlesAroundTip.hpp"
#include "energy_release/SplitNodes.hpp"

#include <map>
#include <utility>
#include <vector>

namespace Rhegma::energy_release
{

/// Displacement of nodes: of a node behind the front one for each side (-1, +1), of all others one (side 0).
using NodeDisplacement = std::map<std::pair<int, int>, Vector<2>>;

/// The mass matrix that displacement is recovered with, as in the effect Mass Matrix:
///
///     M = sum_p m_p [(1 - theta_p) diag(N_p) + theta_p N_p N_p^T],    M_eps = (1 - eps) M + eps diag(M 1)
///
/// \sa consistentMatrix, lumpedMatrix
struct RecoveryMatrix
{
  double lumpedFraction; ///< eps; with 1 the displacement is that of row sums
  double smallestNode; ///< theta is 0 for a particle that touches a lighter node, in fractions of a full cell
  double radius;       ///< theta is 1 up to this distance from a front [m]
  double edge;         ///< and falls to 0 over this width beyond it [m]
  int terms;           ///< of the series about the row sums that stands for the inverse; 0: solved
  double radiusCells = 0.0; ///< of the radius in addition to that in m, in cells as they are at the front
  double edgeCells = 0.0;   ///< of the edge
};

/// theta = 1. A node that a particle barely touches is found by extrapolation; the thousandth of row sums
/// bounds how far noise is blown up there, and changes well-covered nodes by a thousandth of the effect of
/// lumping.
RecoveryMatrix consistentMatrix();

/// Row sums: smooths the opening of a crack over a cell, also with smaller cells.
RecoveryMatrix lumpedMatrix();

/// Least-squares nodal displacement of the particles, M_eps u = sum_p m_p N_p u_p.
/// \param fullCell volume of a cell [m3]. Throws std::runtime_error where M_eps can't be factored.
NodeDisplacement recoverDisplacement(const std::vector<ParticleAroundTip>& particles, const SplitNodes& split,
                                     const RecoveryMatrix& choice, double fullCell);

} // namespace Rhegma::energy_release
