#pragma once
/// How wide a tube around a front in 3D may be.

#include "energy_release/Contour.hpp"
#include "energy_release/FrontLine.hpp"

namespace Rhegma::energy_release
{

/// The tube around a front over which it is integrated.
struct FrontTube
{
  ContourRadii radii;
  double halfWidth; ///< of the hat along the front by which a front node weighs [m]
};

/// Largest outer radius of a tube that stays inside the body, clear of other fronts and cracks and, where the
/// front is curved, of its centre of curvature, at most `radius` [m]. Where an open front ends at the
/// surface, so does the tube. Collective.
double roomAround(const State<3>& state, const CrackFront<3>& front, const FrontLine& line, double radius);

/// Radius of the largest ball that touches a front from behind or ahead and holds no other part of it; parts
/// nearer than 1.5 cells are not looked at, those nearer than 3 count less, and the ends of an open front not
/// at all, where the surface cuts its pieces and a front node points along the crack's mouth. Infinite for a
/// straight front.
double radiusOfCurvature(const FrontLine& line, double cell);

/// Radii that a 3D scene leaves to the program: 2.5 and 5 cells. With 1 and 3 cells J of
/// verification/thick_plate.xml is 2.5 % low.
GivenRadii radiiInSpace();

/// Radii and half width: 2.5, 5 and 2 cells. The radii are less where there is no room, but the outer one no
/// less than smallestOuter; the half width is no more than half of the radius of curvature, but no less than
/// a cell.
FrontTube fittingTube(const State<3>& state, const CrackFront<3>& front, const FrontLine& line,
                      const GivenRadii& given);

} // namespace Rhegma::energy_release
