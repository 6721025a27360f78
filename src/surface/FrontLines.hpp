#pragma once
/// The vertices of a front while its crack grows.

#include "base/Types.hpp"

#include <algorithm>
#include <vector>

namespace Rhegma::surface
{

/// A vertex on a front.
template <int D>
struct FrontPoint
{
  int vertex = 0; ///< of the crack
  int name = 0;   ///< number that stays the same while the front grows
  int from = -1;  ///< the point, by name, that it came from when the front grew; -1: it was there
  int origin = 0; ///< index of the same point, or the point that it was copied from, before the front grew
  bool joined = false;    ///< a piece of front runs from it to the next
  bool landed = false;    ///< it has reached the surface of the body
  bool stopped = false;   ///< it does not advance
  double toughness = 0.0; ///< of the last face that it made [J/m2]
  Vector<D> direction{};  ///< unit vector of straight growth
  Vector<D> normal{};     ///< unit normal of the crack
};

/// The pieces of a front, one line after another; closed where the last point is joined to the first. A front
/// in 2D is one point.
template <int D>
using FrontLines = std::vector<FrontPoint<D>>;

/// The point after the k-th, the first after the last.
template <int D>
std::size_t nextPoint(const FrontLines<D>& lines, std::size_t k)
{
  return k + 1 < lines.size() ? k + 1 : 0;
}

/// The point before the k-th on its line, or -1.
template <int D>
int previousPoint(const FrontLines<D>& lines, std::size_t k)
{
  const std::size_t last = k > 0 ? k - 1 : lines.size() - 1;
  return lines[last].joined ? static_cast<int>(last) : -1;
}

/// Mean toughness of two points; if only one has made a face, its toughness [J/m2].
template <int D>
double meanToughness(const FrontPoint<D>& a, const FrontPoint<D>& b)
{
  return a.toughness > 0.0 && b.toughness > 0.0 ? 0.5 * (a.toughness + b.toughness)
                                                : std::max(a.toughness, b.toughness);
}

/// Removes pieces between points that have landed, and isolated landed points, from the lines.
template <int D>
void cutLanded(FrontLines<D>& lines);

} // namespace Rhegma::surface
