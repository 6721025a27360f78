#pragma once
/// What the material's own stress does to the nodes around a front.

#include "state/State.hpp"

namespace Rhegma::energy_release
{

/// Acceleration [m/s2] of nodes by internal forces alone, -sum_p V0 tau grad N / m, from the particles within
/// `radius` of a place; a row a node, second fields included. Without loads it is the nodes' acceleration.
/// Where loads act, such as pressure on crack faces, contact, body force or damping, it is less by what they
/// do: used as `a` in the domain integrals it takes their work into account, whoever applies them.
View<double* [2]> internalAcceleration(const State<2>& state, const Vector<2>& centre, double radius);

/// The same in rows that are used again and again; they grow where they must.
void internalAcceleration(const State<2>& state, const Vector<2>& centre, double radius,
                          View<double* [2]>& acceleration);

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
void internalAcceleration(const State<3>& state, const Region<3>& box, View<double* [3]>& acceleration);

} // namespace Rhegma::energy_release
