#include "boundary/DomainEdges.hpp"

#include "base/EntryValue.hpp"
#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "geometry/Shape.hpp"

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

MirroredSides::MirroredSides(const ParameterList& scene) : supports_(boundaryRegions(scene))
{
  supports_.erase(std::remove_if(supports_.begin(), supports_.end(),
                                 [](const BoundaryRegion& region)
                                 { return region.kind == BoundaryRegion::Kind::Force; }),
                  supports_.end());
}

template <int D>
bool MirroredSides::has(const Geometry::Bounds<D>& part, int axis, bool upper, double slack) const
{
  using Kind = BoundaryRegion::Kind;
  const double side = upper ? part.upper[axis] : part.lower[axis];
  const double opposite = upper ? part.lower[axis] : part.upper[axis];
  return std::any_of(supports_.begin(), supports_.end(),
                     [&](const BoundaryRegion& support)
                     {
                       if (!holds(support, axis, side, slack) || holds(support, axis, opposite, -slack))
                         return false;
                       bool whole = true;
                       for (int d = 0; d < D; ++d)
                         whole = whole && (d == axis || support.kind != Kind::Held ||
                                           (support.from[d] <= part.lower[d] + slack &&
                                            support.to[d] >= part.upper[d] - slack));
                       return whole;
                     });
}

template bool MirroredSides::has(const Geometry::Bounds<2>&, int, bool, double) const;
template bool MirroredSides::has(const Geometry::Bounds<3>&, int, bool, double) const;

template <int D>
std::vector<std::string> warningsOfEdges(const ParameterList& scene)
{
  const ParameterList& domain = scene.sublist("Domain");
  const Vector<D> lower = readVector<D>(domain, "Lower Corner"),
                  upper = readVector<D>(domain, "Upper Corner");
  const std::vector<BoundaryRegion> supports = boundaryRegions(scene);
  const double slack = 1e-6 * domain.get<double>("Cell Size");
  std::vector<std::string> warnings;
  for (const auto& entry : scene.sublist("Bodies"))
  {
    const std::string& name = entry.first;
    const auto* const body = valueIf<ParameterList>(entry.second);
    if (body == nullptr)
      continue;
    const auto bounds = makeShape<D>(*body).bounds();
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
