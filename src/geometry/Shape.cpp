#include "geometry/Shape.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace Rhegma
{
namespace Geometry
{

template <int D>
bool Part<D>::contains(const Vector<D>& x) const
{
  const Vector<D> own = frame.toOwn(x);
  return std::visit([&](const auto& p) { return p.contains(own); }, primitive);
}

template <int D>
double Part<D>::depth(const Vector<D>& x) const
{
  const Vector<D> own = frame.toOwn(x);
  return std::visit([&](const auto& p) { return p.depth(own); }, primitive);
}

namespace
{

/// The depth of a point as far as it matters for a box: a larger one is given as its reach.
template <class Any, int D>
double depthFor(const Any& primitive, const Vector<D>& own, double)
{
  return primitive.depth(own);
}
template <int D>
double depthFor(const FileShape<D>& shape, const Vector<D>& own, double reach)
{
  return shape.depth(own, reach);
}

} // namespace

template <int D>
Coverage Part<D>::coverage(const BoxPoints<D>& box) const
{
  const Vector<D> own = frame.toOwn(box.centre);
  const double middle = std::visit([&](const auto& p) { return depthFor(p, own, box.reach); }, primitive);
  if (middle >= box.reach)
    return Coverage::Whole;
  if (middle <= -box.reach)
    return Coverage::None;
  if (middle < 0.0 || !std::visit([](const auto& p) { return p.convex; }, primitive))
    return Coverage::Unknown;
  // Corners on the surface are inside whatever the rounding.
  const double slack = 1e-9 * box.reach;
  const bool whole = std::all_of(box.corners.begin(), box.corners.end(),
                                 [&](const Vector<D>& corner) { return depth(corner) >= -slack; });
  return whole ? Coverage::Whole : Coverage::Unknown;
}

template <int D>
Bounds<D> Part<D>::bounds() const
{
  return std::visit([&](const auto& p) { return p.bounds(frame); }, primitive);
}

template <int D>
Bounds<D> Part<D>::ownBounds() const
{
  const Frame<D> straight{spaceAxes<D>(), Vector<D>{}};
  return std::visit([&](const auto& p) { return p.bounds(straight); }, primitive);
}

template struct Part<2>;
template struct Part<3>;

} // namespace Geometry

template <int D>
Shape<D>::Shape(std::vector<Geometry::Part<D>> parts) : parts_(std::move(parts))
{
  if (parts_.empty())
    throw std::invalid_argument("A shape needs at least one primitive.");
  parts_.front().operation = Geometry::Operation::Add;
}

template <int D>
bool Shape<D>::contains(const Vector<D>& x) const
{
  for (auto part = parts_.rbegin(); part != parts_.rend(); ++part)
    if (part->contains(x))
      return part->operation == Geometry::Operation::Add;
  return false;
}

template <int D>
double Shape<D>::depth(const Vector<D>& x) const
{
  double depth = parts_.front().depth(x);
  for (auto part = parts_.begin() + 1; part != parts_.end(); ++part)
    depth = part->operation == Geometry::Operation::Add ? std::max(depth, part->depth(x))
                                                        : std::min(depth, -part->depth(x));
  return depth;
}

template <int D>
Geometry::Coverage Shape<D>::coverage(const Geometry::BoxPoints<D>& box) const
{
  using Geometry::Coverage;
  Coverage all = parts_.front().coverage(box);
  for (auto part = parts_.begin() + 1; part != parts_.end(); ++part)
  {
    const bool adds = part->operation == Geometry::Operation::Add;
    const Coverage after = adds ? Coverage::Whole : Coverage::None;
    if (all == after)
      continue;
    const Coverage one = part->coverage(box);
    if (one != Coverage::None)
      all = one == Coverage::Whole ? after : Coverage::Unknown;
  }
  return all;
}

template <int D>
Geometry::Bounds<D> Shape<D>::bounds() const
{
  Geometry::Bounds<D> result = Geometry::emptyBounds<D>();
  for (const auto& part : parts_)
    if (part.operation == Geometry::Operation::Add)
      result.include(part.bounds());
  return result;
}

template class Shape<2>;
template class Shape<3>;

} // namespace Rhegma
