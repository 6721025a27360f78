#pragma once
/// The laws of the springs behind a front and of the traction of new faces, without state: what replaces them
/// replaces this file and SpringConstants.hpp.

#include "base/CohesiveLaw.hpp"
#include "base/Types.hpp"
#include "cracks/FrontCell.hpp"
#include "cracks/SpringConstants.hpp"
#include "state/OpeningFraction.hpp"

#include <cmath>

namespace Rhegma::cracks
{

/// How the two fields of a split node are joined.
enum class SpringState : int
{
  Bonded = 0,    ///< by a front spring; without stiffness away from fronts
  Releasing = 1, ///< by a cohesive traction
  Open = 2       ///< not at all: the traction has fallen to zero
};

/// Where the law of FrontCell.hpp holds; elsewhere the plain one does.
struct FrontLaw
{
  bool ofCells = false;   ///< in 2D for cracks along the cells
  bool unlimited = false; ///< no step limits the stiffness: for cracks at angles and in 3D too

  /// xi of a node that just opens [cells].
  KOKKOS_INLINE_FUNCTION double least() const
  {
    return unlimited ? springs::leastOfUnlimited : springs::leastOfLimited;
  }
};

/// Whether the law of FrontCell.hpp holds. \param steepest c: largest component of the crack's normal
template <int D>
KOKKOS_INLINE_FUNCTION bool hasFrontCell(double steepest, FrontLaw law)
{
  return law.ofCells && (law.unlimited || (D == 2 && steepest > springs::onTheCells));
}

/// How far ahead of a front a node may lie that has an enriched field, with front springs [cells].
///
/// s = (s0 + q (1 - c)) / c: the crack of the cells, which ends between the last node that opens and
/// the next, then ends at the front in the mean (FrontCell.hpp). With limited springs,
/// s = s0 + m min(2 z, 2 - 2 z) for cracks along the cells in 2D.
///
/// \param steepest c: largest component of the crack's normal \param away z: distance of the node from the
/// crack along the axis nearest to its normal [cells]
template <int D>
KOKKOS_INLINE_FUNCTION double splitAhead(double steepest, double away, FrontLaw law)
{
  if (!hasFrontCell<D>(steepest, law))
    return steepest > springs::alongTheCells && !(D == 2 && law.ofCells) ? -springs::splitBehindAligned
                                                                         : springs::splitAheadInclined;
  if (law.unlimited)
    return (frontCell::unlimited::lag + frontCell::unlimited::lagTurned * (1.0 - steepest)) / steepest;
  const double middle = std::fmax(0.0, 2.0 * std::fmin(away, 1.0 - away));
  return frontCell::limited::lag + frontCell::limited::lagMidCell * middle;
}

/// (l - xi) / xi of the law of FrontCell.hpp [-]: how close the two fields of a node near a front are to one.
/// Parameters: see frontSpringStiffness
template <int D>
KOKKOS_INLINE_FUNCTION double frontBond(double behind, double away, double steepest, FrontLaw law)
{
  if (!hasFrontCell<D>(steepest, law))
    return 0.0;
  const double range = (law.unlimited ? frontCell::unlimited::range : frontCell::limited::range) / steepest;
  const double xi = std::fmax(behind + splitAhead<D>(steepest, away, law), law.least());
  return xi < range ? (range - xi) / xi : 0.0;
}

/// By how much the traction between the two fields of a node near a front falls with their opening [N/m],
///
///     s = a (1 + b max(0, 1 - 2 z)) E' w,
///
/// with the constants of FrontCell.hpp; b is zero for limited springs. Zero where that law does not hold.
/// Parameters: see frontSpringStiffness
template <int D>
KOKKOS_INLINE_FUNCTION double frontCellSlope(double modulus, double width, double away, double steepest,
                                             FrontLaw law)
{
  if (!hasFrontCell<D>(steepest, law))
    return 0.0;
  const double factor = law.unlimited
                            ? frontCell::unlimited::stiffness *
                                  (1.0 + frontCell::unlimited::onCrack * std::fmax(0.0, 1.0 - 2.0 * away))
                            : frontCell::limited::stiffness;
  return factor * modulus * width;
}

/// Stiffness of the spring between the two fields of a node near a front [N/m]. By the law of
/// FrontCell.hpp
///
///     k = s (l - xi) / xi,   xi = behind + ahead,   l = l0 / c,
///
/// zero from xi = l on, s of frontCellSlope, the distance ahead of splitAhead and the other constants from
/// the near field in the cells of a front (FrontCell.hpp). It holds for all nodes with two fields: w falls to
/// zero where the crack leaves the cells of a node. Elsewhere
///
///     k = 0.1 E' w (1 - xi) / xi (1 - z),   xi = sqrt(c) behind + 0.05,   zero from z = 1 on.
///
/// \param modulus E' of fracture mechanics [Pa] \param width w: thickness times openingFraction (2D), filled
/// part of a cell (3D) [m] \param behind distance behind the front, negative ahead [cells] \param away,
/// steepest: see splitAhead
template <int D>
KOKKOS_INLINE_FUNCTION double frontSpringStiffness(double modulus, double width, double behind, double away,
                                                   double steepest, FrontLaw law)
{
  if (hasFrontCell<D>(steepest, law))
    return frontCellSlope<D>(modulus, width, away, steepest, law) * frontBond<D>(behind, away, steepest, law);
  const double xi = behind * std::sqrt(steepest) + springs::distanceOffset;
  return xi < 1.0 && away < 1.0
             ? springs::stiffnessFraction * modulus * width * (1.0 - xi) / xi * (1.0 - away)
             : 0.0;
}

/// Opening over which nodes that a front passes together release an energy [m]: w = 2 E / sum T, all with the
/// same. Together they dissipate E, each in proportion to its force (for example, the two rows of nodes next
/// to a crack that runs between them). \param energy [J] \param holding sum of the forces that would hold the
/// fields [N]
inline double releaseRange(double energy, double holding)
{
  return 2.0 * energy / (springs::initialFraction * holding);
}

/// Fraction phi of the holding force that a node starts with.
///
/// Where w is so short that the fields would pass it within a step or two, T would act to the end of a step
/// in which the faces are apart already. There the node starts with less force and a longer range of the same
/// energy, so that the fields reach w as the step ends:
///
///     w = 2 E / (phi T) = (1 - phi) T / m dt^2,   phi below a half, m = m1 m2 / (m1 + m2).
///
/// The last step overshoots w. Where it opens the fields by s w with a fraction x <= s of w left, it
/// dissipates x T s w / 2 instead of x T x w / 2: too much by x (s - x) of the energy T w / 2, at most s^2 /
/// 4, s^2 / 6 in the mean of all x. A node that over-dissipates by a twentieth has opened by s > 0.45 in its
/// last step: its traction falls within little more than two steps. From there on, `toleratedExcess`, the
/// excess is deducted from the energy of nodes that the front passes next; slower ones dissipate 3 % too much
/// in the mean at most.
///
/// \param range as of releaseRange [m] \param apart how far the fields would move apart within the step if
/// nothing held them [m]
KOKKOS_INLINE_FUNCTION double startingFraction(double range, double apart)
{
  const double product = springs::initialFraction * range / apart; // phi (1 - phi)
  return product < 0.25 ? 2.0 * product / (1.0 + std::sqrt(1.0 - 4.0 * product)) : springs::initialFraction;
}

/// The law of a node that a front has passed. \param strength its initial traction [N] \param fraction phi
/// \param stiffness k [N/m]
KOKKOS_INLINE_FUNCTION CohesiveLaw releaseLaw(double strength, double range, double fraction,
                                              double stiffness)
{
  return {strength, range * springs::initialFraction / fraction, strength / stiffness};
}

/// The law that a stretched front spring follows from when its front is initiated.
///
/// By the law of FrontCell.hpp its force falls by s times the further opening: as a front moves through a
/// cell under a constant K, the force k = s (l - xi) / xi times the opening of its node falls along the line
/// s (w - opening), and the area below this line is Gc times the area of the cell
/// (unit_tests/studies/front_cell.py --opening). Elsewhere the force falls to zero over another stretch.
///
/// \param stretch now, larger than zero [m] \param slope s, zero where that law does not hold [N/m]
/// \param spent part of G that new faces dissipate: the node is part of them
KOKKOS_INLINE_FUNCTION CohesiveLaw softeningLaw(double stiffness, double stretch, double slope, double spent)
{
  const double force = stiffness * stretch;
  return {force, slope > 0.0 ? spent * force / slope : springs::softeningStretch * stretch, stretch};
}

/// Energy that a softening spring dissipates in all, with what it stored when it began to soften [J].
KOKKOS_INLINE_FUNCTION double softenedEnergy(const CohesiveLaw& law)
{
  return 0.5 * law.strength * law.onset + law.energy();
}

} // namespace Rhegma::cracks
