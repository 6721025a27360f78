#pragma once
/// When a run writes checkpoints, and of which state.

#include "Simulation.hpp"
#include "output/History.hpp"
#include "parallel/Ranks.hpp"

#include <Teuchos_ParameterList.hpp>

#include <chrono>
#include <string>

namespace Rhegma::program
{

/// What copies of the state in memory may take of a run [-].
constexpr double costOfCopies = 1.0 / 400.0;

/// Writes checkpoint.h5 in the output folder: at intervals of simulated time and of the clock (section
/// Output), where a signal stops the run, before the run ends in failure, and at its end where an interval of
/// simulated time is given.
///
/// A failure is detected within a step, when the state is inconsistent, and its cause may be much earlier.
/// Therefore a copy of the state is stored in memory at samples with a sound energy balance, as often as
/// costOfCopies allows and, in short runs, at each fifth of the simulated time (in equilibrium after each
/// load step); it is written when the run fails. Load steps of equilibrium may take long, and a signal stops
/// a run within them: there each step may end with a copy. The history up to a copy is in its file before the
/// copy is made, so that the copy can be used when later rows can't be written.
class Checkpoints
{
public:
  /// \param scene validated \param ranks of the run: every call is collective, the first rank reads the clock
  /// and writes
  Checkpoints(const Teuchos::ParameterList& scene, const std::string& folder, Simulation& simulation,
              History& history, const Ranks& ranks);

  /// To be called when the run begins and at each sample. Where the history can't be written, no copy is made
  /// (History::whyLost).
  void afterSample();
  /// Whether a checkpoint is due by the clock.
  bool isTime() const;
  /// To be called after each step. \param byClock whether one is due by the clock, the same on all ranks
  /// Throws OutputError when a checkpoint can't be written.
  void afterStep(bool byClock);
  /// To be called at the end of the run.
  void atEnd();

  /// To be called when the run has gone back to the copy in memory. Throws OutputError when a checkpoint
  /// can't be written.
  void afterGoingBack();

  /// Writes the current state, or, if it is not sound, the last sound one; nothing before the first step,
  /// where a checkpoint would spare nothing.
  /// \return text to append to the message that the run stopped; begins with "; ", or is empty
  std::string atStop();
  /// Writes the last sound state. \return the same; where it can't be written, or there is none, the reason
  std::string atFailure();

  /// Checkpoints written, copies taken, and the seconds that both took.
  struct Cost
  {
    int written = 0, copies = 0;
    double seconds = 0.0;
  };
  const Cost& cost() const { return cost_; }

private:
  using Clock = std::chrono::steady_clock;

  /// Simulation::sound, the same on all ranks.
  bool sound() const;
  /// Whether the time for a copy has come; of the first rank.
  bool copyIsDue(Clock::time_point now) const;
  /// Whether all rows of the history are in its file; of the first rank.
  bool historyIsWritten();
  /// Whether a state at this time would spare a step to who continues from it.
  bool isAhead(double time) const { return time > written_ && time > 0.0; }
  void write();
  void writeCopy();
  /// Why no checkpoint can be written of a run that has written none; empty where none was due.
  std::string whyNone() const;
  std::string whereToGoOn() const;

  bool wanted_;
  bool afterEachStep_; ///< copies, and not only at samples
  double interval_;    ///< 0: none
  double minutes_;     ///< 0: none
  std::string path_;
  Simulation& simulation_;
  History& history_;
  Ranks ranks_;
  double next_;                 ///< time of the next one [s]
  HistorySoFar copied_;         ///< history of the copy in memory
  double written_ = -1.0;       ///< time of the last one on the disk [s]; negative: none
  Clock::time_point lastWrite_; ///< or the start
  Clock::time_point nextHold_;  ///< no copy before, but at fifths of the run
  double longestWithoutCopy_;   ///< a fifth of the run [s]
  double secondsOfCopies_ = 0.0;
  Cost cost_;
};

/// The checkpoint's notes on the history.
Simulation::Notes notesOf(const HistorySoFar& soFar);
HistorySoFar readNotes(const Simulation::Notes& notes);

} // namespace Rhegma::program
