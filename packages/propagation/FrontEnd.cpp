#include "propagation/FrontEnd.hpp"

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "transfer/FrontCompliance.hpp"

namespace Rhegma::propagation
{

template <int D>
FrontEnd<D>::FrontEnd(const State<D>& state, const Options& options, const CrackFront<D>& front,
                      const FrontState<D>& own)
{
  bool any = false;
  // Intensities are known where a node is about to advance.
  const bool opening = !front.ended && front.advances();
  const ModeRelease modes = opening ? modeReleaseAt(state, front) : ModeRelease{};
  for (const FrontNode<D>& node : front.nodes)
    if (!node.stopped && !front.ended)
    {
      const double opens = opening ? openingRelease(node.driving, modes) : node.driving.release;
      const AdvanceRule rule = ruleAt(node.temperature, options);
      // A node that runs goes on at the toughness of a front without speed, whatever it took to initiate.
      const auto past = own.nodes.find(node.name);
      const bool runs = past != own.nodes.end() && past->second.history.running();
      const double drive = past != own.nodes.end() ? past->second.aim.drive : 1.0;
      const double needed = (runs ? rule.toughness(0.0, rule.temperature) : rule.initiation) / drive;
      if (!any || opens * toughness > release * needed)
      {
        release = opens;
        toughness = needed;
        arrest = rule.arrest / drive;
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
  const double nodes = double(front.nodes.size()), intervals = double(own.increments) - nodes; // of all nodes
  pauses = fate == Fate::Running && release < toughness && intervals > 0.0 &&
           state.clock.time - own.lastTime > 3.0 * nodes * (own.lastTime - own.firstTime) / intervals;
  waits = pauses && own.hasAlmostStopped(front, state.clock.time);
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
         " (a numerical stop, not arrest): " + (front.stop.lost ? "G is not known, it was last " : "G = ") +
         formatShort(front.stop.release) + " J/m2 for Gc = " + formatShort(front.stop.toughness) + " J/m2";
}

/// What a front does that has not advanced for some time, without being arrested.
template <int D>
std::string pauseAsText(const FrontState<D>& own, const FrontEnd<D>& end)
{
  if (end.release < 0.0)
    return "no advance since t = " + readableTime(own.lastTime) + ", G = " + formatShort(end.release) +
           " J/m2, which is negative: its J integral can't be relied on here, so this is not arrest; see "
           "what its domain contains";
  const std::string since = "no advance since t = " + readableTime(own.lastTime) +
                            ", G = " + formatShort(end.release) +
                            " J/m2 below Gc = " + formatShort(end.toughness) + " J/m2";
  return since + (end.waits ? ", but not below Arrest Toughness = " + formatShort(end.arrest) +
                                  " J/m2: it does not advance unless G rises"
                            : ", but too short ago to count as arrested: run longer (Time > Final Time)");
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
    return end.pauses ? pauseAsText(own, end) : runs;
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
