#include "geometry/Shape.hpp"

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
