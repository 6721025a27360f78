#include "plausibility/BodyGroups.hpp"

#include "plausibility/SupportReach.hpp"

#include <Teuchos_Array.hpp>

#include <algorithm>

namespace Rhegma
{

namespace
{

using Geometry::Bounds;

template <int D>
std::vector<Bounds<D>> boundsOf(const std::vector<BodyMeasure<D>>& bodies)
{
  std::vector<Bounds<D>> bounds;
  bounds.reserve(bodies.size());
  for (const BodyMeasure<D>& body : bodies)
    bounds.push_back({body.lower, body.upper});
  return bounds;
}

} // namespace

template <int D>
BodyGroups<D>::BodyGroups(const std::vector<BodyMeasure<D>>& bodies, double cell)
    : bodies_(bodies), cell_(cell), bounds_(boundsOf(bodies)), boxes_(bounds_), groupOf_(bodies.size(), -1)
{
}

template <int D>
int BodyGroups<D>::of(int first)
{
  if (groupOf_[first] >= 0)
    return groupOf_[first];
  const int number = static_cast<int>(groups_.size());
  BodyGroup<D> group{bounds_[first]};
  group.bodies.push_back(first);
  groupOf_[first] = number;
  for (std::size_t k = 0; k < group.bodies.size(); ++k)
  {
    const int body = group.bodies[k];
    group.bounds.include(bounds_[body]);
    group.mass += bodies_[body].mass;
    for (const int other : boxes_.near(bounds_[body], 2.0 * cell_))
      if (groupOf_[other] < 0)
      {
        groupOf_[other] = number;
        group.bodies.push_back(other);
      }
  }
  groups_.push_back(std::move(group));
  return number;
}

template <int D>
bool BodyGroups<D>::isStopped(int number, const Vector<D>& by,
                              const std::vector<BoundaryRegion>& supports) const
{
  const Bounds<D>& bounds = groups_[number].bounds;
  Bounds<D> swept = bounds;
  swept.include({bounds.lower + by, bounds.upper + by});
  for (const BoundaryRegion& support : supports)
    if (!reaches(support, bounds, cell_) && reaches(support, swept, cell_))
      return true;
  const std::vector<int> near = boxes_.near(swept, cell_);
  return std::any_of(near.begin(), near.end(), [&](int body) { return groupOf_[body] != number; });
}

template <int D>
bool isThrown(const Teuchos::ParameterList& scene, const std::vector<BodyMeasure<D>>& bodies,
              const std::vector<int>& numbers)
{
  const Teuchos::ParameterList& section = scene.sublist("Bodies");
  for (const int body : numbers)
    for (const char* const motion : {"Velocity", "Angular Velocity"})
      for (const double v : section.sublist(bodies[body].name).template get<Teuchos::Array<double>>(motion))
        if (v != 0.0)
          return true;
  return false;
}

template class BodyGroups<2>;
template class BodyGroups<3>;
template bool isThrown(const Teuchos::ParameterList&, const std::vector<BodyMeasure<2>>&,
                       const std::vector<int>&);
template bool isThrown(const Teuchos::ParameterList&, const std::vector<BodyMeasure<3>>&,
                       const std::vector<int>&);

} // namespace Rhegma
