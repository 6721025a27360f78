#include "program/Production.hpp"

#include "output/OutputError.hpp"
#include "output/OutputFolder.hpp"
#include "parallel/FirstRank.hpp"
#include "scene/Numbers.hpp"
#include "step/Run.hpp"

#include <algorithm>
#include <new>
#include <unistd.h>

namespace Rhegma::program
{

namespace
{

/// \return the history's file; on all ranks but the first one that holds nothing
std::string emptyOutputFolder(const std::string& folder, const Ranks& ranks)
{
  onFirstRank<std::invalid_argument>(ranks,
                                     [&]
                                     {
                                       makeOutputFolder(folder);
                                       removeOldResults(folder);
                                     });
  return ranks.rank() == 0 ? folder + "/history.csv" : "/dev/null";
}

double historyInterval(const Teuchos::ParameterList& scene)
{
  const Teuchos::ParameterList& output = scene.sublist("Output");
  return output.isParameter("History Interval") ? output.get<double>("History Interval")
                                                : scene.sublist("Time").get<double>("Final Time") / 200.0;
}

} // namespace

Production::Production(const Options& options, const Teuchos::ParameterList& scene, Simulation& simulation,
                       std::ostream& out, const Ranks& ranks)
    : ranks_(ranks),
      folder_(options.output.empty() ? defaultOutputFolder(options.scene) : options.output),
      scene_(scene),
      simulation_(simulation),
      finalTime_(scene.sublist("Time").get<double>("Final Time")),
      history_(emptyOutputFolder(folder_, ranks)),
      progress_(options.quiet ? nullptr : &out, finalTime_, isatty(STDOUT_FILENO) != 0)
{
  observe();
}

void Production::observe()
{
  simulation_.sampleEvery(historyInterval(scene_),
                          [this](double time, const Simulation::Row& row)
                          {
                            try
                            {
                              history_.write(time, row);
                            }
                            catch (const OutputError& error)
                            {
                              unwritten_ = error.what();
                            }
                            progress_.sample(row);
                          });
  simulation_.onStep(
      [this](double time, long step)
      {
        progress_.step(time, step);
        stopIfAsked(time, step);
      });
}

std::string Production::toTheEnd()
{
  std::string trouble;
  try
  {
    advanceFromFieldToField();
  }
  catch (const RunError& error)
  {
    trouble = error.what();
  }
  catch (const OutputError& error)
  {
    trouble = stoppedBy(error.what());
  }
  catch (const std::bad_alloc&)
  {
    if (ranks_.many())
      throw;
    trouble = stoppedBy("there is no memory left; take larger cells (Domain > Cell Size)");
  }
  try
  {
    history_.close();
  }
  catch (const OutputError& error)
  {
    if (trouble.empty())
      trouble = stoppedBy(error.what());
  }
  progress_.finish();
  return ranks_.firstText(trouble);
}

bool Production::outOfSteps() const
{
  return simulation_.time() < finalTime_ &&
         simulation_.steps() >= scene_.sublist("Time").get<int>("Maximum Steps");
}

void Production::advanceFromFieldToField()
{
  const Teuchos::ParameterList& output = scene_.sublist("Output");
  const bool fields = output.get<bool>("Fields");
  const double interval =
      output.isParameter("Field Interval") ? output.get<double>("Field Interval") : finalTime_;
  if (fields && output.isParameter("Field Interval"))
    simulation_.writeFields(folder_);
  try
  {
    for (long k = 1; simulation_.time() < finalTime_ && !simulation_.ended(); ++k)
    {
      simulation_.advance(std::min(static_cast<double>(k) * interval, finalTime_));
      if (fields)
        simulation_.writeFields(folder_);
    }
  }
  catch (const RunError&)
  {
    // Who stops a run wants to see how far it came; what an unstable step left is no result.
    if (fields && !ranks_.firstText(signal_.name()).empty())
      simulation_.writeFields(folder_);
    throw;
  }
}

void Production::stopIfAsked(double time, long step) const
{
  const std::string unwritten = ranks_.firstText(unwritten_);
  if (!unwritten.empty())
    throw OutputError(unwritten);
  const std::string signal = ranks_.firstText(signal_.name());
  if (!signal.empty())
    throw RunError("the run was stopped by " + signal + " at time " + formatReal(time) + " s, step " +
                   std::to_string(step));
}

std::string Production::stoppedBy(const std::string& reason) const
{
  return "the run stopped at time " + formatReal(simulation_.time()) + " s, step " +
         std::to_string(simulation_.steps()) + ": " + reason;
}

} // namespace Rhegma::program
