#include "propagation/AdvanceFronts.hpp"

#include "material/StartOfGrowth.hpp"
#include "propagation/Aim.hpp"
#include "propagation/Direction.hpp"
#include "propagation/HoopStress.hpp"
#include "propagation/MaterialsAhead.hpp"
#include "propagation/SmoothedAlong.hpp"
#include "state/DistancesFromEnds.hpp"
#include "state/RecordStop.hpp"
#include "transfer/FrontCompliance.hpp"
#include "transfer/LocalSpacing.hpp"
#include "transfer/NearestMaterial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace Rhegma::propagation
{

namespace
{

/// Fraction of the increment by which a front node advances at a time. Neighbours along a front that runs
/// advance at different times; short advances keep them in line.
template <int D>
double incrementFraction(const Options& options)
{
  return D == 2 || options.equilibrium ? 1.0 : 0.25;
}

/// Cosine of a sharp turn, 15 degrees, and the cells that a front node goes straight on behind one: the
/// fields round a shorter kink are those of the crack before it.
constexpr double sharp = 0.966, straightCells = 3.0;

/// Whether a front node may advance at the end of the step, at the time `now` [s]; if not, its history
/// records the step.
bool mayAdvance(const AdvanceRule& rule, double now, double release, FrontNodeState& node)
{
  if (node.history.running())
  {
    if (node.history.wouldAdvance(rule, now, release, node.increment, node.speedLimit))
      return true;
    node.history.advance(rule, now, release, node.increment, node.speedLimit); // none, but it may be arrested
    return false;
  }
  if (release >= rule.initiation && now >= rule.startTime)
    return true;
  node.history.recordAtRest(rule, now, release);
  return false;
}

/// Finds what a front node needs to know of its position before its next advance.
template <int D>
void prepareNode(const State<D>& state, const Options& options, const FrontNode<D>& node, FrontNodeState& own)
{
  if (own.speedLimit == 0.0)
    own.speedLimit = speedLimitAt(state, node.position, options);
  // Cells may be refined around a front at rest.
  if (own.increment == 0.0 || !own.history.running())
    own.increment = incrementFraction<D>(options) * options.cells * spacingAt(state, node.position);
}

/// Why the J integral of a front node can't be used, and what helps.
struct LostReason
{
  const char* what;
  const char* advice;
};
constexpr LostReason noContour{"with no material left in the domain of its J integral",
                               "; use smaller cells (Domain > Cell Size), with which the domain is smaller"};
constexpr LostReason negativeRelease{"where its J integral is negative, which G of a crack is not",
                                     "; see what its domain contains (a support, a load, an edge), or use "
                                     "smaller cells (Domain > Cell Size), with "
                                     "which the domain is smaller"};

/// Stops a front node whose J integral is of no use: whether it advances is not known.
template <int D>
void stopLost(State<D>& state, double now, const AdvanceRule& rule, const LostReason& reason,
              CrackFront<D>& front, FrontNode<D>& node, const FrontHistory& history)
{
  node.stopped = true;
  node.speed = 0.0;
  recordStop(state, front,
             {reason.what, now, node.position, node.driving.release,
              history.running() ? rule.toughness(history.speed(now), rule.temperature) : rule.initiation,
              true},
             reason.advice);
}

/// Length next to the ends of a 3D front in which the surface cuts the tubes of its nodes [cells].
constexpr double cutTube = 2.0;

/// Whether a front node that was arrested was so by a J integral without meaning: G has been negative in the
/// mean since its last advance, by more than noise, or is now by as much as the toughness, more than waves
/// that pass make it. \param release at the arrest [J/m2]
bool isArrestedByNegative(const AdvanceRule& rule, double release, const FrontHistory& history)
{
  constexpr double noise = 0.1; // of the toughness
  return !history.running() && (history.meanSinceAdvance() < -noise * rule.arrest || release < -rule.arrest);
}

/// Angles by which the nodes of a front turn, smoothed along it [rad].
template <int D>
std::vector<double> turningAngles(const CrackFront<D>& front, const Options& options,
                                  const std::map<int, FrontNodeState>& states)
{
  std::vector<double> angle(front.nodes.size(), 0.0);
  for (std::size_t k = 0; k < angle.size(); ++k)
    if (front.nodes[k].advances && !(states.at(front.nodes[k].name).straightLength > 0.0))
      angle[k] = options.ratio ? states.at(front.nodes[k].name).aim.angle
                               : turningAngle(front.nodes[k].driving, options.direction);
  return smoothedAlong(front, angle);
}

/// The toughness of Propagation > Toughness that a front node reaches when it advances in equilibrium [J/m2].
template <int D>
double toughnessAtRest(const FrontNode<D>& node, const FrontNodeState& own, const Options& options)
{
  const AdvanceRule rule = ruleAt(node.temperature, options);
  return own.history.running() ? rule.toughness(0.0, rule.temperature) : rule.initiation;
}

/// G/Gc of the nodes of a front that advance in equilibrium, of the part of G that opens the crack; 0 of
/// others. G is smoothed along the front: nodes are about a cell apart, and the domain of the J integral of
/// each is several cells wide, so that differences between neighbours are those of the cells. The toughness
/// is that of each node.
template <int D>
std::vector<double> drivesAlong(const CrackFront<D>& front, const std::map<int, FrontNodeState>& states,
                                const ModeRelease& modes, const Options& options)
{
  std::vector<double> release(front.nodes.size(), 0.0);
  for (std::size_t k = 0; k < release.size(); ++k)
    if (front.nodes[k].advances)
      release[k] = states.at(front.nodes[k].name).aim.drive * openingRelease(front.nodes[k].driving, modes);
  std::vector<double> drive = smoothedAlong(front, release);
  for (std::size_t k = 0; k < drive.size(); ++k)
    if (const FrontNode<D>& node = front.nodes[k]; node.advances)
      drive[k] /= toughnessAtRest(node, states.at(node.name), options);
  return drive;
}

/// Fraction of its increment by which a front node advances in equilibrium. Fronts of one node advance if
/// their G/Gc is within a hundredth of the largest: which of two fronts alike is the first is a matter of
/// rounding. Along a front nodes advance by less, the further they are below, until all have one G/Gc.
template <int D>
double advanceFraction(double drive, double largest)
{
  constexpr double alike = 0.01, along = 0.25;
  const double below = 1.0 - drive / largest;
  if (D == 2)
    return below <= alike ? 1.0 : 0.0;
  return std::max(0.0, 1.0 - below / along);
}

/// What a node does that is selected in equilibrium, with the part of its increment that it advances by.
/// \param drive its G/Gc
template <int D>
std::pair<Advance, double> advanceAtRest(const State<D>& state, const Options& options, double drive,
                                         const FrontNode<D>& node, FrontNodeState& own)
{
  const double fraction = advanceFraction<D>(drive, state.cracks.growth.drive);
  if (!(fraction > 0.0))
    return {Advance{}, 0.0};
  own.history.advanceInEquilibrium(state.clock.time, own.aim.drive * node.driving.release,
                                   fraction * own.increment);
  // What it spends from now on is the toughness, whatever it took to initiate.
  return {Advance{1, toughnessAtRest(node, own, options)}, fraction};
}

/// The energy release rate that would advance a front node at rest [J/m2]; in time infinite before the start
/// time. In equilibrium no front advances before it.
double resistanceAtRest(double now, bool equilibrium, const AdvanceRule& rule, const FrontNodeState& own)
{
  if (now < rule.startTime && !equilibrium)
    return std::numeric_limits<double>::infinity();
  return (own.history.running() ? rule.arrest : rule.initiation) / own.aim.drive;
}

/// The advance of a selected node; zero where the opening part of the energy release rate does not reach the
/// toughness. \param modes of the material at the front \param angle by which it turns [rad] \param drive
/// G/Gc in equilibrium \param starts no node of the front has advanced before this step
template <int D>
FrontNodeAdvance<D> advanceNode(const State<D>& state, const Options& options, const ModeRelease& modes,
                                double angle, double drive, bool starts, FrontNode<D>& node,
                                FrontState<D>& front)
{
  FrontNodeState& own = front.nodes.at(node.name);
  const AdvanceRule rule = ruleAt(node.temperature, options);
  const double release = own.aim.drive * openingRelease(node.driving, modes);
  const bool held = !options.equilibrium && own.history.wasHeld(rule, state.clock.time, release);
  Advance made;
  double fraction = 1.0;
  if (options.equilibrium)
    std::tie(made, fraction) = advanceAtRest(state, options, drive, node, own);
  else
    made = own.history.advance(rule, state.clock.time, release, own.increment, own.speedLimit);
  node.speed = own.history.speed(state.clock.time);
  FrontNodeAdvance<D> advance{node.direction, 0.0,
                              resistanceAtRest(state.clock.time, options.equilibrium, rule, own)};
  if (made.increments == 0)
    return advance;
  if (starts)
    front.first.include({own.aim.drive * node.driving.release / rule.initiation, node.driving.modeI,
                         node.driving.modeII, node.driving.modeIII, held});
  front.count(own.history, made.increments);
  advance.length = made.increments * fraction * own.increment;
  advance.toughness = made.toughness * (options.ratio ? own.aim.weight : 1.0);
  if (!(own.straightLength > 0.0))
    advance.direction = turned(node.direction, node.normal, angle);
  own.straightLength -= advance.length;
  if (dot(advance.direction, node.direction) < sharp)
    own.straightLength =
        straightCells * own.increment / (incrementFraction<D>(options) * options.cells) - advance.length;
  // Cells and material may change along its path.
  own.increment = 0.0;
  if (state.materials.properties.size() > 1)
    own.speedLimit = 0.0;
  return advance;
}

/// Adds the advance of a front with one node to its path.
template <int D>
void recordPath(const CrackFront<D>& front, const FrontNodeAdvance<D>& advance, FrontState<D>& own)
{
  if (!front.grown)
  {
    own.start = {front.position, front.direction, advance.direction};
    own.hoop.load = hoopStressLoad(front.nodes[0].driving.hoopAngle);
  }
  own.path.push_back({own.lastTime, front.position + advance.length * advance.direction});
}

} // namespace

template <int D>
void markDue(State<D>& state, const Options& options, std::vector<FrontState<D>>& fronts)
{
  constexpr double beforeStart = 2.0; // intervals: as many samples are known when fronts may advance
  const double now = state.clock.time + state.clock.dt;
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    CrackFront<D>& front = state.cracks.fronts[f];
    front.due = options.equilibrium || !(options.samplingCells > 0.0);
    if (front.ended || front.due)
      continue;
    fronts[f].matchNodes(front);
    const double interval = options.samplingCells * spacingAt(state, front.position) / options.waveSpeed;
    if (now < options.rule.startTime - beforeStart * interval - state.clock.dt)
      continue;
    front.due = std::any_of(front.nodes.begin(), front.nodes.end(),
                            [&](const FrontNode<D>& node)
                            {
                              FrontNodeState& own = fronts[f].nodes.at(node.name);
                              if (node.stopped)
                                return false;
                              prepareNode(state, options, node, own);
                              return own.history.isDue(ruleAt(node.temperature, options), now, state.clock.dt,
                                                       interval, own.increment, own.speedLimit);
                            });
  }
}

template <int D>
void selectAdvancing(State<D>& state, const Options& options, std::vector<FrontState<D>>& fronts)
{
  const double now = state.clock.time + state.clock.dt;
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    CrackFront<D>& front = state.cracks.fronts[f];
    if (front.ended)
      continue;
    fronts[f].matchNodes(front);
    const std::vector<double> fromEnds = distancesFromEnds(front, [](const FrontNode<D>&) { return true; });
    for (std::size_t k = 0; k < front.nodes.size(); ++k)
    {
      FrontNode<D>& node = front.nodes[k];
      node.advances = false;
      if (node.stopped)
        continue;
      if (!front.due)
      {
        node.speed = fronts[f].nodes.at(node.name).history.speed(now);
        continue;
      }
      FrontNodeState& own = fronts[f].nodes.at(node.name);
      if (node.driving.lost)
      {
        stopLost(state, now, ruleAt(node.temperature, options), noContour, front, node, own.history);
        continue;
      }
      prepareNode(state, options, node, own);
      fronts[f].speedLimit = std::max(fronts[f].speedLimit, own.speedLimit);
      const AdvanceRule rule = ruleAt(node.temperature, options);
      if (!std::isfinite(node.driving.release))
      {
        state.failure = "the energy release rate of " + frontName(state.cracks, front) +
                        ", is not a number, so it can't be said whether it advances; use smaller cells "
                        "(Domain > Cell Size)";
        return;
      }
      if (isWeak(rule, own.speedLimit))
      {
        state.failure = failureOfWeak(node.temperature);
        return;
      }
      if (!(own.aim.weight > 0.0)) // no stress intensities are known yet
        aimFronts(state, options, fronts);
      const double release = own.aim.drive * node.driving.release; // as Toughness compares with
      if (options.equilibrium)
        own.history.recordAtRest(rule, now, release);
      const bool ran = own.history.running();
      node.advances = options.equilibrium || mayAdvance(rule, now, release, own);
      node.speed = own.history.speed(now);
      // Next to the ends of a front the surface cuts its tube, and it lags behind: negative G is no fault
      // there.
      const bool atEnd = fromEnds[k] < cutTube * spacingAt(state, node.position);
      if (ran && !options.equilibrium && !atEnd && isArrestedByNegative(rule, release, own.history))
        stopLost(state, now, rule, negativeRelease, front, node, own.history);
    }
  }
}

template <int D>
void measureDrive(State<D>& state, const Options& options, std::vector<FrontState<D>>& fronts)
{
  aimFronts(state, options, fronts);
  double largest = 0.0, release = 0.0;
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    const CrackFront<D>& front = state.cracks.fronts[f];
    if (!front.advances())
      continue;
    const ModeRelease modes = modeReleaseAt(state, front);
    const std::vector<double> drive = drivesAlong(front, fronts[f].nodes, modes, options);
    for (std::size_t k = 0; k < drive.size(); ++k)
      if (const FrontNode<D>& node = front.nodes[k]; node.advances && drive[k] > largest)
      {
        largest = drive[k];
        release = drive[k] * toughnessAtRest(node, fronts[f].nodes.at(node.name), options);
      }
  }
  state.cracks.growth.drive = largest;
  state.cracks.growth.release = release;
}

template <int D>
void advanceSelected(State<D>& state, const Options& options, std::vector<FrontState<D>>& fronts)
{
  if (options.equilibrium && !std::exchange(state.cracks.growth.advance, false))
    return;
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    CrackFront<D>& front = state.cracks.fronts[f];
    if (!front.advances())
      continue;
    const std::vector<double> angle = turningAngles(front, options, fronts[f].nodes);
    const ModeRelease modes = modeReleaseAt(state, front);
    const std::vector<double> drive = options.equilibrium
                                          ? drivesAlong(front, fronts[f].nodes, modes, options)
                                          : std::vector<double>(angle.size());
    FrontAdvance<D> advance;
    advance.front = static_cast<int>(f);
    bool any = false;
    const bool starts = fronts[f].increments == 0;
    for (std::size_t k = 0; k < front.nodes.size(); ++k)
    {
      FrontNode<D>& node = front.nodes[k];
      if (node.advances)
      {
        const FrontNodeAdvance<D> by =
            advanceNode(state, options, modes, angle[k], drive[k], starts, node, fronts[f]);
        if (by.length > 0.0)
          warnOfOtherMaterial(options, front, node, by.length * by.direction, state);
        advance.nodes.push_back(by);
      }
      else
        advance.nodes.push_back(
            {node.direction, 0.0,
             resistanceAtRest(state.clock.time, options.equilibrium, ruleAt(node.temperature, options),
                              fronts[f].nodes.at(node.name))});
      node.advances = false;
      any = any || advance.nodes.back().length > 0.0;
    }
    if (!any)
      continue;
    state.cracks.advances.push_back(advance);
    if constexpr (D == 2)
      recordPath(front, advance.nodes[0], fronts[f]);
  }
}

template void markDue(State<2>&, const Options&, std::vector<FrontState<2>>&);
template void markDue(State<3>&, const Options&, std::vector<FrontState<3>>&);
template void selectAdvancing(State<2>&, const Options&, std::vector<FrontState<2>>&);
template void selectAdvancing(State<3>&, const Options&, std::vector<FrontState<3>>&);
template void measureDrive(State<2>&, const Options&, std::vector<FrontState<2>>&);
template void measureDrive(State<3>&, const Options&, std::vector<FrontState<3>>&);
template void advanceSelected(State<2>&, const Options&, std::vector<FrontState<2>>&);
template void advanceSelected(State<3>&, const Options&, std::vector<FrontState<3>>&);

} // namespace Rhegma::propagation
