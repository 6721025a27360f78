#pragma once
/// The contribution of tractions on the faces of a crack to the domain integrals of a front in 2D.

#include "energy_release/Contour.hpp"
#include "energy_release/CrackTipFields.hpp"

#include <vector>

namespace Rhegma::energy_release
{

/// A piece of a crack on whose faces a traction acts.
struct LoadedPiece
{
  Vector<2> near, far; ///< its ends, seen from the front
  Vector<2> traction;  ///< on side +1, opposite on side -1 [Pa]
};

/// The pieces of a front's crack, from the front on, with the pressure on their faces (CrackSet::pressure).
std::vector<LoadedPiece> pressedPieces(const State<2>& state, const CrackFront<2>& front);

/// The same with the tractions of closed faces on each other (CrackSet::tractions).
std::vector<LoadedPiece> touchingPieces(const State<2>& state, const CrackFront<2>& front);

/// Where the jump of displacement between faces is taken from.
enum class OpeningBy
{
  Nodes, ///< on both sides of the crack, for faces that are open: by their vertices G of
         ///< verification/pressed_crack_static.xml would be 6 % too low
  Faces  ///< the vertices of the faces, for those that touch: by nodes
         ///< G of verification/closed_crack_static.xml would be 1.5 % too low instead of 0.1
};

/// What tractions on the faces behind a front add to its domain integrals, as far as their weight q reaches.
///
/// With an acceleration of nodes that has the forces of the tractions in it (InternalAcceleration.hpp), the
/// domain integrals lack their work: with t the traction on side +1, s the distance behind the front along
/// the crack, [u] the jump from side -1 to side +1,
///
///     J += int t . [u],s q ds,     M += int t . [w],s q ds,     R -= int t . [w] q ds.
///
/// The jump of the singular field w is exact, so that the root singularity of [w],s is, too. In J the
/// derivative goes to t q by integration by parts: only openings at positions where q varies count, which are
/// accurate, where those in the cells of the front are not. The faces are loaded up to the tip of the crack
/// in the cells, to which J and K belong. Sources as for the domain integrals: Li, Shih and Needleman, Eng.
/// Fract. Mech. 21 (1985) 405; Karlsson and Bäcklund, Int. J. Fract. 14 (1978) R311.
class FaceTractions
{
public:
  /// \param weight q Collective.
  FaceTractions(const State<2>& state, const CrackFront<2>& front, const NodalWeight<2>& weight,
                const std::vector<LoadedPiece>& pieces, OpeningBy openingBy);

  /// Whether all faces that q reaches press on each other.
  bool closed() const;

  /// Gives all of the faces the mean traction: tractions of closed faces are not singular, but scatter with
  /// the particles next to the crack.
  void takeMean();

  /// Of J [J/m2].
  double release() const;

  /// Parts of M and R, per thickness, for the modes I and II.
  struct Interaction
  {
    double M[2] = {}, R[2] = {};
  };
  /// \param offset how far the tip of the crack in the cells lies ahead of the front [m]
  Interaction interaction(double offset, const CrackCompliance& material) const;

  /// Half of M of mode I that belongs to the opening of the faces, [u_2] = 8 M / 2 sqrt(r / 2 pi)
  /// (CrackCompliance), by least squares [m^0.5].
  double halfInteractionOfOpening(double offset) const;

private:
  std::vector<Vector<2>> points_;   ///< on the crack, from the front on
  std::vector<double> weights_;     ///< q at the points
  std::vector<Vector<2>> jumps_;    ///< [u] at the points [m]
  std::vector<Vector<2>> traction_; ///< between a point and the next [Pa]
  CrackFront<2> front_;

  void cut(const std::vector<LoadedPiece>& pieces, double longest, double reach);
  void findWeights(const State<2>& state, const NodalWeight<2>& weight);
  /// q times the length between a point and the next [m].
  double weighedLength(std::size_t k) const;
};

} // namespace Rhegma::energy_release
