#include "propagation/Aim.hpp"

#include "propagation/Direction.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::propagation
{

Aim aimOf(double modeI, double modeII, double ahead, double normal, const ToughnessRatio& ratio,
          bool straight)
{
  modeI = std::max(modeI, 0.0);
  const double here = kinkedRelease(0.0, modeI, modeII);
  if (straight || !(here > 0.0))
    return {0.0, 1.0 / ratio(ahead), ratio(ahead)};
  const double angle = largestIn(
      -mostTurn, mostTurn,
      [&](double turn) { return kinkedRelease(turn, modeI, modeII) / ratio(ahead + normal * turn); });
  const double weight = ratio(ahead + normal * angle);
  return {angle, kinkedRelease(angle, modeI, modeII) / (here * weight), weight};
}

void aimFronts(const State<2>& state, const Options& options, std::vector<FrontState<2>>& fronts)
{
  for (std::size_t f = 0; options.ratio && f < state.cracks.fronts.size(); ++f)
  {
    const CrackFront<2>& front = state.cracks.fronts[f];
    if (front.ended || front.nodes.empty())
      continue;
    const FrontNode<2>& node = front.nodes[0];
    const auto own = fronts[f].nodes.find(node.name);
    if (own == fronts[f].nodes.end())
      continue;
    const bool known = front.advances() || front.measured;
    FrontNodeState& of = own->second;
    if (!known && of.aim.weight > 0.0)
      continue;
    const Vector<2>& d = node.direction;
    const double left = d[0] * node.normal[1] - d[1] * node.normal[0] > 0.0 ? 1.0 : -1.0;
    of.aim = aimOf(known ? node.driving.modeI : 1.0, known ? node.driving.modeII : 0.0,
                   std::atan2(d[1], d[0]), left, *options.ratio, of.straightLength > 0.0);
  }
}

void aimFronts(const State<3>&, const Options&, std::vector<FrontState<3>>&) {}

} // namespace Rhegma::propagation
