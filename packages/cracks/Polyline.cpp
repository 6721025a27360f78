#include "base/Numbers.hpp"
#include "cracks/CrackMesh.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Rhegma::cracks
{

namespace
{

using Points = std::vector<Vector<2>>;

double distanceToSegment(const Vector<2>& x, const Vector<2>& a, const Vector<2>& b)
{
  const Vector<2> t = b - a;
  const double s = std::clamp(dot(x - a, t) / dot(t, t), 0.0, 1.0);
  return norm(x - a - s * t);
}

/// What lies outside of the bodies is cut off later, piece by piece; a unit or an exponent that is wrong
/// would make too many pieces.
void refuseLong(const Points& points, const std::string& where, double spacing)
{
  double cells = 0.0;
  for (std::size_t k = 1; k < points.size(); ++k)
    cells += norm(points[k] - points[k - 1]) / spacing;
  if (!(cells <= 1e5))
    throw std::invalid_argument(where + ": the crack is " + formatReal(cells) +
                                " cells long; write its points in metres, not far outside of the body");
}

/// Whether the segments a-b and c-d have a point in common.
bool meet(const Vector<2>& a, const Vector<2>& b, const Vector<2>& c, const Vector<2>& d, double tolerance)
{
  const auto turn = [](const Vector<2>& p, const Vector<2>& q, const Vector<2>& r)
  { return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]); };
  if (turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0)
    return true;
  return std::min({distanceToSegment(a, c, d), distanceToSegment(b, c, d), distanceToSegment(c, a, b),
                   distanceToSegment(d, a, b)}) < tolerance;
}

void refuseCrossing(const Points& points, const std::string& where, double spacing)
{
  const double tolerance = 1e-6 * spacing;
  const auto refuse = [&](std::size_t i, std::size_t j)
  {
    throw std::invalid_argument(where + ": the piece after point " + std::to_string(j + 1) +
                                " meets the piece after point " + std::to_string(i + 1) +
                                " (counted from 1); write a line that neither crosses itself nor turns back");
  };
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    for (std::size_t j = i + 1; j + 1 < points.size(); ++j)
      // Neighbours share a point; they overlap if the end of one lies on the other.
      if (j == i + 1 ? distanceToSegment(points[j + 1], points[i], points[j]) < tolerance ||
                           distanceToSegment(points[i], points[j], points[j + 1]) < tolerance
                     : meet(points[i], points[i + 1], points[j], points[j + 1], tolerance))
        refuse(i, j);
}

Points readPoints(const Teuchos::ParameterList& list, const std::string& where, double spacing)
{
  const auto values = list.get<Teuchos::Array<double>>("Points");
  Points points;
  for (int k = 0; k + 1 < values.size(); k += 2)
    points.push_back({values[k], values[k + 1]});
  for (std::size_t k = 1; k < points.size(); ++k)
    if (norm(points[k] - points[k - 1]) < 1e-6 * spacing)
      throw std::invalid_argument(where + ": " + samePoints);
  refuseLong(points, where, spacing);
  refuseCrossing(points, where, spacing);
  return points;
}

/// Cells: the crack follows the faces, and the opening between its vertices is a straight line. Shorter
/// pieces show what single nodes do: a diagonal crack that is pulled open seems to overlap in places.
constexpr double longestSegment = 4.0;

/// Equal pieces no longer than `longest`.
Points refine(const Points& points, double longest)
{
  Points fine{points.front()};
  for (std::size_t k = 1; k < points.size(); ++k)
  {
    const Vector<2> along = points[k] - points[k - 1];
    const int pieces = std::max(1, static_cast<int>(std::ceil(norm(along) / longest - 1e-9)));
    for (int i = 1; i <= pieces; ++i)
      fine.push_back(points[k - 1] + (double(i) / pieces) * along);
  }
  return fine;
}

/// Drops what lies outside of the bodies at both ends, to a hundredth of a cell.
Points clip(const Points& points, const MaterialPlaces<2>& material, double spacing)
{
  const Points dense = refine(points, 0.01 * spacing);
  std::size_t first = 0, last = dense.size();
  while (first < dense.size() && !material.at(dense[first]))
    ++first;
  while (last > first && !material.at(dense[last - 1]))
    --last;
  if (last < first + 2)
    return {};
  // Keep the user's own points that are left, between the two ends.
  Points kept{dense[first]};
  double from = 0.0;
  for (std::size_t k = 0; k < first; ++k)
    from += norm(dense[k + 1] - dense[k]);
  double to = from;
  for (std::size_t k = first; k + 1 < last; ++k)
    to += norm(dense[k + 1] - dense[k]);
  double at = 0.0;
  for (std::size_t k = 1; k + 1 < points.size(); ++k)
  {
    at += norm(points[k] - points[k - 1]);
    if (at > from + 1e-9 * spacing && at < to - 1e-9 * spacing)
      kept.push_back(points[k]);
  }
  kept.push_back(dense[last - 1]);
  return kept;
}

Vector<2> unit(const Vector<2>& a) { return (1.0 / norm(a)) * a; }

/// An end is a front if the user's crack ends there and there is material one cell ahead of it.
bool isFront(const Vector<2>& end, const Vector<2>& before, const MaterialPlaces<2>& material, double spacing)
{
  const Vector<2> ahead = unit(end - before);
  for (const double step : {0.25, 0.5, 0.75, 1.0})
    if (!material.at(end + (step * spacing) * ahead))
      return false;
  return true;
}

/// What to say of an end that stops in the material but is no front; nothing of one that reaches the surface.
void warnOfBridge(const Vector<2>& end, const Vector<2>& before, const std::string& where,
                  const MaterialPlaces<2>& material, double spacing, std::vector<std::string>& warnings)
{
  if (material.at(end + (0.5 * spacing) * unit(end - before)))
    warnings.push_back(where + ": less than a cell of material is left ahead of the end at " +
                       formatReal(end[0]) + ", " + formatReal(end[1]) +
                       ", so it counts as broken; take smaller cells (Domain > Cell Size), or choose Fronts");
}

} // namespace

CrackMesh<2> readPolyline(const Teuchos::ParameterList& list, const std::string& where,
                          const MaterialPlaces<2>& material, double spacing)
{
  const Points given = readPoints(list, where, spacing);
  const Points inside = clip(given, material, spacing);
  if (inside.empty())
    throw std::invalid_argument(where + ": " + outsideOfBodies);
  const Points points = refine(inside, longestSegment * spacing);
  const std::string fronts = list.get<std::string>("Fronts");
  const bool firstGiven = norm(points.front() - given.front()) < 1e-9 * spacing;
  const bool lastGiven = norm(points.back() - given.back()) < 1e-9 * spacing;
  const bool first = fronts == "Automatic" ? firstGiven && isFront(points[0], points[1], material, spacing)
                                           : fronts == "First" || fronts == "Both";
  const bool last = fronts == "Automatic"
                        ? lastGiven && isFront(points.back(), points[points.size() - 2], material, spacing)
                        : fronts == "Last" || fronts == "Both";
  CrackMesh<2> mesh;
  if (fronts == "Automatic" && firstGiven && !first)
    warnOfBridge(points[0], points[1], where, material, spacing, mesh.warnings);
  if (fronts == "Automatic" && lastGiven && !last)
    warnOfBridge(points.back(), points[points.size() - 2], where, material, spacing, mesh.warnings);
  mesh.vertices = points;
  const int segments = static_cast<int>(points.size()) - 1;
  for (int s = 0; s < segments; ++s)
  {
    mesh.simplices.push_back({s, s + 1});
    mesh.beyond.push_back({s + 1, s - 1});
  }
  mesh.beyond.front()[1] = first ? facet::front : facet::mouth;
  mesh.beyond.back()[0] = last ? facet::front : facet::mouth;
  return mesh;
}

} // namespace Rhegma::cracks
