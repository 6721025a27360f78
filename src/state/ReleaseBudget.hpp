#pragma once
/// The energy of new crack faces at one front: required, released and pending.

#include <algorithm>

namespace Rhegma
{

/// Energies at one front [J]. They fulfil
///
///     released + pending = required + advected + carriedOver + overDissipated.
struct ReleaseBudget
{
  /// How nodes get their energy. True (3D): each that of the area that it stands for, and what springs and
  /// nodes dissipate beyond it is deducted from the pending energy at once. False (2D): those of one
  /// step share all that is pending, and it is deducted from the nodes that come next.
  bool byArea = false;
  double required = 0.0;       ///< toughness times area of all faces that the front has made
  double pending = 0.0;        ///< part of it that no node has received yet
  double released = 0.0;       ///< received by nodes, which dissipate it as they open
  double carriedOver = 0.0;    ///< dissipated by softened springs, deducted from the next nodes
  double overDissipated = 0.0; ///< dissipated by nodes beyond their energy, deducted likewise
  double advected = 0.0;       ///< released at nodes that the front reached while it made no new face
  double toughness = 0.0;      ///< of the last advance, 2D [J/m2]

  /// New faces require an energy [J].
  void require(double energy)
  {
    required += energy;
    pending += energy;
  }

  /// Nodes get tractions that dissipate an energy [J].
  void release(double energy)
  {
    pending -= energy;
    released += energy;
  }

  /// Nodes that are uncracked again, or no longer exist, return the part of their energy that they have not
  /// dissipated [J].
  void returnPending(double energy) { release(-energy); }

  /// Energy dissipated in advance by springs or nodes: deducted, see `byArea` [J].
  void carryOver(double energy) { deduct(carriedOver, energy); }
  /// Nodes dissipated more than their energy. \param energy [J]
  void overDissipate(double energy) { deduct(overDissipated, energy); }

  /// Releases all pending energy less the deductions.
  /// \param ofAdvection energy of these nodes where nothing is pending: the front reached them only because
  /// material moves through the grid [J] \param carriedOverFraction, deductedFraction largest parts that are
  /// deducted for carriedOver and, of the rest, for overDissipated \return the energy of the nodes [J]
  double releaseAll(double ofAdvection, double carriedOverFraction, double deductedFraction)
  {
    const bool isPending = pending > 0.0;
    const double energy = isPending ? pending : ofAdvection;
    const double fromCarriedOver = std::min(carriedOver, carriedOverFraction * energy);
    const double deducted = std::min(overDissipated, deductedFraction * (energy - fromCarriedOver));
    const double ofNodes = energy - fromCarriedOver - deducted;
    if (!(ofNodes > 0.0))
      return 0.0;
    advected += isPending ? 0.0 : energy - pending;
    pending = 0.0;
    released += ofNodes;
    carriedOver -= fromCarriedOver;
    overDissipated -= deducted;
    return ofNodes;
  }

  /// Fraction of toughness times area that nodes get, so that the energy that is pending stays near zero.
  /// \param wanted toughness times area of these nodes [J] \param ofRow the same of a row of cells along the
  /// front, by which nodes may be ahead of its faces or behind them; zero where no more nodes follow [J]
  /// \param least, most bounds of the fraction
  double fractionOfArea(double wanted, double ofRow, double least, double most) const
  {
    return std::clamp(1.0 + (pending - wanted) / (ofRow > 0.0 ? ofRow : wanted), least, most);
  }

private:
  void deduct(double& later, double energy)
  {
    (byArea ? pending : later) += byArea ? -energy : energy;
    released += energy;
  }
};

} // namespace Rhegma
