#include "adaptivity/Adaptivity.hpp"

#include "adaptivity/Criteria.hpp"
#include "adaptivity/Merging.hpp"
#include "adaptivity/Splitting.hpp"
#include "archive/Archive.hpp"
#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "grid/LeafList.hpp"
#include "scene/RoundBodies.hpp"
#include "state/Ancestry.hpp"
#include "state/Subdomain.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

namespace Rhegma::adaptivity
{

namespace
{

template <int D>
struct Options
{
  Criteria<D> criteria;
  int interval = 10;
  double mergeLoss = 0.1;
  double startTime = 0.0, levelTime = 0.0;
};

/// What a run has done so far.
template <int D>
struct Progress
{
  Branches<D> branches;
  long changes = 0, split = 0, merged = 0;
  int most = 0, kept = 0;
};

const char* const nothingRefines =
    "there is no refinement criterion; write Velocity Change or Temperature Change, add a box, or add the "
    "section Cracks with Front Cells above 0";

bool refinesByItself(const Teuchos::ParameterList& list)
{
  return list.isParameter("Velocity Change") || list.isParameter("Temperature Change") ||
         !sublistNames(list).empty();
}

bool refinesAtFronts(const Teuchos::ParameterList& list)
{
  return !(list.isType<double>("Front Cells") && list.get<double>("Front Cells") == 0.0);
}

bool refinesLater(const Teuchos::ParameterList& list)
{
  for (const char* time : {"Start Time", "Level Time"})
    if (list.isType<double>(time) && list.get<double>(time) > 0.0)
      return true;
  return false;
}

void addCriteria(Section& s)
{
  s.integer("Maximum Level")
      .range(1, 6)
      .byDefault(2)
      .meaning("Deepest refinement level. The finest cells have the size Domain > Cell Size / 2^level.");
  s.real("Front Cells")
      .range(0.0, 64.0)
      .byDefault(3.0)
      .meaning("A cell is refined if its distance to a crack front is below this number of its own edge "
               "lengths. 0: no refinement at fronts.");
  s.real("Velocity Change")
      .unit("m/s")
      .positive()
      .optional("no refinement by velocity")
      .meaning("A cell is refined if the velocity changes by more than this over it (edge length times mean "
               "velocity gradient of its particles).");
  s.real("Temperature Change")
      .temperatureDifference()
      .positive()
      .optional("no refinement by temperature")
      .meaning("A cell is refined if the temperature changes by more than this over it (edge length times "
               "mean temperature gradient of its particles). Needs the section Thermal.");
  s.real("Coarsening")
      .above(0.0)
      .below(1.0)
      .byDefault(0.5)
      .meaning("Cells are coarsened where the change over the coarser cell is below this fraction of "
               "Velocity Change or Temperature Change. Near 1, cells switch back and forth.");
  s.integer("Buffer Cells")
      .range(0, 16)
      .byDefault(1)
      .meaning("Layers of cells that are also refined around the cells refined by velocity or temperature.");
}

void addTimes(Section& s)
{
  s.integer("Interval")
      .atLeast(1)
      .byDefault(10)
      .meaning("Number of time steps of the finest cells between two adaptations.");
  s.real("Start Time")
      .unit("s")
      .notNegative()
      .byDefault(0.0)
      .meaning("No cell is refined by a criterion before this time, for example while a body is loaded "
               "before its crack runs.");
  s.real("Level Time")
      .unit("s")
      .notNegative()
      .byDefault(0.0)
      .meaning("Delay between one level and the next after Start Time. Each new level emits small waves; the "
               "delay lets them decay while steps are still large.");
  s.real("Merge Loss")
      .above(0.0)
      .atMost(1.0)
      .byDefault(0.1)
      .meaning("Particles are not merged if this would lose more than this fraction of their energy. The "
               "energy lost is recorded in the energy balance as merged.");
}

Section section()
{
  Section s("Adaptivity", "Adaptive mesh refinement (AMR): cells are refined and coarsened during the run, "
                          "and particles are split and merged with them.");
  refuseAxisymmetric(s, "refined cells have no hoop strain");
  s.refuse({when::given("Adaptivity", "Velocity Change"), when::equilibrium()},
           "in equilibrium all velocities are zero; use Front Cells or a box");
  s.refuse(
      {when::satisfies("Adaptivity", "with Start Time or Level Time", refinesLater), when::equilibrium()},
      "in equilibrium cells are refined before the first load step; remove Start Time and Level Time");
  addCriteria(s);
  addTimes(s);
  Section region("region", "A box in which cells are refined from the start. You choose its name.");
  region.realArray("Lower Corner")
      .unit("m")
      .perAxis()
      .meaning("Corner of the box with the smallest coordinates.");
  region.realArray("Upper Corner")
      .unit("m")
      .perAxis()
      .meaning("Corner of the box with the largest coordinates.");
  region.integer("Level").range(1, 6).meaning(
      "Refinement level of the cells in the box, at most Maximum Level.");
  s.namedByUser(region);
  s.refuse({when::present("Adaptivity"), when::is("Cracks", "Formulation", {"Corrected Broken Cell"})},
           "it can't be combined with Cracks > Formulation = Corrected Broken Cell, which needs cells of one "
           "size; choose another formulation");
  s.refuse({when::present("Adaptivity"), when::is("Contact", "Law", {"Visibility"})},
           "it can't be combined with Contact > Law = Visibility; choose another contact law");
  s.refuse(
      {when::present("Cracks"), when::above("Adaptivity", "Front Cells", 0.0),
       when::is("Time", "Initial State", {"Equilibrium Without Cracks"})},
      "without cracks cells are not refined at fronts, and bodies start with other particles; refine with "
      "boxes, and write Adaptivity > Front Cells = 0",
      1);
  s.refuse({when::given("Adaptivity", "Temperature Change"), when::unprovided(capability::heat)},
           "the scene has no temperature; add the section Thermal or leave this parameter out");
  s.refuse({when::satisfies("Adaptivity", "without Velocity Change, Temperature Change or a box",
                            [](const Teuchos::ParameterList& list)
                            { return !refinesByItself(list) && refinesAtFronts(list); }),
            when::absent("Cracks")},
           nothingRefines);
  return s;
}

void check(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors)
{
  const Teuchos::ParameterList& list = scene.sublist("Adaptivity");
  if (list.isType<int>("Maximum Level"))
    for (const std::string& name : sublistNames(list))
      if (list.sublist(name).isType<int>("Level") &&
          list.sublist(name).get<int>("Level") > list.get<int>("Maximum Level"))
        errors.push_back(
            {"Adaptivity > " + name + " > Level", "it is deeper than Maximum Level, which is " +
                                                      std::to_string(list.get<int>("Maximum Level")) +
                                                      "; raise Maximum Level or lower this level"});
  if (!refinesByItself(list) && !refinesAtFronts(list))
    errors.push_back({"Adaptivity", nothingRefines});
}

/// How many levels take steps shorter than the run's.
template <int D>
int ownLevels(const State<D>& state)
{
  return std::min(state.mesh.tree.deepest, state.mesh.subcycledLevels);
}

template <int D>
Options<D> readOptions(const Teuchos::ParameterList& list)
{
  Options<D> options;
  Criteria<D>& criteria = options.criteria;
  criteria.maximumLevel = list.get<int>("Maximum Level");
  criteria.frontCells = list.get<double>("Front Cells");
  if (list.isParameter("Velocity Change"))
    criteria.velocityChange = list.get<double>("Velocity Change");
  if (list.isParameter("Temperature Change"))
    criteria.temperatureChange = list.get<double>("Temperature Change");
  criteria.coarsening = list.get<double>("Coarsening");
  criteria.buffer = list.get<int>("Buffer Cells");
  options.interval = list.get<int>("Interval");
  options.mergeLoss = list.get<double>("Merge Loss");
  options.startTime = list.get<double>("Start Time");
  options.levelTime = list.get<double>("Level Time");
  for (const std::string& name : sublistNames(list))
  {
    const Teuchos::ParameterList& box = list.sublist(name);
    criteria.regions.push_back(
        {readVector<D>(box, "Lower Corner"), readVector<D>(box, "Upper Corner"), box.get<int>("Level")});
  }
  return options;
}

template <int D>
void checkRegions(const Teuchos::ParameterList& list, const Grid<D>& grid)
{
  for (const std::string& name : sublistNames(list))
  {
    const Teuchos::ParameterList& box = list.sublist(name);
    const Vector<D> lower = readVector<D>(box, "Lower Corner"), upper = readVector<D>(box, "Upper Corner");
    for (int d = 0; d < D; ++d)
    {
      if (!(lower[d] < upper[d]))
        throw std::invalid_argument("Adaptivity > " + name +
                                    " > Upper Corner: it must exceed Lower Corner along " + "xyz"[d] +
                                    "; write larger coordinates");
      if (upper[d] <= grid.lower[d] || lower[d] >= grid.upper[d])
        throw std::invalid_argument("Adaptivity > " + name +
                                    ": the box lies outside of the domain; write one inside");
    }
  }
}

/// Refuses more cells along an axis than trees can number.
template <int D>
void checkNumbers(const Teuchos::ParameterList& domain, int levels)
{
  const Vector<D> lower = readVector<D>(domain, "Lower Corner"),
                  upper = readVector<D>(domain, "Upper Corner");
  const double most = std::ldexp(1.0, Branches<D>::bitsPerAxis - levels) - 4.0 * gridMargin;
  for (int d = 0; d < D; ++d)
    if ((upper[d] - lower[d]) / domain.get<double>("Cell Size") > most)
      throw std::invalid_argument("Adaptivity > Maximum Level: the grid holds at most " + formatReal(most) +
                                  " coarsest cells along an axis with " + std::to_string(levels) +
                                  " refinement levels, and the domain has more; write a lower level, larger "
                                  "cells or a smaller domain");
}

/// The criteria with the levels that there may be by now.
template <int D>
Criteria<D> criteriaNow(const State<D>& state, const Options<D>& options)
{
  Criteria<D> now = options.criteria;
  const double since = state.clock.time - options.startTime;
  if (since < options.levelTime * (now.maximumLevel - 1))
    now.maximumLevel = 1 + static_cast<int>(since / options.levelTime);
  for (auto& region : now.regions)
    region.level = std::min(region.level, now.maximumLevel);
  return now;
}

/// Splits particles that touch cells finer than theirs.
template <int D>
void fitParticles(State<D>& state, Progress<D>& progress)
{
  progress.split += splitParticles(state);
  if (state.mesh.subdomain)
    state.particles.ofAllRanks = static_cast<int>(state.ranks.sum(state.particles.size()));
  progress.most =
      std::max(progress.most, state.mesh.subdomain ? allParticles(state) : state.particles.size());
}

/// Changes cells and particles to the sizes that the criteria require now.
template <int D>
void adapt(State<D>& state, const Options<D>& options, Progress<D>& progress)
{
  Branches<D> wanted = wantedBranches(state, criteriaNow(state, options), progress.branches);
  if (!(wanted == progress.branches))
  {
    progress.branches = std::move(wanted);
    refineCells(state, progress.branches);
    ++progress.changes;
  }
  const Merged merged = mergeParticles(state, options.mergeLoss);
  state.energy.merged += merged.lost;
  progress.merged += merged.families;
  progress.kept = merged.kept;
  fitParticles(state, progress);
}

template <int D>
void adaptBetweenSteps(State<D>& state, const Options<D>& options, bool startsInEquilibrium,
                       Progress<D>& progress)
{
  // A motion that starts in equilibrium has the particles of that equilibrium: in both those of the start.
  if (state.method.analysis == Analysis::Preload || (startsInEquilibrium && state.clock.step == 0))
    return;
  // The stress of a load step is in equilibrium on the cells that it was solved on.
  if (state.method.equilibrium())
    return fitParticles(state, progress);
  // Counted in steps of the finest cells, so that no particle runs far into them unsplit.
  const int interval = std::max(options.interval >> ownLevels(state), 1);
  if (state.clock.time < options.startTime)
    return;
  if (state.clock.step % interval == (state.clock.step < interval ? 1 % interval : 0))
    adapt(state, options, progress);
}

template <int D>
Effect<D> make(const Teuchos::ParameterList& scene)
{
  const Teuchos::ParameterList list = scene.sublist("Adaptivity"), domain = scene.sublist("Domain");
  const Options<D> options = readOptions<D>(list);
  const bool startsInEquilibrium = scene.sublist("Time").get<std::string>("Initial State") != "Unloaded";
  const auto progress = std::make_shared<std::shared_ptr<Progress<D>>>();
  Effect<D> effect;
  effect.name = "Adaptivity";
  effect.balance = {"merged"};
  effect.adds.push_back({fields::level, 1, "", "number of times it was split", true});
  effect.adds.push_back({fields::ancestor, 1, "", "id of the initial particle that it is part of", true});
  effect.adds.push_back({fields::lineage, 1, "", "which part of that particle", true});
  if (options.criteria.velocityChange > 0.0)
    effect.adds.push_back({fields::rate, D * D, "1/s", "velocity gradient, row by row"});
  effect.atStart = [=](State<D>& state)
  {
    checkRegions<D>(list, state.mesh.grid);
    checkNumbers<D>(domain, list.get<int>("Maximum Level"));
    *progress = std::make_shared<Progress<D>>(Progress<D>{Branches<D>(state.mesh.grid)});
    if (options.startTime == 0.0)
      adapt(state, options, **progress);
  };
  effect.call(Stage::BetweenSteps, "adaptation of cells and particles", {ifWritten(quantity::crackGeometry)},
              {quantity::cells}, {},
              [=](State<D>& state) { adaptBetweenSteps(state, options, startsInEquilibrium, **progress); });
  effect.memory = [=](State<D>& state, Archive& archive)
  {
    Progress<D>& done = **progress;
    archive("changes", done.changes);
    archive("split", done.split);
    archive("merged", done.merged);
    archive("most", done.most);
    archive("kept", done.kept);
    if (archive.loads())
      done.branches = refinedCells(state);
  };
  effect.report = [=](const State<D>& state, nlohmann::json& summary)
  {
    const Progress<D>& done = **progress;
    summary["adaptivity"] = {{"deepest_level", state.mesh.tree.deepest},
                             {"leaves", LeafList<D>(done.branches).size()},
                             {"changes_of_cells", done.changes},
                             {"particles_added", done.split},
                             {"families_merged", done.merged},
                             {"families_kept", done.kept},
                             {"most_particles", done.most}};
  };
  return effect;
}

} // namespace

EffectEntry adaptivityEntry()
{
  EffectEntry entry{section(), check, make<2>, make<3>, true};
  entry.cells.addNeeds = [](const auto&, CellNeeds& needs, auto&) { needs.equal = true; };
  entry.declare = [](const Teuchos::ParameterList& list, RunOptions& options)
  {
    options.adaptive = true;
    options.frontLevels = list.get<double>("Front Cells") > 0.0 ? list.get<int>("Maximum Level") : 0;
  };
  entry.cells.levels = [](const Teuchos::ParameterList& list, double around)
  { return list.get<double>("Front Cells") < around ? 0 : list.get<int>("Maximum Level"); };
  entry.cells.refine = [](Teuchos::ParameterList& scene, const FrontRefinement& refinement)
  {
    Teuchos::ParameterList& list = scene.sublist("Adaptivity");
    list.set("Maximum Level", refinement.levels).set("Front Cells", refinement.around);
    const double cell = scene.sublist("Domain").get<double>("Cell Size");
    int number = 0;
    for (const RefinedBox& box : refinement.boxes)
      if (const int level = static_cast<int>(std::ceil(std::log2(cell / box.cell) - 1e-6)); level > 0)
        list.sublist("Narrow Gap " + std::to_string(++number))
            .set("Lower Corner", Teuchos::Array<double>(box.lower))
            .set("Upper Corner", Teuchos::Array<double>(box.upper))
            .set("Level", level);
  };
  return entry;
}

} // namespace Rhegma::adaptivity
