#include "propagation/FrontEnd.hpp"

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "transfer/NearestMaterial.hpp"

namespace Rhegma::propagation
{

template <int D>
FrontEnd<D>::FrontEnd(const State<D>& state, const Options& options, const CrackFront<D>& front,
                      const FrontState<D>& own)
{
  bool any = false;
  // Intensities are known where a node is about to advance.
  const bool opening = !front.ended && front.advances();
  const Elasticity e =
      elasticity(state.materials.properties[opening ? materialAt(state, front.position) : std::size_t(0)]);
  for (const FrontNode<D>& node : front.nodes)
    if (!node.stopped && !front.ended)
    {
      const double opens = opening ? openingRelease(node.driving, e) : node.driving.release;
      const double needed = ruleAt(node.temperature, options).initiation;
      if (!any || opens * toughness > release * needed)
      {
        release = opens;
        toughness = needed;
      }
      any = true;
    }
  inPart = any;
  if (front.numStopped() > 0)
    fate = Fate::Stopped;
  else if (!any)
    fate = Fate::Ended;
  else if (own.running(front) && !options.equilibrium)
    fate = Fate::Running;
  else if (own.increments == 0)
    fate = Fate::NotInitiated;
  else if (state.method.analysis == Analysis::LoadFactor ||
           (options.equilibrium && own.lastTime >= state.clock.time - 0.5 * state.clock.dt))
    fate = Fate::Growing; // in the last load step
  else
    fate = release < toughness ? Fate::Arrested : Fate::AtRest;
  const double between = own.increments > 1 ? (own.lastTime - own.firstTime) / (own.increments - 1) : 0.0;
  pauses = D == 2 && fate == Fate::Running && release < toughness && own.increments > 1 &&
           state.clock.time - own.lastTime > 3.0 * between;
}

namespace
{

/// How many front nodes stopped, why, and at what G for which toughness.
template <int D>
std::string stopAsText(const CrackFront<D>& front)
{
  std::string text;
  if (D == 3)
    text = std::to_string(front.numStopped()) + " of " + std::to_string(front.nodes.size()) + " front nodes ";
  return text + "stopped " + front.stop.what + (D == 3 ? ", the first at t = " : " at t = ") +
         readableTime(front.stop.time) +
         " (a numerical stop, not arrest): G = " + formatShort(front.stop.release) +
         " J/m2 for Gc = " + formatShort(front.stop.toughness) + " J/m2";
}

} // namespace

template <int D>
std::string fateAsText(const CrackFront<D>& front, const FrontState<D>& own, const FrontEnd<D>& end)
{
  const std::string runs = "still running at the end" +
                           (front.speed() > 0.0 ? " at " + formatShort(front.speed()) + " m/s"
                                                : std::string(", after too few increments for a speed"));
  switch (end.fate)
  {
  case Fate::Stopped:
    return stopAsText(front) + (own.running(front) ? "; the others are " + runs : "");
  case Fate::Ended:
    return front.arrival.happened() ? front.arrival.what + " at t = " + readableTime(front.arrival.time)
                                    : "whole front at a surface since t = " + readableTime(own.lastTime);
  case Fate::Running:
    return end.pauses
               ? "no advance since t = " + readableTime(own.lastTime) + ", G = " + formatShort(end.release) +
                     " J/m2 below Gc = " + formatShort(end.toughness) +
                     " J/m2, but too short ago to count as arrested: run longer (Time > Final Time)"
               : runs;
  case Fate::Arrested:
  {
    const auto [release, toughness] = own.arrest();
    const bool known = toughness > 0.0; // else the nodes that ran have landed
    return "arrested at t = " + readableTime(own.lastTime) +
           ", G = " + formatShort(known ? release : end.release) +
           " J/m2 below Gc = " + formatShort(known ? toughness : end.toughness) + " J/m2";
  }
  default:
    return "at rest at the end, G = " + formatShort(end.release) +
           " J/m2 for Gc = " + formatShort(end.toughness) + " J/m2";
  }
}

template <int D>
std::string statusOf(const CrackFront<D>& front, const FrontEnd<D>& end)
{
  switch (end.fate)
  {
  case Fate::Stopped:
    return (end.inPart ? "stopped in part, " + std::to_string(front.numStopped()) + " of " +
                             std::to_string(front.nodes.size()) + " front nodes: "
                       : "stopped: ") +
           front.stop.what;
  case Fate::Ended:
    return "ended";
  case Fate::Running:
    return end.pauses ? "pausing" : "running";
  case Fate::Growing:
    return "growing";
  case Fate::NotInitiated:
    return "not initiated";
  case Fate::Arrested:
    return "arrested";
  default:
    return "at rest";
  }
}

template struct FrontEnd<2>;
template struct FrontEnd<3>;
template std::string fateAsText(const CrackFront<2>&, const FrontState<2>&, const FrontEnd<2>&);
template std::string statusOf(const CrackFront<2>&, const FrontEnd<2>&);
template std::string fateAsText(const CrackFront<3>&, const FrontState<3>&, const FrontEnd<3>&);
template std::string statusOf(const CrackFront<3>&, const FrontEnd<3>&);

} // namespace Rhegma::propagation
