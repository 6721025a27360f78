#include "geometry/SurfaceChoice.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::Geometry
{

namespace
{

template <int D>
bool isIn(const Bounds<D>& box, const Vector<D>& x, double slack)
{
  for (int d = 0; d < D; ++d)
    if (x[d] < box.lower[d] - slack || x[d] > box.upper[d] + slack)
      return false;
  return true;
}

/// Whether a part before this one has a surface at x, of which the point was taken.
template <int D>
bool isTaken(const Shape<D>& shape, std::size_t part, const Vector<D>& x, double slack)
{
  const auto first = shape.parts().begin();
  return std::any_of(first, first + static_cast<std::ptrdiff_t>(part),
                     [&](const Part<D>& earlier) { return std::abs(earlier.depth(x)) < slack; });
}

} // namespace

template <int D>
bool NormalRange<D>::holds(const Vector<D>& normal) const
{
  const double pi = std::acos(-1.0), slack = 1e-6;
  const double cosine = dot(direction, normal) / norm(direction);
  const double angle = std::acos(std::min(1.0, std::max(-1.0, cosine))) * 180.0 / pi;
  return (around ? std::abs(90.0 - angle) : angle) <= largestAngle + slack;
}

template <int D>
std::vector<SurfacePoint<D>> chosenPoints(const Shape<D>& shape, const SurfaceChoice<D>& choice,
                                          double spacing)
{
  const double slack = 1e-6 * spacing;
  std::vector<SurfacePoint<D>> chosen;
  for (std::size_t part = 0; part < shape.parts().size(); ++part)
  {
    if (choice.part && *choice.part != part)
      continue;
    for (const SurfacePoint<D>& point : surfacePoints(shape, part, spacing))
      if ((!choice.box || isIn(*choice.box, point.x, slack)) &&
          (!choice.facing || choice.facing->holds(point.normal)) && !isTaken(shape, part, point.x, slack))
        chosen.push_back(point);
  }
  return chosen;
}

template struct NormalRange<2>;
template struct NormalRange<3>;
template std::vector<SurfacePoint<2>> chosenPoints(const Shape<2>&, const SurfaceChoice<2>&, double);
template std::vector<SurfacePoint<3>> chosenPoints(const Shape<3>&, const SurfaceChoice<3>&, double);

} // namespace Rhegma::Geometry
