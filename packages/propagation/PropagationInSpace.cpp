#include "archive/Archive.hpp"
#include "plan/LastStage.hpp"
#include "propagation/FrontShape.hpp"
#include "propagation/InSpace.hpp"
#include "propagation/Options.hpp"
#include "propagation/Report.hpp"
#include "transfer/LocalSpacing.hpp"
#include "transfer/NearestMaterial.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <utility>

namespace Rhegma::propagation
{

namespace
{

constexpr double notYet = std::numeric_limits<double>::quiet_NaN(); ///< null in the summary

/// Front nodes advance by this share of the increment at a time, so that neighbours, which do so at different
/// times, stay in line.
constexpr double shareOfIncrement = 0.25;

/// Cosine of a sharp turn, 15 degrees, and the cells that a front node goes straight on behind one.
constexpr double sharp = 0.966, straightCells = 3.0;

/// What is known of a front node from step to step.
struct Memory
{
  FrontHistory history;
  double fastest = 0.0;     ///< its largest speed [m/s]; 0: not known yet
  double increment = 0.0;   ///< its next one [m]; 0: not known yet
  double straightFor = 0.0; ///< length for which it goes straight on [m]
};

/// What is known of a front: of its front nodes, by their names, and of what all of them have done, those too
/// that are no more.
struct FrontMemory
{
  std::map<int, Memory> nodes;
  long increments = 0;      ///< of all front nodes together
  double first = 0.0;       ///< time of the first of them [s]
  double last = 0.0;        ///< and of the last [s]
  double fastest = 0.0;     ///< the largest speed that its front nodes may have had [m/s]; 0: not known yet
  double lastSettled = 0.0; ///< mean of the settled speeds of the front nodes that it had last [m/s]
};

using Memories = std::vector<FrontMemory>;

using Circles = std::vector<Circle>; ///< that the fronts were at the start

double settledSpeed(const FrontMemory& front)
{
  double sum = 0.0;
  for (const auto& [name, memory] : front.nodes)
    sum += memory.history.settledSpeed();
  return front.nodes.empty() ? front.lastSettled : sum / double(front.nodes.size());
}

/// Front nodes that are new have the past of those that they came from; those that are no more are forgotten.
void follow(const State<3>& state, Memories& memories)
{
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    memories[f].lastSettled = settledSpeed(memories[f]);
    std::map<int, Memory>& known = memories[f].nodes;
    std::map<int, Memory> now;
    for (const FrontNode<3>& frontNode : state.cracks.fronts[f].nodes)
    {
      auto past = known.find(frontNode.name);
      if (past == known.end())
        past = known.find(frontNode.from);
      if (past == known.end())
        now[frontNode.name] = {};
      else
        now[frontNode.name] = past->second;
    }
    known = std::move(now);
  }
}

bool isNew(const CrackFront<3>& front, const std::map<int, Memory>& known)
{
  return front.nodes.size() != known.size() ||
         std::any_of(front.nodes.begin(), front.nodes.end(),
                     [&](const FrontNode<3>& s) { return known.count(s.name) == 0; });
}

/// Decides whether a front node may advance after the step that ends, as Propagation.cpp does in 2D.
/// \return what is wrong; empty if nothing
std::string decideAt(const State<3>& state, FrontNode<3>& frontNode, const Options& options, Memory& memory)
{
  const double now = state.clock.time + state.clock.dt, release = frontNode.driving.release;
  if (memory.fastest == 0.0)
    memory.fastest = fastestAt(state, frontNode.position, options);
  if (memory.increment == 0.0)
    memory.increment = shareOfIncrement * options.cells * spacingAt(state, frontNode.position);
  const AdvanceRule rule = ruleAt(frontNode.temperature, options);
  if (isWeak(rule, memory.fastest))
    return complaintOfWeak(frontNode.temperature);
  FrontHistory& history = memory.history;
  if (history.running())
  {
    FrontHistory asItWouldBe = history;
    frontNode.advances =
        asItWouldBe.advance(rule, now, release, memory.increment, memory.fastest).increments > 0;
    if (!frontNode.advances)
      history = std::move(asItWouldBe);
  }
  else if (release >= rule.initiation && now >= rule.startTime)
    frontNode.advances = true;
  else
    history.wait(rule, now, release);
  frontNode.speed = history.speed(now);
  return "";
}

void decide(State<3>& state, const Options& options, Memories& memories)
{
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    CrackFront<3>& front = state.cracks.fronts[f];
    if (front.ended)
      continue;
    if (isNew(front, memories[f].nodes))
      follow(state, memories);
    for (FrontNode<3>& frontNode : front.nodes)
    {
      frontNode.advances = false;
      if (frontNode.stopped)
        continue;
      const std::string wrong = decideAt(state, frontNode, options, memories[f].nodes.at(frontNode.name));
      if (!wrong.empty())
      {
        state.failure = wrong;
        return;
      }
      memories[f].fastest = std::max(memories[f].fastest, memories[f].nodes.at(frontNode.name).fastest);
    }
  }
}

/// Turns, smoothed along the front over those front nodes that go on with it: a hat two front nodes wide,
/// twice.
std::vector<double> turns(const CrackFront<3>& front, const Options& options,
                          const std::map<int, Memory>& memories)
{
  const std::size_t count = front.nodes.size();
  std::vector<double> angle(count, 0.0);
  for (std::size_t k = 0; k < count; ++k)
    if (front.nodes[k].advances && !(memories.at(front.nodes[k].name).straightFor > 0.0))
      angle[k] = turningAngle(front.nodes[k].driving, options.direction);
  for (int round = 0; round < 2; ++round)
  {
    std::vector<double> mean = angle;
    for (std::size_t k = 0; k < count; ++k)
    {
      double sum = 2.0 * angle[k], weight = 2.0;
      const std::size_t last = k > 0 ? k - 1 : count - 1, next = k + 1 < count ? k + 1 : 0;
      if (front.nodes[last].facet >= 0 && front.nodes[last].advances)
      {
        sum += angle[last];
        weight += 1.0;
      }
      if (front.nodes[k].facet >= 0 && front.nodes[next].advances)
      {
        sum += angle[next];
        weight += 1.0;
      }
      mean[k] = sum / weight;
    }
    angle = mean;
  }
  return angle;
}

/// What a front node that does not advance would have to be driven by [J/m2]; infinite before the start time.
double resistanceAtRest(double now, const AdvanceRule& rule, const FrontHistory& history)
{
  if (now < rule.startTime)
    return std::numeric_limits<double>::infinity();
  return history.running() ? rule.arrest : rule.initiation;
}

void ask(State<3>& state, const Options& options, Memories& memories)
{
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    CrackFront<3>& front = state.cracks.fronts[f];
    if (!front.advances())
      continue;
    const std::vector<double> angle = turns(front, options, memories[f].nodes);
    // That by which the intensities were found.
    const Elasticity e = elasticity(state.materials.list[materialAt(state, front.position)]);
    FrontAdvance<3> asked;
    asked.front = static_cast<int>(f);
    asked.nodes.resize(front.nodes.size());
    bool any = false;
    for (std::size_t k = 0; k < front.nodes.size(); ++k)
    {
      FrontNode<3>& frontNode = front.nodes[k];
      FrontNodeAdvance<3>& to = asked.nodes[k];
      to.direction = frontNode.direction;
      if (!frontNode.advances)
      {
        to.toughness = resistanceAtRest(state.clock.time, ruleAt(frontNode.temperature, options),
                                        memories[f].nodes.at(frontNode.name).history);
        continue;
      }
      frontNode.advances = false;
      Memory& memory = memories[f].nodes.at(frontNode.name);
      const Advance made =
          memory.history.advance(ruleAt(frontNode.temperature, options), state.clock.time,
                                 openingRelease(frontNode.driving, e), memory.increment, memory.fastest);
      frontNode.speed = memory.history.speed(state.clock.time);
      if (made.increments == 0)
        continue;
      FrontMemory& whole = memories[f];
      if (whole.increments == 0 || memory.history.firstTime() < whole.first)
        whole.first = memory.history.firstTime();
      whole.last = std::max(whole.last, memory.history.lastTime());
      whole.increments += made.increments;
      any = true;
      to.length = made.increments * memory.increment;
      to.toughness = made.toughness;
      const bool held = memory.straightFor > 0.0;
      if (!held)
        to.direction = turned(frontNode.direction, frontNode.normal, angle[k]);
      memory.straightFor -= to.length;
      if (dot(to.direction, frontNode.direction) < sharp)
        memory.straightFor =
            straightCells * memory.increment / (shareOfIncrement * options.cells) - to.length;
      // Cells and material may be others where it is going.
      memory.increment = 0.0;
      if (state.materials.list.size() > 1)
        memory.fastest = 0.0;
    }
    if (any)
      state.cracks.advances.push_back(asked);
  }
}

void reportShape(const CrackFront<3>& front, const Circle& circle, nlohmann::json& entry)
{
  if (circle.radius == 0.0 || front.ended)
    return;
  const Shape shape = shapeOf(front, circle);
  entry["radius"] = shape.radius;
  entry["roundness"] = shape.roundness;
  entry["flatness"] = shape.flatness;
}

void report(const State<3>& state, const Memories& memories, const Circles& circles, nlohmann::json& summary)
{
  double taken = 0.0;
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    const CrackFront<3>& front = state.cracks.fronts[f];
    taken += front.budget.required;
    nlohmann::json& entry = summary["cracks"][front.crack]["fronts"][front.number];
    const FrontMemory& memory = memories[f];
    const bool running =
        std::any_of(memory.nodes.begin(), memory.nodes.end(),
                    [](const auto& frontNode) { return frontNode.second.history.running(); });
    entry["increments"] = memory.increments;
    entry["running"] = running && !front.ended && !front.stopped();
    entry["ended"] = front.ended;
    entry["halted"] = front.stopped();
    entry["set_out"] = memory.increments > 0 ? memory.first : notYet;
    entry["last_advance"] = memory.increments > 0 ? memory.last : notYet;
    entry["settled_speed"] = settledSpeed(memory);
    entry["speed_limit"] = memory.fastest;
    entry["energy_of_new_faces"] = front.budget.required;
    reportShape(front, circles[f], entry);
    double closest = 0.0;
    for (const auto& [name, frontNode] : memory.nodes)
      closest = std::max(closest, frontNode.history.closest());
    if (memory.increments == 0 && !front.ended && !front.stopped())
      reportRest(state, front, closest, summary);
    else if (memory.increments > 0)
      reportRuns(state, front, {{memory.first, memory.last, notYet}},
                 running && !front.ended && !front.stopped(), settledSpeed(memory), summary);
  }
  reportEnergy(state, taken, summary);
}

} // namespace

Effect<3> propagationInSpace(const Teuchos::ParameterList& scene, const RunOptions& run)
{
  const auto options = std::make_shared<Options>(readOptions(scene, run));
  const auto memories = std::make_shared<Memories>();
  const auto circles = std::make_shared<Circles>();
  Effect<3> effect;
  effect.name = "Propagation";
  effect.balance = {"fracture"};
  effect.atStart = [=](State<3>& state)
  {
    state.cracks.driven = true;
    state.cracks.drivingContours = options->contours;
    memories->assign(state.cracks.fronts.size(), {});
    refuseWeak(state, *options);
    follow(state, *memories);
    for (const CrackFront<3>& front : state.cracks.fronts)
      circles->push_back(circleOf(front));
  };
  effect.call({lastStage(scene),
               "fronts that advance",
               {quantity::drivingForces, ifWritten(quantity::frontTemperature)},
               {quantity::advancingFronts},
               {},
               [=](State<3>& state) { decide(state, *options, *memories); }});
  effect.call({Stage::BetweenSteps,
               "where fronts go",
               {quantity::stressIntensities, quantity::advancingFronts},
               {quantity::frontAdvances},
               {},
               [=](State<3>& state) { ask(state, *options, *memories); }});
  effect.memory = [=](State<3>& state, Archive& archive)
  {
    follow(state, *memories); // the front nodes are those that they are now, and when loaded these
    for (std::size_t f = 0; f < memories->size(); ++f)
    {
      FrontMemory& whole = (*memories)[f];
      const Archive::Group front(archive, "front " + std::to_string(f));
      archive("increments", whole.increments);
      archive("first", whole.first);
      archive("last", whole.last);
      archive("fastest", whole.fastest);
      archive("last_settled_speed", whole.lastSettled);
      for (auto& [name, memory] : whole.nodes)
      {
        const Archive::Group group(archive, "frontNode " + std::to_string(name));
        memory.history.keep(archive);
        archive("fastest", memory.fastest);
        archive("next_increment", memory.increment);
        archive("straight_for", memory.straightFor);
      }
    }
  };
  effect.report = [=](const State<3>& state, nlohmann::json& summary)
  {
    report(state, *memories, *circles, summary);
    reportToughness(*options, summary);
  };
  return effect;
}

} // namespace Rhegma::propagation
