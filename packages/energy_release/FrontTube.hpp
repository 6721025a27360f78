#pragma once
/// The disk (2D) or tube (3D) around a front over which domain integrals run.

#include "energy_release/Contour.hpp"
#include "energy_release/FrontLine.hpp"

#include <string>

namespace Rhegma
{
class Archive;
}

namespace Rhegma::energy_release
{

struct FrontTube
{
  ContourRadii radii{0.0, 0.0};
  double halfWidth = 0.0; ///< of the weight of a front node along the front, a hat [m]; none in 2D

  /// Saves or loads it. \param name of a group of the archive
  void store(const std::string& name, Archive& archive);
};

/// Radii that a scene leaves to the program: 3 and 6 cells in 2D (more round cracks that run), 2.5 and 5 in
/// 3D. With 1 and 3 cells J of verification/thick_plate.xml is 2.5 % low.
template <int D>
GivenRadii usualCells();
template <>
GivenRadii usualCells<2>();
template <>
GivenRadii usualCells<3>();

/// Largest outer radius that stays inside the body and clear of other fronts, of other cracks and of parts of
/// its own crack that come back to the front (ClearOfCracks.hpp), at most `radius` [m]. In 3D it is no more
/// than the radius of curvature of the front; where an open front ends at the surface, so does the tube.
/// Collective.
double clearAround(const State<2>& state, const CrackFront<2>& front, double radius);
double clearAround(const State<3>& state, const CrackFront<3>& front, double radius);

/// Radius of the largest ball that touches a front from behind or ahead and holds no other part of it; parts
/// nearer than 1.5 cells do not count, those nearer than 3 count less, and neither do the ends of an open
/// front, where the surface cuts its pieces and a front node points along the surface-breaking edge. Infinite
/// for a straight front.
double radiusOfCurvature(const FrontLine& line, double cell);

/// The tube of a front. An outer radius that the scene does not give is reduced to clearAround, but not below
/// smallestOuter; the inner one then to half of it, in 2D to no less than 2 cells where a cell is left for
/// the weight to fall. The half width is 2 cells, no more than half of the radius of curvature, but no less
/// than a cell. Collective.
template <int D>
FrontTube fittingTube(const State<D>& state, const CrackFront<D>& front, const GivenRadii& given);

} // namespace Rhegma::energy_release
