#include "program/RunScene.hpp"

#include "Simulation.hpp"
#include "base/FoldMessages.hpp"
#include "base/NonNumbers.hpp"
#include "base/Numbers.hpp"
#include "base/OutputError.hpp"
#include "output/OutputFolder.hpp"
#include "output/References.hpp"
#include "output/RunLock.hpp"
#include "output/Summary.hpp"
#include "parallel/FirstRank.hpp"
#include "plan/EffectSchema.hpp"
#include "plan/KnownEffects.hpp"
#include "plan/LastStage.hpp"
#include "program/Answer.hpp"
#include "program/Budget.hpp"
#include "program/CheckText.hpp"
#include "program/CheckedState.hpp"
#include "program/Forecast.hpp"
#include "program/Intervals.hpp"
#include "program/MaterialsText.hpp"
#include "program/Production.hpp"
#include "program/RunEnd.hpp"
#include "program/ScenePicture.hpp"
#include "program/ScratchFolder.hpp"
#include "program/StartForces.hpp"
#include "program/Templates.hpp"
#include "program/Twice.hpp"
#include "scene/FillFromLibrary.hpp"
#include "scene/ReadFile.hpp"
#include "scene/Scene.hpp"

#include <Kokkos_Core.hpp>
#include <Teuchos_DefaultMpiComm.hpp>

#include <iostream>
#include <new>
#include <optional>
#include <set>
#include <sstream>

namespace Rhegma::program
{

namespace
{

Teuchos::RCP<const Teuchos::Comm<int>> world()
{
  return Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD));
}

/// Prints one error per line, with the name of the program and without what is no number.
void printLines(const std::vector<std::string>& lines, std::ostream& err)
{
  for (const std::string& line : foldMessages(lines))
    err << "rhegma: " << withWordsForNonNumbers(line) << "\n";
}

void printErrors(const std::string& messages, std::ostream& err)
{
  std::istringstream lines(messages);
  std::vector<std::string> all;
  for (std::string line; std::getline(lines, line);)
    all.push_back(line);
  printLines(all, err);
}

void printErrors(const std::vector<SceneError>& errors, std::ostream& err)
{
  std::vector<std::string> all;
  all.reserve(errors.size());
  for (const SceneError& error : errors)
    all.push_back(toString(error));
  printLines(all, err);
}

/// A validated scene, or nothing after its errors have been printed.
Teuchos::RCP<Teuchos::ParameterList> validScene(const Options& options, std::ostream& err)
{
  const Ranks ranks(world());
  // A file may be visible to some ranks only.
  std::ostringstream own;
  SceneResult result;
  if (!isPipe(options.scene))
    result = readScene(options.scene, options.overrides, effectSchema());
  else if (ranks.many())
    result.errors = {
        {"", "\"" + options.scene +
                 "\" is a pipe, which can be read once only, and not by all ranks; give the path "
                 "of a scene's XML file."}};
  else
  {
    if (!options.quiet)
      err << "rhegma: reading the scene from the pipe " << options.scene << "\n" << std::flush;
    result = readScene(options.scene, options.overrides, effectSchema());
  }
  printErrors(result.errors, own);
  const std::string errors = ranks.firstText(own.str());
  if (errors.empty())
    return result.list;
  err << errors;
  return Teuchos::null;
}

SummaryFacts facts(const Options& options, const Simulation& simulation)
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
  return f;
}

/// What summary.json holds of a run that has ended, but for its references and answers.
/// \param failure why it could not go on; empty if it could
nlohmann::json summaryOf(const Options& options, const Teuchos::ParameterList& scene,
                         const Simulation& simulation, const Production& production,
                         const std::string& failure)
{
  nlohmann::json summary = makeSummary(facts(options, simulation), simulation.report());
  const RunEnd end = production.end(failure);
  const bool moving = end == RunEnd::Finished && summary.value("ended_before_settled", false);
  writeEnd(moving ? RunEnd::NotAtRest : end, failure, summary);
  const Checkpoints::Cost& cost = production.costOfCheckpoints();
  summary["history_interval"] = historyInterval(scene);
  summary["checkpoints"] = {{"written", cost.written}, {"copies", cost.copies}, {"seconds", cost.seconds}};
  for (const std::string& warning : production.warnings())
    summary["warnings"].push_back(warning);
  return summary;
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

/// Writes the summary and the list of all files. \return why they could not be written; empty if they were
std::string writeResults(const nlohmann::json& summary, Production& production, const Ranks& ranks)
{
  std::string unwritten =
      ranks.rank() == 0 ? writeWhereItCan(summary, production.folder() + "/summary.json") : std::string();
  if (const std::string unlisted = production.listFiles(); unwritten.empty())
    unwritten = unlisted;
  return ranks.firstText(unwritten);
}

Teuchos::ParameterList references(const Teuchos::ParameterList& scene)
{
  return scene.isSublist("Reference") ? scene.sublist("Reference") : Teuchos::ParameterList();
}

/// Prints the warnings of a summary that have not been printed yet.
void printWarnings(const nlohmann::json& summary, std::set<std::string>& printed, std::ostream& err)
{
  for (const auto& warning : summary.value("warnings", nlohmann::json::array()))
    if (printed.insert(warning.get<std::string>()).second)
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
  if (!scene.isSublist("Reference"))
    return earlier;
  const nlohmann::json summary = simulation.report();
  try
  {
    refuseUnknownQuantities(references(scene), makeSummary(facts(options, simulation), summary));
  }
  catch (const std::invalid_argument&)
  {
    std::set<std::string> none;
    printWarnings(summary, none, err); // they may say why the quantity is missing
    throw;
  }
  return earlier;
}

/// What is not freed before the program ends: of a scene with many bodies that takes as long as to read it.
template <class T>
T& keepToTheEnd(T* made)
{
  static auto* const kept = new std::vector<const void*>; // so that it is not taken for lost
  kept->push_back(made);
  return *made;
}

/// Prints the warnings of a scene before its run. \param printed gets them \return whether it may run: with
/// --strict, if there are none
bool mayRun(const Options& options, const nlohmann::json& summary, std::set<std::string>& printed,
            std::ostream& err)
{
  const auto warnings = summary.value("warnings", nlohmann::json::array());
  if (!options.strict || warnings.empty())
  {
    printWarnings(summary, printed, err);
    return true;
  }
  for (const auto& warning : warnings)
    err << "rhegma: " << warning.get<std::string>() << " (an error by --strict)\n";
  return false;
}

/// Adds a warning to the report if loads on bodies that may move freely do not balance.
/// \return why the first load step fails; empty if it does not
std::string warnOfUnbalancedLoads(Simulation& simulation, const Teuchos::ParameterList& scene)
{
  const Teuchos::ParameterList& time = scene.sublist("Time");
  if (time.get<std::string>("Rigid Modes") != "Remove" || simulation.time() >= time.get<double>("Final Time"))
    return {};
  try
  {
    simulation.trySolve(true);
  }
  catch (const RunError& failure)
  {
    return failure.what();
  }
  return {};
}

/// The report before the first step, with what is known of the references.
nlohmann::json reportBefore(const Simulation& simulation, const Teuchos::ParameterList& scene,
                            std::size_t mostBodies)
{
  nlohmann::json summary = simulation.report(mostBodies);
  for (const auto& estimate : summary.value("warnings_of_a_check", nlohmann::json::array()))
    summary["warnings"].push_back(
        estimate); // of what a run computes: it has not begun, or its first step fails
  summary.erase("warnings_of_a_check");
  if (const RunOptions declared = declaredOptions(scene); declared.loadFactor && isEquilibrium(scene))
    if (const std::string warning = warningOfReferences(references(scene)); !warning.empty())
      summary["warnings"].push_back(warning);
  return summary;
}

/// \param start processor time that the program took before it read the scene [s]
int checkScene(const Options& options, const Teuchos::RCP<Teuchos::ParameterList>& scene, double start,
               std::ostream& out, std::ostream& err)
{
  if (!options.quiet)
    out << sizeAsText(*scene) << std::flush;
  Simulation& simulation = keepToTheEnd(new Simulation(world(), scene, true));
  initialize(simulation, *scene, options, err);
  const double setup = processorSeconds();
  const std::string failure = warnOfUnbalancedLoads(simulation, *scene);
  nlohmann::json& summary = keepToTheEnd(new nlohmann::json(reportBefore(simulation, *scene, bodiesInText)));
  if (!failure.empty() && options.quiet) // else the forecast reports it
    summary["warnings"].push_back("the first load step fails: " + failure);
  std::set<std::string> printed;
  if (!mayRun(options, summary, printed, err))
    return exitWrongScene;
  out << options.scene << " is a valid scene"
      << (options.restart.empty() ? "" : ", and " + options.restart + " a checkpoint of it") << ": "
      << cellsAsText(summary, simulation.particles()) << unknownsAsText(summary)
      << stepsAsText(simulation, *scene) << "\n"
      << std::flush;
  const Ranks ranks(world());
  const std::string loads = options.quiet && options.state.empty() ? std::string() : loadsAsText(*scene);
  if (!options.state.empty()) // before the forecast, which takes steps
    writeCheckedState(options.state, simulation, summary, loads, ranks);
  if (options.quiet)
    return exitFinished;
  out << bodiesAsText(summary, *scene) << loads << libraryUsesAsText(*scene, effectSchema());
  const Forecast forecast = makeForecast(simulation, *scene, ranks, setup);
  if (!forecast.rates.failure.empty())
  {
    err << "rhegma: " << (options.strict ? "" : "warning: ") << "in its first steps "
        << forecast.rates.failure << (options.strict ? " (an error by --strict)" : "") << "\n";
    return options.strict ? exitWrongScene : exitFinished;
  }
  out << asText(forecast) << "\n" << equilibriumAsText(*scene, ranks);
  printCostOfAccuracy(options, *scene, ranks, &forecast, start, out);
  return exitFinished;
}

/// Checks a scene, and draws it if the options say so, from the state that the check writes.
int checkAndDraw(Options options, const Teuchos::RCP<Teuchos::ParameterList>& scene, double start,
                 std::ostream& out, std::ostream& err)
{
  const Ranks ranks(world());
  std::optional<ScratchFolder> folder;
  try
  {
    if (!options.picture.empty() && options.state.empty() && !ranks.many())
      options.state = folder.emplace(ranks).path(); // empty: rhegma-plot asks the program for it
    const int code = checkScene(options, scene, start, out, err);
    out << std::flush; // before the output of the tool that draws
    return code == exitFinished && !options.picture.empty() ? drawScene(options, ranks, err) : code;
  }
  catch (const OutputError& error)
  {
    err << "rhegma: " << error.what()
        << (folder ? "; set TMPDIR to a folder with free space\n" : "; choose another folder with --state\n");
    return exitWrongScene;
  }
}

/// \param start as in checkScene \param beforeFiles called before the run changes files
int runScene(const Options& options, const Teuchos::RCP<Teuchos::ParameterList>& scene, double start,
             std::ostream& out, std::ostream& err, const std::function<void()>& beforeFiles)
{
  const Ranks ranks(world());
  const std::string folder = options.output.empty() ? defaultOutputFolder(options.scene) : options.output;
  if (options.action == Options::Action::Run) // before the work of making all
    onFirstRank<std::invalid_argument>(ranks, [&] { refuseFolderInUse(folder); });
  if (options.action == Options::Action::Run && !options.quiet && options.restart.empty())
  {
    out << sizeAsText(*scene) << libraryUsesAsText(*scene, effectSchema()) << std::flush;
    printCostOfAccuracy(options, *scene, ranks, nullptr, start, out);
  }
  Simulation simulation(world(), scene, !options.twice);
  const EarlierPart earlier = initialize(simulation, *scene, options, err);
  if (options.action == Options::Action::PrintPlan)
  {
    out << simulation.plan();
    return exitFinished;
  }
  std::set<std::string> printed;
  if ((!options.quiet || options.strict) &&
      !mayRun(options, reportBefore(simulation, *scene, 0), printed, err))
    return exitWrongScene;
  beforeFiles();
  Production production(options, *scene, simulation, earlier, out, ranks);
  std::string failure = production.runToEnd();
  if (production.folderIsLost()) // its files are those of another run
  {
    err << "rhegma: " << failure << "\n";
    return exitStopped;
  }
  nlohmann::json summary = summaryOf(options, *scene, simulation, production, failure);
  const bool within = addReferences(references(*scene), summary);
  if (ranks.rank() == 0) // whose files are there
    addStartForces(summary, production.folder() + "/history.csv");
  addAnswers(summary);
  const std::string unwritten = writeResults(summary, production, ranks);
  if (failure.empty())
    failure = unwritten;
  if (!options.quiet)
    out << (failure.empty() ? "Results are in " : "Results up to then are in ") << production.folder()
        << "\n";
  if (!options.quiet && failure.empty())
    out << referencesAsText(summary) << std::flush;
  printWarnings(summary, printed, err);
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
  else if (options.action == Action::New)
    return writeTemplate(options, out, err);
  else if (options.action == Action::Materials)
    out << (options.section.empty() ? materialsAsText() : materialAsXml(options.section));
  else if (options.action == Action::MaterialsMarkdown)
    out << materialsAsMarkdown();
  else
  {
    const double start = processorSeconds();
    const auto scene = validScene(options, err);
    if (scene.is_null())
      return exitWrongScene;
    try
    {
      if (options.action == Action::Check)
        return checkAndDraw(options, scene, start, out, err);
      const RunOne runOne = [&](const Options& one, const auto& list, const auto& beforeFiles)
      { return runScene(one, list, start, out, err, beforeFiles); };
      return options.twice ? runTwice(options, scene, Ranks(world()), out, err, runOne)
                           : runOne(options, scene, [] {});
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
