#include "thermal/Thermal.hpp"

#include "archive/Archive.hpp"
#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "material/MaterialTable.hpp"
#include "material/ThermoMaterials.hpp"
#include "plan/LastStage.hpp"
#include "plan/LoadOverStep.hpp"
#include "step/CoreStep.hpp"
#include "thermal/CellsForSources.hpp"
#include "thermal/Conduction.hpp"
#include "thermal/JudgeCutPieces.hpp"
#include "thermal/JudgeHeat.hpp"
#include "thermal/JudgeSteady.hpp"
#include "thermal/JudgeTemperatures.hpp"
#include "thermal/LibraryRanges.hpp"
#include "thermal/Observations.hpp"
#include "thermal/RepeatedStep.hpp"
#include "thermal/Start.hpp"
#include "thermal/ThinLayers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

namespace Rhegma::thermal
{

namespace
{

template <int D>
struct Probe
{
  std::string name;
  Vector<D> position;
};

/// Thermal data of a run in addition to those of particles.
template <int D>
struct Run
{
  Conduction<D> conduction;
  RepeatedStep<D> repeated; ///< for load steps of equilibrium
  std::vector<Probe<D>> probes;
  double initial = 0.0, finalTime = 0.0;
  double settledPeaks = 0.0; ///< sum of the highest temperatures at the samples of the last twentieth [K]
  int settledSamples = 0;
  TemperatureRecord<D> record;
  std::vector<TabulatedProperty> tables; ///< of all materials
  std::vector<LibraryRange> library;     ///< materials of the library
  bool startCorrected = false;           ///< CellExpansion.hpp
};

/// Sets the properties of materials that other effects use to those at the reference temperature.
template <int D>
void useReferenceProperties(State<D>& state, const Teuchos::ParameterList& materials, double initial)
{
  const auto host = Kokkos::create_mirror_view(state.materials.device);
  for (std::size_t m = 0; m < state.materials.properties.size(); ++m)
  {
    const std::string& name = state.materials.names[m];
    const Teuchos::ParameterList& list = materials.sublist(name);
    const double reference =
        list.isParameter("Reference Temperature") ? list.get<double>("Reference Temperature") : initial;
    state.materials.properties[m] = makeProperties(materialAt(list, reference), name, state.method.plane);
    state.materials.properties[m].heated = true;
    host(m) = state.materials.properties[m];
  }
  Kokkos::deep_copy(state.materials.device, host);
}

template <int D>
void readBoundaries(State<D>& state, const Teuchos::ParameterList& scene, Run<D>& run)
{
  Conduction<D>& conduction = run.conduction;
  conduction.boundaries.read(scene, state);
  conduction.cellsSeen = state.mesh.tree.generation;
  const std::string wrong = conduction.boundaries.contradictions(state, run.finalTime);
  if (!wrong.empty())
    throw std::invalid_argument(wrong);
}

template <int D>
void start(State<D>& state, const Teuchos::ParameterList& scene, Run<D>& run)
{
  const Teuchos::ParameterList& list = scene.sublist("Thermal");
  state.materials.thermo =
      makeThermoTables(scene.sublist("Materials"), state.method.plane, run.initial, state.method.mechanics);
  useReferenceProperties(state, scene.sublist("Materials"), run.initial);
  run.conduction.measure(state);
  run.conduction.finalTime = run.finalTime;
  run.conduction.diffusionNumber = list.get<double>("Diffusion Number");
  const std::string method = list.get<std::string>("Conduction");
  run.conduction.integrator.method = method == "Implicit"              ? Method::Implicit
                                     : method == "Super Time Stepping" ? Method::SuperTimeStepping
                                     : method == "Steady"              ? Method::Steady
                                                                       : Method::Explicit;
  state.method.heldTemperatures = run.conduction.integrator.method == Method::Steady;
  run.conduction.integrator.stepRatio = list.get<double>("Step Ratio");
  run.conduction.frontFraction = list.get<double>("Front Heat Fraction");
  if (list.isParameter("Front Radius"))
    run.conduction.frontRadius = list.get<double>("Front Radius");
  if (list.isSublist("Sources"))
    run.conduction.sources = readSources<D>(list.sublist("Sources"));
  if (list.isSublist("Probes"))
    for (const std::string& name : sublistNames(list.sublist("Probes")))
      run.probes.push_back({name, readVector<D>(list.sublist("Probes").sublist(name), "Point")});
  if (scene.isSublist("Boundaries"))
    readBoundaries(state, scene, run);
  if (list.isSublist("Crack Faces"))
    run.conduction.faces.read(list.sublist("Crack Faces"), state);
  if (state.method.mechanics)
  {
    const double steps = run.conduction.substeps(state, state.method.equilibrium()
                                                            ? largestLoadStep(scene)
                                                            : state.method.cfl * state.mesh.stepSpacing() /
                                                                  fastestSpeed(state));
    if (!(steps <= Conduction<D>::mostSubsteps))
      throw std::invalid_argument("Thermal: " + run.conduction.tooMany(state, steps));
  }
  judgeHeat(scene, run.conduction, run.finalTime, state);
  if (run.conduction.integrator.method == Method::Steady)
  {
    refuseThinLayers(scene.sublist("Materials"), state);
    judgeSteady(scene, run.conduction, run.finalTime, state);
    judgeCutPieces(scene, run.conduction, state);
  }
  startTemperature(state, scene.sublist("Bodies"), run.initial);
  if (run.conduction.integrator.method == Method::Steady && !(run.conduction.diffusivity > 0.0))
    throw std::invalid_argument(
        "Thermal > Conduction: no material conducts, so there is no steady state; give a "
        "Conductivity in Materials");
  judgeTemperatures(scene, run.conduction, run.finalTime, state);
  run.tables = tabulated(scene.sublist("Materials"));
  run.library = libraryRanges(scene.sublist("Materials"));
  warnOfRangesAtStart(state, run.library);
  startEnergy(state);
  run.conduction.frontTemperature.assign(state.cracks.fronts.size(), run.initial);
  for (CrackFront<D>& front : state.cracks.fronts)
    for (FrontNode<D>& frontNode : front.nodes)
      frontNode.temperature = run.initial;
  state.particles.afterSplit.push_back([](State<D>& s, const SplitParts& parts) { copyGradient(s, parts); });
}

/// \param bodies the section Bodies
template <int D>
void conduct(State<D>& state, const Teuchos::ParameterList& bodies, Run<D>& run)
{
  if (!run.startCorrected && state.clock.step == 0 && run.conduction.expands)
    correctStart(state, bodies);
  run.startCorrected = true;
  if (state.method.equilibrium())
    run.repeated.begin(state, run.conduction);
  run.conduction.step(state);
}

template <int D>
void observe(State<D>& state, Run<D>& run)
{
  const Extremes<D> now = extremes(state);
  run.record.sample(now, state.clock.time);
  sampleRanges(state, run.library);
  if (state.clock.time >= 0.95 * run.finalTime)
  {
    run.settledPeaks += now.highest;
    ++run.settledSamples;
  }
  state.sample.row.emplace_back("temperature_highest", now.highest);
  state.sample.row.emplace_back("temperature_lowest", now.lowest);
  for (const Probe<D>& probe : run.probes)
    state.sample.row.emplace_back(probe.name + ".temperature", temperatureAt(state, probe.position));
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    const CrackFront<D>& front = state.cracks.fronts[f];
    state.sample.row.emplace_back(state.cracks.cracks[front.crack].name + "." + std::to_string(front.number) +
                                      ".temperature",
                                  run.conduction.frontTemperature[f]);
  }
  if (!(now.lowest > 0.0) && state.failure.empty())
    state.failure = "the temperature of a particle is " + formatReal(now.lowest) +
                    " K, and it is absolute; check the heat sources and the outgoing heat fluxes";
}

/// Warns of tables that do not cover the temperatures at the end.
template <int D>
void reportTables(const State<D>& state, const Run<D>& run, nlohmann::json& summary)
{
  if (state.clock.step == 0 || run.tables.empty())
    return;
  const std::vector<TemperatureRange> end = temperaturesOf(state);
  for (const TabulatedProperty& property : run.tables)
  {
    const TemperatureRange& own = end[property.material];
    const TemperatureRange all{-state.ranks.max(-own.lowest), state.ranks.max(own.highest)};
    if (const auto message = property.messageOn(all, "bodies came to"); message && all.highest > 0.0)
      summary["warnings"].push_back(*message);
  }
}

template <int D>
void report(const State<D>& state, const Run<D>& run, nlohmann::json& summary)
{
  // Checked at the end, as cells may be refined after a front has initiated.
  if (std::isfinite(run.conduction.finestHeated))
    if (const std::string word =
            unresolved("Thermal > Front Radius", run.conduction.frontRadius, run.conduction.finestHeated);
        !word.empty())
      summary["warnings"].push_back(word);
  reportTables(state, run, summary);
  for (const LibraryRange& range : run.library)
    if (const std::string warning = range.warning(); !warning.empty())
      summary["warnings"].push_back(warning);
  const Extremes<D> now = extremes(state);
  nlohmann::json where = nlohmann::json::array();
  for (int d = 0; d < D; ++d)
    where.push_back(now.hottest[d]);
  summary["conduction"] = {{"steps", run.conduction.stepsTaken},
                           {"passes", run.conduction.stepsTaken + run.conduction.integrator.products}};
  nlohmann::json& temperature = summary["temperature"];
  temperature = {{"peak", now.highest},
                 {"peak_rise", now.highest - run.initial},
                 {"where", where},
                 {"settled_peak_rise", run.settledSamples > 0
                                           ? run.settledPeaks / run.settledSamples - run.initial
                                           : std::numeric_limits<double>::quiet_NaN()},
                 {"lowest", now.lowest},
                 {"largest_fall", run.initial - now.lowest},
                 {"probes", nlohmann::json::object()}};
  TemperatureRecord<D> record = run.record;
  record.sample(now, state.clock.time);
  record.report(state, temperature);
  if (state.clock.step > 0) // not of a scene that is only checked
    for (const std::string& line : record.asText(state, run.initial, now))
      summary["answers"].push_back(line);
  for (const Probe<D>& probe : run.probes)
  {
    const double here = temperatureAt(state, probe.position);
    temperature["probes"][probe.name] = {{"temperature", here}, {"rise", here - run.initial}};
  }
}

/// Adds the fronts' temperatures to the cracks of the summary, if their effect has written it.
template <int D>
void reportFronts(const State<D>& state, const std::vector<double>& temperature, nlohmann::json& summary)
{
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    const CrackFront<D>& front = state.cracks.fronts[f];
    nlohmann::json& cracks = summary["cracks"];
    if (front.crack >= static_cast<int>(cracks.size()) || !cracks[front.crack].contains("fronts"))
      continue;
    nlohmann::json& fronts = cracks[front.crack]["fronts"];
    if (front.number < static_cast<int>(fronts.size()))
      fronts[front.number]["temperature"] = temperature[f];
  }
}

template <int D>
Effect<D> make(const Teuchos::ParameterList& scene)
{
  const auto run = std::make_shared<Run<D>>();
  run->initial = scene.sublist("Thermal").get<double>("Initial Temperature");
  run->finalTime = scene.sublist("Time").get<double>("Final Time");
  Effect<D> effect;
  effect.name = "Thermal";
  effect.balance = {"thermal", "heat"};
  effect.adds.push_back({fields::temperature, 1, "K", "its temperature"});
  effect.adds.push_back({fields::temperatureGradient, D, "K/m", "gradient of the nodes' temperature"});
  effect.adds.push_back(
      {fields::internalEnergy, 1, "J/m3", "thermal and elastic energy per undeformed volume"});
  effect.atStart = [run, all = Teuchos::ParameterList(scene)](State<D>& state) { start(state, all, *run); };
  effect.call(Stage::BeforeSolve, "conduction", {quantity::stencils, ifWritten(quantity::fractureEnergy)},
              {quantity::temperature, quantity::frontTemperature}, {},
              [run, bodies = Teuchos::ParameterList(scene.sublist("Bodies"))](State<D>& state)
              { conduct(state, bodies, *run); });
  if (isEquilibrium(scene))
    effect.call(Stage::AfterSolve, "acceptance of conduction", {}, {}, {},
                [run](State<D>&) { run->repeated.accept(); });
  effect.call(Stage::Observe, "temperatures", {quantity::temperature, quantity::frontTemperature}, {}, {},
              [run](State<D>& state) { observe(state, *run); });
  effect.report = [run](const State<D>& state, nlohmann::json& summary)
  {
    report(state, *run, summary);
    reportFronts(state, run->conduction.frontTemperature, summary);
  };
  effect.timeStepLimit = [run](const State<D>& state)
  {
    const double sources = run->conduction.sourceLimit(state);
    if (state.method.mechanics)
      return sources;
    // Without conduction, sources may still change with time.
    return std::min({run->conduction.stepLimit(state), sources, run->finalTime / 100.0});
  };
  effect.memory = [run](State<D>&, Archive& archive)
  {
    archive("front temperatures", run->conduction.frontTemperature);
    archive("fracture seen", run->conduction.fractureSeen);
    archive("front heat", run->conduction.frontHeat);
    archive("settled peaks", run->settledPeaks);
    archive("settled samples", run->settledSamples);
    run->record.serialize(archive);
    storeRanges(run->library, archive);
    archive("pending", run->conduction.pending);
    archive("waited", run->conduction.waited);
    archive("steps taken", run->conduction.stepsTaken);
    archive("warned", run->conduction.warned);
    archive("finest heated", run->conduction.finestHeated);
    {
      const Archive::Group integrator(archive, "integrator");
      run->conduction.integrator.serialize(archive);
    }
    const Archive::Group faces(archive, "crack faces");
    run->conduction.faces.serialize(archive);
  };
  return effect;
}

/// Whether a source never settles, as it moves.
bool isMoving(const Teuchos::ParameterList& source)
{
  if (!source.isType<Teuchos::Array<double>>("Velocity"))
    return false;
  const auto& velocity = source.get<Teuchos::Array<double>>("Velocity");
  return std::any_of(velocity.begin(), velocity.end(), [](double v) { return v != 0.0; });
}

void declareHeat(const Teuchos::ParameterList& list, RunOptions& options)
{
  options.mechanics = list.get<bool>("Mechanics");
  options.initialTemperature = list.get<double>("Initial Temperature");
  // Its stages do not include heat that passes between fields, and in a splitting of steps nodes with little
  // material would be far from the temperature that they have together.
  if (list.isSublist("Sources"))
    for (const std::string& name : sublistNames(list.sublist("Sources")))
      if (isMoving(list.sublist("Sources").sublist(name)))
        options.driving.push_back({"Thermal > Sources > " + name + " > Velocity", "t"});
  options.fieldsConduct = list.get<std::string>("Conduction") != "Super Time Stepping";
}

} // namespace

EffectEntry thermalEntry()
{
  EffectEntry entry{thermalSection(), checkThermal, make<2>, make<3>, true, declareHeat};
  entry.cells.subject = "round heat sources";
  entry.cells.addNeeds = reportCells;
  return entry;
}

} // namespace Rhegma::thermal
