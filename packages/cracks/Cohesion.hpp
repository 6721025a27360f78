#pragma once
/// The force with which new crack faces resist being opened.

#include "base/Types.hpp"

#include <cmath>

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
/// Where w is so short that the fields would move past it within a step or two, T would act to the end of a
/// step in which the faces are apart already. There the node starts with a smaller share phi of what holds
/// it, and a longer w of the same energy, so that the fields reach w as the step ends:
///
///     w = 2 E / (phi T) = (1 - phi) T / m dt^2,   phi below a half, m = m1 m2 / (m1 + m2).
///
/// The last step overshoots w. Let it open the fields by s w, the share x <= s of w being left: at its start
/// the force is x T and at its end there is none, so that the step takes x T s w / 2 where x T x w / 2 was
/// left, and too much by
///
///     x (s - x) of the energy T w / 2:   s^2 / 4 at most, s^2 / 6 in the mean of all x.
///
/// A node that takes a twentieth too much has therefore opened by s > 0.45 in its last step: the force falls
/// within little more than two steps. From there on, `tolerated`, what was too much is deducted from the
/// energy of nodes that the front passes next; slower ones take 3 % too much in the mean at most, s^2 / 6 at
/// s = 0.45. A debt takes up to nine tenths of a node's energy, `deduction`, after what softened ties are
/// owed: a node keeps (1 - 1/4) (1 - 9/10) = 7.5 % of its energy, and with that a range, however much is
/// owed, so that none is without a force. The nine tenths are chosen; the same debt at another share is paid
/// over more nodes or less.
///
/// A row: the numbers below; then T / k, as many as axes.
namespace cohesion
{
constexpr double strengthAtFirst = 0.95; ///< share of the holding force

constexpr double repayment = 0.25; ///< most of the energy of new faces that goes to softened ties

constexpr double tolerated = 0.05; ///< share of its energy by which a node may take more without deduction
constexpr double deduction = 0.9;  ///< most of it that goes to what nodes have taken too much

/// Share of the holding force that a node starts with.
/// \param range w, by strengthAtFirst [m] \param apart by how much the fields would move apart within the
/// step if nothing held them [m]
KOKKOS_INLINE_FUNCTION double shareAtFirst(double range, double apart)
{
  const double product = strengthAtFirst * range / apart; // of the share and what it lacks of one
  return product < 0.25 ? 2.0 * product / (1.0 + std::sqrt(1.0 - 4.0 * product)) : strengthAtFirst;
}

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

/// What the force of a node would yet take until its fields are apart, with what it holds as a spring [J].
/// \param square of the fields' distance now, counted from -T / k [m2]
template <class Rows>
KOKKOS_INLINE_FUNCTION double yetToTake(const Rows& rows, int n, double square)
{
  const double r = rows(n, reached), force = strength(rows, n);
  return force > 0.0
             ? 0.5 * force * (rows(n, start) + rows(n, range) - r) + 0.5 * force / r * (r * r - square)
             : 0.0;
}
} // namespace cohesion

} // namespace Rhegma::cracks
