#pragma once
/// The bodies of a scene as shapes, before there are cells.

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

  /// Distance to the nearest surface along the axes and the diagonals between them [m], to 1 %; 0 outside,
  /// and where below 1e-9 of the bodies' extent.
  double depth(const Vector<D>& x) const;

  /// The largest cell edge up to `most` for which all faces of the bodies' bounds lie on lines of a grid from
  /// `corner`, unless that needs cells of less than half of `most` (two thirds in 3D). In cells that a face cuts, particles are
  /// shifted, and displacements prescribed on the face are off by up to half a cell.
  double fit(double most, const Teuchos::Array<double>& corner) const;

  /// How far along a direction all positions are inside [m]. It is searched in 400 steps up to `most`;
  /// infinite if there is no end. \param direction of length one
  double reach(const Vector<D>& x, const Vector<D>& direction, double most) const;

  double extent() const { return extent_; } ///< the longest edge of their bounds [m]

private:
  double nearest(const Vector<D>& x, double span) const;

  std::vector<Shape<D>> shapes_;
  double extent_ = 0.0;
};

} // namespace Rhegma
