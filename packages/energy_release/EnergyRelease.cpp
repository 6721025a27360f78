#include "energy_release/EnergyRelease.hpp"

#include "energy_release/Contour.hpp"
#include "energy_release/CrackClosure.hpp"
#include "energy_release/DomainIntegral.hpp"
#include "scene/Numbers.hpp"

#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <stdexcept>

namespace Rhegma::energy_release
{

namespace
{

constexpr double innerCells = 3.0, outerCells = 6.0;

struct Options
{
  ContourRadii radii{0.0, 0.0}; ///< 0 where the scene leaves them to the cells
  bool closure = true;
  bool lumped = false;
  bool openingKnown = true; ///< shape functions without linear completeness give no opening to close
  int columns = 1;
};

/// The last sample of a front.
struct Sample
{
  CrackFront<2> front;
  DomainIntegral integral;
  CrackClosure closure{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
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
      .optional("3 cells")
      .meaning("The weight of the domain integrals is 1 up to this distance from the front. Take 5 cells "
               "round a front "
               "that runs: a closer contour cuts its cohesive zone.");
  s.real("Outer Radius")
      .unit("m")
      .positive()
      .optional("6 cells")
      .meaning(
          "The weight falls to 0 at this distance, which must be inside the body and clear of other fronts.");
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
  if (!scene.isSublist("Domain"))
    return;
  const Teuchos::ParameterList& domain = scene.sublist("Domain");
  if (domain.isType<int>("Dimension") && domain.get<int>("Dimension") == 3)
    errors.push_back({"Energy Release", "it is for 2D scenes as yet; take this section out"});
  if (!domain.isType<double>("Cell Size"))
    return;
  const double cell = domain.get<double>("Cell Size");
  const Teuchos::ParameterList& list = scene.sublist("Energy Release");
  const double inner =
      list.isType<double>("Inner Radius") ? list.get<double>("Inner Radius") : innerCells * cell;
  const double outer =
      list.isType<double>("Outer Radius") ? list.get<double>("Outer Radius") : outerCells * cell;
  if (outer < inner + cell)
    errors.push_back({"Energy Release > Outer Radius",
                      "the weight must fall over at least one cell of " + formatReal(cell) +
                          " m; write at least " + formatReal(inner + cell) + ", or a smaller Inner Radius"});
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
  options.closure = list.get<bool>("Crack Closure");
  options.lumped = list.get<bool>("Lumped Closure");
  options.columns = list.get<int>("Closure Cells");
  return options;
}

ContourRadii radiiIn(const State<2>& state, const Options& options)
{
  const double cell = state.grid.spacing;
  return {options.radii.inner > 0.0 ? options.radii.inner : innerCells * cell,
          options.radii.outer > 0.0 ? options.radii.outer : outerCells * cell};
}

std::string frontName(const State<2>& state, const CrackFront<2>& front)
{
  return state.cracks.cracks[front.crack].name + "." + std::to_string(front.number);
}

/// A node may come to lie this share of a cell inside of the contour as the body moves.
constexpr double slack = 1e-6;

void checkContours(const State<2>& state, const Options& options)
{
  const ContourRadii radii = radiiIn(state, options);
  for (const CrackFront<2>& front : state.cracks.fronts)
  {
    const double clear = largestContour(state, front, radii.outer);
    if (clear < radii.outer - slack * state.grid.spacing)
      throw std::invalid_argument("Energy Release > Outer Radius: the contour of " + formatReal(radii.outer) +
                                  " m round the front " + frontName(state, front) +
                                  " leaves the body or reaches another front; write at most " +
                                  formatReal(clear) + ", or take smaller cells (Domain > Cell Size)");
  }
}

void warnOfContour(State<2>& state, const CrackFront<2>& front, const ContourRadii& radii, Samples& samples)
{
  if (samples.warned.count({front.crack, front.number}) != 0 ||
      largestContour(state, front, radii.outer) > radii.outer - state.grid.spacing)
    return;
  samples.warned.insert({front.crack, front.number});
  state.warnings.push_back("from time " + formatReal(state.time) +
                           " s on the contour of Energy Release round the front " + frontName(state, front) +
                           " leaves the body or reaches another front: G_J, K_I and K_II are less accurate");
}

void sample(State<2>& state, const Options& options, Samples& samples)
{
  const ContourRadii radii = radiiIn(state, options);
  samples.last.clear();
  for (const CrackFront<2>& front : state.cracks.fronts)
  {
    warnOfContour(state, front, radii, samples);
    Sample s;
    s.front = front;
    s.integral = integrateDomain(state, front, radii);
    const bool closure = options.closure && samples.inclined.count({front.crack, front.number}) == 0;
    if (closure)
      s.closure = closeCrack(state, front, options.columns);
    samples.last.push_back(s);

    const std::string name = frontName(state, front) + ".";
    state.row.emplace_back(name + "G_J", s.integral.J);
    if (closure && options.openingKnown)
      state.row.emplace_back(name + "G_closure", s.closure.consistent);
    if (closure && options.lumped)
      state.row.emplace_back(name + "G_closure_lumped", s.closure.lumped);
    state.row.emplace_back(name + "K_I", s.integral.modeI);
    state.row.emplace_back(name + "K_II", s.integral.modeII);
    state.row.emplace_back(name + "length", front.length);
    state.row.emplace_back(name + "speed", front.speed);
    state.row.emplace_back(name + "x", front.position[0]);
    state.row.emplace_back(name + "y", front.position[1]);
  }
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
    entry["G_J"] = s.integral.J;
    entry["K_I"] = s.integral.modeI;
    entry["K_II"] = s.integral.modeII;
    if (options.openingKnown && std::isfinite(s.closure.consistent))
      entry["G_closure"] = s.closure.consistent;
    if (options.lumped && std::isfinite(s.closure.lumped))
      entry["G_closure_lumped"] = s.closure.lumped;
  }
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
