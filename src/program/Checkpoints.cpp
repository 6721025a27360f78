#include "program/Checkpoints.hpp"

#include "base/Numbers.hpp"
#include "base/OutputError.hpp"
#include "parallel/FirstRank.hpp"
#include "plan/LastStage.hpp"
#include "program/Intervals.hpp"

#include <cmath>
#include <new>
#include <stdexcept>

namespace Rhegma::program
{

namespace
{

/// A copy in memory is made when the time since the last one is this multiple of its cost.
constexpr int timeBetweenCopies = static_cast<int>(1.0 / costOfCopies);

/// Copies that a run makes so that a short one that fails is not lost as a whole, and the time that they may
/// take together [s].
constexpr double copiesAtLeast = 5.0, secondsOfCopies = 0.1;

} // namespace

Checkpoints::Checkpoints(const Teuchos::ParameterList& scene, const std::string& folder,
                         Simulation& simulation, History& history, const Ranks& ranks)
    : wanted_(scene.sublist("Output").get<bool>("Checkpoints")),
      afterEachStep_(isEquilibrium(scene)),
      interval_(checkpointInterval(scene)),
      minutes_(checkpointMinutes(scene)),
      path_(folder + "/checkpoint.h5"),
      simulation_(simulation),
      history_(history),
      ranks_(ranks),
      next_(interval_ > 0.0 ? interval_ * (std::floor(simulation.time() / interval_) + 1.0) : 0.0),
      lastWrite_(Clock::now()),
      nextHold_(lastWrite_),
      longestWithoutCopy_((scene.sublist("Time").get<double>("Final Time") - simulation.time()) /
                          copiesAtLeast)
{
}

void Checkpoints::afterSample()
{
  const Clock::time_point begin = Clock::now();
  if (!wanted_ || !asFirstRank(ranks_, copyIsDue(begin) && simulation_.sound() && historyIsWritten()))
    return;
  copied_ = history_.soFar();
  simulation_.hold(notesOf(copied_));
  const Clock::time_point end = Clock::now();
  nextHold_ = end + timeBetweenCopies * (end - begin);
  ++cost_.copies;
  secondsOfCopies_ += std::chrono::duration<double>(end - begin).count();
  cost_.seconds += std::chrono::duration<double>(end - begin).count();
}

bool Checkpoints::copyIsDue(Clock::time_point now) const
{
  const bool isFree =
      cost_.copies < 2 || secondsOfCopies_ < secondsOfCopies; // the second: the first after the start
  const double since = simulation_.time() - simulation_.heldTime();
  return now >= nextHold_ || (isFree && (afterEachStep_ ? since > 0.0 : since >= longestWithoutCopy_));
}

bool Checkpoints::historyIsWritten()
try
{
  history_.flush();
  return true;
}
catch (const OutputError&) // the run stops for it at the end of the step
{
  return false;
}

bool Checkpoints::isTime() const
{
  return wanted_ && minutes_ > 0.0 &&
         Clock::now() - lastWrite_ >= std::chrono::duration<double>(60.0 * minutes_);
}

void Checkpoints::afterStep(bool byClock)
{
  if (afterEachStep_)
    afterSample();
  const bool byTime = interval_ > 0.0 && simulation_.time() >= next_;
  if (!wanted_ || !(byTime || byClock))
    return;
  while (interval_ > 0.0 && next_ <= simulation_.time())
    next_ += interval_;
  lastWrite_ = Clock::now();
  if (sound())
    write();
}

bool Checkpoints::sound() const { return asFirstRank(ranks_, simulation_.sound()); }

void Checkpoints::atEnd()
{
  if (wanted_ && interval_ > 0.0 && written_ != simulation_.time() && sound())
    write();
}

void Checkpoints::write()
{
  const Clock::time_point begin = Clock::now();
  // The history first: a checkpoint without its history would be less useful.
  onFirstRank<OutputError>(ranks_, [&] { history_.sync(); });
  simulation_.checkpoint(path_, notesOf(history_.soFar()));
  written_ = simulation_.time();
  lastWrite_ = Clock::now();
  ++cost_.written;
  cost_.seconds += std::chrono::duration<double>(lastWrite_ - begin).count();
}

void Checkpoints::afterGoingBack()
{
  const double time = simulation_.time();
  if (interval_ > 0.0)
    next_ = interval_ * (std::floor(time / interval_) + 1.0);
  if (written_ > time) // of a part of the run that was repeated
    write();
}

std::string Checkpoints::atStop()
{
  // Without rows of the history only an earlier state can be continued.
  if (!wanted_ || asFirstRank(ranks_, !history_.whyLost().empty()) || !sound())
    return atFailure();
  if (!isAhead(simulation_.time()))
    return whereToGoOn();
  try
  {
    write();
  }
  catch (const OutputError& error)
  {
    return whereToGoOn() + "; its state could not be saved: " + error.what();
  }
  return whereToGoOn();
}

void Checkpoints::writeCopy()
{
  onFirstRank<OutputError>(ranks_, [&] { history_.syncBeginning(copied_.bytes); });
  simulation_.checkpointHeld(path_);
  written_ = simulation_.heldTime();
}

std::string Checkpoints::atFailure()
{
  if (!wanted_)
    return {};
  std::string why;
  try
  {
    if (simulation_.holds() && isAhead(simulation_.heldTime()))
      writeCopy();
    else if (written_ < 0.0)
      why = whyNone();
  }
  catch (const std::bad_alloc&)
  {
    why = "there is no memory left";
  }
  catch (const std::exception& error) // the older one, if any, stays
  {
    why = error.what();
  }
  if (why.empty())
    return whereToGoOn();
  return whereToGoOn() + "; no " + (written_ < 0.0 ? "" : "later ") + "checkpoint could be written: " + why;
}

std::string Checkpoints::whyNone() const
{
  if (simulation_.holds())
    return simulation_.time() > longestWithoutCopy_ ? "no state after the start was copied" : "";
  return history_.whyLost().empty() ? "the energy balance was never sound" : history_.whyLost();
}

std::string Checkpoints::whereToGoOn() const
{
  if (written_ < 0.0)
    return {};
  const std::string folder = path_.substr(0, path_.rfind('/'));
  return "; --output " + folder + " --restart " + path_ + " continues from t = " + readableTime(written_);
}

Simulation::Notes notesOf(const HistorySoFar& soFar)
{
  return {{"history_bytes", std::to_string(soFar.bytes)},
          {"history_crc", std::to_string(soFar.crc)},
          {"history_last_time", formatExactly(soFar.lastTime)}};
}

HistorySoFar readNotes(const Simulation::Notes& notes)
{
  HistorySoFar soFar;
  if (notes.count("history_bytes") == 0) // written by an application
    return soFar;
  soFar.bytes = std::stoll(notes.at("history_bytes"));
  soFar.crc = std::stoul(notes.at("history_crc"));
  soFar.lastTime = std::stod(notes.at("history_last_time"));
  return soFar;
}

} // namespace Rhegma::program
