#include "cracks/EndLigaments.hpp"

#include "base/Numbers.hpp"
#include "base/PointText.hpp"
#include "base/ShortNumber.hpp"
#include "cracks/AvailableLength.hpp"
#include "cracks/GrowingCrack.hpp"
#include "transfer/LocalSpacing.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

namespace Rhegma::cracks
{

namespace
{

using surface::FrontLines;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Fewest cells of material ahead of a front.
constexpr double fewestAhead = 3.0;
/// By how much the length of a ligament may be off, as it is found from particles [cells].
constexpr double inaccuracy = 0.3;

/// Where the material ahead of a front is shortest.
template <int D>
struct ShortestAhead
{
  double length = infinity, cell = 1.0; ///< infinite: nowhere less than `fewestAhead` cells [m]
  Vector<D> at{};
};

template <int D>
bool isMirrored(const std::vector<MirrorPlane>& mirrors, const Vector<D>& x, double cell, double within)
{
  return std::any_of(mirrors.begin(), mirrors.end(),
                     [&](const MirrorPlane& plane)
                     { return std::fabs(x[plane.axis] - plane.position) < within * cell; });
}

/// Distance of each front node from where its front ends at the surface, along the front; infinite in 2D and
/// on closed fronts [m].
template <int D>
std::vector<double> distancesFromEnds(const CrackFront<D>& front, const FrontLines<D>& lines,
                                      const std::vector<MirrorPlane>& mirrors, double cell)
{
  constexpr double onPlane = 0.05; // cells
  const std::size_t count = lines.size();
  std::vector<double> from(count, infinity);
  if (D == 2)
    return from;
  for (std::size_t k = 0; k < count; ++k)
    if ((previousPoint(lines, k) >= 0) != lines[k].joined &&
        !isMirrored(mirrors, front.nodes[k].position, cell, onPlane))
      from[k] = 0.0;
  const auto piece = [&](std::size_t k)
  { return norm(front.nodes[nextPoint(lines, k)].position - front.nodes[k].position); };
  for (int round = 0; round < 2; ++round) // twice, as lines may be closed
  {
    for (std::size_t k = 0; k < count; ++k)
      if (lines[k].joined)
        from[nextPoint(lines, k)] = std::min(from[nextPoint(lines, k)], from[k] + piece(k));
    for (std::size_t k = count; k-- > 0;)
      if (lines[k].joined)
        from[k] = std::min(from[k], from[nextPoint(lines, k)] + piece(k));
  }
  return from;
}

template <int D>
ShortestAhead<D> shortestAhead(const State<D>& state, const CrackFront<D>& front,
                               const GrowingCrack<D>& crack, const FrontLines<D>& lines,
                               const std::vector<MirrorPlane>& mirrors)
{
  std::vector<Path<D>> paths;
  const std::vector<double> fromEnds =
      distancesFromEnds(front, lines, mirrors, spacingAt(state, front.position));
  for (std::size_t k = 0; k < lines.size(); ++k)
  {
    const FrontNode<D>& node = front.nodes[k];
    const double cell = spacingAt(state, node.position);
    if (node.landed || fromEnds[k] < fewestAhead * cell)
      continue;
    Path<D> path{node.position, node.direction, (fewestAhead - leastLigament) * cell, cell};
    if constexpr (D == 2)
      path.gap = std::max(leastLigament * cell, crack.mesh.openingBehind(lines[k].vertex, cell));
    paths.push_back(path);
  }
  ShortestAhead<D> shortest;
  const std::vector<Ligament> ligaments = ligamentsAhead(state, paths);
  for (std::size_t k = 0; k < paths.size(); ++k)
  {
    const Vector<D> end = paths[k].from + ligaments[k].length * paths[k].direction;
    const double length =
        (isMirrored(mirrors, end, paths[k].cell, inaccuracy) ? 2.0 : 1.0) * ligaments[k].length;
    if (ligaments[k].ends && length < fewestAhead * paths[k].cell && length < shortest.length)
      shortest = {length, paths[k].cell, paths[k].from};
  }
  return shortest;
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
      entry["ligament"] = nullptr;
      if (!(front.extension.largest > 0.0) || front.ended || state.clock.step == 0)
        continue;
      const ShortestAhead<D> ahead = shortestAhead(state, front, crack, crack.fronts[i], mirrors);
      if (ahead.length == infinity)
        continue;
      entry["ligament"] = ahead.length;
      if (!(front.speed() > 0.0))
        summary["warnings"].push_back(
            frontName(set, front) + ": only " + readableLength(ahead.length) +
            " of material are left ahead of it, at " + formatPoint(ahead.at) + ", " +
            formatShort(ahead.length / ahead.cell) + " cells of " + readableLength(ahead.cell) +
            "; fewer than three cells neither bend nor strain as the material does, so G, and whether the "
            "crack stops there, can be wrong: use smaller cells (Domain > Cell Size)");
    }
}

template void reportLigaments(const State<2>&, const std::vector<MirrorPlane>&, nlohmann::json&);
template void reportLigaments(const State<3>&, const std::vector<MirrorPlane>&, nlohmann::json&);

} // namespace Rhegma::cracks
