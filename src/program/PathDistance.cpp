#include "program/PathDistance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Rhegma::program
{

namespace
{

using Point = std::vector<double>;

constexpr double noDistance = std::numeric_limits<double>::quiet_NaN();

/// From a point to a segment.
double toSegment(const Point& x, const Point& a, const Point& b)
{
  double along = 0.0, length = 0.0;
  for (std::size_t d = 0; d < x.size(); ++d)
  {
    along += (x[d] - a[d]) * (b[d] - a[d]);
    length += (b[d] - a[d]) * (b[d] - a[d]);
  }
  const double fraction = length > 0.0 ? std::clamp(along / length, 0.0, 1.0) : 0.0;
  Point nearest(x.size());
  for (std::size_t d = 0; d < x.size(); ++d)
    nearest[d] = a[d] + fraction * (b[d] - a[d]);
  return distanceBetween(x, nearest);
}

} // namespace

double distanceBetween(const Point& a, const Point& b)
{
  double sum = a.size() == b.size() && !a.empty() ? 0.0 : noDistance;
  for (std::size_t d = 0; d < std::min(a.size(), b.size()); ++d)
    sum += (a[d] - b[d]) * (a[d] - b[d]);
  return std::sqrt(sum);
}

double distanceBetweenPaths(std::vector<Point> one, std::vector<Point> other)
{
  const auto length = [](const std::vector<Point>& path)
  {
    double sum = 0.0;
    for (std::size_t k = 1; k < path.size(); ++k)
      sum += distanceBetween(path[k - 1], path[k]);
    return sum;
  };
  if (one.size() < 2 || other.size() < 2)
    return noDistance;
  if (length(one) > length(other))
    std::swap(one, other);
  double most = 0.0;
  for (const Point& x : one)
  {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k < other.size(); ++k)
      least = std::min(least, toSegment(x, other[k - 1], other[k]));
    most = std::max(most, least);
  }
  return most;
}

} // namespace Rhegma::program
