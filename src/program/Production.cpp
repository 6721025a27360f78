#include "program/Production.hpp"

#include "base/Numbers.hpp"
#include "base/OutputError.hpp"
#include "base/StopRequest.hpp"
#include "output/OutputFolder.hpp"
#include "parallel/FirstRank.hpp"
#include "plan/KnownEffects.hpp"
#include "plan/LastStage.hpp"
#include "program/ContinueOutput.hpp"
#include "program/Intervals.hpp"
#include "step/Run.hpp"

#include <algorithm>
#include <new>
#include <optional>
#include <unistd.h>

namespace Rhegma::program
{

namespace
{

/// How the message of a run begins that a signal stopped.
constexpr const char* stoppedBySignal = "the run was stopped by ";

/// Takes the folder for this run, on the first rank.
std::unique_ptr<RunLock> takeFolder(const std::string& folder, const std::string& scene, const Ranks& ranks)
{
  std::unique_ptr<RunLock> lock;
  onFirstRank<std::invalid_argument>(ranks,
                                     [&]
                                     {
                                       makeOutputFolder(folder);
                                       refuseForeignFiles(folder, scene);
                                       lock = std::make_unique<RunLock>(folder);
                                     });
  return lock;
}

/// Prepares the folder and opens the history in it; on all other ranks an empty one.
History beginHistory(const std::string& folder, const EarlierPart& earlier, const Ranks& ranks,
                     Manifest& manifest)
{
  std::optional<History> history;
  onFirstRank<std::invalid_argument>(ranks,
                                     [&]
                                     {
                                       if (!earlier.exists())
                                         removeOldResults(folder);
                                       else
                                         earlier.bring();
                                       manifest.write(earlier.history());
                                       const std::string path = folder + "/history.csv";
                                       if (earlier.history().bytes > 0)
                                         history.emplace(path, earlier.history());
                                       else
                                         history.emplace(path);
                                     });
  return history ? std::move(*history) : History("/dev/null");
}

} // namespace

Production::Production(const Options& options, const Teuchos::ParameterList& scene, Simulation& simulation,
                       const EarlierPart& earlier, std::ostream& out, const Ranks& ranks)
    : ranks_(ranks),
      folder_(options.output.empty() ? defaultOutputFolder(options.scene) : options.output),
      scene_(scene),
      simulation_(simulation),
      finalTime_(scene.sublist("Time").get<double>("Final Time")),
      lock_(takeFolder(folder_, options.scene, ranks)),
      manifest_(folder_, options.scene),
      history_(beginHistory(folder_, earlier, ranks, manifest_)),
      progress_(options.quiet ? nullptr : &out, finalTime_, isatty(STDOUT_FILENO) != 0),
      checkpoints_(scene, folder_, simulation, history_, ranks),
      retries_(isEquilibrium(scene) ? 0 : scene.sublist("Time").get<int>("Retries")),
      continued_(earlier.exists()),
      warnings_(earlier.warnings())
{
  const RunOptions run = declaredOptions(scene);
  if (run.endAtRest)
    progress_.stopsAtRest(run.endAtRest->energyRatio, run.endAtRest->drift, run.endAtRest->notBefore);
  progress_.setToughness(run.initiationToughness);
  if (run.growth && isEquilibrium(scene))
    progress_.showExtents();
  if (options.watch && ranks.rank() == 0)
  {
    progress_.follow();
    watch_ = std::make_unique<WatchPage>(folder_, options.scene, progress_);
  }
  observe();
  if (continued_)
    takeUpFiles();
}

void Production::takeUpFiles()
{
  const std::vector<std::string> found = continueOutput(scene_, simulation_, folder_, ranks_);
  warnings_.insert(warnings_.end(), found.begin(), found.end());
}

void Production::observe()
{
  simulation_.sampleEvery(historyInterval(scene_),
                          [this](double time, const Simulation::Row& row)
                          {
                            try
                            {
                              history_.write(time, row);
                              if (writesFronts(scene_, "With History"))
                                simulation_.writeFronts(folder_);
                              if (lock_ && manifest_.isDue())
                              {
                                history_.flush();
                                manifest_.write(history_.soFar());
                              }
                            }
                            catch (const OutputError& error)
                            {
                              unwritten_ = error.what();
                            }
                            progress_.sample(time, row);
                            if (watch_)
                              watch_->sample(time, row);
                            checkpoints_.afterSample();
                            if (unwritten_.empty())
                              unwritten_ = history_.whyLost();
                          });
  simulation_.onIteration(
      [this](int iteration, double residual)
      {
        progress_.iteration(loadStep(), iteration, residual);
        if (watch_)
          watch_->update();
      });
  simulation_.onStep(
      [this](double time, long step)
      {
        progress_.step(time, step);
        if (watch_)
          watch_->update();
        const bool byClock = stopIfRequested(time, step);
        checkpoints_.afterStep(byClock);
      });
}

long Production::loadStep() const
{
  constexpr double rounding = 1e-6; // equilibrium is restored a little before the end
  const bool atEnd = simulation_.steps() > 0 && simulation_.time() >= (1.0 - rounding) * finalTime_;
  const long step = simulation_.steps() + (atEnd ? 0 : 1);
  const Teuchos::ParameterList& time = scene_.sublist("Time");
  return step == 1 && time.isType<int>("Load Steps") && time.get<int>("Load Steps") == 1 ? 0 : step;
}

std::string Production::runToEnd()
{
  std::string failure = advanceToEnd();
  findLostFolder(failure);
  if (folderLost_)
    history_ = History("/dev/null"); // its last rows would be written into the file of another run
  else
    closeHistory(failure);
  progress_.finish();
  if (watch_ && !folderLost_)
    watch_->finish(failure);
  return ranks_.firstText(failure);
}

std::string Production::advanceToEnd()
try
{
  checkpoints_.afterSample();
  for (bool done = false; !done;)
    try
    {
      advanceFromFieldToField();
      done = true;
    }
    catch (const RunError& error)
    {
      if (!retry(error))
        throw;
    }
  onFirstRank<OutputError>(ranks_, [&] { history_.flush(); });
  checkpoints_.atEnd();
  // The state is whole, and the run may go on from it with another scene.
  const std::string reason = ranks_.firstText(simulation_.report(0).value("ended_by", std::string()));
  return reason.empty() ? reason : stoppedBy(reason) + checkpoints_.atStop();
}
catch (const StopRequested& stop)
{
  return stoppedWithin(stop.what());
}
catch (const RunError& error)
{
  const std::string failure = error.what();
  if (!stopRequested_)
    return failure + retries_.inVain() + checkpoints_.atFailure();
  // Otherwise the step for the last sample has failed.
  return failure.rfind(stoppedBySignal, 0) == 0 ? failure : failure + toGoOn_;
}
catch (const OutputError& error)
{
  return stoppedWithCheckpoint(error.what());
}
catch (const std::bad_alloc&)
{
  if (ranks_.many())
    throw;
  return stoppedWithCheckpoint("there is no memory left; use larger cells (Domain > Cell Size)");
}

std::string Production::stoppedWithin(const std::string& where)
{
  stopRequested_ = true;
  signalName_ = ranks_.firstText(signal_.name());
  // The state is not whole; a signal before the step has saved that before it.
  if (toGoOn_.empty())
    toGoOn_ = checkpoints_.atFailure();
  if (toGoOn_.empty())
    toGoOn_ = std::string(simulation_.steps() == 0 ? "; no load step is complete, so" : ";") +
              " there is no checkpoint";
  return stoppedBySignal + signalName_ + " " + where + toGoOn_;
}

std::string Production::stoppedWithCheckpoint(const std::string& reason)
{
  if (folderLost_)
    return stoppedBy(reason);
  return stoppedBy(reason) + (toGoOn_.empty() ? checkpoints_.atFailure() : toGoOn_);
}

void Production::closeHistory(std::string& failure)
try
{
  history_.close();
}
catch (const OutputError& error)
{
  if (failure.empty())
    failure = stoppedBy(error.what());
  else if (failure.find(error.what()) == std::string::npos)
    failure += std::string("; ") + error.what();
}

void Production::findLostFolder(std::string& failure)
{
  if (folderLost_)
    return;
  const std::string loss = lock_ ? lock_->loss() : std::string();
  folderLost_ = asFirstRank(ranks_, lock_ && !lock_->holds());
  if (folderLost_)
    failure = stoppedBy(loss);
}

bool Production::retry(const RunError& failure)
{
  if (stopRequested_ || !simulation_.holds() ||
      !retries_.mayHelp(failure.what(), simulation_.heldTime(), simulation_.time()))
    return false;
  const HistorySoFar soFar = readNotes(simulation_.goBack());
  onFirstRank<OutputError>(ranks_,
                           [&]
                           {
                             history_.sync();
                             manifest_.write(soFar); // before the file is shorter
                             history_ = History(folder_ + "/history.csv", soFar);
                           });
  retries_.setStepFraction(simulation_.stepFraction());
  checkpoints_.afterGoingBack();
  continued_ = true;
  takeUpFiles();
  warnings_.push_back(retries_.asText());
  return true;
}

std::string Production::listFiles()
{
  if (!lock_)
    return {};
  try
  {
    manifest_.write(history_.soFar(), true);
    return {};
  }
  catch (const std::exception& error) // also of the file system
  {
    return error.what();
  }
}

RunEnd Production::end(const std::string& failure) const
{
  if (!failure.empty())
    return stopRequested_ ? RunEnd::Signalled : RunEnd::Stopped;
  const bool outOfSteps = simulation_.time() < finalTime_ &&
                          simulation_.steps() >= scene_.sublist("Time").get<int>("Maximum Steps");
  return outOfSteps ? RunEnd::CutOff : RunEnd::Finished;
}

void Production::writeFrame()
{
  if (!scene_.sublist("Output").get<bool>("Fields"))
    return;
  simulation_.writeFields(folder_);
  if (writesFronts(scene_, "With Fields"))
    simulation_.writeFronts(folder_);
}

void Production::advanceFromFieldToField()
{
  const Teuchos::ParameterList& output = scene_.sublist("Output");
  const double interval = fieldInterval(scene_);
  // A multiple of the interval may be a rounding error short of the end: programs that read both frames take
  // them for one time.
  constexpr double rounding = 1e-12;
  const auto timeOf = [&](long k)
  {
    const double time = static_cast<double>(k) * interval;
    return time < (1.0 - rounding) * finalTime_ ? time : finalTime_;
  };
  if (output.isParameter("Field Interval") && simulation_.time() == 0.0)
    writeFrame();
  // A run that continues may have stopped between a step and its fields; existing fields are not written
  // again.
  bool pending = continued_;
  long k = std::max(1L, static_cast<long>(simulation_.time() / interval) - 1);
  while (static_cast<double>(k) * interval < simulation_.time())
    ++k;
  try
  {
    for (; pending || (simulation_.time() < finalTime_ && !simulation_.ended()); ++k)
    {
      pending = false;
      simulation_.advance(timeOf(k));
      writeFrame();
    }
  }
  catch (const StopRequested&) // within a step: the state is not whole
  {
    throw;
  }
  catch (const RunError&)
  {
    // A stopped run writes its last fields; an unstable step leaves no valid result.
    if (stopRequested_)
      writeFrame();
    throw;
  }
}

std::string Production::reasonToStop()
{
  if (lock_ && lock_->isDue())
    if (const std::string loss = lock_->loss(); !loss.empty())
      return (lock_->holds() ? "W" : "L") + loss;
  if (!unwritten_.empty())
    return "W" + unwritten_;
  if (const std::string signal = signal_.name(); !signal.empty())
    return "S" + signal;
  return ranks_.rank() == 0 && checkpoints_.isTime() ? "C" : "";
}

bool Production::stopIfRequested(double time, long step)
{
  if (stopRequested_)
    stopBySignal(time, step);
  const std::string why = ranks_.firstText(reasonToStop()); // one reduction for all reasons
  folderLost_ = !why.empty() && why[0] == 'L';
  if (!folderLost_ && !why.empty() && why[0] == 'W')
    toGoOn_ = checkpoints_.atStop(); // the state is whole
  if (folderLost_ || (!why.empty() && why[0] == 'W'))
    throw OutputError(why.substr(1));
  stopRequested_ = !why.empty() && why[0] == 'S';
  if (stopRequested_)
  {
    signalName_ = why.substr(1);
    toGoOn_ = checkpoints_.atStop(); // before the extra sample, which the run that continues has not
    if (!simulation_.sampleNextStep())
      stopBySignal(time, step);
    return false;
  }
  return !why.empty();
}

void Production::stopBySignal(double time, long step)
{
  onFirstRank<OutputError>(ranks_, [&] { history_.write(time, simulation_.observe()); });
  if (writesFronts(scene_, "With History"))
    simulation_.writeFronts(folder_);
  throw RunError(stoppedBySignal + signalName_ + " at t = " + readableTime(time) + ", step " +
                 std::to_string(step) + toGoOn_);
}

std::string Production::stoppedBy(const std::string& reason) const
{
  return "the run stopped at t = " + readableTime(simulation_.time()) + ", step " +
         std::to_string(simulation_.steps()) + ": " + reason;
}

} // namespace Rhegma::program
