#pragma once
/// The force with which new crack faces resist being opened.

#include "state/Types.hpp"

namespace Rhegma::cracks
{

/// The cohesive law of a node that a front has passed.
///
/// At the step in which it gets two fields they are held together by the force T that both need to have one
/// acceleration. From there the force falls linearly to zero as the fields move apart by w; unloading goes
/// straight back. So opening the node takes T w / 2. All nodes that a front passes at once have one w,
///
///     w = 2 E / sum |T|,
///
/// T being a twentieth less than what would hold the fields: a node that is held exactly is in an
/// equilibrium, if an unstable one, which only noise would end. E is the energy of the new face, so that
/// together they take E and share it by their forces (two rows of nodes beside a crack that runs between
/// them). A force that pushes the faces apart across the crack is no cohesion and is left out.
///
/// So that the force can turn with the opening u and has a finite stiffness k at first, u is counted from
/// -T / k: with s = |u + T / k| the force is F(r) / r (u + T / k), r the largest s so far, F(r) falling from
/// |T| at |T| / k to 0 at |T| / k + w.
///
/// A row: the numbers below; then T / k, as many as axes.
namespace cohesion
{
constexpr double strengthAtFirst = 0.95; ///< share of the holding force

constexpr double repayment = 0.25; ///< most of the energy of new faces that goes to softened ties

constexpr int peak = 0;  ///< |T| [N]; 0: no cohesion; -1 - f: the node waits for its force, front f passed it
constexpr int range = 1; ///< w [m]
constexpr int start = 2; ///< |T| / k [m]
constexpr int reached = 3; ///< r [m]
constexpr int shift = 4;   ///< the first component of T / k [m]

/// F(r) / r of a node [N/m] at an r that is not its own.
template <class Rows>
KOKKOS_INLINE_FUNCTION double secantAt(const Rows& rows, int n, double r)
{
  const double left = 1.0 - (r - rows(n, start)) / rows(n, range);
  return left > 0.0 ? rows(n, peak) * left / r : 0.0;
}

/// F(r) of a node [N].
template <class Rows>
KOKKOS_INLINE_FUNCTION double strength(const Rows& rows, int n)
{
  return secantAt(rows, n, rows(n, reached)) * rows(n, reached);
}

/// F(r) / r [N/m].
template <class Rows>
KOKKOS_INLINE_FUNCTION double secant(const Rows& rows, int n)
{
  return secantAt(rows, n, rows(n, reached));
}
} // namespace cohesion

} // namespace Rhegma::cracks
