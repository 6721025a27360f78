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

  /// Distance to the nearest surface along the axes and the diagonals between them [m], to a hundredth; 0
  /// outside, and below 1e-9 of the bodies' extent.
  double depth(const Vector<D>& x) const;

  /// The largest edge up to `most` of which a grid from `corner` has all faces of the bodies' bounds on its
  /// lines, unless that would take cells smaller by more than a third: particles of cells that a face cuts
  /// are not where those of whole cells are, and displacements given on it are off by up to half a cell.
  double fit(double most, const Teuchos::Array<double>& corner) const;

private:
  double nearest(const Vector<D>& x, double span) const;
  double reach(const Vector<D>& x, const Vector<D>& way, double most) const;

  std::vector<Shape<D>> shapes_;
  double extent_ = 0.0; ///< the longest edge of their bounds
};

} // namespace Rhegma
