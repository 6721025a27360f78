#pragma once
/// Which supports hold a part of a scene.

#include "geometry/Frame.hpp"
#include "plan/BoundaryType.hpp"

#include <vector>

namespace Rhegma
{

/// Whether a support holds nodes of a box, or of its surroundings within a gap. \param gap [m]
template <int D>
bool reaches(const BoundaryRegion& support, const Geometry::Bounds<D>& box, double gap)
{
  using Kind = BoundaryRegion::Kind;
  bool meets = true, within = true;
  for (int d = 0; d < D; ++d)
  {
    const bool counts = support.kind != Kind::Mirror || support.axes[0] == 'x' + d;
    meets =
        meets && (!counts || (support.from[d] <= box.upper[d] + gap && support.to[d] >= box.lower[d] - gap));
    within = within && support.from[d] < box.lower[d] - gap && support.to[d] > box.upper[d] + gap;
  }
  return support.kind == Kind::HeldOutside ? !within : meets;
}

/// The boxes in which supports hold nodes, in their order; nowhere of those that hold the outside.
template <int D>
std::vector<Geometry::Bounds<D>> boxesOfSupports(const std::vector<BoundaryRegion>& supports)
{
  std::vector<Geometry::Bounds<D>> boxes;
  for (const BoundaryRegion& support : supports)
  {
    boxes.push_back(Geometry::emptyBounds<D>());
    for (int d = 0; d < D && support.kind == BoundaryRegion::Kind::Held; ++d)
    {
      boxes.back().lower[d] = support.from[d];
      boxes.back().upper[d] = support.to[d];
    }
  }
  return boxes;
}

} // namespace Rhegma
