#pragma once
/// Primitive shapes of bodies, each in its own axes. A point on a surface is inside.
///
/// `depth` is positive inside and negative outside [m]. Between two points it changes by no more than their
/// distance, so a ball of the radius |depth| about a point is on one side of the surface.

#include "geometry/Solid.hpp"
#include "geometry/VoxelPhase.hpp"

#include <memory>
#include <variant>
#include <vector>

namespace Rhegma::Geometry
{

template <int D>
struct Box
{
  Bounds<D> corners;
  static constexpr bool convex = true; ///< a box is inside where its corners are

  bool contains(const Vector<D>& own) const;
  double depth(const Vector<D>& own) const;
  /// Smallest bounds in 3D of the box turned by the frame; so for the other primitives.
  Bounds<D> bounds(const Frame<D>& frame) const;
};

/// A disk in 2D.
template <int D>
struct Ball
{
  Vector<D> centre;                    ///< [m]
  double radius;                       ///< [m]
  static constexpr bool convex = true; ///< a box is inside where its corners are

  bool contains(const Vector<D>& own) const;
  double depth(const Vector<D>& own) const;
  Bounds<D> bounds(const Frame<D>& frame) const;
};

/// A round bar with flat ends, between two points of its axis (3D).
template <int D>
struct Cylinder
{
  Vector<D> from;                      ///< [m]
  Vector<D> to;                        ///< [m]
  double radius;                       ///< [m]
  static constexpr bool convex = true; ///< a box is inside where its corners are

  bool contains(const Vector<D>& own) const;
  double depth(const Vector<D>& own) const;
  Bounds<D> bounds(const Frame<D>& frame) const;
};

/// A closed polygon in the x-y plane, in 3D a prism from `bottom` to `top` along z. Either sense of rotation.
template <int D>
struct Polygon
{
  std::vector<Vector<2>> points;        ///< [m]
  double bottom = 0.0;                  ///< 3D only [m]
  double top = 0.0;                     ///< 3D only [m]
  static constexpr bool convex = false; ///< a box is inside where its corners are

  bool contains(const Vector<D>& own) const;
  double depth(const Vector<D>& own) const;
  Bounds<D> bounds(const Frame<D>& frame) const;
};

/// Area of a polygon, positive if its points are counter-clockwise [m^2].
double signedArea(const std::vector<Vector<2>>& points);

/// Indices of the first points of two edges that cross or touch without being neighbours; {-1, -1} where none
/// do.
std::array<int, 2> crossingEdges(const std::vector<Vector<2>>& points);

/// Whether the segments a b and c d have a point in common.
bool segmentsMeet(const Vector<2>& a, const Vector<2>& b, const Vector<2>& c, const Vector<2>& d);

/// The solid of a file, scaled and moved.
template <int D>
struct FileShape
{
  std::shared_ptr<const Solid<D>> solid;
  double scale;                         ///< of a unit of the file [m]
  Vector<D> origin;                     ///< where the file's origin is [m]
  static constexpr bool convex = false; ///< a box is inside where its corners are

  bool contains(const Vector<D>& own) const;
  double depth(const Vector<D>& own) const;
  /// The same up to a distance; a larger one is given as this one [m].
  double depth(const Vector<D>& own, double within) const;
  Bounds<D> bounds(const Frame<D>& frame) const;
  /// The part of a box along its axes about `own`: exact but for rounding.
  BoxPart<D> part(const Vector<D>& own, const Vector<D>& edge) const;
};

/// The voxels of an image that have one value.
template <int D>
struct VoxelShape
{
  std::shared_ptr<const VoxelPhase<D>> phase;
  double size;                          ///< of a voxel [m]
  Vector<D> corner;                     ///< lower corner of the image [m]
  static constexpr bool convex = false; ///< a box is inside where its corners are

  bool contains(const Vector<D>& own) const;
  double depth(const Vector<D>& own) const;
  Bounds<D> bounds(const Frame<D>& frame) const;
  /// The part of a box along its axes about `own`: exact but for rounding.
  BoxPart<D> part(const Vector<D>& own, const Vector<D>& edge) const;
  /// Of the image, which is the same for all of its values.
  Vector<D> middle() const;
};

template <int D>
using Primitive = std::variant<Box<D>, Ball<D>, Cylinder<D>, Polygon<D>, FileShape<D>, VoxelShape<D>>;

} // namespace Rhegma::Geometry
