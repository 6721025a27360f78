#pragma once
/// How far the domain of a particle is from the surface of a tool.

#include "geometry/Shape.hpp"
#include "rigid_tools/RigidMotion.hpp"

namespace Rhegma::rigid_tools
{

/// The surface of a tool where it is now.
template <int D>
struct ToolSurface
{
  const Shape<D>& shape;
  const Placement<D>& placement;
  double step; ///< for the normal, small next to a cell [m]

  /// Positive inside the tool [m]; no larger than the distance from its surface.
  double depth(const Vector<D>& x) const { return shape.depth(placement.toOwn(x)); }
  /// Unit vector out of the tool: opposite to the gradient of the depth, by central differences.
  Vector<D> outward(const Vector<D>& x) const;
};

/// A domain of a particle and a tool.
template <int D>
struct Separation
{
  double gap = 0.0;   ///< distance between the two; negative: how deep the domain lies in the tool [m]
  Vector<D> normal{}; ///< unit vector out of the tool at its point that is nearest to the particle
  Vector<D> foot{};   ///< that point [m]
};

/// Separation of a domain, a parallelogram (2D) or parallelepiped (3D), from a tool.
///
/// The gap is that of the deepest of several points of the domain: the corner which lies furthest against the
/// normal, and those that are found by going to the nearest point of the tool and back to the domain in
/// turns. The first is exact for a flat surface, the others for a tool that touches the middle of a face.
///
/// \param centre of the domain [m] \param edge its edge vectors [m]
template <int D>
Separation<D> separate(const ToolSurface<D>& surface, const Vector<D>& centre, const Vector<D> (&edge)[D]);

} // namespace Rhegma::rigid_tools
