#include "cracks/EndLigaments.hpp"

#include "base/Numbers.hpp"
#include "base/PointText.hpp"
#include "base/ShortNumber.hpp"
#include "cracks/AvailableLength.hpp"
#include "cracks/CracksOnPath.hpp"
#include "cracks/GrowingCrack.hpp"
#include "state/DistancesFromEnds.hpp"
#include "transfer/LocalSpacing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace Rhegma::cracks
{

namespace
{

using surface::FrontLines;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Fewest cells of material ahead of a front, of which a part bends as the material does, and of one that
/// strains evenly.
constexpr double fewestAhead = 10.0, fewestAtAll = 3.0;
/// By how much the length of a ligament may be off, as it is found from particles [cells].
constexpr double inaccuracy = 0.3;
/// Lengths in which a ligament is searched [cells]: the first is short, so that gaps next to the front are
/// found to a twentieth of a cell.
constexpr double firstLength = 3.0, otherLengths = 10.0;
constexpr int mostLengths = 1000;
/// Another crack as near to the path ends the ligament [cells].
constexpr double asNear = 0.1;

/// Where the material ahead of a front is shortest.
template <int D>
struct ShortestAhead
{
  double length = infinity, cell = 1.0; ///< [m]; infinite: there is no node that it is known for
  Vector<D> at{};
  int crack = -1; ///< at which it ends; -1: a surface
};

/// Length of the material along each path, up to the surface [m]; infinite where the path does not come to
/// it. Collective.
template <int D>
std::vector<double> lengthsAhead(const State<D>& state, int crack, const std::vector<Path<D>>& paths)
{
  std::vector<double> ahead(paths.size(), 0.0);
  std::vector<Path<D>> rest = paths;
  std::vector<std::size_t> of(paths.size()); // of each of the rest
  for (std::size_t k = 0; k < of.size(); ++k)
    of[k] = k;
  for (int round = 0; round < mostLengths && !rest.empty(); ++round)
  {
    const std::vector<Ligament> found = ligamentsAhead(state, crack, rest);
    std::vector<Path<D>> more;
    std::vector<std::size_t> ofMore;
    for (std::size_t k = 0; k < rest.size(); ++k)
    {
      ahead[of[k]] += found[k].length;
      if (found[k].ends)
        continue;
      Path<D> next = rest[k];
      next.from = next.from + found[k].length * next.direction;
      next.length = otherLengths * next.cell;
      next.gap = D == 2 ? leastLigament * next.cell : 0.0;
      more.push_back(next);
      ofMore.push_back(of[k]);
    }
    rest = more;
    of = ofMore;
  }
  for (const std::size_t k : of)
    ahead[k] = infinity;
  return ahead;
}

/// A length that no path in the domain exceeds [m].
template <int D>
double longest(const State<D>& state)
{
  double square = 0.0;
  for (int d = 0; d < D; ++d)
    square += std::pow(state.mesh.grid.cells[d] * state.mesh.grid.spacing, 2);
  return std::sqrt(square);
}

template <int D>
bool isMirrored(const std::vector<MirrorPlane>& mirrors, const Vector<D>& x, double cell, double within)
{
  return std::any_of(mirrors.begin(), mirrors.end(),
                     [&](const MirrorPlane& plane)
                     { return std::fabs(x[plane.axis] - plane.position) < within * cell; });
}

template <int D>
ShortestAhead<D> shortestAhead(const State<D>& state, const CrackFront<D>& front,
                               const GrowingCrack<D>& crack, const FrontLines<D>& lines,
                               const std::vector<MirrorPlane>& mirrors)
{
  std::vector<Path<D>> paths;
  constexpr double onPlane = 0.05; // cells
  const double coarse = spacingAt(state, front.position);
  const std::vector<double> fromEnds = distancesFromEnds(
      front, [&](const FrontNode<D>& node) { return !isMirrored(mirrors, node.position, coarse, onPlane); });
  for (std::size_t k = 0; k < lines.size(); ++k)
  {
    const FrontNode<D>& node = front.nodes[k];
    const double cell = spacingAt(state, node.position);
    if (node.landed || fromEnds[k] < fewestAtAll * cell)
      continue;
    Path<D> path{node.position, node.direction, (firstLength - leastLigament) * cell, cell};
    if constexpr (D == 2)
      path.gap = std::max(leastLigament * cell, crack.mesh.openingBehind(lines[k].vertex, cell));
    paths.push_back(path);
  }
  ShortestAhead<D> shortest;
  const std::vector<double> lengths = lengthsAhead(state, front.crack, paths);
  const CracksOnPath<D> others(state.cracks, front.crack);
  for (std::size_t k = 0; k < paths.size(); ++k)
  {
    const auto& [from, direction, least, cell, gap] = paths[k];
    const CrackOnPath met =
        others.first(from, direction, std::min(lengths[k], longest(state)), asNear * cell);
    if (met.crack < 0 && !std::isfinite(lengths[k]))
      continue;
    const Vector<D> end = from + met.length * direction;
    const bool doubled = met.crack < 0 && isMirrored(mirrors, end, cell, inaccuracy);
    if (const double length = (doubled ? 2.0 : 1.0) * met.length; length < shortest.length)
      shortest = {length, cell, from, met.crack};
  }
  return shortest;
}

/// What too few cells of material ahead of a front mean; empty if there are enough.
template <int D>
std::string warningOf(const CrackSet<D>& set, const ShortestAhead<D>& ahead)
{
  const double cells = ahead.length / ahead.cell;
  if (cells >= fewestAhead)
    return {};
  return ": only " + readableLength(ahead.length) + " of material are left ahead of it" +
         (ahead.crack < 0 ? "" : ", up to crack " + set.cracks[ahead.crack].name) + ", at " +
         formatPoint(ahead.at) + ", " + formatShort(cells) + " cells of " + readableLength(ahead.cell) +
         "; " +
         (cells < fewestAtAll
              ? "fewer than three cells neither bend nor strain as the material does, so G, and whether the "
                "crack stops there, can be wrong"
              : "where fewer than ten cells bend, G is too low, and the loads at which the crack grows are "
                "too "
                "high: by some 5 % with 8 cells and 10 to 20 % with 6") +
         ": use smaller cells (Domain > Cell Size)";
}

} // namespace

template <int D>
void reportLigaments(const State<D>& state, const std::vector<MirrorPlane>& mirrors, nlohmann::json& summary)
{
  const CrackSet<D>& set = state.cracks;
  for (const GrowingCrack<D>& crack : readGrowing(set, FaceToughness(set.fronts.size())))
    for (std::size_t i = 0; i < crack.fronts.size(); ++i)
    {
      const CrackFront<D>& front = set.fronts[crack.numbers[i]];
      nlohmann::json& entry = summary["cracks"][front.crack]["fronts"][front.number];
      entry["ligament"] = entry["ligament_ends_at"] = nullptr;
      if (!(front.extension.largest > 0.0) || front.ended || state.clock.step == 0)
        continue;
      const ShortestAhead<D> ahead = shortestAhead(state, front, crack, crack.fronts[i], mirrors);
      if (ahead.length == infinity)
        continue;
      entry["ligament"] = ahead.length;
      entry["ligament_ends_at"] = ahead.crack < 0 ? "surface" : "crack " + set.cracks[ahead.crack].name;
      if (const std::string warning = warningOf(set, ahead); !(front.speed() > 0.0) && !warning.empty())
        summary["warnings"].push_back(frontName(set, front) + warning);
    }
}

template void reportLigaments(const State<2>&, const std::vector<MirrorPlane>&, nlohmann::json&);
template void reportLigaments(const State<3>&, const std::vector<MirrorPlane>&, nlohmann::json&);

} // namespace Rhegma::cracks
