#include "boundary/DomainEdges.hpp"

#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "geometry/Shape.hpp"
#include "plan/BoundaryType.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma
{

namespace
{

using Teuchos::ParameterList;

/// Whether a support holds nodes on the plane where an axis has this value.
bool holds(const BoundaryRegion& support, int axis, double value, double slack)
{
  return support.axes.find("xyz"[axis]) != std::string::npos &&
         (support.kind == BoundaryRegion::Kind::HeldOutside
              ? value <= support.from[axis] + slack || value >= support.to[axis] - slack
              : support.from[axis] <= value + slack && support.to[axis] >= value - slack);
}

bool isHeld(const std::vector<BoundaryRegion>& supports, int axis, double value, double slack)
{
  return std::any_of(supports.begin(), supports.end(),
                     [&](const BoundaryRegion& support) { return holds(support, axis, value, slack); });
}

} // namespace

bool isSupportedPlane(const ParameterList& scene, int axis, double value, double slack)
{
  return isHeld(boundaryRegions(scene), axis, value, slack);
}

template <int D>
std::vector<std::string> warningsOfEdges(const ParameterList& scene)
{
  const ParameterList& domain = scene.sublist("Domain");
  const Vector<D> lower = readVector<D>(domain, "Lower Corner"),
                  upper = readVector<D>(domain, "Upper Corner");
  const std::vector<BoundaryRegion> supports = boundaryRegions(scene);
  const double slack = 1e-6 * domain.get<double>("Cell Size");
  std::vector<std::string> warnings;
  for (const std::string& name : sublistNames(scene.sublist("Bodies")))
  {
    const auto bounds = makeShape<D>(scene.sublist("Bodies").sublist(name)).bounds();
    for (int d = 0; d < D; ++d)
      for (const bool low : {true, false})
      {
        const double edge = low ? lower[d] : upper[d], face = low ? bounds.lower[d] : bounds.upper[d];
        if (std::fabs(face - edge) <= slack && !isHeld(supports, d, edge, slack))
          warnings.push_back(
              "Bodies > " + name + ": it touches the domain's edge at " + "xyz"[d] + " = " +
              formatReal(edge) +
              " m and is not supported there; the run stops if it moves outside: enlarge the domain by a few "
              "cells, or support that face (Boundaries, Symmetry or Velocity)");
      }
  }
  return warnings;
}

template std::vector<std::string> warningsOfEdges<2>(const ParameterList&);
template std::vector<std::string> warningsOfEdges<3>(const ParameterList&);

} // namespace Rhegma
