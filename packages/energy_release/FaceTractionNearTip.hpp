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
/// constant t, from the tip of w on; sums over particles or over middles of pieces leave out percents of a
/// remote K.
///
/// Where all faces inside of the contour press, their tractions are not singular, but scatter with the
/// particles next to the crack: M and R take their mean. Their opening is then zero, and so is K_I. It is
/// taken from the opening itself, of which M would be the small difference of large numbers.
class FaceTractions
{
public:
  FaceTractions(const State<2>& state, const CrackFront<2>& front, const ContourRadii& radii);

  /// Part of J [J/m2].
  double release() const;
  /// Parts of M for K_I and K_II as intensities E' M / 2 [Pa m^0.5]. \param tipOffset how far the tip of w
  /// lies ahead of the front [m]
  Vector<2> intensities(double tipOffset) const;
  /// Whether all faces inside of the contour press.
  bool closed() const { return closed_; }
  /// K_I of the opening of the faces, [u] = 8 K_I / E' sqrt(r / 2 pi), by least squares [Pa m^0.5].
  double intensityOfOpening(double tipOffset, double effectiveModulus) const;
  /// Parts of R for both modes, per thickness.
  Vector<2> reciprocals(double tipOffset, double effectiveModulus) const;

private:
  void smoothen();
  struct Piece
  {
    double from, to;    ///< distances behind the front, along the crack [m]
    double q;           ///< weight of the integrals
    Vector<2> traction; ///< on side +1, along the front's normal and direction [Pa]
    Vector<2> step;     ///< jump at `to` less that at `from`, in the same axes [m]
    double opening;     ///< in the middle [m]
  };
  bool closed_ = false;
  /// Distance of a piece's start from the tip of the crack in the cells, to which the first one reaches [m].
  double startOf(const Piece& piece, double tipOffset) const;

  std::vector<Piece> pieces_;
};

} // namespace Rhegma::energy_release
