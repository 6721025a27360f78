#pragma once
/// Lengths at a front by which its energy release rate changes when it advances.

#include "energy_release/Contour.hpp"

namespace Rhegma::energy_release
{

/// Lengths of a front [m].
struct FrontLengths
{
  double crack;    ///< of its crack, half of it where the crack has a front at its other end; 3D: a radius
  double ligament; ///< from the front ahead to a surface or another front; infinite where there is none
  int ends;        ///< fronts of the crack that have not ended, in 3D 2 for a closed one
  double front;    ///< 3D: of all fronts of the crack; 2D: their number times the thickness
  double arm;      ///< from the front across the crack to the farther surface; infinite where there is none

  /// |d ln G / da| [1/m], an upper estimate for the loads that are usual: 1 / a + m / b, with the exponent m
  /// of estimateErrors. A crack that leaves arms, longer than three times their height h, in addition has the
  /// 4 / (a + 0.64 h) of a double cantilever beam whose ends are held; under forces it is half of that.
  /// Source: Kanninen, Int. J. Fract. 9 (1973) 83.
  double slope() const;
};

/// The lengths at a front. \param cover of all nodes, by coverOfNodes. Collective.
template <int D>
FrontLengths lengthsAt(const State<D>& state, const CrackFront<D>& front, const NodeCover<D>& cover);

} // namespace Rhegma::energy_release
