#pragma once
/// Tractions of closed faces on each other behind a front.

#include "energy_release/Contour.hpp"
#include "energy_release/CrackTipFields.hpp"

#include <vector>

namespace Rhegma::energy_release
{

/// What tractions of closed faces (CrackSet::tractions) add to the domain integrals of a front of a 2D scene,
/// whose acceleration has the forces of contact in it, as of all nodes:
///
///     J   -= int t . [u],1 q ds,     M  -= int t . [w],1 q ds,     R  -= int t . [w] q ds
///
/// t the traction on side +1, [ ] the jump from side -1 to +1, w Williams' field of unit intensity, whose
/// jump goes with the root of the distance. The integrals of w are those over each piece of crack with
/// constant t; sums over particles or over middles of pieces leave out percents of a remote K.
class FaceTractions
{
public:
  FaceTractions(const State<2>& state, const CrackFront<2>& front, const ContourRadii& radii);

  /// Part of J [J/m2].
  double release() const;
  /// Parts of M for K_I and K_II as intensities E' M / 2 [Pa m^0.5]. \param tipOffset how far the tip of w
  /// lies ahead of the front [m]
  Vector<2> intensities(double tipOffset) const;
  /// Parts of R for both modes, per thickness.
  Vector<2> reciprocals(double tipOffset, double effectiveModulus) const;

private:
  struct Piece
  {
    double from, to;   ///< distances behind the front, along the crack [m]
    double q;          ///< weight of the integrals
    Vector<2> traction; ///< on side +1, along the front's normal and direction [Pa]
    double work;       ///< of the traction by the jump at `to` less that at `from` [J/m2]
  };
  std::vector<Piece> pieces_;
};

} // namespace Rhegma::energy_release
