#pragma once
/// The cavity between the faces of a crack, and which of them burn.

#include "boundary/MirrorPlanes.hpp"
#include "transfer/FacePoints.hpp"

#include <array>
#include <vector>

namespace Rhegma::combustion
{

/// Sums over the face points of one crack. Areas in 2D are lengths times the thickness.
struct Cavity
{
  double area = 0.0;    ///< of one face [m2]
  double burning = 0.0; ///< of both faces that burn [m2]
  double felt = 0.0;    ///< of one face that nodes feel [m2]
  double widest = 0.0;  ///< opening of all points [m]
};

/// All ranks have all points and find the same. \param lit not 0 where a point burns
template <int D>
Cavity measureCavity(const State<D>& state, const FacePoints<D>& points, int crack, const View<int*>& lit);

/// Area through which a crack opens at the surface of the body [m2]: the opening at its surface-breaking
/// ends, those on mirror planes left out.
template <int D>
double surfaceEndArea(const State<D>& state, int crack, const std::vector<MirrorPlane>& mirrors);
/// The same of the first and the last end of a crack in 2D.
template <int D>
std::array<double, 2> surfaceEndAreas(const State<D>& state, int crack,
                                      const std::vector<MirrorPlane>& mirrors);

/// Area through which the first and the last end of a crack in 2D open into another crack, on which it has
/// ended [m2].
template <int D>
std::array<double, 2> joinedAreas(const State<D>& state, int crack);

/// Whether the crack has a surface-breaking end, those on mirror planes left out.
template <int D>
bool hasSurfaceEnd(const State<D>& state, int crack, const std::vector<MirrorPlane>& mirrors);

/// Distance of a box from a crack [m]; 0 where it meets it.
template <int D>
double distanceFromCrack(const CrackSet<D>& cracks, int crack, const Vector<D>& lower,
                         const Vector<D>& upper);

} // namespace Rhegma::combustion
