#include "energy_release/LoadsInRing.hpp"

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "energy_release/FrontLine.hpp"
#include "scene/TimeFunction.hpp"
#include "transfer/LocalSpacing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Rhegma::energy_release
{

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

/// By how many cells a load may lie inside of the rim, where the weight is nearly zero. A force on the
/// surface that the ring touches ahead of a crack in a bent bar changes J by 0.3 % with a ring of four cells.
/// In 2D held nodes may not: one is the whole support of a front.
constexpr double grazed = 0.1;

/// Whether a load is not zero at some time of the run.
bool everActs(const Teuchos::ParameterList& load, double end)
{
  constexpr int times = 257;
  if (!load.isParameter("History"))
    return true;
  const TimeFunction history = TimeFunction::parse(load.get<std::string>("History"));
  for (int k = 0; k < times; ++k)
    if (history(end * k / (times - 1)) != 0.0)
      return true;
  return false;
}

bool isReported(const std::vector<std::string>& warnings, const std::string& load, const std::string& front)
{
  return std::any_of(warnings.begin(), warnings.end(),
                     [&](const std::string& warning) {
                       return warning.compare(0, load.size(), load) == 0 &&
                              warning.find(front) != std::string::npos;
                     });
}

template <int D>
Vector<D> inSpace(const Vector<3>& x)
{
  Vector<D> own;
  for (int d = 0; d < D; ++d)
    own[d] = x[d];
  return own;
}

/// Distance of a position from a line or a box, or from the outside of a box [m].
template <int D>
double distanceTo(const BoundaryRegion& load, const Vector<D>& x)
{
  const Vector<D> from = inSpace<D>(load.from), to = inSpace<D>(load.to);
  if (load.kind == BoundaryRegion::Kind::Force)
  {
    const Vector<D> along = to - from;
    const double square = dot(along, along);
    const double at = square > 0.0 ? std::clamp(dot(x - from, along) / square, 0.0, 1.0) : 0.0;
    return norm(x - from - at * along);
  }
  Vector<D> beyond; // from the position to the box
  double inside = infinity;
  for (int d = 0; d < D; ++d)
  {
    beyond[d] = std::max({from[d] - x[d], 0.0, x[d] - to[d]});
    inside = std::min({inside, x[d] - from[d], to[d] - x[d]});
  }
  return load.kind == BoundaryRegion::Kind::HeldOutside ? std::max(0.0, inside) : norm(beyond);
}

/// Smallest value on a piece of a function that has one minimum on it [m].
template <int D, class Distance>
double smallestOn(const FrontSegment<D>& piece, const Distance& distance)
{
  constexpr int thirds = 60; // 1e-10 of the piece
  const Vector<D> along = piece[1] - piece[0];
  double low = 0.0, high = 1.0;
  for (int k = 0; k < thirds && norm(along) > 0.0; ++k)
  {
    const double one = low + (high - low) / 3.0, other = high - (high - low) / 3.0;
    if (distance(piece[0] + one * along) < distance(piece[0] + other * along))
      high = other;
    else
      low = one;
  }
  return std::min(
      {distance(piece[0]), distance(piece[1]), distance(piece[0] + (0.5 * (low + high)) * along)});
}

template <int D>
double distanceFrom(const std::vector<FrontSegment<D>>& front, const Vector<D>& x)
{
  double nearest = infinity;
  for (const FrontSegment<D>& piece : front)
  {
    const Vector<D> along = piece[1] - piece[0], to = x - piece[0];
    const double square = dot(along, along);
    const double at = square > 0.0 ? std::clamp(dot(to, along) / square, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, norm(to - at * along));
  }
  return nearest;
}

/// Whether the bounds of a load come within a distance of those of a front.
template <int D>
bool comesNear(const BoundaryRegion& load, const std::vector<FrontSegment<D>>& front, double distance)
{
  for (int d = 0; d < D && load.kind != BoundaryRegion::Kind::HeldOutside; ++d)
  {
    double low = infinity, high = -infinity;
    for (const FrontSegment<D>& piece : front)
      for (const Vector<D>& x : piece)
      {
        low = std::min(low, x[d]);
        high = std::max(high, x[d]);
      }
    if (std::min(load.from[d], load.to[d]) > high + distance ||
        std::max(load.from[d], load.to[d]) < low - distance)
      return false;
  }
  return true;
}

/// Whether a support prescribes motion along a straight front alone.
template <int D>
bool holdsAlongOnly(const BoundaryRegion& load, const std::vector<FrontSegment<D>>& front)
{
  constexpr double straight = 0.99;
  return D == 3 && load.axes.size() == 1 &&
         std::all_of(front.begin(), front.end(),
                     [&](const FrontSegment<D>& piece)
                     {
                       const Vector<D> along = piece[1] - piece[0];
                       return std::fabs(along[load.axes[0] - 'x']) >= straight * norm(along);
                     });
}

} // namespace

std::vector<FrontSegment<2>> segmentsOf(const CrackFront<2>& front)
{
  return {{front.position, front.position}};
}

std::vector<FrontSegment<3>> segmentsOf(const CrackFront<3>& front)
{
  const FrontLine line = lineOf(front);
  std::vector<FrontSegment<3>> segments;
  for (const FrontPiece& piece : line.pieces)
    segments.push_back({line.nodes[piece.from].position, line.nodes[piece.to].position});
  return segments;
}

template <int D>
Reach reachOf(const BoundaryRegion& load, const std::vector<FrontSegment<D>>& front)
{
  Reach reach{infinity, 0.0};
  for (const FrontSegment<D>& piece : front)
    reach.nearest =
        std::min(reach.nearest, smallestOn(piece, [&](const Vector<D>& x) { return distanceTo(load, x); }));
  if (load.kind == BoundaryRegion::Kind::HeldOutside)
    return {reach.nearest, infinity};
  const bool line = load.kind == BoundaryRegion::Kind::Force;
  for (int k = 0; k < (line ? 2 : 1 << D); ++k)
  {
    Vector<D> corner;
    for (int d = 0; d < D; ++d)
      corner[d] = (line ? k : k >> d & 1) != 0 ? load.to[d] : load.from[d];
    reach.furthest = std::max(reach.furthest, distanceFrom(front, corner));
  }
  return reach;
}

std::vector<BoundaryRegion> readLoads(const Teuchos::ParameterList& scene)
{
  using Kind = BoundaryRegion::Kind;
  std::vector<BoundaryRegion> loads;
  const double end = scene.sublist("Time").get<double>("Final Time");
  for (const BoundaryRegion& region : boundaryRegions(scene))
    if (region.kind == Kind::Held || region.kind == Kind::HeldOutside ||
        (region.kind == Kind::Force && everActs(scene.sublist("Boundaries").sublist(region.name), end)))
      loads.push_back(region);
  return loads;
}

template <int D>
void warnOfLoads(State<D>& state, const CrackFront<D>& front, const ContourRadii& radii,
                 const std::vector<BoundaryRegion>& loads)
{
  if (loads.empty())
    return;
  const double cell = spacingAt(state, front.position);
  const std::vector<FrontSegment<D>> segments = segmentsOf(front);
  for (const BoundaryRegion& load : loads)
  {
    const bool held = load.kind != BoundaryRegion::Kind::Force;
    const double rim = radii.outer - (held && D == 2 ? 0.0 : grazed * cell);
    if (!comesNear(load, segments, rim) || (held && holdsAlongOnly(load, segments)))
      continue;
    const Reach reach = reachOf(load, segments);
    if (reach.nearest > rim || reach.furthest < radii.inner - (held ? 0.0 : cell))
      continue;
    const std::string start =
        "Energy Release: Boundaries > " + load.name + (held ? " prescribes nodes" : " acts");
    const std::string round = " around " + frontName(state.cracks, front) + ", ";
    if (isReported(state.warnings, start, round))
      continue;
    std::string warning = start;
    warning.append(" in the domain integral from ")
        .append(readableLength(radii.inner))
        .append(" to ")
        .append(readableLength(radii.outer))
        .append(round);
    if (state.clock.time > 0.0)
      warning.append("from t = ").append(readableTime(state.clock.time)).append(" on, ");
    warning.append("so G_J can be wrong by 10 %; choose Inner Radius and Outer Radius so that ")
        .append(held ? "these nodes are" : "the load is")
        .append(D == 2 ? " at least a cell outside this ring" : " at least a cell outside this tube");
    state.warnings.push_back(warning);
  }
}

template Reach reachOf(const BoundaryRegion&, const std::vector<FrontSegment<2>>&);
template Reach reachOf(const BoundaryRegion&, const std::vector<FrontSegment<3>>&);
template void warnOfLoads(State<2>&, const CrackFront<2>&, const ContourRadii&,
                          const std::vector<BoundaryRegion>&);
template void warnOfLoads(State<3>&, const CrackFront<3>&, const ContourRadii&,
                          const std::vector<BoundaryRegion>&);

} // namespace Rhegma::energy_release
