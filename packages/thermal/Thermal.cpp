#include "thermal/Thermal.hpp"

#include "checkpoint/Archive.hpp"
#include "material/ThermoMaterials.hpp"
#include "scene/Numbers.hpp"
#include "scene/ReadList.hpp"
#include "thermal/Conduction.hpp"
#include "thermal/Observations.hpp"
#include "thermal/Start.hpp"

#include <algorithm>
#include <memory>

namespace Rhegma::thermal
{

namespace
{

template <int D>
struct Probe
{
  std::string name;
  Vector<D> place;
  double temperature = 0.0; ///< as last observed [K]
};

/// What a run has of heat beside its particles.
template <int D>
struct Run
{
  Conduction<D> conduction;
  std::vector<Probe<D>> probes;
  double initial = 0.0, finalTime = 0.0;
  Extremes<D> last;
};

template <int D>
void start(State<D>& state, const Teuchos::ParameterList& scene, Run<D>& run)
{
  const Teuchos::ParameterList& list = scene.sublist("Thermal");
  state.thermo = makeThermoTables(scene.sublist("Materials"), state.plane, run.initial, state.mechanics);
  run.conduction.measure(state);
  run.conduction.diffusionNumber = list.get<double>("Diffusion Number");
  run.conduction.frontFraction = list.get<double>("Front Heat Fraction");
  if (list.isParameter("Front Radius"))
    run.conduction.frontRadius = list.get<double>("Front Radius");
  if (list.isSublist("Sources"))
    run.conduction.sources = readSources<D>(list.sublist("Sources"));
  if (list.isSublist("Probes"))
    for (const std::string& name : sublistNames(list.sublist("Probes")))
      run.probes.push_back({name, readVector<D>(list.sublist("Probes").sublist(name), "Point")});
  if (scene.isSublist("Boundaries"))
    run.conduction.boundaries.read(scene.sublist("Boundaries"), state);
  startTemperature(state, scene.sublist("Bodies"), run.initial);
  startEnergy(state);
  state.afterSplit.push_back([](State<D>& s, const SplitParts& parts) { followGradient(s, parts); });
  run.last = extremes(state);
}

template <int D>
void observe(State<D>& state, Run<D>& run)
{
  run.last = extremes(state);
  state.row.emplace_back("temperature_highest", run.last.highest);
  state.row.emplace_back("temperature_lowest", run.last.lowest);
  for (Probe<D>& probe : run.probes)
  {
    probe.temperature = temperatureAt(state, probe.place);
    state.row.emplace_back(probe.name + ".temperature", probe.temperature);
  }
  for (const CrackFront<D>& front : state.cracks.fronts)
    state.row.emplace_back(state.cracks.cracks[front.crack].name + "." + std::to_string(front.number) +
                               ".temperature",
                           front.temperature);
  if (!(run.last.lowest > 0.0) && state.trouble.empty())
    state.trouble = "a particle is at " + formatReal(run.last.lowest) +
                    " K, and temperatures are absolute; look at the sources and at what flows out";
}

template <int D>
void report(const State<D>& state, const Run<D>& run, nlohmann::json& summary)
{
  nlohmann::json where = nlohmann::json::array();
  for (int d = 0; d < D; ++d)
    where.push_back(run.last.where[d]);
  nlohmann::json& temperature = summary["temperature"];
  temperature = {{"peak", run.last.highest},
                 {"peak_rise", run.last.highest - run.initial},
                 {"where", where},
                 {"lowest", run.last.lowest},
                 {"probes", nlohmann::json::object()}};
  for (const Probe<D>& probe : run.probes)
    temperature["probes"][probe.name] = {{"temperature", probe.temperature},
                                         {"rise", probe.temperature - run.initial}};
  static_cast<void>(state);
}

template <int D>
Effect<D> make(const Teuchos::ParameterList& scene)
{
  const auto run = std::make_shared<Run<D>>();
  run->initial = scene.sublist("Thermal").get<double>("Initial Temperature");
  run->finalTime = scene.sublist("Time").get<double>("Final Time");
  Effect<D> effect;
  effect.name = "Thermal";
  effect.adds.push_back({fields::temperature, 1, "K", "its temperature"});
  effect.adds.push_back({fields::temperatureGradient, D, "K/m", "gradient of the nodes' temperature"});
  effect.adds.push_back({fields::internalEnergy, 1, "J/m3", "heat and elastic energy per undeformed volume"});
  effect.atStart = [run, all = Teuchos::ParameterList(scene)](State<D>& state) { start(state, all, *run); };
  effect.call({Stage::BeforeSolve, "conduction", {"nodal mass"}, {"temperature"}, {}, [run](State<D>& state) {
                 run->conduction.step(state);
               }});
  effect.call({Stage::Observe, "temperatures", {}, {}, {}, [run](State<D>& state) { observe(state, *run); }});
  effect.report = [run](const State<D>& state, nlohmann::json& summary) { report(state, *run, summary); };
  effect.timeStepLimit = [run](const State<D>& state)
  {
    const double sources = run->conduction.sourceLimit(state);
    if (state.mechanics)
      return sources;
    // Heat that goes nowhere still has sources that change with time.
    return std::min({run->conduction.stepLimit(state), sources, run->finalTime / 100.0});
  };
  effect.memory = [run](State<D>&, Archive& archive)
  {
    archive("pending", run->conduction.pending);
    archive("waited", run->conduction.waited);
    archive("warned", run->conduction.warned);
  };
  return effect;
}

bool leavesMechanicsOut(const Teuchos::ParameterList& scene)
{
  return !scene.sublist("Thermal").get<bool>("Mechanics");
}

} // namespace

EffectEntry thermalEntry()
{
  return {thermalSection(), checkThermal, make<2>, make<3>, true, leavesMechanicsOut};
}

} // namespace Rhegma::thermal
