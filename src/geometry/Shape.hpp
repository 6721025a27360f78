#pragma once
/// A body's shape: a first primitive, to which others are added or from which they are cut, in order.

#include "geometry/PartOfBox.hpp"
#include "geometry/Primitives.hpp"

#include <Teuchos_ParameterList.hpp>

#include <vector>

namespace Rhegma
{
namespace Geometry
{

enum class Operation
{
  Add,
  Cut
};

/// A primitive turned about a point.
template <int D>
struct Part
{
  Primitive<D> primitive;
  Frame<D> frame;
  Operation operation = Operation::Add;

  bool contains(const Vector<D>& x) const;
  /// Of the primitive [m].
  double depth(const Vector<D>& x) const;
  Coverage coverage(const BoxPoints<D>& box) const;
  /// Smallest bounds in 3D.
  Bounds<D> bounds() const;
  /// Smallest bounds in the part's own coordinates.
  Bounds<D> ownBounds() const;
};

} // namespace Geometry

template <int D>
class Shape
{
public:
  /// \param parts  at least one; the first is the base and is added whatever its operation says
  explicit Shape(std::vector<Geometry::Part<D>> parts);

  /// Whether the last operation that reaches x added it.
  bool contains(const Vector<D>& x) const;
  /// Positive inside, negative outside, zero on the surface [m]; where added parts touch each other it may be
  /// zero inside. It changes by no more than the distance between two points.
  double depth(const Vector<D>& x) const;
  /// How much of a box is inside, as far as that is certain.
  Geometry::Coverage coverage(const Geometry::BoxPoints<D>& box) const;
  /// Bounds of all that is added; cuts do not shrink them.
  Geometry::Bounds<D> bounds() const;
  /// The first primitive, whose axes and corner the particles follow.
  const Geometry::Part<D>& base() const { return parts_.front(); }
  const std::vector<Geometry::Part<D>>& parts() const { return parts_; }

private:
  std::vector<Geometry::Part<D>> parts_;
};

/// Reads the shape of a body.
///
/// `Shape`: Box (Lower Corner, Upper Corner), Ball (Centre, Radius), Cylinder (From, To, Radius; 3D) or
/// Polygon (Points: x y x y ...; Bottom and Top in 3D), or File (File, Scale, Origin). `Rotation` [degrees]
/// about `Rotation Centre` (default: the middle of the primitive's bounds) and, in 3D, `Rotation Axis`
/// (default 0 0 1). The sublist `Operations` holds sublists of the same parameters and `Operation` = Add or
/// Cut, applied in their order; each is turned by its own rotation only. Other parameters of the list are
/// ignored; an empty array counts as absent.
///
/// Throws std::invalid_argument with the path of the section.
template <int D>
Shape<D> makeShape(const Teuchos::ParameterList& body);

} // namespace Rhegma
