#include "base/Numbers.hpp"
#include "cracks/ReadCrack.hpp"
#include "surface/Polyline.hpp"

#include <stdexcept>

namespace Rhegma::cracks
{

namespace
{

using Points = std::vector<Vector<2>>;

/// Largest length of a segment [cells]. The opening is linear between vertices. Shorter segments would follow
/// single nodes: a diagonal crack under tension then seems to overlap at some vertices.
constexpr double longestSegment = 4.0;

/// Parts outside of the bodies are cut off later, so a wrong unit or exponent would make too many segments.
void refuseLong(const Points& points, const std::string& where, double cell)
{
  double cells = 0.0;
  for (std::size_t k = 1; k < points.size(); ++k)
    cells += norm(points[k] - points[k - 1]) / cell;
  if (!(cells <= 1e5))
    throw std::invalid_argument(where + ": the crack is " + formatReal(cells) +
                                " cells long; write its points in metres, not far outside of the body");
}

Points readPoints(const Teuchos::ParameterList& list, const std::string& where, double cell)
{
  const auto values = list.get<Teuchos::Array<double>>("Points");
  Points points;
  for (int k = 0; k + 1 < values.size(); k += 2)
    points.push_back({values[k], values[k + 1]});
  for (std::size_t k = 1; k < points.size(); ++k)
    if (norm(points[k] - points[k - 1]) < 1e-6 * cell)
      throw std::invalid_argument(where + ": " + samePoints);
  refuseLong(points, where, cell);
  if (const std::array<int, 2> pair = surface::firstCrossing(points, 1e-6 * cell); pair[0] >= 0)
    throw std::invalid_argument(where + ": the piece after point " + std::to_string(pair[1] + 1) +
                                " meets the piece after point " + std::to_string(pair[0] + 1) +
                                " (counted from 1); write a line that neither crosses itself nor turns back");
  return points;
}

/// The kind of an end: it is a front if the user's crack ends there and there is material for a cell (of
/// those at fronts) ahead of it, unless Fronts decides. \param outermost the point that the user gave
int beyondEnd(const Vector<2>& end, const Vector<2>& before, const Vector<2>& outermost, bool first,
              const std::string& fronts, const std::string& where, const ReadingContext<2>& context,
              std::vector<std::string>& warnings)
{
  const Vector<2> ahead = (1.0 / norm(end - before)) * (end - before);
  if (fronts != "Automatic")
  {
    const bool named = fronts == "Both" || fronts == (first ? "First" : "Last");
    if (named && !context.bodies.contains(end + (0.1 * context.front) * ahead))
      throw std::invalid_argument(
          where + ": Fronts = " + fronts + " makes a front of the end at " + formatReal(end[0]) + ", " +
          formatReal(end[1]) + ", which has no material ahead; write " +
          (fronts == "Both"
               ? (first ? "Last" : "First")
               : (first ? "Last, if the other end is meant," : "First, if the other end is meant,")) +
          " or leave Fronts out: then each end inside material is a front");
    return named ? facet::front : facet::surfaceBreaking;
  }
  if (norm(end - outermost) >= 1e-9 * context.cell)
    return facet::surfaceBreaking;
  // Where cells at fronts are smaller, particles beyond the surface reach too far.
  const bool refined = context.front < context.cell;
  const auto isIn = [&](const Vector<2>& x)
  { return refined ? context.bodies.contains(x) : context.bodies.isNear(x); };
  if (surface::extendsBeyond<2>(isIn, end, ahead, context.front))
    return facet::front;
  if (context.bodies.contains(end + (0.1 * context.front) * ahead))
    warnings.push_back(
        where + ": less than a cell of material is left ahead of the end at " + formatReal(end[0]) + ", " +
        formatReal(end[1]) +
        ", so it is treated as broken through; use smaller cells (Domain > Cell Size), or set Fronts");
  return facet::surfaceBreaking;
}

} // namespace

template <>
surface::CrackMesh<2> readCrack(const Teuchos::ParameterList& list, const std::string& section,
                                const ReadingContext<2>& context, std::vector<std::string>& warnings)
{
  const std::string where = section + " > Points";
  const Points given = readPoints(list, where, context.cell);
  const Points inside = surface::clipEnds(
      given, [&](const Vector<2>& x) { return context.bodies.isNear(x); }, 0.01 * context.cell);
  if (inside.empty())
    throw std::invalid_argument(where + ": " + outsideOfBodies);
  const Points points = surface::splitSegments(inside, longestSegment * context.cell);
  const std::string fronts = list.get<std::string>("Fronts");
  const int first = beyondEnd(points[0], points[1], given.front(), true, fronts, where, context, warnings);
  const int last = beyondEnd(points.back(), points[points.size() - 2], given.back(), false, fronts, where,
                             context, warnings);
  return surface::polylineMesh(points, {first, last});
}

} // namespace Rhegma::cracks
