#include "program/RunScene.hpp"

#include "Simulation.hpp"
#include "output/History.hpp"
#include "output/OutputFolder.hpp"
#include "output/Progress.hpp"
#include "output/References.hpp"
#include "output/Summary.hpp"
#include "scene/Scene.hpp"
#include "step/EffectSchema.hpp"
#include "step/Run.hpp"

#include <Kokkos_Core.hpp>
#include <Teuchos_DefaultMpiComm.hpp>

#include <iostream>
#include <optional>
#include <unistd.h>

namespace Rhegma::program
{

namespace
{

Teuchos::RCP<const Teuchos::Comm<int>> world()
{
  return Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD));
}

void printErrors(const std::vector<SceneError>& errors, std::ostream& err)
{
  for (const SceneError& error : errors)
    err << "rhegma: " << (error.where.empty() ? "" : error.where + ": ") << error.message << "\n";
}

/// A validated scene, or nothing after its errors have been printed.
Teuchos::RCP<Teuchos::ParameterList> validScene(const Options& options, std::ostream& err)
{
  const SceneResult result = readScene(options.scene, options.overrides, effectSchema());
  if (result.errors.empty())
    return result.list;
  printErrors(result.errors, err);
  return Teuchos::null;
}

double historyInterval(const Teuchos::ParameterList& scene)
{
  const Teuchos::ParameterList& output = scene.sublist("Output");
  return output.isParameter("History Interval") ? output.get<double>("History Interval")
                                                : scene.sublist("Time").get<double>("Final Time") / 200.0;
}

/// Runs from field output to field output.
class Production
{
public:
  Production(const Options& options, const Teuchos::ParameterList& scene, Simulation& simulation,
             std::ostream& out)
      : folder_(options.output.empty() ? defaultOutputFolder(options.scene) : options.output),
        scene_(scene),
        simulation_(simulation),
        finalTime_(scene.sublist("Time").get<double>("Final Time")),
        history_(makeOutputFolder(folder_) + "/history.csv"),
        progress_(options.quiet ? nullptr : &out, finalTime_, isatty(STDOUT_FILENO) != 0)
  {
    simulation_.sampleEvery(historyInterval(scene),
                            [this](double time, const Simulation::Row& row)
                            {
                              history_.write(time, row);
                              progress_.sample(row);
                            });
    simulation_.onStep([this](double time, long step) { progress_.step(time, step); });
  }

  const std::string& folder() const { return folder_; }

  void toTheEnd()
  {
    const Teuchos::ParameterList& output = scene_.sublist("Output");
    const bool fields = output.get<bool>("Fields");
    const double interval =
        output.isParameter("Field Interval") ? output.get<double>("Field Interval") : finalTime_;
    if (fields && output.isParameter("Field Interval"))
      simulation_.writeFields(folder_);
    for (int k = 1; simulation_.time() < finalTime_ && !simulation_.ended(); ++k)
    {
      simulation_.advance(std::min(k * interval, finalTime_));
      if (fields)
        simulation_.writeFields(folder_);
    }
    history_.close();
    progress_.finish();
  }

private:
  std::string folder_;
  const Teuchos::ParameterList& scene_;
  Simulation& simulation_;
  double finalTime_;
  History history_;
  Progress progress_;
};

SummaryFacts facts(const Options& options, const Simulation& simulation, double wallSeconds,
                   const std::string& status)
{
  SummaryFacts f;
  f.scene = options.scene;
  f.ranks = 1;
  f.threads = Kokkos::DefaultExecutionSpace().concurrency();
  f.backend = Kokkos::DefaultExecutionSpace::name();
  f.effects = simulation.effects();
  f.steps = simulation.steps();
  f.time = simulation.time();
  f.wallSeconds = wallSeconds;
  f.particles = simulation.particles();
  f.particleSteps = simulation.particleSteps();
  f.stages = simulation.stageSeconds();
  f.settled = simulation.settled();
  f.status = status;
  return f;
}

int runScene(const Options& options, const Teuchos::RCP<Teuchos::ParameterList>& scene, std::ostream& out,
             std::ostream& err)
{
  Kokkos::Timer timer;
  Simulation simulation(world(), scene);
  simulation.initialize();
  if (options.action == Options::Action::PrintPlan)
  {
    out << simulation.plan();
    return exitFinished;
  }
  Production production(options, *scene, simulation, out);
  std::string trouble;
  try
  {
    production.toTheEnd();
  }
  catch (const RunError& error)
  {
    trouble = error.what();
  }
  nlohmann::json summary =
      makeSummary(facts(options, simulation, timer.seconds(), trouble.empty() ? "finished" : trouble),
                  simulation.report());
  const bool within = addReferences(scene->sublist("Reference"), summary);
  writeSummary(summary, production.folder() + "/summary.json");
  for (const auto& warning : summary["warnings"])
    err << "rhegma: warning: " << warning.get<std::string>() << "\n";
  if (!trouble.empty())
  {
    err << "rhegma: " << trouble << "\n";
    return exitStopped;
  }
  if (!options.quiet)
    out << "Results are in " << production.folder() << "\n" << referencesInWords(summary);
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
      {
        Simulation simulation(world(), scene);
        simulation.initialize();
        out << options.scene << " is a valid scene\n";
        return exitFinished;
      }
      return runScene(options, scene, out, err);
    }
    catch (const std::invalid_argument& error)
    {
      err << "rhegma: " << error.what() << "\n";
      return exitWrongScene;
    }
  }
  return exitFinished;
}

} // namespace Rhegma::program
