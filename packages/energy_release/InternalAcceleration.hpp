#pragma once
/// What the material's own stress does to the nodes around a front.

#include "state/State.hpp"

namespace Rhegma::energy_release
{

/// Of each node, second fields included: acceleration [m/s2], then the mass that it is of [kg].
template <int D>
using NodalAcceleration = View<double * [D + 1]>;

/// Acceleration [m/s2] of nodes by internal forces alone, -sum_p V0 tau grad N / m, from the particles within
/// `radius` of a position; a row a node, second fields included. Without loads it is the nodes' acceleration.
/// Where loads act, such as pressure on crack faces, contact, body force or damping, it is less by what they
/// do: used as `a` in the domain integrals it takes their work into account, whoever applies them. The mass m
/// is that where the particles are now, as N is: a node that a box just reaches has a mass of the square of
/// that length and a force of its first power, so that with the mass of the step's start a box that has moved
/// by a thousandth of a cell would give it any acceleration.
NodalAcceleration<2> internalAcceleration(const State<2>& state, const Vector<2>& centre, double radius);

/// The same in rows that are used again and again; they grow where they must.
void internalAcceleration(const State<2>& state, const Vector<2>& centre, double radius,
                          NodalAcceleration<2>& acceleration);

/// A box with its faces along the axes.
template <int D>
struct Region
{
  Vector<D> lower, upper;

  KOKKOS_INLINE_FUNCTION bool holds(const Vector<D>& x) const
  {
    bool in = true;
    for (int d = 0; d < D; ++d)
      in = in && x[d] >= lower[d] && x[d] <= upper[d];
    return in;
  }
};

/// The same in 3D, from the particles in a box.
void internalAcceleration(const State<3>& state, const Region<3>& box, NodalAcceleration<3>& acceleration);

} // namespace Rhegma::energy_release
