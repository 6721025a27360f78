#include "program/Forecast.hpp"

#include "base/Counted.hpp"
#include "base/RunError.hpp"
#include "base/UtcTime.hpp"
#include "plan/EffectSchema.hpp"
#include "plan/KnownEffects.hpp"
#include "plan/LastStage.hpp"
#include "program/Budget.hpp"
#include "program/CheckText.hpp"
#include "program/Checkpoints.hpp"
#include "program/Intervals.hpp"
#include "program/RateCache.hpp"
#include "scene/Scene.hpp"
#include "scene/SceneBodies.hpp"

#include <Kokkos_Core.hpp>
#include <Teuchos_DefaultMpiComm.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <limits>
#include <new>
#include <stdexcept>

namespace Rhegma::program
{

namespace
{

/// Time of the processor that measuring the rates may take [s].
constexpr double measuringSeconds = 1.0;

/// A run with the copies of its state for a restart, as a multiple of one without.
constexpr double copies = 1.0 + costOfCopies;

/// Particles from which a load step takes so long that it is announced: tens of seconds.
constexpr double slowParticles = 3e5;

/// Where a machine is this busy, who reads a forecast should know.
constexpr double busyMachine = 1.3;

/// By when damping of mass has an amplitude fall to Settled Drift, exp(-r t / 2), up to critical damping r =
/// 2 w of the slowest motion [s]. Infinite without damping, and where the motion creeps or is not known.
double timeToRest(const EndAtRest& end, double slowest)
{
  return end.massRate <= 2.0 * slowest ? -2.0 * std::log(std::min(1.0, end.drift)) / end.massRate
                                       : std::numeric_limits<double>::infinity();
}

/// Angular frequency of the slowest motion that Damping must bring to rest [1/s]; 0: unknown.
double slowestMotion(const Simulation& simulation)
{
  const nlohmann::json report = simulation.report(0);
  const auto found = report.find("slowest_motion");
  return found == report.end() ? 0.0 : found->at("angular_frequency").get<double>();
}

std::string seconds(double value)
{
  char text[48];
  const long all = std::lround(value);
  if (value < 9.95)
    std::snprintf(text, sizeof text, "%.2g s", value);
  else if (all < 60)
    std::snprintf(text, sizeof text, "%ld s", all);
  else if (all < 3600)
    std::snprintf(text, sizeof text, "%ld min %02ld s", all / 60, all % 60);
  else
    std::snprintf(text, sizeof text, "%.3g h", value / 3600.0);
  return text;
}

std::string size(double bytes)
{
  char text[48];
  if (bytes < 1e9)
    std::snprintf(text, sizeof text, "%.3g MB", std::ceil(1e-5 * bytes) / 10.0);
  else
    std::snprintf(text, sizeof text, "%.3g GB", 1e-9 * bytes);
  return text;
}

std::string cost(const Forecast& forecast)
{
  if (forecast.secondsToRest > 0.0)
    return seconds(forecast.secondsToRest) + " to rest by Damping, at most " + seconds(forecast.seconds);
  return seconds(forecast.seconds);
}

/// What takes the time: steps, or linear systems of so many unknowns.
std::string workAsText(const Forecast& forecast)
{
  const StepRates& rates = forecast.rates;
  char text[160];
  if (rates.unknowns == 0)
    std::snprintf(text, sizeof text, "%.3g ms a step", 1e3 * rates.step);
  else
    std::snprintf(text, sizeof text, "%s, %s of %d unknowns, %.3g ms each",
                  counted(std::lround(forecast.steps), "load step").c_str(),
                  counted(std::max(1L, std::lround(forecast.solves)), "linear system").c_str(),
                  rates.unknowns, 1e3 * rates.solve);
  return text;
}

/// What the forecast is made of.
std::string sourceAsText(const Forecast& forecast)
{
  const StepRates& rates = forecast.rates;
  if (rates.unknowns > 0 && rates.steps == 0)
    return "; from the time of one linear system and the usual number of them in a load step";
  const char* const noun = rates.unknowns > 0 ? "load step" : "step";
  return "; from its first " + (rates.steps == 1 ? std::string(noun) : counted(rates.steps, noun)) +
         (isNoticeable(rates.growth) ? " and a run with cells of twice the size" : "");
}

/// What it leaves out, as how far cracks grow is not known before.
std::string growthAsText(const StepRates& rates)
{
  if (rates.incrementSolves == 0.0)
    return {};
  return "; a crack that grows takes about " +
         counted(std::lround(rates.incrementSolves), "more linear system") + " (" +
         seconds(rates.incrementSolves * rates.solve) + ") for each increment of its front";
}

std::string costLine(int particles, const Forecast& forecast)
{
  return counted(particles, "particle") + ", " + cost(forecast) +
         (forecast.kept ? "; rates of " + utcTime(forecast.rates.measured) : "") + "\n";
}

} // namespace

double checkpointsOf(const Teuchos::ParameterList& scene, double from, double to, double steps,
                     double seconds)
{
  if (!writesCheckpoints(scene))
    return 0.0;
  constexpr double rounding = 1e-9;
  const double interval = checkpointInterval(scene), minutes = checkpointMinutes(scene);
  // After each interval and at the end (Checkpoints::afterStep, atEnd).
  const double byTime =
      interval > 0.0 ? std::ceil(to / interval - rounding) - std::floor(from / interval + rounding) : 0.0;
  // By the clock only where the last one is so long ago.
  const double parts = std::max(1.0, byTime);
  const double byClock = minutes > 0.0 ? parts * std::floor(seconds / parts / (60.0 * minutes)) : 0.0;
  return std::min(byTime + byClock, steps);
}

Forecast forecastOf(const StepRates& rates, const Teuchos::ParameterList& scene, double time, double slowest)
{
  const Teuchos::ParameterList& times = scene.sublist("Time");
  const double length = times.get<double>("Final Time") - time;
  const double rest = std::max(0.0, length - rates.time);
  // The last step of an equilibrium takes what is left, however little rounding leaves.
  const double evenSteps = std::ceil(rest / rates.timeStep - (rates.unknowns > 0 ? 1e-6 : 0.0));
  const double restSteps = evenSteps * rates.growth.steps;
  const double restSeconds = evenSteps * rates.growth.work * rates.step;
  const double all = rates.steps + std::round(restSteps);
  Forecast f;
  f.rates = rates;
  f.steps = std::min(all, double(times.get<int>("Maximum Steps")));
  const double fraction = all > 0.0 ? f.steps / all : 0.0;
  const double frames = scene.sublist("Output").get<bool>("Fields")
                            ? std::max(1.0, std::floor(fraction * length / fieldInterval(scene)))
                            : 0.0;
  const double samples = std::min(f.steps, fraction * length / historyInterval(scene));
  const double running = copies * (fraction * (rates.spent + restSeconds) + samples * rates.sample);
  const double withoutCheckpoints = rates.setup + running + frames * rates.frame;
  f.checkpoints = checkpointsOf(scene, time, time + fraction * length, f.steps, withoutCheckpoints);
  f.seconds = withoutCheckpoints + f.checkpoints * rates.checkpoint;
  f.bytes = frames * rates.frameBytes;
  f.solves = f.steps * rates.solves;
  if (const std::optional<EndAtRest> end = declaredOptions(scene).endAtRest)
  {
    const double settled = std::max(0.0, end->notBefore - time) +
                           std::max(timeToRest(*end, slowest), historyInterval(scene)); // seen in a sample
    if (settled < fraction * length)
    {
      const double part = settled / (fraction * length);
      f.secondsToRest = rates.setup + part * running + rates.frame;
      f.secondsToRest +=
          checkpointsOf(scene, time, time + settled, part * f.steps, f.secondsToRest) * rates.checkpoint;
    }
  }
  return f;
}

Forecast makeForecast(Simulation& simulation, const Teuchos::ParameterList& scene, const Ranks& ranks,
                      double setup)
{
  const double time = simulation.time(), slowest = slowestMotion(simulation);
  const RateCache cache(cacheFolder(), machineIdentity(ranks.size()), buildIdentity());
  std::optional<StepRates> kept = cache.find(scene);
  if (ranks.max(kept && kept->particles == simulation.particles() ? 0.0 : 1.0) > 0.0)
    kept.reset(); // on all ranks, or on none
  StepRates rates = kept ? *kept : measureRates(simulation, scene, ranks, measuringSeconds);
  if (!kept)
  {
    rates.setup = ranks.max(setup);
    rates.measured = std::time(nullptr);
    if (ranks.rank() == 0)
      cache.keep(scene, rates);
  }
  Forecast forecast = forecastOf(rates, scene, time, slowest);
  forecast.kept = kept.has_value();
  return forecast;
}

std::string asText(const Forecast& forecast)
{
  const StepRates& rates = forecast.rates;
  std::string text = "Forecast: " + cost(forecast) + " (" + workAsText(forecast) + ", " +
                     Kokkos::DefaultExecutionSpace::name() + ", " +
                     counted(Kokkos::DefaultExecutionSpace().concurrency(), "thread") + "), " +
                     size(rates.memory) + " of memory";
  if (forecast.bytes > 0.0)
    text += ", " + size(forecast.bytes) + " of fields";
  if (forecast.checkpoints > 0.0 && rates.checkpoint > 0.0)
    text += ", " + counted(std::lround(forecast.checkpoints), "checkpoint") + " of " +
            size(rates.checkpointBytes) + " (" + seconds(forecast.checkpoints * rates.checkpoint) + ")";
  text += growthAsText(rates);
  if (forecast.kept)
    return text + "; rates kept from an earlier measurement, " + utcTime(rates.measured);
  text += sourceAsText(forecast);
  char busy[96] = "";
  if (rates.busy > busyMachine)
    std::snprintf(busy, sizeof busy, "; %.1f times as long while the machine is as busy as now", rates.busy);
  return text + busy;
}

void printCostOfAccuracy(const Options& options, const Teuchos::ParameterList& scene, const Ranks& ranks,
                         const Forecast* own, double start, std::ostream& out)
{
  const Teuchos::ParameterList& domain = scene.sublist("Domain");
  if (!domain.isType<std::string>("Accuracy"))
    return;
  const std::string chosen = domain.get<std::string>("Accuracy");
  std::vector<std::string> names = {chosen};
  for (const char* const other : {"3 %", "10 %"})
    if (chosen != other)
      names.emplace_back(other);
  for (const std::string& name : names)
    try
    {
      const double before = processorSeconds();
      Options other = options;
      other.overrides.push_back("Domain:Accuracy=" + name);
      const SceneResult result = readScene(other.scene, other.overrides, effectSchema());
      if (!result.errors.empty())
      {
        out << "  with " << name << ": not possible: " << toString(result.errors.front()) << "\n";
        continue;
      }
      const bool known = own != nullptr && name == chosen;
      const std::string begin = (name == chosen ? "Accuracy " : "  with ") + name + ": ";
      const double number = estimateParticles(*result.list);
      if (number > manyParticles && !known)
      {
        char line[160];
        std::snprintf(line, sizeof line, "about %.2g million particles, too many to be timed first\n",
                      1e-6 * number);
        out << begin << line << std::flush;
        continue;
      }
      if (number > slowParticles && !known && isEquilibrium(*result.list))
        out << "solving for a load step with " << name << ", to forecast the run\n" << std::flush;
      Forecast forecast;
      int particles = 0;
      if (known)
      {
        forecast = *own;
        particles = own->rates.particles;
      }
      else
      {
        const auto world = Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD));
        Simulation simulation(world, result.list, true);
        simulation.initialize();
        particles = simulation.particles();
        forecast = makeForecast(simulation, *result.list, ranks, start + processorSeconds() - before);
      }
      if (forecast.rates.failure.empty())
        out << begin << costLine(particles, forecast) << std::flush;
    }
    catch (const std::invalid_argument& refusal)
    {
      out << "  with " << name << ": not possible: " << refusal.what() << "\n";
    }
    catch (const std::bad_alloc&)
    {
      out << "  with " << name << ": more memory than there is\n";
    }
}

} // namespace Rhegma::program
