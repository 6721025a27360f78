#include "energy_release/LoadsInRing.hpp"

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "plan/BoundaryType.hpp"
#include "scene/TimeFunction.hpp"
#include "transfer/LocalSpacing.hpp"

#include <algorithm>
#include <limits>

namespace Rhegma::energy_release
{

namespace
{

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

bool isReported(const State<2>& state, const std::string& load, const std::string& front)
{
  return std::any_of(state.warnings.begin(), state.warnings.end(),
                     [&](const std::string& warning) {
                       return warning.compare(0, load.size(), load) == 0 &&
                              warning.find(front) != std::string::npos;
                     });
}

} // namespace

Reach reachOf(const LoadRegion& load, const Vector<2>& x)
{
  const Vector<2> along = load.to - load.from, to = x - load.from;
  if (load.kind == LoadRegion::Kind::Line)
  {
    const double square = dot(along, along);
    const double at = square > 0.0 ? std::clamp(dot(to, along) / square, 0.0, 1.0) : 0.0;
    return {norm(to - at * along), std::max(norm(to), norm(to - along))};
  }
  Vector<2> beyond, across; // from the position to the box, and to its furthest corner
  double inside = std::numeric_limits<double>::infinity();
  for (int d = 0; d < 2; ++d)
  {
    beyond[d] = std::max({load.from[d] - x[d], 0.0, x[d] - load.to[d]});
    across[d] = std::max(x[d] - load.from[d], load.to[d] - x[d]);
    inside = std::min({inside, x[d] - load.from[d], load.to[d] - x[d]});
  }
  if (load.kind == LoadRegion::Kind::Outside)
    return {std::max(0.0, inside), std::numeric_limits<double>::infinity()};
  return {norm(beyond), norm(across)};
}

std::vector<LoadRegion> readLoads(const Teuchos::ParameterList& scene)
{
  std::vector<LoadRegion> loads;
  const double end = scene.sublist("Time").get<double>("Final Time");
  for (const BoundaryRegion& region : boundaryRegions(scene))
  {
    LoadRegion load{region.name, {region.from[0], region.from[1]}, {region.to[0], region.to[1]}};
    if (region.kind == BoundaryRegion::Kind::Held || region.kind == BoundaryRegion::Kind::HeldOutside)
      load.kind =
          region.kind == BoundaryRegion::Kind::Held ? LoadRegion::Kind::Box : LoadRegion::Kind::Outside;
    else if (region.kind != BoundaryRegion::Kind::Force ||
             !everActs(scene.sublist("Boundaries").sublist(region.name), end))
      continue;
    loads.push_back(load);
  }
  return loads;
}

void warnOfLoads(State<2>& state, const CrackFront<2>& front, const ContourRadii& radii,
                 const std::vector<LoadRegion>& loads)
{
  const double cell = spacingAt(state, front.position);
  for (const LoadRegion& load : loads)
  {
    const bool held = load.kind != LoadRegion::Kind::Line;
    const Reach reach = reachOf(load, front.position);
    const double slack = held ? 0.0 : cell;
    if (reach.nearest > radii.outer + slack || reach.furthest < radii.inner - slack)
      continue;
    const std::string start =
        "Energy Release: Boundaries > " + load.name + (held ? " prescribes nodes" : " acts");
    const std::string round = " around crack " + state.cracks.cracks[front.crack].name + ", front " +
                              std::to_string(front.number) + ", ";
    if (isReported(state, start, round))
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
        .append(" at least a cell outside this ring");
    state.warnings.push_back(warning);
  }
}

} // namespace Rhegma::energy_release
