#include "energy_release/EnergyRelease.hpp"

#include "archive/Archive.hpp"
#include "base/Attempts.hpp"
#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "base/ShortNumber.hpp"
#include "energy_release/Contour.hpp"
#include "energy_release/CrackClosure.hpp"
#include "energy_release/CrackTipFields.hpp"
#include "energy_release/DomainIntegral.hpp"
#include "energy_release/DrivingCalls.hpp"
#include "energy_release/DrivingForces.hpp"
#include "energy_release/FrontSet.hpp"
#include "energy_release/FrontsInSpace.hpp"
#include "energy_release/LoadsInRing.hpp"
#include "energy_release/ReadOptions.hpp"
#include "transfer/LocalSpacing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

namespace Rhegma::energy_release
{

namespace
{

constexpr double notYet = std::numeric_limits<double>::quiet_NaN(); ///< null in the summary

/// The last sample of a front.
struct Sample
{
  CrackFront<2> front;
  ContourRadii radii{0.0, 0.0}; ///< none round a front that has ended
  bool closed = false;          ///< whether crack closure is wanted and can be found
  DomainIntegral integral;
  CrackClosure closure{notYet, notYet};
};

struct Samples
{
  std::vector<Sample> last;
  std::vector<PlacedLoad> loads; ///< that may act near fronts
  FrontSet inclined;             ///< fronts that did not start along the grid: without crack closure
  FrontSet warned;               ///< fronts whose contour has left the body during the run
  FrontSet unclosed;             ///< fronts that had no crack closure at some time
};

std::string frontName(const State<2>& state, const CrackFront<2>& front)
{
  return state.cracks.cracks[front.crack].name + "." + std::to_string(front.number);
}

/// Its name in messages, such as "crack Notch, front 0".
std::string messageName(const State<2>& state, const CrackFront<2>& front)
{
  return "crack " + state.cracks.cracks[front.crack].name + ", front " + std::to_string(front.number);
}

/// A node may come to lie this share of a cell inside of the contour as the body moves.
constexpr double slack = 1e-6;

void refuseContour(const State<2>& state, const CrackFront<2>& front, const std::string& where,
                   const std::string& contour, const std::string& advice)
{
  throw std::invalid_argument("Energy Release > " + where + ": the contour of " + contour + " m around " +
                              messageName(state, front) + " leaves the body or reaches another " + advice +
                              ", or use smaller cells (Domain > Cell Size)");
}

/// Refuses radii that the scene gives and that don't fit; says which ones are used where the usual ones
/// don't.
void checkContour(State<2>& state, const CrackFront<2>& front, const Options& options)
{
  const double cell = spacingAt(state, front.position);
  const GivenRadii& given = options.radii;
  if (given.outer > 0.0)
  {
    const double clear = largestContour(state, front, given.outer);
    if (clear < given.outer - slack * cell)
      refuseContour(state, front, "Outer Radius", formatReal(given.outer),
                    "front; write at most " + formatReal(clear));
    return;
  }
  const double usual = usualRadii(given, cell).outer, room = roomAround(state, front, usual);
  const double least = smallestOuter(given, cell);
  if (room < least - slack * cell)
    refuseContour(state, front, given.inner > 0.0 ? "Inner Radius" : "Outer Radius", formatReal(least),
                  "front or crack; at most " + formatReal(room) + " m fit: " +
                      (given.inner > 0.0 ? "write a smaller Inner Radius"
                                         : "write both radii, or leave out Energy Release"));
  if (room < usual - slack * cell)
  {
    const ContourRadii radii = fittingRadii(state, front, given);
    state.warnings.push_back("Energy Release: for " + messageName(state, front) +
                             ", the domain integral is reduced to radii of " + readableLength(radii.inner) +
                             " to " + readableLength(radii.outer) + " (default: to " + readableLength(usual) +
                             "), because of a surface, another front or another crack; G and K are less "
                             "accurate: use smaller cells (Domain > Cell Size)");
  }
}

/// Closer contours see the tip's own cells.
constexpr double leastInnerCells = 2.0;

void checkContours(State<2>& state, const Options& options)
{
  if (state.cracks.fronts.empty())
    throw std::invalid_argument(
        "Energy Release: no crack has a front inside a body; end a crack inside material, choose "
        "its front with Cracks > NAME > Fronts, or remove this section");
  if (!options.contour)
    return;
  Attempts attempts;
  for (const CrackFront<2>& front : state.cracks.fronts)
    attempts.attempt([&] { checkContour(state, front, options); });
  attempts.complain();
  const double cell = spacingAt(state, state.cracks.fronts.front().position);
  if (options.radii.inner > 0.0 && options.radii.inner < (leastInnerCells - slack) * cell)
    state.warnings.push_back(
        "Energy Release > Inner Radius is " + formatReal(options.radii.inner / cell) +
        " cells: below two cells the contour passes through the cells of the front, and G and K "
        "can be wrong by 10 % or more; use smaller cells or a larger radius");
}

void warnOfContour(State<2>& state, const CrackFront<2>& front, const ContourRadii& radii,
                   const Options& options, Samples& samples)
{
  const bool follows = options.radii.outer == 0.0; // then the contour is drawn in as far as it may be
  if (follows && radii.outer > smallestOuter(options.radii, spacingAt(state, front.position)))
    return;
  if (samples.warned.count({front.crack, front.number}) != 0 ||
      largestContour(state, front, radii.outer) > radii.outer - spacingAt(state, front.position))
    return;
  samples.warned.insert({front.crack, front.number});
  state.warnings.push_back(
      "Energy Release: from t = " + readableTime(state.clock.time) + " on, the contour around " +
      messageName(state, front) +
      " leaves the body or reaches another front, so G_J, K_I and K_II are less accurate; "
      "use smaller cells or radii");
}

bool wantsClosure(const State<2>& state, const Options& options, const Samples& samples,
                  const CrackFront<2>& front)
{
  return options.closure && options.pushed.count(state.cracks.cracks[front.crack].name) == 0 &&
         samples.inclined.count({front.crack, front.number}) == 0;
}

/// Says once of a front along the grid that it has no crack closure.
void warnOfClosure(State<2>& state, const CrackFront<2>& front, const CrackClosure& closure, Samples& samples)
{
  if (std::isfinite(closure.chosen) || !runsAlongGrid(front) ||
      !samples.unclosed.insert({front.crack, front.number}).second)
    return;
  state.warnings.push_back(
      "Energy Release: G_closure of " + messageName(state, front) +
      " is not available at t = " + readableTime(state.clock.time) +
      ", because no node behind the front has material of both faces within reach: the crack is too short "
      "for Closure Cells, or its faces are several cells apart; use G_J");
}

/// A front whose surroundings have fallen apart ends the run.
CrackClosure tryToClose(State<2>& state, const CrackFront<2>& front, const Options& options, Samples& samples)
{
  try
  {
    const CrackClosure closure = closeCrack(state, front, options.columns, options.recovery);
    if (options.openingKnown)
      warnOfClosure(state, front, closure, samples);
    return closure;
  }
  catch (const std::runtime_error& error)
  {
    state.failure = error.what();
    return {notYet, notYet};
  }
}

void sample(State<2>& state, const Options& options, Samples& samples)
{
  samples.last.clear();
  for (const CrackFront<2>& front : state.cracks.fronts)
  {
    Sample s;
    s.front = front;
    if (options.contour && !front.ended)
    {
      s.radii = fittingRadii(state, front, options.radii);
      warnOfContour(state, front, s.radii, options, samples);
      warnOfLoads(state, front, s.radii, samples.loads);
      s.integral = integrateDomain(state, front, s.radii);
    }
    const bool closure = wantsClosure(state, options, samples, front);
    s.closed = closure;
    if (closure && front.ended)
      s.closure = {0.0, 0.0};
    else if (closure)
      s.closure = tryToClose(state, front, options, samples);
    samples.last.push_back(s);

    const std::string name = frontName(state, front) + ".";
    if (options.contour)
      state.sample.row.emplace_back(name + "G_J", s.integral.J);
    if (closure && options.openingKnown)
      state.sample.row.emplace_back(name + "G_closure", s.closure.chosen);
    if (closure && options.lumped)
      state.sample.row.emplace_back(name + "G_closure_lumped", s.closure.lumped);
    if (options.contour)
    {
      state.sample.row.emplace_back(name + "K_I", s.integral.modeI);
      state.sample.row.emplace_back(name + "K_II", s.integral.modeII);
    }
    state.sample.row.emplace_back(name + "length", front.length);
    state.sample.row.emplace_back(name + "speed", front.speed());
    state.sample.row.emplace_back(name + "x", front.position[0]);
    state.sample.row.emplace_back(name + "y", front.position[1]);
  }
}

/// Angle [degrees], counter-clockwise, by which the front would turn.
double kinkAngle(const Sample& s)
{
  const double degrees = 45.0 / std::atan(1.0);
  const Vector<2>&along = s.front.direction, &normal = s.front.normal;
  const double turn = along[0] * normal[1] - along[1] * normal[0] > 0.0 ? degrees : -degrees;
  return turn * hoopStressAngle(s.integral.modeI, s.integral.modeII);
}

void report(const State<2>& state, const Options& options, const Samples& samples, nlohmann::json& summary)
{
  for (const Sample& s : samples.last)
  {
    nlohmann::json& crack = summary["cracks"][s.front.crack];
    crack["name"] = state.cracks.cracks[s.front.crack].name;
    nlohmann::json& entry = crack["fronts"][s.front.number];
    entry["position"] = {s.front.position[0], s.front.position[1]};
    entry["length"] = s.front.length;
    entry["speed"] = s.front.speed();
    if (options.contour)
    {
      entry["G_J"] = s.integral.J;
      entry["K_I"] = s.integral.modeI;
      entry["K_II"] = s.integral.modeII;
      entry["kink_angle"] = kinkAngle(s);
      entry["tip_offset"] = s.integral.tipOffset;
      entry["inner_radius"] = s.radii.inner;
      entry["outer_radius"] = s.radii.outer;
    }
    if (s.closed && options.openingKnown)
      entry["G_closure"] = s.closure.chosen;
    if (s.closed && options.lumped)
      entry["G_closure_lumped"] = s.closure.lumped;
  }
}

void keepFront(CrackFront<2>& front, Archive& archive)
{
  archive("crack", front.crack);
  archive("number", front.number);
  archive("vertex", front.vertex);
  archive("first_facet", front.firstFacet);
  archive("facets", front.numFacets);
  archive("position", front.position);
  archive("direction", front.direction);
  archive("normal", front.normal);
  archive("length", front.length);
  archive("speed", front.nodes[0].speed);
}

void keepSample(Sample& s, Archive& archive)
{
  keepFront(s.front, archive);
  archive("inner_radius", s.radii.inner);
  archive("outer_radius", s.radii.outer);
  archive("closed", s.closed);
  archive("J", s.integral.J);
  archive("K_I", s.integral.modeI);
  archive("K_II", s.integral.modeII);
  archive("tip_offset", s.integral.tipOffset);
  archive("closure", s.closure.chosen);
  archive("closure_lumped", s.closure.lumped);
}

/// Saves or loads the last sample and which fronts were warned of.
void keep(Samples& samples, Archive& archive)
{
  int count = static_cast<int>(samples.last.size());
  archive("fronts", count);
  samples.last.resize(count);
  for (int k = 0; k < count; ++k)
  {
    const Archive::Group group(archive, "front " + std::to_string(k));
    keepSample(samples.last[k], archive);
  }
  keepFronts(samples.warned, "warned", archive);
  keepFronts(samples.unclosed, "unclosed", archive);
}

Effect<2> make2(const Teuchos::ParameterList& scene, const RunOptions& run)
{
  const Options options = readOptions(scene, run);
  const auto samples = std::make_shared<Samples>();
  samples->loads = readLoads(scene);
  Effect<2> effect;
  effect.name = "Energy Release";
  effect.atStart = [=](State<2>& state)
  {
    checkContours(state, options);
    for (const CrackFront<2>& front : state.cracks.fronts)
      if (!runsAlongGrid(front))
        samples->inclined.insert({front.crack, front.number});
    // What will be reported is known from the start, though its values are not.
    for (const CrackFront<2>& front : state.cracks.fronts)
    {
      Sample s;
      s.front = front;
      s.closed = wantsClosure(state, options, *samples, front);
      if (options.contour)
      {
        s.radii = fittingRadii(state, front, options.radii);
        warnOfLoads(state, front, s.radii, samples->loads);
      }
      s.integral = {notYet, notYet, notYet, notYet};
      samples->last.push_back(s);
    }
  };
  effect.call({Stage::Observe,
               "energy release of crack fronts",
               {quantity::crackGeometry, quantity::particleStress, quantity::enrichedFields,
                ifWritten(quantity::springForce), ifWritten(quantity::facePressure)},
               {},
               {quantity::energyRelease},
               [=](State<2>& state)
               {
                 if (state.clock.observing)
                   sample(state, options, *samples);
               }});
  const auto driving = std::make_shared<DrivingForces>();
  if (run.growth)
    addDrivingCalls(effect, scene, driving);
  effect.memory = [=](State<2>&, Archive& archive) { keepBoth(*samples, *driving, archive); };
  effect.report = [=](const State<2>& state, nlohmann::json& summary)
  { report(state, options, *samples, summary); };
  return effect;
}

} // namespace

EffectEntry energyReleaseEntry()
{
  return {energyReleaseSection(), checkEnergyRelease, make2, fronts3, true};
}

} // namespace Rhegma::energy_release
