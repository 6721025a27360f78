#include "boundary/MirrorPlanes.hpp"

#include "plan/BoundaryType.hpp"

namespace Rhegma
{

std::vector<MirrorPlane> mirrorPlanes(const Teuchos::ParameterList& scene)
{
  std::vector<MirrorPlane> planes;
  for (const BoundaryRegion& region : boundaryRegions(scene))
    if (region.kind == BoundaryRegion::Kind::Mirror)
      planes.push_back({region.axes[0] - 'x', region.from[region.axes[0] - 'x']});
  return planes;
}

} // namespace Rhegma
