#include "geometry/MendSurface.hpp"

#include "base/Counted.hpp"
#include "base/Numbers.hpp"
#include "geometry/HalfEdges.hpp"
#include "geometry/MeetingTriangles.hpp"
#include "geometry/MergePoints.hpp"
#include "geometry/Shells.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>

namespace Rhegma::Geometry
{

namespace
{

/// Rounding of positions in files, of the largest coordinate: a few units of the last place of the single
/// precision that binary STL files have.
constexpr double inSinglePrecision = 4.0 * 5.97e-8;
/// A unit of the last of six digits, which most programs write as text.
constexpr double inSixDigits = 1e-5;

/// Edges that belong to one triangle only.
struct OpenEdges
{
  std::vector<std::array<int, 2>> edges;
  std::vector<int> points; ///< each once
  double shortest = std::numeric_limits<double>::infinity();
};

/// Whether each edge belongs to two triangles.
bool isClosed(const Simplices<3>& surface)
{
  bool found = true;
  HalfEdges(surface.items).forEachEdge([&](const HalfEdge*, int count) { found = found && count == 2; });
  return found;
}

OpenEdges openEdgesOf(const Simplices<3>& surface)
{
  OpenEdges open;
  HalfEdges(surface.items)
      .forEachEdge(
          [&](const HalfEdge* side, int count)
          {
            if (count != 1)
              return;
            open.edges.push_back({side->lower(), side->upper()});
            open.points.insert(open.points.end(), {side->lower(), side->upper()});
            open.shortest =
                std::min(open.shortest, norm(surface.points[side->lower()] - surface.points[side->upper()]));
          });
  std::sort(open.points.begin(), open.points.end());
  open.points.erase(std::unique(open.points.begin(), open.points.end()), open.points.end());
  return open;
}

/// Bounds of each connected set of open edges.
std::vector<Bounds<3>> holesOf(const Simplices<3>& surface, const OpenEdges& open)
{
  std::map<int, int> hole; // of each point; the smallest number that is found from its edges
  for (const int point : open.points)
    hole[point] = point;
  const auto rootOf = [&](int point)
  {
    while (hole[point] != point)
      point = hole[point] = hole[hole[point]];
    return point;
  };
  for (const auto& edge : open.edges)
    hole[rootOf(edge[0])] = rootOf(edge[1]);
  std::map<int, Bounds<3>> bounds;
  for (const int point : open.points)
    bounds.emplace(rootOf(point), emptyBounds<3>()).first->second.include(surface.points[point]);
  std::vector<Bounds<3>> found;
  for (const auto& [root, one] : bounds)
    found.push_back(one);
  return found;
}

void refuseOpen(const Simplices<3>& surface, const OpenEdges& open)
{
  if (open.edges.empty())
    return;
  const std::vector<Bounds<3>> holes = holesOf(surface, open);
  const auto sizeOf = [](const Bounds<3>& hole) { return norm(hole.upper - hole.lower); };
  const Bounds<3>& largest =
      *std::max_element(holes.begin(), holes.end(),
                        [&](const Bounds<3>& a, const Bounds<3>& b) { return sizeOf(a) < sizeOf(b); });
  const int count = static_cast<int>(holes.size());
  throw std::invalid_argument(
      "the surface is not closed: " + counted(static_cast<int>(open.edges.size()), "edge") +
      (open.edges.size() == 1 ? " belongs" : " belong") + " to one triangle only, round " +
      counted(count, "gap") + (count == 1 ? "" : ", the largest") + " at " + placeInFile(largest.centre()) +
      ", " + formatReal(sizeOf(largest)) + " across; close it in the program that made the file");
}

void refuseCrowded(const Simplices<3>& surface)
{
  int crowded = 0;
  Vector<3> from{}, to{};
  HalfEdges(surface.items)
      .forEachEdge(
          [&](const HalfEdge* side, int count)
          {
            if (count <= 2 || crowded++ > 0)
              return;
            from = surface.points[side->lower()];
            to = surface.points[side->upper()];
          });
  if (crowded > 0)
    throw std::invalid_argument(
        counted(crowded, "edge") + (crowded == 1 ? " belongs" : " belong") +
        " to more than two triangles, such as that from " + placeInFile(from) + " to " + placeInFile(to) +
        ": parts touch there, or a wall has no thickness; unite the parts or write each as "
        "a file of its own, and remove such walls");
}

/// Leaves out triangles with the same three points as others, where the surface is closed with one of them,
/// or with none. \return their number, and a position of the first
std::pair<int, Vector<3>> dropRepeated(Simplices<3>& surface)
{
  using Points = std::array<int, 3>;
  const auto pointsOf = [&](int t)
  {
    Points points = surface.items[t];
    std::sort(points.begin(), points.end());
    return points;
  };
  std::map<Points, std::vector<int>> groups; // of triangles at crowded edges
  std::map<std::uint64_t, int> sides;        // how many different triangles such an edge has
  HalfEdges(surface.items)
      .forEachEdge(
          [&](const HalfEdge* side, int count)
          {
            std::set<Points> different;
            for (int k = 0; k < count && count > 2; ++k)
            {
              different.insert(pointsOf(side[k].triangle()));
              groups[pointsOf(side[k].triangle())].push_back(side[k].triangle());
            }
            if (count > 2)
              sides[side->edge] = static_cast<int>(different.size());
          });
  std::vector<char> gone(surface.items.size(), 0);
  std::pair<int, Vector<3>> found{0, {}};
  for (auto& [points, group] : groups)
  {
    std::sort(group.begin(), group.end());
    group.erase(std::unique(group.begin(), group.end()), group.end());
    const int size = static_cast<int>(group.size());
    if (size < 2)
      continue;
    int even = 0; // edges that are closed without these triangles
    for (int i = 0; i < 3; ++i)
    {
      const std::uint64_t low = std::min(points[i], points[(i + 1) % 3]),
                          high = std::max(points[i], points[(i + 1) % 3]);
      const auto all = sides.find(low << 32 | high);
      even += all == sides.end() || (all->second - 1) % 2 == 0 ? 1 : 0;
    }
    if (even != 0 && even != 3)
      continue;
    for (int k = even == 3 ? 0 : 1; k < size; ++k)
      gone[group[k]] = 1;
    if (found.first == 0)
      found.second = surface.points[points[0]];
    found.first += even == 3 ? size : size - 1;
  }
  std::size_t kept = 0;
  for (std::size_t t = 0; t < surface.items.size(); ++t)
    if (gone[t] == 0)
      surface.items[kept++] = surface.items[t];
  surface.items.resize(kept);
  return found;
}

/// Points that the single precision of files does not distinguish are no mistake.
void noteMerged(const MergedPoints& merged, MendedSurface<3>& mended)
{
  if (merged.pairs > 0 && merged.farthest > mended.resolution)
    mended.notes.push_back(counted(merged.pairs, "pair") + " of points up to " + formatReal(merged.farthest) +
                           " apart, such as at " + placeInFile(merged.at) + ", " +
                           (merged.pairs == 1 ? "was" : "were") + " merged");
}

void noteDropped(int count, const std::string& what, std::vector<std::string>& notes)
{
  if (count > 0)
    notes.push_back(counted(count, "triangle") + " " + what + (count == 1 ? " was" : " were") + " left out");
}

/// Merges points at open edges as far as a rounding of six digits explains the gap, if that closes the
/// surface.
void closeByRounding(MendedSurface<3>& mended, double largest)
{
  OpenEdges open = openEdgesOf(mended.surface);
  if (open.edges.empty())
    return;
  constexpr double clear = 0.1; // of the shortest edge: it is certain which points belong together
  Simplices<3> merged = mended.surface;
  const MergedPoints pairs =
      mergeNearPoints(merged, open.points, std::min(inSixDigits * largest, clear * open.shortest));
  dropCollapsed(merged);
  if (pairs.pairs == 0 || !openEdgesOf(merged).edges.empty())
    refuseOpen(mended.surface, open);
  mended.surface = std::move(merged);
  noteMerged(pairs, mended);
}

} // namespace

MendedSurface<3> mendSurface(const SurfaceMesh& mesh)
{
  MendedSurface<3> mended{mergeEqualPoints(mesh)};
  Simplices<3>& surface = mended.surface;
  double largest = 0.0;
  for (const Vector<3>& x : surface.points)
    for (int d = 0; d < 3; ++d)
      largest = std::max(largest, std::abs(x[d]));
  mended.resolution = inSinglePrecision * largest;
  int collapsed = dropCollapsed(surface);
  mergeShortEdges(surface, mended.resolution);
  collapsed += dropCollapsed(surface);
  noteDropped(collapsed, "without area", mended.notes);
  if (surface.items.empty())
    throw std::invalid_argument("no triangle has an area above the rounding of single precision");
  if (!isClosed(surface))
  {
    const auto [repeated, at] = dropRepeated(surface);
    noteDropped(repeated,
                "with the same points as " + std::string(repeated == 1 ? "another" : "others") +
                    ", such as at " + placeInFile(at) + ",",
                mended.notes);
    closeByRounding(mended, largest);
    refuseCrowded(surface);
  }
  const Shells shells = findShells(surface);
  refuseMeetings(surface, shells, mended.resolution);
  orientShells(surface, shells, mended.resolution, mended.notes);
  return mended;
}

} // namespace Rhegma::Geometry
