#include "energy_release/EnergyRelease.hpp"

#include "checkpoint/Archive.hpp"
#include "energy_release/Contour.hpp"
#include "energy_release/CrackClosure.hpp"
#include "energy_release/CrackTipFields.hpp"
#include "energy_release/DomainIntegral.hpp"
#include "scene/Attempts.hpp"
#include "scene/Numbers.hpp"
#include "scene/ReadList.hpp"
#include "transfer/LocalSpacing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <stdexcept>

namespace Rhegma::energy_release
{

namespace
{

constexpr double notYet = std::numeric_limits<double>::quiet_NaN(); ///< null in the summary

struct Options
{
  GivenRadii radii;
  bool contour = true; ///< domain integrals are wanted
  bool closure = true;
  std::set<std::string> pushed; ///< cracks with Face Pressure, of which closure would leave out the pressure
  bool lumped = false;
  bool openingKnown = true; ///< shape functions without linear completeness give no opening to close
  int columns = 1;
  RecoveryMatrix recovery = consistentMatrix();
};

/// The last sample of a front.
struct Sample
{
  CrackFront<2> front;
  ContourRadii radii;
  bool closed = false; ///< whether crack closure is wanted and can be found
  DomainIntegral integral;
  CrackClosure closure{notYet, notYet};
};

struct Samples
{
  std::vector<Sample> last;
  std::set<std::pair<int, int>> inclined; ///< fronts that did not start along the grid: without crack closure
  std::set<std::pair<int, int>> warned;   ///< fronts whose contour has left the body during the run
};

Section section()
{
  Section s("Energy Release",
            "Energy release rate and stress intensities of every crack front, at every sample.");
  s.real("Inner Radius")
      .unit("m")
      .positive()
      .optional("3 cells, or half of Outer Radius where that is less")
      .meaning("The weight of the domain integrals is 1 up to this distance from the front. Take 5 cells "
               "round a front "
               "that runs: a closer contour cuts its cohesive zone.");
  s.real("Outer Radius")
      .unit("m")
      .positive()
      .optional("6 cells or twice a given Inner Radius, less where that leaves the body or reaches another "
                "front or crack")
      .meaning(
          "The weight falls to 0 at this distance. One that is given must be inside the body and clear of "
          "other fronts.");
  s.boolean("Contour Integral")
      .byDefault(true)
      .meaning(
          "Find J and the stress intensities by domain integrals. Without them crack closure works on cells "
          "that are too large for a contour inside the body.");
  s.boolean("Crack Closure")
      .byDefault(true)
      .meaning(
          "Also find the energy release rate from the forces ahead of the front and the opening behind it, "
          "where a front starts along a direction of the grid and Cracks > Formulation is not Broken Cell.");
  s.boolean("Lumped Closure")
      .byDefault(false)
      .meaning("Also report crack closure with the opening of a lumped projection, which is 7 to 25 % low "
               "whatever the "
               "cells.");
  s.integer("Closure Cells").range(1, 2).byDefault(1).meaning("Columns of cells that crack closure closes.");
  s.choice("Closure Recovery", {"Consistent", "Lumped", "Mass Matrix"})
      .byDefault("Consistent")
      .meaning("The matrix that crack closure recovers the displacement of nodes with: the consistent mass, "
               "its row "
               "sums, or what the section Mass Matrix says (row sums where there is none).");
  return s;
}

void check(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors)
{
  if (!scene.isSublist("Energy Release"))
    return;
  if (!scene.isSublist("Cracks"))
    errors.push_back({"Energy Release",
                      "there is no crack whose energy release could be found; add a section Cracks or "
                      "take this section out"});
  const Teuchos::ParameterList& list = scene.sublist("Energy Release");
  const auto refused = [&](const char* name) { return list.isType<bool>(name) && !list.get<bool>(name); };
  const bool contour = !refused("Contour Integral");
  const auto formulation = [&] // the opening of Broken Cell is not known
  {
    const bool given =
        scene.isSublist("Cracks") && scene.sublist("Cracks").isType<std::string>("Formulation");
    return given ? scene.sublist("Cracks").get<std::string>("Formulation") : std::string();
  };
  if (!contour && (refused("Crack Closure") || formulation() == "Broken Cell"))
    errors.push_back({"Energy Release > Contour Integral",
                      "nothing is left to find without crack closure; set this to true or take the "
                      "section Energy Release out"});
  if (!scene.isSublist("Domain"))
    return;
  const Teuchos::ParameterList& domain = scene.sublist("Domain");
  if (domain.isType<int>("Dimension") && domain.get<int>("Dimension") == 3)
    errors.push_back({"Energy Release", "it is for 2D scenes as yet; take this section out"});
  if (!contour || !domain.isType<double>("Cell Size"))
    return;
  for (const SceneError& error : errors)
    if (error.where == "Domain > Cell Size") // what follows from a wrong cell says nothing
      return;
  const double cell = domain.get<double>("Cell Size");
  GivenRadii given;
  if (list.isType<double>("Inner Radius"))
    given.inner = list.get<double>("Inner Radius");
  if (list.isType<double>("Outer Radius"))
    given.outer = list.get<double>("Outer Radius");
  const auto [inner, outer] = usualRadii(given, cell);
  if (outer < inner + cell)
    errors.push_back({"Energy Release > Outer Radius",
                      "the weight must fall over at least one cell of " + formatReal(cell) +
                          " m; write at least " + formatReal(inner + cell) + ", or a smaller Inner Radius"});
}

/// What the section Mass Matrix says.
RecoveryMatrix matrixOfTheMotion(const Teuchos::ParameterList& scene)
{
  if (!scene.isSublist("Mass Matrix"))
    return lumpedMatrix();
  const Teuchos::ParameterList& list = scene.sublist("Mass Matrix");
  const auto type = list.get<std::string>("Type");
  if (type == "Lumped")
    return lumpedMatrix();
  RecoveryMatrix matrix = consistentMatrix();
  if (type == "FMPM")
  {
    matrix.terms = list.get<int>("Order");
    return matrix;
  }
  matrix.lumpedShare = std::max(matrix.lumpedShare, list.get<double>("Lumped Share"));
  matrix.smallestNode = list.get<double>("Smallest Node");
  if (type == "Partial")
  {
    const auto length = [&](const char* name)
    { return list.isParameter(name) ? list.get<double>(name) : 0.0; };
    matrix.radius = length("Radius");
    matrix.edge = length("Edge Width");
    // As Mass Matrix has them where they are not given.
    matrix.radiusCells = list.isParameter("Radius") ? 0.0 : 3.0;
    matrix.edgeCells = list.isParameter("Edge Width") ? 0.0 : 1.0;
  }
  return matrix;
}

RecoveryMatrix readRecovery(const Teuchos::ParameterList& scene)
{
  const auto choice = scene.sublist("Energy Release").get<std::string>("Closure Recovery");
  if (choice == "Mass Matrix")
    return matrixOfTheMotion(scene);
  return choice == "Lumped" ? lumpedMatrix() : consistentMatrix();
}

Options readOptions(const Teuchos::ParameterList& scene)
{
  const Teuchos::ParameterList& list = scene.sublist("Energy Release");
  const Teuchos::ParameterList& cracks = scene.sublist("Cracks");
  Options options;
  if (cracks.isParameter("Formulation"))
    options.openingKnown = cracks.get<std::string>("Formulation") != "Broken Cell";
  if (list.isParameter("Inner Radius"))
    options.radii.inner = list.get<double>("Inner Radius");
  if (list.isParameter("Outer Radius"))
    options.radii.outer = list.get<double>("Outer Radius");
  options.contour = list.get<bool>("Contour Integral");
  options.closure = list.get<bool>("Crack Closure");
  if (scene.isSublist("Face Pressure"))
    for (const std::string& name : sublistNames(scene.sublist("Face Pressure")))
      options.pushed.insert(name);
  options.lumped = list.get<bool>("Lumped Closure");
  options.columns = list.get<int>("Closure Cells");
  options.recovery = readRecovery(scene);
  return options;
}

std::string frontName(const State<2>& state, const CrackFront<2>& front)
{
  return state.cracks.cracks[front.crack].name + "." + std::to_string(front.number);
}

/// A node may come to lie this share of a cell inside of the contour as the body moves.
constexpr double slack = 1e-6;

void refuseContour(const State<2>& state, const CrackFront<2>& front, const std::string& where,
                   const std::string& contour, const std::string& advice)
{
  throw std::invalid_argument("Energy Release > " + where + ": the contour of " + contour +
                              " m round the front " + frontName(state, front) +
                              " leaves the body or reaches another " + advice +
                              ", or take smaller cells (Domain > Cell Size)");
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
                  "front or crack; there is room for " + formatReal(room) + " m: " +
                      (given.inner > 0.0 ? "write a smaller Inner Radius"
                                         : "give both radii, or leave out Energy Release"));
  if (room < usual - slack * cell)
  {
    const ContourRadii radii = fittingRadii(state, front, given);
    state.warnings.push_back("Energy Release: round the front " + frontName(state, front) +
                             " the weight is 1 up to " + formatReal(radii.inner) + " m and 0 from " +
                             formatReal(radii.outer) +
                             " m on, which is the room inside the body and clear of "
                             "other fronts and cracks; " +
                             formatReal(usual) + " m would be usual");
  }
}

/// Closer contours see the tip's own cells.
constexpr double leastInnerCells = 2.0;

void checkContours(State<2>& state, const Options& options)
{
  if (state.cracks.fronts.empty())
    throw std::invalid_argument(
        "Energy Release: no crack has a front inside a body; end a crack in material, choose "
        "its front with Cracks > NAME > Fronts, or take this section out");
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
        " cells: below two cells the contour runs through the cells of the front, and G and K "
        "can be off by 10 % and more; take smaller cells or a larger radius");
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
  state.warnings.push_back("from time " + formatReal(state.time) +
                           " s on the contour of Energy Release round the front " + frontName(state, front) +
                           " leaves the body or reaches another front: G_J, K_I and K_II are less accurate");
}

bool wantsClosure(const State<2>& state, const Options& options, const Samples& samples,
                  const CrackFront<2>& front)
{
  return options.closure && options.pushed.count(state.cracks.cracks[front.crack].name) == 0 &&
         samples.inclined.count({front.crack, front.number}) == 0;
}

/// A front whose surroundings have fallen apart ends the run.
CrackClosure tryToClose(State<2>& state, const CrackFront<2>& front, const Options& options)
{
  try
  {
    return closeCrack(state, front, options.columns, options.recovery);
  }
  catch (const std::runtime_error& error)
  {
    state.trouble = error.what();
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
    if (options.contour)
    {
      s.radii = fittingRadii(state, front, options.radii);
      warnOfContour(state, front, s.radii, options, samples);
      s.integral = integrateDomain(state, front, s.radii);
    }
    const bool closure = wantsClosure(state, options, samples, front);
    s.closed = closure;
    if (closure)
      s.closure = tryToClose(state, front, options);
    samples.last.push_back(s);

    const std::string name = frontName(state, front) + ".";
    if (options.contour)
      state.row.emplace_back(name + "G_J", s.integral.J);
    if (closure && options.openingKnown)
      state.row.emplace_back(name + "G_closure", s.closure.chosen);
    if (closure && options.lumped)
      state.row.emplace_back(name + "G_closure_lumped", s.closure.lumped);
    if (options.contour)
    {
      state.row.emplace_back(name + "K_I", s.integral.modeI);
      state.row.emplace_back(name + "K_II", s.integral.modeII);
    }
    state.row.emplace_back(name + "length", front.length);
    state.row.emplace_back(name + "speed", front.speed);
    state.row.emplace_back(name + "x", front.position[0]);
    state.row.emplace_back(name + "y", front.position[1]);
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
    entry["speed"] = s.front.speed;
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
  archive("speed", front.speed);
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
  std::vector<int> warned;
  for (const auto& [crack, number] : samples.warned)
    warned.insert(warned.end(), {crack, number});
  archive("warned", warned, 2);
  for (std::size_t k = 0; k + 1 < warned.size(); k += 2)
    samples.warned.insert({warned[k], warned[k + 1]});
}

Effect<2> make2(const Teuchos::ParameterList& scene)
{
  const Options options = readOptions(scene);
  const auto samples = std::make_shared<Samples>();
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
        s.radii = fittingRadii(state, front, options.radii);
      s.integral = {notYet, notYet, notYet, notYet};
      samples->last.push_back(s);
    }
  };
  effect.call({Stage::Observe,
               "energy release of crack fronts",
               {"crack geometry", "particle stress"},
               {},
               {"energy release"},
               [=](State<2>& state)
               {
                 if (state.observing)
                   sample(state, options, *samples);
               }});
  effect.memory = [=](State<2>&, Archive& archive) { keep(*samples, archive); };
  effect.report = [=](const State<2>& state, nlohmann::json& summary)
  { report(state, options, *samples, summary); };
  return effect;
}

Effect<3> make3(const Teuchos::ParameterList&)
{
  throw std::invalid_argument("Energy Release: it is for 2D scenes as yet; take this section out");
}

} // namespace

EffectEntry energyReleaseEntry() { return {section(), check, make2, make3}; }

} // namespace Rhegma::energy_release
