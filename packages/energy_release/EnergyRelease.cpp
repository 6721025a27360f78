#include "energy_release/EnergyRelease.hpp"

#include "archive/Archive.hpp"
#include "base/Numbers.hpp"
#include "energy_release/BodiesInContour.hpp"
#include "energy_release/CheckTubes.hpp"
#include "energy_release/Disagreement.hpp"
#include "energy_release/DomainIntegral.hpp"
#include "energy_release/DrivingForces.hpp"
#include "energy_release/ErrorEstimate.hpp"
#include "energy_release/FrontIntegral.hpp"
#include "energy_release/FrontOpening.hpp"
#include "energy_release/FrontSample.hpp"
#include "energy_release/FrontSet.hpp"
#include "energy_release/HeldFronts.hpp"
#include "energy_release/JudgeStrain.hpp"
#include "energy_release/JudgeYield.hpp"
#include "energy_release/LargestRelease.hpp"
#include "energy_release/LoadsInRing.hpp"
#include "energy_release/ModeRatios.hpp"
#include "energy_release/NegativeRelease.hpp"
#include "energy_release/PlasticZones.hpp"
#include "energy_release/ReadOptions.hpp"
#include "energy_release/RecordFrontValues.hpp"
#include "energy_release/SurfaceNodes.hpp"
#include "energy_release/ToughnessReached.hpp"
#include "energy_release/YieldedPart.hpp"
#include "transfer/FrontCompliance.hpp"
#include "transfer/LocalSpacing.hpp"

#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace Rhegma::energy_release
{

namespace
{

constexpr double notYet = FrontSample<2>::notYet;

template <int D>
struct Samples
{
  std::vector<FrontSample<D>> last;
  double time = 0.0;                 ///< of these [s]
  LargestRelease largest;            ///< of all samples
  ToughnessReached reached;          ///< by all samples
  std::vector<BoundaryRegion> loads; ///< that may act near fronts
  FrontSet inclined;                 ///< fronts that did not start along the grid: without crack closure (2D)
  FrontSet warned;                   ///< fronts whose tube has left the body during the run
  FrontSet unclosed;                 ///< fronts that had no crack closure at some time (2D)
  std::vector<ErrorEstimate> errors; ///< of the answers of a report, or of a state that is saved
  long errorsOfStep = -1;            ///< at whose end these were estimated
  long step = -1; ///< at whose end the last samples were taken, in this run and not in that of a checkpoint
};

/// The columns of a front in the history begin with it, such as "Notch.0".
template <int D>
std::string columnName(const State<D>& state, const CrackFront<D>& front)
{
  return state.cracks.cracks[front.crack].name + "." + std::to_string(front.number);
}

/// The outer radius that the surroundings of a front allow, for what is computed along it now.
double clearNow(const State<2>& state, const CrackFront<2>& front, double radius)
{
  return largestContour(state, front, radius);
}
double clearNow(const State<3>& state, const CrackFront<3>& front, double radius)
{
  return clearAround(state, front, radius);
}

/// Warns once of each front whose tube no longer fits into the body.
template <int D>
void warnOfTube(State<D>& state, const CrackFront<D>& front, const ContourRadii& radii,
                const Options& options, Samples<D>& samples)
{
  const double cell = spacingAt(state, front.position);
  const bool isFitted = options.radii.outer == 0.0; // then it has been reduced as far as possible
  if ((isFitted && radii.outer > smallestOuter(options.radii, cell)) ||
      samples.warned.count({front.crack, front.number}) != 0 ||
      clearNow(state, front, radii.outer) > radii.outer - cell)
    return;
  samples.warned.insert({front.crack, front.number});
  state.warnings.push_back("Energy Release: from t = " + readableTime(state.clock.time) + " on, the " +
                           (D == 2 ? "domain integral" : "integration tube") + " around " +
                           frontName(state.cracks, front) + " leaves the body or reaches another front, so " +
                           (D == 2 ? "G_J, K_I and K_II" : "G_J and K") +
                           " are less accurate; use smaller cells or radii");
}

bool wantsClosure(const State<2>& state, const Options& options, const Samples<2>& samples,
                  const CrackFront<2>& front)
{
  return options.closure && options.pushed.count(state.cracks.cracks[front.crack].name) == 0 &&
         samples.inclined.count({front.crack, front.number}) == 0;
}

/// Warns once of a front along the grid that it has no crack closure.
void warnOfClosure(State<2>& state, const CrackFront<2>& front, const CrackClosure& closure,
                   Samples<2>& samples)
{
  if (std::isfinite(closure.chosen) || !runsAlongGrid(front) ||
      !samples.unclosed.insert({front.crack, front.number}).second)
    return;
  state.warnings.push_back(
      "Energy Release: G_closure of " + frontName(state.cracks, front) +
      " is not available at t = " + readableTime(state.clock.time) +
      ", because no node behind the front has material of both faces within reach: the crack is too short "
      "for Closure Cells, or its faces are several cells apart; use G_J");
}

/// Ends the run where crack closure can't be computed since the body around the front has disintegrated.
CrackClosure tryToClose(State<2>& state, const CrackFront<2>& front, const Options& options,
                        Samples<2>& samples)
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

/// What the samples of a run reuse.
template <int D>
struct SampleWork
{
  InternalAcceleration<D> acceleration;
  FrontRowTable<D> rows;
  std::vector<BlocksInReach<D>> blocks; ///< around each front
};

Disk rangeOf(const State<2>& state, const FrontSample<2>& s)
{
  return accelerationRange(state, s.front, s.tube.radii);
}
Region<3> rangeOf(const State<3>& state, const FrontSample<3>& s)
{
  return accelerationRange(state, lineOf(s.front), s.tube);
}

/// Computes J and K at the front of a sample.
void compute(const State<2>& state, FrontSample<2>& s, InternalAcceleration<2>& acceleration,
             const FrontWork<2>& kept)
{
  const DomainIntegral integral =
      integrateDomain(state, s.front, s.tube.radii, acceleration.around(state, rangeOf(state, s)), kept);
  s.J = {integral.lost ? notYet : integral.J};
  s.modeI = {integral.lost ? notYet : integral.modeI};
  s.modeII = {integral.lost ? notYet : integral.modeII};
  s.tipOffset = integral.tipOffset;
  s.isotropic = isIsotropicAt(state, s.front);
}

void compute(const State<3>& state, FrontSample<3>& s, InternalAcceleration<3>& acceleration,
             const FrontWork<3>& kept)
{
  const std::vector<std::optional<double>> release =
      integrateAlongFront(state, s.front.crack, lineOf(s.front), s.tube, acceleration, kept);
  for (std::size_t k = 0; k < release.size(); ++k)
    s.J[k] = release[k].value_or(notYet);
  const std::vector<Intensities> K = intensitiesAlong(state, s.front, s.tube.halfWidth, s.J);
  for (std::size_t k = 0; k < K.size(); ++k)
  {
    s.modeI[k] = K[k].modeI;
    s.modeII[k] = K[k].modeII;
    s.modeIII[k] = K[k].modeIII;
  }
}

/// Whether there is anything to compute at a front by domain integrals.
template <int D>
bool isMeasured(const CrackFront<D>& front, const Options& options)
{
  return options.contour && !front.ended && front.numFacets > 0;
}

/// Computes what domain integrals give, of all fronts.
template <int D>
void integrateAll(State<D>& state, const Options& options, Samples<D>& samples, SampleWork<D>& work)
{
  std::vector<typename InternalAcceleration<D>::Range> ranges;
  for (FrontSample<D>& s : samples.last)
  {
    if (!isMeasured(s.front, options))
      continue;
    s.tube = fittingTube(state, s.front, options.radii);
    warnOfTube(state, s.front, s.tube.radii, options, samples);
    warnOfLoads(state, s.front, s.tube.radii, samples.loads);
    warnOfBodies(state, s.front, s.tube.radii.outer);
    ranges.push_back(rangeOf(state, s));
  }
  work.acceleration.renew();
  work.acceleration.around(state, ranges);
  work.blocks.resize(samples.last.size());
  for (std::size_t f = 0; f < samples.last.size(); ++f)
    if (isMeasured(samples.last[f].front, options))
      compute(state, samples.last[f], work.acceleration, {work.rows, work.blocks[f]});
}

template <int D>
void sample(State<D>& state, const Options& options, Samples<D>& samples, SampleWork<D>& work)
{
  samples.last.clear();
  samples.time = state.clock.time;
  samples.step = state.clock.step;
  for (const CrackFront<D>& front : state.cracks.fronts)
    samples.last.emplace_back(front, front.ended ? 0.0 : notYet);
  integrateAll(state, options, samples, work);
  for (FrontSample<D>& s : samples.last)
  {
    if constexpr (D == 2)
    {
      s.closed = wantsClosure(state, options, samples, s.front);
      if (s.closed)
        s.closure = s.front.ended ? CrackClosure{0.0, 0.0} : tryToClose(state, s.front, options, samples);
    }
    s.addTo(state.sample.row, columnName(state, s.front), options);
  }
  samples.largest.add(samples.last, samples.time);
  samples.reached.add(state, samples.last);
  recordFrontValues(state, samples.last, options);
}

/// The errors of the last samples; reports of one step estimate them once.
template <int D>
const std::vector<ErrorEstimate>& errorsOf(const State<D>& state, const Options& options, Samples<D>& samples)
{
  if (samples.errorsOfStep == state.clock.step && samples.errors.size() == samples.last.size())
    return samples.errors;
  if (samples.step == state.clock.step)
    samples.errors = estimateErrors(state, samples.last, options);
  else
  {
    samples.errors.assign(samples.last.size(), ErrorEstimate());
    for (ErrorEstimate& error : samples.errors)
      error.none = "no sample was taken at the end of the run";
  }
  samples.errorsOfStep = state.clock.step;
  return samples.errors;
}

/// Checks the tubes, and prepares samples: what will be reported is known from the start, though its values
/// are not.
template <int D>
void start(State<D>& state, const Options& options, const RunOptions& run, Samples<D>& samples)
{
  checkTubes(state, options, run.growth ? &run.contours : nullptr);
  samples.reached.assumeIntensity(state.materials.properties);
  for (const CrackFront<D>& front : state.cracks.fronts)
  {
    FrontSample<D> s(front, notYet);
    if (isMeasured(front, options))
    {
      s.tube = fittingTube(state, front, options.radii);
      warnOfLoads(state, front, s.tube.radii, samples.loads);
    }
    if constexpr (D == 2)
    {
      if (!runsAlongGrid(front))
        samples.inclined.insert({front.crack, front.number});
      s.closed = wantsClosure(state, options, samples, front);
    }
    samples.last.push_back(s);
  }
}

/// Saves or loads the last sample and which fronts were warned of. Errors are those of the state that is
/// saved, which has no values on nodes when it is loaded.
template <int D>
void serialize(const State<D>& state, const Options& options, Samples<D>& samples, Archive& archive)
{
  if (!archive.loads())
    errorsOf(state, options, samples);
  archive("time", samples.time);
  archive("step_of_errors", samples.errorsOfStep);
  int count = static_cast<int>(samples.last.size());
  archive("fronts", count);
  samples.last.resize(count);
  samples.errors.resize(count);
  for (int k = 0; k < count; ++k)
  {
    const Archive::Group group(archive, "front " + std::to_string(k));
    samples.last[k].serialize(archive);
    const Archive::Group error(archive, "error");
    samples.errors[k].serialize(archive);
  }
  samples.largest.serialize(archive);
  samples.reached.serialize(archive);
  storeFronts(samples.warned, "warned", archive);
  storeFronts(samples.unclosed, "unclosed", archive);
}

/// The entries of all fronts that were sampled.
template <int D>
void reportSamples(const State<D>& state, const Options& options, Samples<D>& samples,
                   nlohmann::json& summary)
{
  const std::vector<ErrorEstimate>& errors = errorsOf(state, options, samples);
  for (std::size_t k = 0; k < samples.last.size(); ++k)
  {
    const FrontSample<D>& s = samples.last[k];
    nlohmann::json& crack = summary["cracks"][s.front.crack];
    crack["name"] = state.cracks.cracks[s.front.crack].name;
    nlohmann::json& front = crack["fronts"][s.front.number];
    s.report(options, front);
    reportNodesAtSurface(state, s.front, samples.reached.mirrors(), front);
    if (options.contour)
      reportModeRatios(state, s, samples.reached.mirrors(), front);
    reportError(s, options, errors[k], front);
    // Where all loads rise in proportion the largest is the last.
    const bool proportional =
        state.method.analysis == Analysis::Static || state.method.analysis == Analysis::LoadFactor;
    if (options.contour && !proportional)
    {
      const LargestRelease::Peak largest = samples.largest.of(s.front.crack, s.front.number);
      front["largest_G_J"] = largest.release;
      front["time_of_largest_G_J"] = largest.time;
    }
  }
}

/// Judges whether the bodies yield by the loads. \param estimate gets a warning of a plastic zone, which a
/// run judges by the K that it computes
template <int D>
void judgeYieldBefore(const Teuchos::ParameterList& scene, std::string& estimate, State<D>& state)
{
  const auto [warning, isOfZone] = judgeYield<D>(scene, state);
  if (isOfZone)
    estimate = warning;
  else if (!warning.empty())
    state.warnings.push_back(warning);
}

template <int D>
Effect<D> make(const Teuchos::ParameterList& scene, const RunOptions& run)
{
  const Options options = readOptions(scene, run);
  const auto samples = std::make_shared<Samples<D>>();
  samples->loads = readLoads(scene);
  samples->reached = ToughnessReached(options.toughness, mirrorPlanes(scene), options.criticalIntensity);
  const auto driving = std::make_shared<DrivingForces<D>>();
  const auto work = std::make_shared<SampleWork<D>>();
  const auto yielded = std::make_shared<YieldRecords<D>>();
  Effect<D> effect;
  effect.name = "Energy Release";
  const auto strain = std::make_shared<StrainWatch>();
  const auto estimate = std::make_shared<std::string>(); // of a plastic zone, before K is known
  effect.atStart = [=](State<D>& state) { start(state, options, run, *samples); };
  effect.judge = [=, all = Teuchos::ParameterList(scene)](State<D>& state)
  {
    strain->start(all, state);
    judgeYieldBefore(all, *estimate, state);
  };
  effect.call(Stage::Observe, "energy release of crack fronts",
              {quantity::crackGeometry, quantity::particleStress, quantity::enrichedFields,
               ifWritten(quantity::springForce), ifWritten(quantity::facePressure)},
              {}, {quantity::energyRelease},
              [=](State<D>& state)
              {
                if (state.clock.observing)
                {
                  sample(state, options, *samples, *work);
                  yielded->sample(state, samples->last);
                }
                strain->sample(state.energy.strain);
              });
  if (run.growth)
    addDrivingCalls(effect, scene, driving);
  effect.memory = [=](State<D>& state, Archive& archive)
  {
    serialize(state, options, *samples, archive);
    yielded->serialize(archive);
    if (archive.loads())
    {
      *work = SampleWork<D>(); // of other particles
      recordFrontValues(state, samples->last, options);
    }
    const Archive::Group group(archive, "driving forces");
    driving->serialize(archive);
  };
  effect.report = [=](const State<D>& state, nlohmann::json& summary)
  {
    reportSamples(state, options, *samples, summary);
    const ToughnessReached::Factors start = samples->reached.report(state, run, summary);
    reportYield(state, samples->last, start, *yielded, summary);
    reportPlasticZones(state, samples->last, start, *estimate, summary);
    addAnswersOfHeldFronts(state.cracks, samples->last, samples->time, summary);
    if (const std::string warning = strain->warning(); !warning.empty())
      summary["warnings"].push_back(warning);
    for (const auto& warnings :
         {warningsOfNegativeRelease(state, samples->last, samples->time, samples->largest.ever()),
          warningsOfDisagreement(state, samples->last, samples->time)})
      for (const std::string& warning : warnings)
        summary["warnings"].push_back(warning);
  };
  return effect;
}

} // namespace

EffectEntry energyReleaseEntry()
{
  EffectEntry entry{energyReleaseSection(), checkEnergyRelease, make<2>, make<3>, true};
  entry.cells.addNeeds = [](const Teuchos::ParameterList& scene, CellNeeds& needs, auto&)
  {
    const Teuchos::ParameterList& list = scene.sublist("Energy Release");
    if (list.isType<double>("Inner Radius"))
      needs.contour = std::min(needs.contour, list.get<double>("Inner Radius"));
  };
  return entry;
}

} // namespace Rhegma::energy_release
