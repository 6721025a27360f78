#include "program/RunScene.hpp"

#include "Simulation.hpp"
#include "base/FoldMessages.hpp"
#include "base/Numbers.hpp"
#include "base/OutputError.hpp"
#include "output/OutputFolder.hpp"
#include "output/References.hpp"
#include "output/RunLock.hpp"
#include "output/Summary.hpp"
#include "parallel/FirstRank.hpp"
#include "plan/EffectSchema.hpp"
#include "program/Answer.hpp"
#include "program/Forecast.hpp"
#include "program/Production.hpp"
#include "program/Twice.hpp"
#include "scene/Compatibility.hpp"
#include "scene/Scene.hpp"

#include <Kokkos_Core.hpp>
#include <Teuchos_DefaultMpiComm.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <new>
#include <sstream>

namespace Rhegma::program
{

namespace
{

Teuchos::RCP<const Teuchos::Comm<int>> world()
{
  return Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD));
}

/// Prints one error per line, with the name of the program.
void printErrors(const std::string& messages, std::ostream& err)
{
  std::istringstream lines(messages);
  std::vector<std::string> all;
  for (std::string line; std::getline(lines, line);)
    all.push_back(line);
  for (const std::string& line : foldMessages(all))
    err << "rhegma: " << line << "\n";
}

void printErrors(const std::vector<SceneError>& errors, std::ostream& err)
{
  std::vector<std::string> all;
  all.reserve(errors.size());
  for (const SceneError& error : errors)
    all.push_back(toString(error));
  for (const std::string& line : foldMessages(all))
    err << "rhegma: " << line << "\n";
}

/// A validated scene, or nothing after its errors have been printed.
Teuchos::RCP<Teuchos::ParameterList> validScene(const Options& options, std::ostream& err)
{
  const SceneResult result = readScene(options.scene, options.overrides, effectSchema());
  // A file may be visible to some ranks only.
  std::ostringstream own;
  printErrors(result.errors, own);
  const std::string errors = Ranks(world()).firstText(own.str());
  if (errors.empty())
    return result.list;
  err << errors;
  return Teuchos::null;
}

SummaryFacts facts(const Options& options, const Simulation& simulation, const std::string& status)
{
  SummaryFacts f;
  f.scene = options.scene;
  f.ranks = world()->getSize();
  f.threads = Kokkos::DefaultExecutionSpace().concurrency();
  f.backend = Kokkos::DefaultExecutionSpace::name();
  f.effects = simulation.effects();
  f.steps = simulation.steps();
  f.time = simulation.time();
  f.wallSeconds = simulation.wallSeconds();
  f.particles = simulation.particles();
  f.particleSteps = simulation.particleSteps();
  f.stages = simulation.stageSeconds();
  f.peakMemory = Ranks(world()).gatherOnAll({peakMemoryBytes()});
  f.settled = simulation.settled();
  f.status = status;
  return f;
}

/// \return why the summary could not be written; empty if it was
std::string writeWhereItCan(const nlohmann::json& summary, const std::string& path)
{
  try
  {
    writeSummary(summary, path);
    return {};
  }
  catch (const OutputError& error)
  {
    return error.what();
  }
}

Teuchos::ParameterList references(const Teuchos::ParameterList& scene)
{
  return scene.isSublist("Reference") ? scene.sublist("Reference") : Teuchos::ParameterList();
}

void printWarnings(const nlohmann::json& summary, std::ostream& err)
{
  for (const auto& warning : summary.value("warnings", nlohmann::json::array()))
    err << "rhegma: warning: " << warning.get<std::string>() << "\n";
}

/// Initialises the simulation and reports errors that depend on the bodies.
/// \return output of the run before its checkpoint, if it continues from one
EarlierPart initialize(Simulation& simulation, const Teuchos::ParameterList& scene, const Options& options,
                       std::ostream& err)
{
  EarlierPart earlier;
  if (options.restart.empty())
    simulation.initialize();
  else
  {
    const std::string folder = options.output.empty() ? defaultOutputFolder(options.scene) : options.output;
    const HistorySoFar soFar = readNotes(simulation.restore(options.restart));
    onEachRank(Ranks(world()), [&] { earlier = EarlierPart(options.restart, folder, soFar); });
    if (simulation.time() > scene.sublist("Time").get<double>("Final Time"))
      throw std::invalid_argument("Time > Final Time: the checkpoint " + options.restart + " is of time " +
                                  readableTime(simulation.time()) + " already; write a later time");
  }
  const nlohmann::json summary = simulation.report();
  try
  {
    refuseUnknownQuantities(references(scene), makeSummary(facts(options, simulation, ""), summary));
  }
  catch (const std::invalid_argument&)
  {
    printWarnings(summary, err); // they may tell why the quantity is not there
    throw;
  }
  return earlier;
}

/// Prints the warnings of a scene before its run. \return whether it may run: with --strict, if there are
/// none
bool mayRun(const Options& options, const nlohmann::json& summary, std::ostream& err)
{
  const auto warnings = summary.value("warnings", nlohmann::json::array());
  if (!options.strict || warnings.empty())
  {
    printWarnings(summary, err);
    return true;
  }
  for (const auto& warning : warnings)
    err << "rhegma: " << warning.get<std::string>() << " (an error by --strict)\n";
  return false;
}

/// Four digits, with the largest unit that leaves at least 1 before the point.
std::string inUnits(double value, const std::vector<std::pair<double, const char*>>& units)
{
  char text[40];
  for (const auto& [size, name] : units)
    if (value >= size || size == units.back().first)
    {
      std::snprintf(text, sizeof text, "%.4g %s", value / size, name);
      return text;
    }
  return {};
}

/// Masses and weights, by which a wrong unit shows: a line for each of the first ten bodies.
std::string bodiesAsText(const nlohmann::json& summary)
{
  constexpr double g = 9.81;
  std::string text;
  int count = 0;
  for (const auto& body : summary.value("bodies", nlohmann::json::array()))
    if (++count <= 10)
    {
      const double mass = body["mass"];
      text +=
          "  Bodies > " + body["name"].get<std::string>() + ": mass " +
          inUnits(mass, {{1e6, "kt"}, {1e3, "t"}, {1.0, "kg"}, {1e-3, "g"}, {1e-6, "mg"}, {1e-9, "ug"}}) +
          ", weight " +
          inUnits(g * mass, {{1e9, "GN"}, {1e6, "MN"}, {1e3, "kN"}, {1.0, "N"}, {1e-3, "mN"}, {1e-6, "uN"}}) +
          "\n";
    }
  return text + (count > 10 ? "  and " + std::to_string(count - 10) + " more bodies\n" : "");
}

/// Size of cells and number of particles, which Domain > Accuracy may have chosen.
std::string cellsAsText(const nlohmann::json& summary, long particles)
{
  const double largest = summary["cells"]["largest"], smallest = summary["cells"]["smallest"];
  return std::to_string(particles) + " particles in cells of " + readableLength(largest) +
         (smallest < largest ? ", the finest of " + readableLength(smallest) : "");
}

/// Size of the linear systems of an equilibrium.
std::string unknownsAsText(const nlohmann::json& summary)
{
  if (!summary.contains("equilibrium"))
    return {};
  const nlohmann::json& of = summary["equilibrium"];
  char text[96];
  std::snprintf(text, sizeof text, "; %d unknowns, a matrix of %.3g MB before it is factored",
                of["unknowns"].get<int>(), 1e-6 * of["matrix_bytes"].get<double>());
  return text;
}

/// Estimated number of steps, by the stable step of the initial state.
std::string stepsAsText(const Simulation& simulation, const Teuchos::ParameterList& scene)
{
  const Teuchos::ParameterList& time = scene.sublist("Time");
  const double step = simulation.stableTimeStep();
  const double steps = std::ceil((time.get<double>("Final Time") - simulation.time()) / step);
  if (!(steps >= 1.0 && steps < 1e15))
    return {};
  const double most = time.get<int>("Maximum Steps");
  // Three digits: the step changes as bodies and cells do.
  const double digits = std::pow(10.0, std::max(0.0, std::floor(std::log10(steps)) - 2.0));
  char text[96];
  std::snprintf(text, sizeof text, "; about %.0f steps of %s to %s",
                std::min(digits * std::round(steps / digits), most), readableTime(step).c_str(),
                steps > most ? "Time > Maximum Steps" : "Time > Final Time");
  return text;
}

/// A hint where a run would wait for a rest that Time > Analysis = Static solves for: the rules then refuse
/// nothing but the section that makes it rest.
std::string equilibriumAsText(const Teuchos::ParameterList& scene, const Forecast& forecast)
{
  if (forecast.secondsToRest == 0.0 || world()->getSize() > 1)
    return {};
  Teuchos::ParameterList other = scene;
  other.sublist("Time").set("Analysis", std::string("Static"));
  std::vector<SceneError> errors;
  checkRules(other, effectSchema(), errors);
  const auto another = [&errors](const SceneError& error) { return error.where != errors.front().where; };
  if (errors.empty() || std::any_of(errors.begin(), errors.end(), another))
    return {};
  return "  Time > Analysis = Static, without " + errors.front().where +
         ", solves for the state of rest directly\n";
}

int checkScene(const Options& options, const Teuchos::RCP<Teuchos::ParameterList>& scene, std::ostream& out,
               std::ostream& err)
{
  Simulation simulation(world(), scene, !options.twice);
  initialize(simulation, *scene, options, err);
  const nlohmann::json summary = simulation.report();
  if (!mayRun(options, summary, err))
    return exitWrongScene;
  out << options.scene << " is a valid scene"
      << (options.restart.empty() ? "" : ", and " + options.restart + " a checkpoint of it") << ": "
      << cellsAsText(summary, simulation.particles()) << unknownsAsText(summary)
      << stepsAsText(simulation, *scene) << "\n"
      << std::flush;
  if (options.quiet)
    return exitFinished;
  out << bodiesAsText(summary);
  const Ranks ranks(world());
  const Forecast forecast = makeForecast(simulation, *scene, ranks);
  out << asText(forecast) << "\n"
      << equilibriumAsText(*scene, forecast) << costOfAccuracy(options, *scene, ranks, &forecast);
  return exitFinished;
}

int runScene(const Options& options, const Teuchos::RCP<Teuchos::ParameterList>& scene, std::ostream& out,
             std::ostream& err)
{
  const Ranks ranks(world());
  const std::string folder = options.output.empty() ? defaultOutputFolder(options.scene) : options.output;
  if (options.action == Options::Action::Run) // before the work of making all
    onFirstRank<std::invalid_argument>(ranks, [&] { refuseFolderInUse(folder); });
  if (options.action == Options::Action::Run && !options.quiet && options.restart.empty())
    out << costOfAccuracy(options, *scene, ranks, nullptr) << std::flush;
  Simulation simulation(world(), scene, !options.twice);
  const EarlierPart earlier = initialize(simulation, *scene, options, err);
  if (options.action == Options::Action::PrintPlan)
  {
    out << simulation.plan();
    return exitFinished;
  }
  if ((!options.quiet || options.strict) && !mayRun(options, simulation.report(), err))
    return exitWrongScene;
  Production production(options, *scene, simulation, earlier, out, ranks);
  std::string failure = production.runToEnd();
  const std::string status = !failure.empty()          ? failure
                             : production.outOfSteps() ? "finished at Time > Maximum Steps"
                                                       : "finished";
  nlohmann::json summary = makeSummary(facts(options, simulation, status), simulation.report());
  const Checkpoints::Cost& cost = production.costOfCheckpoints();
  summary["checkpoints"] = {{"written", cost.written}, {"copies", cost.copies}, {"seconds", cost.seconds}};
  for (const std::string& warning : production.warnings())
    summary["warnings"].push_back(warning);
  const bool within = addReferences(references(*scene), summary);
  addAnswers(summary);
  std::string unwritten =
      ranks.rank() == 0 ? writeWhereItCan(summary, production.folder() + "/summary.json") : std::string();
  if (const std::string unlisted = production.listFiles(); unwritten.empty())
    unwritten = unlisted;
  unwritten = ranks.firstText(unwritten);
  if (failure.empty())
    failure = unwritten;
  if (!options.quiet)
    out << (failure.empty() ? "Results are in " : "Results up to then are in ") << production.folder()
        << "\n";
  if (!options.quiet && failure.empty())
    out << referencesAsText(summary) << std::flush;
  printWarnings(summary, err);
  if (!options.quiet)
    printAnswers(summary, !failure.empty(), out);
  if (!failure.empty())
  {
    err << "rhegma: " << failure << "\n";
    return exitStopped;
  }
  if (options.strict && !summary["warnings"].empty())
  {
    err << "rhegma: warnings are errors by --strict\n";
    return exitReferenceMissed;
  }
  return within ? exitFinished : exitReferenceMissed;
}

} // namespace

int run(const Options& options, std::ostream& out, std::ostream& err)
{
  using Action = Options::Action;
  if (options.action == Action::Help)
    out << usage();
  else if (options.action == Action::Version)
    out << "rhegma " << RHEGMA_VERSION << " (" << Kokkos::DefaultExecutionSpace::name() << ")\n";
  else if (options.action == Action::Describe || options.action == Action::DescribeMarkdown)
  {
    try
    {
      out << (options.action == Action::Describe ? describe(effectSchema(), options.section)
                                                 : describeMarkdown(effectSchema()));
    }
    catch (const std::invalid_argument& error)
    {
      err << "rhegma: " << error.what() << "\n";
      return exitWrongScene;
    }
  }
  else
  {
    const auto scene = validScene(options, err);
    if (scene.is_null())
      return exitWrongScene;
    try
    {
      if (options.action == Action::Check)
        return checkScene(options, scene, out, err);
      const auto runOne = [&](const Options& one, const Teuchos::RCP<Teuchos::ParameterList>& list)
      { return runScene(one, list, out, err); };
      return options.twice ? runTwice(options, scene, Ranks(world()), out, runOne) : runOne(options, scene);
    }
    catch (const std::invalid_argument& error)
    {
      printErrors(error.what(), err);
      return exitWrongScene;
    }
    catch (const OutputError& error)
    {
      err << "rhegma: " << error.what() << "; choose another folder with --output\n";
      return exitWrongScene;
    }
    catch (const std::bad_alloc&)
    {
      if (world()->getSize() > 1)
        throw;
      err << "rhegma: there is not enough memory for this scene; use larger cells (Domain > Cell Size)\n";
      return exitWrongScene;
    }
  }
  return exitFinished;
}

} // namespace Rhegma::program
