#pragma once
/// The inverse of the mass matrix as the first terms of a series (FMPM, XPIC).

#include "state/State.hpp"

namespace Rhegma::mass_matrix
{

/// M_k^-1 b = sum over i < k of (I - L^-1 M)^i L^-1 b, L the lumped mass: order 1 is the lumped division, and
/// the sum tends to M^-1 b. No matrix is made: M x is gathered to the particles and scattered from them. As
/// their weights add up to one, L M_k^-1 b has the sum of b at every order.
/// Source: Nairn and Hammerquist, CMAME 374 (2021) 113564; the same sum filters velocities in XPIC
/// (Hammerquist and Nairn, CMAME 318 (2017) 724).
template <int D>
class Series
{
public:
  explicit Series(int order) : order_(order) {}

  /// Replaces velocity and acceleration of the nodes, which arrive as those of the lumped mass.
  void motion(State<D>& state);

  /// Replaces the velocity after the step, and only it: M_k^-1 of the momentum plus dt times the acceleration
  /// (XPIC), or M_k^-1 of momentum and impulse together (FMPM).
  void updateVelocity(State<D>& state, bool withImpulse);

  /// Replaces the velocity that strains the particles, which arrives as one of the lumped mass.
  void projection(State<D>& state);

private:
  using MotionRows = View<double * [Nodes<D>::motionWidth]>;
  using VelocityRows = View<double * [Nodes<D>::projectionWidth]>;

  int order_;
  MotionRows motionTerm_, motionImage_;
  VelocityRows term_, image_, filtered_;
};

} // namespace Rhegma::mass_matrix
