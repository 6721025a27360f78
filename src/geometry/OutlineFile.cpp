#include "geometry/OutlineFile.hpp"

#include "base/Numbers.hpp"
#include "geometry/Primitives.hpp"
#include "geometry/Shells.hpp"
#include "geometry/SurfaceFile.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace Rhegma::Geometry
{

namespace
{

std::string nameOf(const Outline& outline)
{
  return "the polygon that begins at line " + std::to_string(outline.line);
}

/// Leaves out points that repeat the one before. \return their number
int dropRepeated(Outline& outline)
{
  std::vector<Vector<2>> kept;
  for (const Vector<2>& x : outline.points)
    if (kept.empty() || norm(x - kept.back()) > 0.0)
      kept.push_back(x);
  int count = static_cast<int>(outline.points.size() - kept.size());
  if (kept.size() > 1 && norm(kept.front() - kept.back()) == 0.0)
    kept.pop_back(); // a closing point is no mistake
  outline.points = std::move(kept);
  return count;
}

/// Adds the polygon's edges.
void append(const Outline& outline, Simplices<2>& surface)
{
  const int first = static_cast<int>(surface.points.size()), count = static_cast<int>(outline.points.size());
  for (int k = 0; k < count; ++k)
    surface.items.push_back({first + k, first + (k + 1) % count});
  surface.points.insert(surface.points.end(), outline.points.begin(), outline.points.end());
}

/// Whether an edge goes back on the one before it.
bool turnsBack(const Vector<2>& before, const Vector<2>& at, const Vector<2>& after)
{
  const Vector<2> a = at - before, b = after - at;
  const double across = a[0] * b[1] - a[1] * b[0];
  return dot(a, b) < 0.0 && std::abs(across) <= 1e-12 * norm(a) * norm(b);
}

void refuseMeetings(const Simplices<2>& surface, const std::vector<int>& polygon, const SimplexTree<2>& tree,
                    const std::vector<Outline>& outlines)
{
  for (int t = 0; t < static_cast<int>(surface.items.size()); ++t)
  {
    const Bounds<2> own = surface.boundsOf(t);
    const auto isNear = [&](const Bounds<2>& other)
    {
      for (int d = 0; d < 2; ++d)
        if (own.lower[d] > other.upper[d] || other.lower[d] > own.upper[d])
          return false;
      return true;
    };
    const auto& x = surface.points;
    tree.boxes().forEach(
        isNear,
        [&](int u)
        {
          const auto &a = surface.items[t], &b = surface.items[u];
          const bool follows = a[1] == b[0];
          const bool wrong = follows
                                 ? turnsBack(x[a[0]], x[a[1]], x[b[1]])
                                 : u > t && b[1] != a[0] && segmentsMeet(x[a[0]], x[a[1]], x[b[0]], x[b[1]]);
          if (wrong)
            throw std::invalid_argument(nameOf(outlines[polygon[t]]) + " meets " +
                                        (polygon[t] == polygon[u] ? "itself" : nameOf(outlines[polygon[u]])) +
                                        " at the edge from " + placeInFile(x[a[0]]) + " to " +
                                        placeInFile(x[a[1]]) + "; write polygons that do not touch or cross");
        });
  }
}

} // namespace

std::vector<Outline> parseOutlines(const std::string& text)
{
  std::vector<Outline> outlines;
  std::istringstream lines(text.substr(textBegin(text)));
  bool open = false;
  int number = 0;
  for (std::string line; std::getline(lines, line);)
  {
    ++number;
    const std::size_t comment = line.find('#');
    line = trimmed(line.substr(0, comment));
    if (line.empty())
    {
      open = open && comment != std::string::npos; // a comment separates no polygons
      continue;
    }
    if (number <= 8 && (line.find("<svg") != std::string::npos || line.find("<?xml") != std::string::npos))
      throw std::invalid_argument(
          "it is an SVG drawing; convert it by tools/rhegma-mesh, which writes polygons");
    const auto values = parseReals(line);
    if (!values || values->size() != 2 || !std::isfinite((*values)[0] + (*values)[1]))
      throw std::invalid_argument("line " + std::to_string(number) +
                                  " holds no point: write two finite numbers, x and y, or an "
                                  "empty line between polygons");
    if (!open)
      outlines.push_back({{}, number});
    open = true;
    outlines.back().points.push_back({(*values)[0], (*values)[1]});
  }
  if (outlines.empty())
    throw std::invalid_argument("the file holds no point");
  return outlines;
}

MendedSurface<2> mendOutlines(const std::vector<Outline>& outlines)
{
  MendedSurface<2> mended;
  std::vector<int> polygon; // of each edge
  int repeated = 0;
  for (std::size_t k = 0; k < outlines.size(); ++k)
  {
    Outline outline = outlines[k];
    repeated += dropRepeated(outline);
    if (outline.points.size() < 3 || signedArea(outline.points) == 0.0)
      throw std::invalid_argument(nameOf(outline) +
                                  " has no area: it needs three points that are not on one line");
    append(outline, mended.surface);
    polygon.resize(mended.surface.items.size(), static_cast<int>(k));
  }
  const SimplexTree<2> tree(mended.surface);
  refuseMeetings(mended.surface, polygon, tree, outlines);
  const auto around = shellsAround(mended.surface, tree, polygon, static_cast<int>(outlines.size()));
  std::vector<char> turned;
  for (std::size_t k = 0; k < outlines.size(); ++k)
    turned.push_back((signedArea(outlines[k].points) > 0.0) == (around[k].size() % 2 == 1));
  for (std::size_t t = 0; t < polygon.size(); ++t)
    if (turned[polygon[t]] != 0)
      std::swap(mended.surface.items[t][0], mended.surface.items[t][1]);
  if (repeated > 0)
    mended.notes.push_back(std::to_string(repeated) +
                           (repeated == 1 ? " point that repeats" : " points that repeat") +
                           " the one before " + (repeated == 1 ? "was" : "were") + " left out");
  return mended;
}

} // namespace Rhegma::Geometry
