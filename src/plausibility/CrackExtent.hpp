#pragma once
/// Sizes at a crack, by which a scene is judged.

#include "plausibility/BodyMeasures.hpp"

namespace Rhegma
{

/// Extent of a crack behind its fronts [m]: in 2D the diagonal of its bounds, in 3D the shortest extent along
/// the direction of a front node, so that the depth of a through crack counts and not the thickness of its
/// plate, and of a disk the diameter. Of a crack without fronts the diagonal. As it lies in the bodies; 0
/// while it has no vertices.
template <int D>
double extentOf(const State<D>& state, int crack);

/// The longest of these extents of all cracks [m]; 0 without cracks.
template <int D>
double longestCrack(const State<D>& state);

/// Area of a crack as it lies in the bodies, in 2D its length times the thickness [m2].
template <int D>
double areaOf(const State<D>& state, int crack);

/// The bodies that cracks lie in, by their bounds; all where none does. Call it before particles are divided
/// among ranks.
template <int D>
std::vector<BodyMeasure<D>> crackedBodies(const State<D>& state);

/// A crack in a body, by the body's own axes.
template <int D>
struct CrackedSection
{
  int crack = 0;           ///< index of the crack
  double depth = 0.0;      ///< its extent behind the front [m]
  double fraction = 0.0;   ///< of the body's section that it divides, 1 at most [-]
  double width = 0.0;      ///< of the body along the direction of the front [m]
  double below = 0.0;      ///< of the body from the crack, against its normal [m]
  double above = 0.0;      ///< the same along the normal [m]
  bool atBothEnds = false; ///< it has a front at its other end too, or one closed front
  int alongFront = -1;     ///< the body's axis along an open front; -1 in 2D and of a closed front
  Vector<D> direction{};   ///< of the front, mean along it
  double thinner() const { return below < above ? below : above; } ///< of the two parts next to it [m]
};

/// The cracks with fronts in a body, by their bounds; empty without any.
template <int D>
std::vector<CrackedSection<D>> sectionsOf(const State<D>& state, const BodyMeasure<D>& body);

/// Shortest extent of a body in the planes across the fronts of its cracks [m]: along its own axes but those
/// along fronts, so that a plate with a through crack counts by its height and width. Its shortest extent
/// where it has no such front, and in 2D.
template <int D>
double shortestAcrossFronts(const State<D>& state, const BodyMeasure<D>& body);

/// Length of the plastic zone ahead of a front (Irwin 1960): (K / yield stress)^2 / (2 pi) in plane stress, a
/// third of it elsewhere [m]. \param K stress intensity [Pa m^0.5] \param yield stress [Pa]
inline double irwinRadius(double K, double yield, Plane plane)
{
  constexpr double pi = 3.14159265358979;
  const double ratio = K / yield;
  return ratio * ratio / ((plane == Plane::Stress ? 2.0 : 6.0) * pi);
}

/// The same in a body. \param body with a yield stress
template <int D>
double plasticZone(double K, const BodyMeasure<D>& body, Plane plane)
{
  return irwinRadius(K, body.yield, plane);
}

/// Part of the crack and of the body up to which a plastic zone is small. The standard of K_Ic (ASTM E399,
/// plane strain) asks for lengths of 2.5 (K / yield stress)^2 and more, which is 0.02.
constexpr double smallZone = 0.1;

} // namespace Rhegma
