#include "propagation/Propagation.hpp"

#include "checkpoint/Archive.hpp"
#include "propagation/Direction.hpp"
#include "propagation/FrontHistory.hpp"
#include "propagation/RayleighSpeed.hpp"
#include "scene/Numbers.hpp"
#include "scene/ReadList.hpp"
#include "step/LastStage.hpp"
#include "transfer/LocalSpacing.hpp"
#include "transfer/NearestMaterial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace Rhegma::propagation
{

namespace
{

constexpr double notYet = std::numeric_limits<double>::quiet_NaN(); ///< null in the summary

struct Options
{
  AdvanceRule rule;
  DirectionRule direction;
  double cells;       ///< an increment has [cells]
  double speedLimit;  ///< [m/s]; 0: that of Rayleigh waves
  double temperature; ///< at the start [K]
  DrivingContours contours;
};

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
  std::vector<double> straightFor; ///< length for which each front goes straight on [m]
};

Section section()
{
  Section s("Propagation", "Lets crack fronts advance where the energy release rate reaches the toughness.");
  s.text("Toughness")
      .unit("J/m2")
      .notEmpty()
      .meaning(
          "Energy that new faces take per area, as a function of the speed v of the front [m/s]: a number, "
          "an expression such as \"100*(1 + v/500)\", or a table of speed:energy such as \"0:100, "
          "500:200\".");
  s.real("Initiation Toughness")
      .unit("J/m2")
      .positive()
      .optional("Toughness at v = 0")
      .meaning("Energy release rate at which a front at rest sets out.");
  s.real("Arrest Toughness")
      .unit("J/m2")
      .positive()
      .optional("Toughness at v = 0")
      .meaning(
          "Energy release rate below which a front that has almost stopped comes to rest, to set out again "
          "at Initiation Toughness.");
  s.choice("Direction", {"Maximum Hoop Stress", "Maximum Energy Release", "Straight"})
      .byDefault("Maximum Hoop Stress")
      .meaning(
          "Where a front goes on: across the largest hoop stress, where a short kink would release most, or "
          "straight.");
  s.real("Increment")
      .range(0.5, 4.0)
      .byDefault(1.0)
      .meaning("Length of one advance, in cells as they are at the front.");
  s.real("Start Time").unit("s").notNegative().byDefault(0.0).meaning("Before it no front advances.");
  s.real("Speed Limit")
      .unit("m/s")
      .positive()
      .optional("speed of Rayleigh waves")
      .meaning("No increment is made faster.");
  s.realArray("Release Contour")
      .length(2)
      .byDefault(std::vector<double>{5.0, 10.0})
      .meaning(
          "Inner and outer radius, in cells as they are at the front, of the contour for the energy release "
          "rate. Closer than 5 cells it cuts the zone that is opening.");
  s.realArray("Direction Contour")
      .length(2)
      .byDefault(std::vector<double>{3.0, 6.0})
      .meaning("The same for the stress intensities that turn a front.");
  return s;
}

void refuseContour(const Teuchos::ParameterList& list, const std::string& name,
                   std::vector<SceneError>& errors)
{
  if (!list.isType<Teuchos::Array<double>>(name))
    return;
  const auto& radii = list.get<Teuchos::Array<double>>(name);
  if (radii.size() == 2 && !(radii[0] >= 1.0 && radii[1] >= radii[0] + 1.0))
    errors.push_back(
        {"Propagation > " + name,
         "the radii must be at least 1 and a cell apart, the inner one first; write such as {5, 10}"});
}

void check(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors)
{
  if (!scene.isSublist("Propagation"))
    return;
  const Teuchos::ParameterList& list = scene.sublist("Propagation");
  const auto refuse = [&](const std::string& why) { errors.push_back({"Propagation", why}); };
  if (!scene.isSublist("Cracks"))
    refuse("there are no cracks that could run; add a section Cracks or leave this one out");
  else
  {
    const Teuchos::ParameterList& cracks = scene.sublist("Cracks");
    if (cracks.isType<std::string>("Formulation") && cracks.get<std::string>("Formulation") != "Dual Field")
      refuse("it goes with Cracks > Formulation = Dual Field alone, whose nodes can carry a cohesive force");
    if (cracks.isType<bool>("Front Ties") && !cracks.get<bool>("Front Ties"))
      refuse("it needs Cracks > Front Ties; leave that at true");
  }
  if (scene.isSublist("Mass Matrix"))
    refuse("it does not go with Mass Matrix as yet; take one of the two out");
  if (!scene.isSublist("Energy Release"))
    refuse("nothing measures what drives the fronts; add a section Energy Release, which may be empty");
  if (scene.isSublist("Domain") && scene.sublist("Domain").isType<int>("Dimension") &&
      scene.sublist("Domain").get<int>("Dimension") == 3)
    refuse("cracks of 3D scenes do not run as yet; take this section out");
  refuseContour(list, "Release Contour", errors);
  refuseContour(list, "Direction Contour", errors);
  if (list.isType<std::string>("Toughness"))
    try
    {
      Toughness::parse(list.get<std::string>("Toughness"), scene.isSublist("Thermal"));
    }
    catch (const std::invalid_argument& error)
    {
      errors.push_back({"Propagation > Toughness", error.what()});
    }
}

DirectionRule readDirection(const Teuchos::ParameterList& list)
{
  const auto name = list.get<std::string>("Direction");
  return name == "Straight"                 ? DirectionRule::Straight
         : name == "Maximum Energy Release" ? DirectionRule::EnergyRelease
                                            : DirectionRule::HoopStress;
}

Options readOptions(const Teuchos::ParameterList& scene)
{
  const Teuchos::ParameterList& list = scene.sublist("Propagation");
  const bool heated = scene.isSublist("Thermal");
  const Toughness toughness = Toughness::parse(list.get<std::string>("Toughness"), heated);
  const auto orAtRest = [&](const char* name)
  { return list.isParameter(name) ? list.get<double>(name) : 0.0; };
  Options options{{toughness, orAtRest("Initiation Toughness"), orAtRest("Arrest Toughness"),
                   list.get<double>("Start Time")},
                  readDirection(list),
                  list.get<double>("Increment"),
                  list.isParameter("Speed Limit") ? list.get<double>("Speed Limit") : 0.0,
                  heated ? scene.sublist("Thermal").get<double>("Initial Temperature") : 0.0,
                  {}};
  const auto release = list.get<Teuchos::Array<double>>("Release Contour");
  const auto intensity = list.get<Teuchos::Array<double>>("Direction Contour");
  options.contours = {release[0], release[1], intensity[0], intensity[1]};
  return options;
}

double fastestAt(const State<2>& state, const Vector<2>& place, const Options& options)
{
  return options.speedLimit > 0.0 ? options.speedLimit
                                  : rayleighSpeed(state.materialList[materialAt(state, place)]);
}

/// The rule at a front, whose toughness depends on how warm it is.
AdvanceRule ruleAt(const CrackFront<2>& front, const Options& options)
{
  AdvanceRule rule = options.rule;
  rule.temperature = front.temperature;
  const double atRest = rule.toughness(0.0, front.temperature);
  rule.initiation = rule.initiation > 0.0 ? rule.initiation : atRest;
  rule.arrest = rule.arrest > 0.0 ? rule.arrest : atRest;
  return rule;
}

/// Decides which fronts may advance after the step that ends: those that do if nothing closes them, which
/// only their stress intensities tell.
void decide(State<2>& state, const Options& options, Fronts& fronts)
{
  const double now = state.time + state.dt;
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    CrackFront<2>& front = state.cracks.fronts[f];
    front.advances = false;
    if (front.ended || front.halted)
      continue;
    if (fronts.fastest[f] == 0.0)
      fronts.fastest[f] = fastestAt(state, front.position, options);
    if (fronts.increment[f] == 0.0)
      fronts.increment[f] = options.cells * spacingAt(state, front.position);
    FrontHistory& history = fronts.histories[f];
    const double release = front.driving.release;
    const AdvanceRule rule = ruleAt(front, options);
    for (const double speed : {0.0, fronts.fastest[f]})
      if (!(rule.toughness(speed, front.temperature) > 0.0))
      {
        state.trouble = "the toughness is no longer positive at the temperature of a crack front, " +
                        formatReal(front.temperature) + " K (Propagation > Toughness)";
        return;
      }
    if (history.running())
    {
      FrontHistory asItWouldBe = history;
      front.advances =
          asItWouldBe.advance(rule, now, release, fronts.increment[f], fronts.fastest[f]).increments > 0;
      if (!front.advances)
        history = std::move(asItWouldBe);
    }
    else if (release >= rule.initiation && now >= rule.startTime)
      front.advances = true;
    else
      history.wait(now, release);
    front.speed = history.speed(now);
  }
}

/// The energy release rate without what closes the crack: a front that is pressed together does not break,
/// though J is positive.
double openingRelease(const DrivingForce& driving)
{
  const double opening = std::max(driving.modeI, 0.0) * std::max(driving.modeI, 0.0);
  const double closing = driving.modeI * driving.modeI - opening, sliding = driving.modeII * driving.modeII;
  return closing > 0.0 ? driving.release * sliding / (closing + sliding) : driving.release;
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
    if (!front.advances)
      continue;
    front.advances = false;
    FrontHistory& history = fronts.histories[f];
    fronts.next[f] = history.advance(ruleAt(front, options), state.time, openingRelease(front.driving),
                                     fronts.increment[f], fronts.fastest[f]);
    front.speed = history.speed(state.time);
    if (fronts.next[f].increments == 0)
      continue;
    const double length = fronts.next[f].increments * fronts.increment[f];
    const bool held = fronts.straightFor[f] > 0.0;
    const Vector<2> direction = held ? front.direction : nextDirection(front, options.direction);
    fronts.straightFor[f] -= length;
    if (dot(direction, front.direction) < sharp)
      fronts.straightFor[f] = straightCells * fronts.increment[f] / options.cells - length;
    if (!front.grown)
      fronts.origins[f] = {front.position, front.direction, direction};
    state.cracks.advances.push_back({static_cast<int>(f), direction, length, fronts.next[f].toughness});
    // Cells and material may be others where it is going.
    fronts.increment[f] = 0.0;
    if (state.materialList.size() > 1)
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
  double fastest = options.speedLimit;
  for (const Properties& material : state.materialList)
    fastest = std::max(fastest, rayleighSpeed(material));
  try
  {
    options.rule.toughness.refuseWeak(fastest, options.temperature);
  }
  catch (const std::invalid_argument& error)
  {
    throw std::invalid_argument(std::string("Propagation > Toughness: ") + error.what());
  }
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
    taken += front.taken;
    nlohmann::json& entry = summary["cracks"][front.crack]["fronts"][front.number];
    entry["increments"] = history.increments();
    entry["running"] = history.running() && !front.ended && !front.halted;
    entry["ended"] = front.ended;
    entry["halted"] = front.halted;
    const Origin& origin = fronts.origins[f];
    const bool moved = history.increments() > 0;
    entry["set_out"] = moved ? history.firstTime() : notYet;
    entry["last_advance"] = moved ? history.lastTime() : notYet;
    entry["first_turn"] = moved ? turn(origin.before, origin.first) : notYet;
    entry["turn"] = moved ? turn(origin.before, front.position - origin.place) : notYet;
    entry["settled_speed"] = history.settledSpeed();
    entry["settled_release"] = history.settledRelease();
    entry["speed_limit"] = fronts.fastest[f];
    entry["energy_of_new_faces"] = front.taken;
  }
  // What the body has been given, and how much of it the ledger knows of now.
  const EnergyLedger& energy = state.energy;
  const double given =
      energy.start + std::fabs(energy.externalWork) + std::fabs(energy.combustion) + std::fabs(energy.heat);
  const double inFlight = summary.value("energy_in_flight", 0.0);
  summary["propagation"] = {
      {"energy_of_new_faces", taken},
      {"in_flight", inFlight},
      {"dissipated", energy.fracture},
      {"accounted_for", given > 0.0 ? 1.0 - energy.residual() / given : notYet},
      {"dissipated_share", taken > inFlight ? energy.fracture / (taken - inFlight) : notYet}};
}

Effect<2> make2(const Teuchos::ParameterList& scene)
{
  const auto options = std::make_shared<Options>(readOptions(scene));
  const auto fronts = std::make_shared<Fronts>();
  Effect<2> effect;
  effect.name = "Propagation";
  effect.atStart = [=](State<2>& state) { start(state, *options, *fronts); };
  effect.call({lastStage(scene),
               "fronts that advance",
               {"driving forces"},
               {"fronts that advance"},
               {},
               [=](State<2>& state) { decide(state, *options, *fronts); }});
  effect.call({Stage::BetweenSteps, "where fronts go", {}, {"advances of fronts"}, {}, [=](State<2>& state) {
                 ask(state, *options, *fronts);
               }});
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
      archive("origin", fronts->origins[f].place);
      archive("before", fronts->origins[f].before);
      archive("first", fronts->origins[f].first);
    }
  };
  effect.report = [=](const State<2>& state, nlohmann::json& summary) { report(state, *fronts, summary); };
  return effect;
}

Effect<3> make3(const Teuchos::ParameterList&)
{
  throw std::invalid_argument("Propagation: cracks of 3D scenes do not run as yet; take this section out");
}

} // namespace

EffectEntry propagationEntry() { return {section(), check, make2, make3, true}; }

} // namespace Rhegma::propagation
