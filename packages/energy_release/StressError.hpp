#pragma once
/// Strain energy of the error of the particles' stress, by a recovered stress.

#include "state/State.hpp"

#include <vector>

namespace Rhegma::energy_release
{

/// A front node as the error of the stress is seen from it.
template <int D>
struct ErrorSight
{
  Vector<D> position; ///< [m]
  double leftOut;     ///< up to this distance errors do not count [m]
  double reach;       ///< up to this distance they count fully [m]
};

/// Strain energy of the difference of two stresses, weighted by the distance r from the nodes of fronts [J]:
///
///     E = sum_p w_p V0 / 2 (s* - s) : C^-1 : (s* - s),    s*(x_p) = sum_n N_n(x_p) s*_n
///
/// s is the stress of a particle, s*_n the value at node n of the linear function that fits the stresses of
/// the particles around the node best, with the weights V0 N_n: a superconvergent patch recovery whose
/// sampling points are the particles. The fit of a stress that is linear in space has no error, nor has it
/// next to a surface; nodes behind a front have a fit for each side of the crack. C is that of small
/// strain. If s* converges faster than s, E converges to the energy of the error of the displacements.
/// Source: Zienkiewicz and Zhu, Int. J. Numer. Meth. Eng. 33 (1992) 1331 and 1365, theorem 1.
///
/// w_p is the largest of min(1, (reach / r)^D) of all front nodes, and 0 where r < leftOut of any.
///
/// Needs nodes with values (haveNodalValues). Costs two transfers. Collective.
template <int D>
double energyOfStressError(const State<D>& state, const std::vector<ErrorSight<D>>& sights);

} // namespace Rhegma::energy_release
