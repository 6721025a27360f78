#include "propagation/Propagation.hpp"

#include "archive/Archive.hpp"
#include "plan/LastStage.hpp"
#include "propagation/AdvanceFronts.hpp"
#include "propagation/Aim.hpp"
#include "propagation/FrontEnd.hpp"
#include "propagation/HoopStress.hpp"
#include "propagation/JudgeToughness.hpp"
#include "propagation/MaterialsAhead.hpp"
#include "propagation/PathReport.hpp"
#include "propagation/Report.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace Rhegma::propagation
{

namespace
{

template <int D>
struct Run
{
  Options options;
  std::vector<FrontState<D>> fronts;
};

template <int D>
void start(State<D>& state, Run<D>& run)
{
  state.cracks.driven = true;
  state.cracks.drivingContours = run.options.contours;
  state.cracks.growth.startTime = run.options.rule.startTime;
  refuseAnisotropic(state, run.options);
  refuseWeak(state, run.options);
  run.options.waveSpeed = fastestRayleighWave(state);
  run.fronts.resize(state.cracks.fronts.size());
  for (std::size_t f = 0; f < run.fronts.size(); ++f)
    run.fronts[f].matchNodes(state.cracks.fronts[f]);
}

/// Ends the run with the first sample in which a front node is stopped for a numerical reason.
template <int D>
void endAtStops(State<D>& state)
{
  for (const CrackFront<D>& front : state.cracks.fronts)
    if (front.numStopped() > 0)
      state.clock.maximumSteps = std::min(state.clock.maximumSteps, state.clock.step);
}

/// Once no front is left that can advance, the path of equilibrium ends.
template <int D>
void endOfPath(State<D>& state)
{
  const auto& fronts = state.cracks.fronts;
  if (std::all_of(fronts.begin(), fronts.end(),
                  [](const CrackFront<D>& front) { return front.ended || front.stopped(); }))
    state.clock.maximumSteps = std::min(state.clock.maximumSteps, state.clock.step);
}

/// Compares G by which fronts in 2D grow with G of the sample, which may have another contour.
template <int D>
void recordContours(const State<D>& state, Run<D>& run)
{
  for (std::size_t f = 0; D == 2 && f < state.cracks.fronts.size(); ++f)
  {
    const CrackFront<D>& front = state.cracks.fronts[f];
    const FrontEnd<D> end(state, run.options, front, run.fronts[f]);
    const std::string name =
        state.cracks.cracks[front.crack].name + "." + std::to_string(front.number) + ".G_J";
    const auto sampled = std::find_if(state.sample.row.begin(), state.sample.row.end(),
                                      [&](const auto& column) { return column.first == name; });
    if (end.fate == Fate::Growing && sampled != state.sample.row.end())
      run.fronts[f].contours.include(sampled->second, end.release, state.clock.time);
  }
}

template <int D>
void addCallsOfEquilibrium(const Teuchos::ParameterList& scene, const std::shared_ptr<Run<D>>& run,
                           Effect<D>& effect)
{
  effect.call(lastStage(scene), "drive of fronts", {quantity::stressIntensities, quantity::advancingFronts},
              {quantity::equilibriumGrowth}, {},
              [run](State<D>& state) { measureDrive(state, run->options, run->fronts); });
  effect.call(Stage::Observe, "end of the growth in equilibrium", {quantity::crackGeometry}, {}, {},
              [run](State<D>& state)
              {
                if (state.method.analysis == Analysis::LoadFactor)
                  state.sample.row.emplace_back("load_factor", state.clock.factor.end);
                recordContours(state, *run);
                endOfPath(state);
              });
}

/// Goes on as motion from a state of equilibrium, in which all fronts are marked whose G is looked at.
template <int D>
void startMotion(State<D>& state, Run<D>& run)
{
  for (CrackFront<D>& front : state.cracks.fronts)
    for (FrontNode<D>& node : front.nodes)
      node.advances = false;
  for (FrontState<D>& front : run.fronts)
    front.startMotion();
}

/// What the stress intensities of a step say of the start and the direction of fronts.
template <int D>
void useIntensities(const State<D>& state, Run<D>& run)
{
  recordHoopStart(state, run.options, run.fronts);
  aimFronts(state, run.options, run.fronts);
}

template <int D>
Effect<D> make(const Teuchos::ParameterList& scene, const RunOptions& options)
{
  const auto run = std::make_shared<Run<D>>(Run<D>{readOptions(scene, options), {}});
  Effect<D> effect;
  effect.name = "Propagation";
  effect.balance = {"fracture"};
  effect.atStart = [run](State<D>& state) { start(state, *run); };
  effect.judge = [run, options, all = Teuchos::ParameterList(scene)](State<D>& state)
  {
    judgeToughness(all, options, run->options, state);
    judgeMaterialsAhead(all, run->options, state);
  };
  effect.call(lastStage(scene), "fronts that are due", {}, {quantity::dueFronts}, {},
              [run](State<D>& state) { markDue(state, run->options, run->fronts); });
  effect.call(lastStage(scene), "fronts that advance",
              {quantity::drivingForces, ifWritten(quantity::frontTemperature)}, {quantity::advancingFronts},
              {},
              [run](State<D>& state)
              {
                selectAdvancing(state, run->options, run->fronts);
                markMeasured(state, run->options, run->fronts);
              });
  effect.call(lastStage(scene), "largest hoop stress at fronts at rest",
              {quantity::stressIntensities, quantity::advancingFronts}, {}, {},
              [run](State<D>& state) { useIntensities(state, *run); });
  if (run->options.equilibrium)
    addCallsOfEquilibrium(scene, run, effect);
  effect.call(Stage::BetweenSteps, "advances of fronts",
              {quantity::stressIntensities, quantity::advancingFronts}, {quantity::frontAdvances}, {},
              [run](State<D>& state) { advanceSelected(state, run->options, run->fronts); });
  if (run->options.endsAtStops)
    effect.call(Stage::Observe, "numerical stops of fronts", {quantity::crackGeometry}, {}, {},
                [](State<D>& s) { endAtStops(s); });
  effect.memory = [run](State<D>& state, Archive& archive)
  {
    for (std::size_t f = 0; f < run->fronts.size(); ++f)
    {
      const Archive::Group group(archive, "front " + std::to_string(f));
      run->fronts[f].matchNodes(state.cracks.fronts[f]); // when loaded, those of the checkpoint
      run->fronts[f].serialize(archive);
    }
    if (run->options.equilibrium || state.method.handsOver)
      storeGrowth(state.cracks.growth, archive);
    if (state.method.handsOver)
      archive("motion_from", state.cracks.growth.motionFrom);
    const bool follows = !run->options.equilibrium && state.method.handsOver;
    if (archive.loads() && follows && state.cracks.growth.motionFrom < 0.0)
      startMotion(state, *run);
  };
  effect.report = [run](const State<D>& state, nlohmann::json& summary)
  {
    reportFronts(state, run->fronts, run->options, summary);
    reportToughness(run->options, summary);
    if (run->options.equilibrium || state.method.handsOver)
      reportPathOfEquilibrium(
          state.cracks.growth.path, state.method.analysis == Analysis::LoadFactor, summary,
          state.method.handsOver ? std::make_optional(state.cracks.growth.motionFrom) : std::nullopt);
  };
  return effect;
}

} // namespace

EffectEntry propagationEntry()
{
  EffectEntry entry{propagationSection(), checkPropagation, make<2>, make<3>, true, declareGrowth};
  entry.cells.addNeeds = [](const Teuchos::ParameterList& scene, CellNeeds& needs, auto&)
  {
    // Cells don't follow a front that grows, and in equilibrium no front runs.
    needs.equal = true;
    needs.running = !isEquilibrium(scene) || handsOver(scene);
  };
  return entry;
}

} // namespace Rhegma::propagation
