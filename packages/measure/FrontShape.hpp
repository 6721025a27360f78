#pragma once
/// How round and how flat a front has stayed.

#include "state/CrackSet.hpp"

namespace Rhegma::measure
{

/// The circle that a front was at the start, or a part of it.
struct Circle
{
  Vector<3> centre{}, normal{};
  double radius = 0.0; ///< [m]; 0: not a circle
};

/// The circle through the front nodes of a front by least squares (Kasa, IEEE Trans. Instrum. Meas. 25 (1976)
/// 8) in the plane of their mean normal; none where a front node lies further than a twentieth of the radius
/// off it.
Circle circleOf(const CrackFront<3>& front);

/// A front seen from the middle of a circle.
struct Shape
{
  double radius = 0.0;    ///< mean distance of its front nodes from the circle's axis, weighted by their
                          ///< tributary lengths [m]
  double roundness = 1.0; ///< 1 less the largest deviation from that mean, in parts of it
  double flatness = 1.0;  ///< 1 less the largest distance from the circle's plane, in parts of it
};

Shape shapeOf(const CrackFront<3>& front, const Circle& circle);

} // namespace Rhegma::measure
