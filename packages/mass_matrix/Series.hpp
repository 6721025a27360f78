#pragma once
/// The inverse of the mass matrix as the first terms of a series (FMPM, XPIC).

#include "mass_matrix/MassSystem.hpp"

namespace Rhegma::mass_matrix
{

/// M_k^-1 b = sum over i < k of (I - L^-1 M)^i L^-1 b, L the lumped mass: order 1 is the lumped division, and
/// the sum tends to M^-1 b. As the rows of M - L add up to zero, L M_k^-1 b has the sum of b at every order.
/// Source: Nairn and Hammerquist, CMAME 374 (2021) 113564; the same sum filters velocities in XPIC
/// (Hammerquist and Nairn, CMAME 318 (2017) 724).
template <int D>
class Series
{
public:
  explicit Series(int order) : order_(order) {}

  void begin(const MassSystem<D>& system);

  /// Replaces velocity and acceleration of the nodes by M_k^-1 of momentum and force.
  void motion(State<D>& state, const MassSystem<D>& system);

  /// Replaces the velocity after the step, and only it: M_k^-1 of the momentum plus dt times the acceleration
  /// that is there (XPIC), or M_k^-1 of momentum and impulse together (FMPM).
  void updateVelocity(State<D>& state, const MassSystem<D>& system, bool withImpulse);

  /// Replaces the velocity that strains the particles, which arrives as one of the lumped mass.
  void projection(State<D>& state, const MassSystem<D>& system);

  /// Part of the above: sums the terms into sum_, from the first in term_. Public because compilers for
  /// devices want kernels in public functions.
  void sum(const State<D>& state, const MassSystem<D>& system);

private:
  int order_;
  View<double*> term_, image_, sum_;
};

} // namespace Rhegma::mass_matrix
