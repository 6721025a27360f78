#pragma once
/// The bodies of a scene as shapes, before there are cells.

#include "geometry/NearBoxes.hpp"
#include "geometry/Shape.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>

#include <vector>

namespace Rhegma
{

template <int D>
class SceneBodies
{
public:
  /// \param scene validated
  explicit SceneBodies(const Teuchos::ParameterList& scene);

  /// Whether x lies in one of them.
  bool contain(const Vector<D>& x) const;

  /// Whether x lies in one of them or no further than that outside: by Shape::depth, which is smaller than
  /// the distance at corners of boxes, by a factor of up to the root of D. \param outside [m]
  bool contain(const Vector<D>& x, double outside) const;

  /// Whether x lies in one of them, at least that far from its surface; where parts are added to each other
  /// it may be further and this false, as Shape::depth says. \param depth [m]
  bool isDeep(const Vector<D>& x, double depth) const;

  /// Distance to the nearest surface along the axes and the diagonals between them [m], to 1 %; 0 outside,
  /// and where below 1e-9 of the bodies' extent.
  double depth(const Vector<D>& x) const;

  /// The largest cell edge up to `most` for which all faces of the bodies' bounds lie on lines of a grid from
  /// `corner`, unless that needs cells of less than half of `most` (two thirds in 3D). In cells that a face
  /// cuts, particles are shifted, and displacements prescribed on the face are off by up to half a cell.
  double fit(double most, const Teuchos::Array<double>& corner) const;

  /// How far along a direction all positions are inside [m]. It is searched in 400 steps up to `most`;
  /// infinite if there is no end. \param direction of length one
  double reach(const Vector<D>& x, const Vector<D>& direction, double most) const;

  /// Bounds of the bodies whose bounds come within a distance of x [m].
  std::vector<Geometry::Bounds<D>> boundsNear(const Vector<D>& x, double distance) const;

  double extent() const { return extent_; } ///< the longest edge of their bounds [m]

private:
  double nearest(const Vector<D>& x, double span) const;

  /// Whether a condition holds for a shape whose bounds come within a distance of x.
  template <class Condition>
  bool any(const Vector<D>& x, double distance, const Condition& condition) const;

  std::vector<Shape<D>> shapes_;
  Geometry::NearBoxes<D> boxes_{{}}; ///< their bounds
  double extent_ = 0.0;
};

/// Estimated number of particles of all bodies, without refined cells: from a sample of positions, without
/// making them. \param scene validated, with a Cell Size
double estimateParticles(const Teuchos::ParameterList& scene);

} // namespace Rhegma
