#pragma once
/// Bodies that touch the edge of the domain, and planes at which supports hold them.

#include "geometry/Frame.hpp"
#include "plan/BoundaryType.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace Rhegma
{

/// Sides of bodies at which a support stands for what lies beyond, as a mirror does.
class MirroredSides
{
public:
  /// \param scene validated
  explicit MirroredSides(const Teuchos::ParameterList& scene);

  /// Whether a support holds the whole lower or upper side of a part along an axis and leaves the opposite
  /// side free: one that holds both moves the part as a whole. \param slack [m]
  template <int D>
  bool has(const Geometry::Bounds<D>& part, int axis, bool upper, double slack) const;

private:
  std::vector<BoundaryRegion> supports_;
};

/// A warning for each body and each face of the domain that it touches at the start without a support normal
/// to that face: it can't move beyond, and the run would end if it does.
/// \param scene validated
template <int D>
std::vector<std::string> warningsOfEdges(const Teuchos::ParameterList& scene);

} // namespace Rhegma
