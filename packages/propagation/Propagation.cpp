#include "propagation/Propagation.hpp"

#include "archive/Archive.hpp"
#include "plan/LastStage.hpp"
#include "propagation/Direction.hpp"
#include "propagation/FrontHistory.hpp"
#include "propagation/InSpace.hpp"
#include "propagation/Options.hpp"
#include "propagation/Report.hpp"
#include "transfer/LocalSpacing.hpp"
#include "transfer/NearestMaterial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace Rhegma::propagation
{

namespace
{

constexpr double notYet = std::numeric_limits<double>::quiet_NaN(); ///< null in the summary

/// Where a front set out, and in which directions.
struct Origin
{
  Vector<2> place{{0.0, 0.0}};  ///< [m]
  Vector<2> before{{0.0, 0.0}}; ///< direction of the crack that was there
  Vector<2> first{{0.0, 0.0}};  ///< of the first advance
};

struct Fronts
{
  std::vector<FrontHistory> histories;
  std::vector<Advance> next;     ///< what fronts are about to do
  std::vector<double> fastest;   ///< speed of each front [m/s]
  std::vector<double> increment; ///< of each front [m]
  std::vector<Origin> origins;
  std::vector<double> straightFor;        ///< length for which each front goes straight on [m]
  std::vector<std::vector<double>> paths; ///< time, x and y of each advance of each front
};

/// Decides which fronts may advance after the step that ends: those that do if nothing closes them, which
/// only their stress intensities tell.
void decide(State<2>& state, const Options& options, Fronts& fronts)
{
  const double now = state.clock.time + state.clock.dt;
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    CrackFront<2>& front = state.cracks.fronts[f];
    FrontNode<2>& node = front.nodes[0];
    node.advances = false;
    if (front.ended || node.stopped)
      continue;
    if (fronts.fastest[f] == 0.0)
      fronts.fastest[f] = fastestAt(state, front.position, options);
    FrontHistory& history = fronts.histories[f];
    // Cells may become smaller round a front at rest.
    if (fronts.increment[f] == 0.0 || !history.running())
      fronts.increment[f] = options.cells * spacingAt(state, front.position);
    const double release = node.driving.release;
    const AdvanceRule rule = ruleAt(node.temperature, options);
    if (isWeak(rule, fronts.fastest[f]))
    {
      state.failure = complaintOfWeak(node.temperature);
      return;
    }
    if (history.running())
    {
      FrontHistory asItWouldBe = history;
      node.advances =
          asItWouldBe.advance(rule, now, release, fronts.increment[f], fronts.fastest[f]).increments > 0;
      if (!node.advances)
        history = std::move(asItWouldBe);
    }
    else if (release >= rule.initiation && now >= rule.startTime)
      node.advances = true;
    else
      history.wait(rule, now, release);
    node.speed = history.speed(now);
  }
}

/// Cosine of a sharp turn, 15 degrees, and the cells that a front goes straight on behind one: the fields
/// round a shorter kink are those of the crack before it.
constexpr double sharp = 0.966, straightCells = 3.0;

/// Asks them to.
void ask(State<2>& state, const Options& options, Fronts& fronts)
{
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    CrackFront<2>& front = state.cracks.fronts[f];
    FrontNode<2>& node = front.nodes[0];
    if (!node.advances)
      continue;
    node.advances = false;
    FrontHistory& history = fronts.histories[f];
    const Elasticity e = elasticity(state.materials.list[materialAt(state, front.position)]);
    fronts.next[f] = history.advance(ruleAt(node.temperature, options), state.clock.time,
                                     openingRelease(node.driving, e), fronts.increment[f], fronts.fastest[f]);
    node.speed = history.speed(state.clock.time);
    if (fronts.next[f].increments == 0)
      continue;
    const double length = fronts.next[f].increments * fronts.increment[f];
    const bool held = fronts.straightFor[f] > 0.0;
    const Vector<2> direction =
        held ? front.direction
             : nextDirection(node.driving, front.direction, front.normal, options.direction);
    fronts.straightFor[f] -= length;
    if (dot(direction, front.direction) < sharp)
      fronts.straightFor[f] = straightCells * fronts.increment[f] / options.cells - length;
    if (!front.grown)
      fronts.origins[f] = {front.position, front.direction, direction};
    state.cracks.advances.push_back({static_cast<int>(f), {{direction, length, fronts.next[f].toughness}}});
    const Vector<2> place = front.position + length * direction;
    fronts.paths[f].insert(fronts.paths[f].end(), {history.lastTime(), place[0], place[1]});
    // Cells and material may be others where it is going.
    fronts.increment[f] = 0.0;
    if (state.materials.list.size() > 1)
      fronts.fastest[f] = 0.0;
  }
}

void start(State<2>& state, const Options& options, Fronts& fronts)
{
  state.cracks.driven = true;
  state.cracks.drivingContours = options.contours;
  const std::size_t count = state.cracks.fronts.size();
  fronts.histories.resize(count);
  fronts.next.resize(count);
  fronts.fastest.assign(count, 0.0);
  fronts.increment.assign(count, 0.0);
  fronts.origins.resize(count);
  fronts.straightFor.assign(count, 0.0);
  fronts.paths.resize(count);
  refuseWeak(state, options);
}

/// Mean of one of time, x and y over the advances of a path between two times.
double settledMean(const std::vector<double>& path, const std::pair<double, double>& times, std::size_t which)
{
  double sum = 0.0;
  int count = 0;
  for (std::size_t k = 0; k < path.size(); k += 3)
    if (path[k] >= times.first && path[k] <= times.second)
    {
      sum += path[k + which];
      ++count;
    }
  return count > 0 && times.second > times.first ? sum / count : notYet;
}

/// Angle from a to b, counter-clockwise [degrees].
double turn(const Vector<2>& a, const Vector<2>& b)
{
  return std::atan2(a[0] * b[1] - a[1] * b[0], dot(a, b)) * 45.0 / std::atan(1.0);
}

void report(const State<2>& state, const Fronts& fronts, nlohmann::json& summary)
{
  double taken = 0.0;
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    const CrackFront<2>& front = state.cracks.fronts[f];
    const FrontHistory& history = fronts.histories[f];
    taken += front.budget.required;
    nlohmann::json& entry = summary["cracks"][front.crack]["fronts"][front.number];
    entry["increments"] = history.increments();
    entry["running"] = history.running() && !front.ended && !front.stopped();
    entry["ended"] = front.ended;
    entry["halted"] = front.stopped();
    const Origin& origin = fronts.origins[f];
    const bool moved = history.increments() > 0;
    entry["set_out"] = moved ? history.firstTime() : notYet;
    entry["last_advance"] = moved ? history.lastTime() : notYet;
    entry["first_turn"] = moved ? turn(origin.before, origin.first) : notYet;
    entry["turn"] = moved ? turn(origin.before, front.position - origin.place) : notYet;
    entry["settled_speed"] = history.settledSpeed();
    entry["settled_release"] = history.settledRelease();
    const std::vector<double>& path = fronts.paths[f];
    entry["settled_time"] = settledMean(path, history.settled(), 0);
    entry["settled_position"] = {settledMean(path, history.settled(), 1),
                                 settledMean(path, history.settled(), 2)};
    entry["speed_limit"] = fronts.fastest[f];
    entry["energy_of_new_faces"] = front.budget.required;
    if (!moved && !front.ended && !front.stopped())
      reportRest(state, front, history.closest(), summary);
    reportRuns(state, front, history.runs(), history.running() && !front.ended && !front.stopped(),
               front.speed(), summary);
  }
  reportEnergy(state, taken, summary);
}

Effect<2> make2(const Teuchos::ParameterList& scene, const RunOptions& run)
{
  const auto options = std::make_shared<Options>(readOptions(scene, run));
  const auto fronts = std::make_shared<Fronts>();
  Effect<2> effect;
  effect.name = "Propagation";
  effect.balance = {"fracture"};
  effect.atStart = [=](State<2>& state) { start(state, *options, *fronts); };
  effect.call({lastStage(scene),
               "fronts that advance",
               {quantity::drivingForces, ifWritten(quantity::frontTemperature)},
               {quantity::advancingFronts},
               {},
               [=](State<2>& state) { decide(state, *options, *fronts); }});
  effect.call({Stage::BetweenSteps,
               "where fronts go",
               {quantity::stressIntensities, quantity::advancingFronts},
               {quantity::frontAdvances},
               {},
               [=](State<2>& state) { ask(state, *options, *fronts); }});
  effect.memory = [=](State<2>&, Archive& archive)
  {
    for (std::size_t f = 0; f < fronts->histories.size(); ++f)
    {
      const Archive::Group group(archive, "front " + std::to_string(f));
      fronts->histories[f].keep(archive);
      archive("fastest", fronts->fastest[f]);
      archive("next_increment", fronts->increment[f]);
      archive("next", fronts->next[f].increments);
      archive("next_toughness", fronts->next[f].toughness);
      archive("straight_for", fronts->straightFor[f]);
      archive("path", fronts->paths[f]);
      archive("origin", fronts->origins[f].place);
      archive("before", fronts->origins[f].before);
      archive("first", fronts->origins[f].first);
    }
  };
  effect.report = [=](const State<2>& state, nlohmann::json& summary)
  {
    report(state, *fronts, summary);
    reportToughness(*options, summary);
  };
  return effect;
}

} // namespace

EffectEntry propagationEntry()
{
  EffectEntry entry{propagationSection(), checkPropagation, make2, propagationInSpace, true, declareGrowth};
  entry.cells.tell = [](const auto&, CellNeeds& needs, auto&) { needs.running = needs.equal = true; };
  return entry;
}

} // namespace Rhegma::propagation
