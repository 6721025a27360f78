#pragma once
/// A run from its first step to its last, with its files and its progress.

#include "Simulation.hpp"
#include "output/History.hpp"
#include "output/Manifest.hpp"
#include "output/Progress.hpp"
#include "output/RunLock.hpp"
#include "output/WatchPage.hpp"
#include "parallel/Ranks.hpp"
#include "program/Checkpoints.hpp"
#include "program/EarlierPart.hpp"
#include "program/Options.hpp"
#include "program/Retries.hpp"
#include "program/RunEnd.hpp"
#include "program/StopSignal.hpp"

#include <iosfwd>
#include <memory>
#include <string>

namespace Rhegma::program
{

class Production
{
public:
  /// Makes the output folder and removes the files of an older run there; if the run continues, the output
  /// after the checkpoint. Throws std::invalid_argument when the folder can't be used.
  /// \param scene   validated; must outlive this
  /// \param earlier output of the run before its checkpoint
  /// \param out     for the progress line
  /// \param ranks   of the run; the first of them writes the files
  Production(const Options& options, const Teuchos::ParameterList& scene, Simulation& simulation,
             const EarlierPart& earlier, std::ostream& out, const Ranks& ranks);

  /// The output folder.
  const std::string& folder() const { return folder_; }

  /// Steps to the final time, to where the run has settled or to Time > Maximum Steps. The files then contain
  /// all rows and fields up to the last step, also after a failure.
  /// \return why the run failed; empty if it did not
  std::string runToEnd();

  const Checkpoints::Cost& costOfCheckpoints() const { return checkpoints_.cost(); }

  /// Warnings on the start of the run.
  const std::vector<std::string>& warnings() const { return warnings_; }

  /// To be called when all files are written: lists them with their checksums. \return why that could not be
  /// written; empty: it was
  std::string listFiles();

  /// Whether another run has taken the folder: nothing may be written there any more.
  bool folderIsLost() const { return folderLost_; }

  /// How the run ended. \param failure that runToEnd() returned
  RunEnd end(const std::string& failure) const;

private:
  void observe();
  /// Number of the load step that is being solved, from 1; 0: the only one.
  long loadStep() const;
  /// Continues the files of the run before its checkpoint.
  void takeUpFiles();
  /// Writes the fields and, with them, the values along fronts, as far as the scene asks for them.
  void writeFrame();
  void advanceFromFieldToField();
  /// \return why the run failed, with how it continues; empty if it did not
  std::string advanceToEnd();
  /// Writes the last rows. \param failure gets why they could not be written
  void closeHistory(std::string& failure);
  /// Continues after a failure with shorter steps. \return whether that may help
  bool retry(const RunError& failure);
  /// Throws where a signal or a file that can't be written, on any rank, ends the run. Where the step of a
  /// signal was not sampled, the run ends after one more, so that the history and the summary are of the same
  /// time as the last fields. \return whether a checkpoint is due by the clock
  bool stopIfRequested(double time, long step);
  /// Throws what ends a run that a signal has stopped, with the last row of its history.
  [[noreturn]] void stopBySignal(double time, long step);
  /// Ends a run that a signal has stopped within a load step, which is lost. \param where of the step
  std::string stoppedWithin(const std::string& where);
  std::string stoppedBy(const std::string& reason) const;
  /// The same, with how the run continues.
  std::string stoppedWithCheckpoint(const std::string& reason);
  /// Why the run must stop after this step, after a letter for the kind of reason; of this rank.
  std::string reasonToStop();
  /// The last look whether the folder is this run's; the same on all ranks. \param failure gets the loss
  void findLostFolder(std::string& failure);

  Ranks ranks_;
  std::string folder_;
  const Teuchos::ParameterList& scene_;
  Simulation& simulation_;
  double finalTime_;
  StopSignal signal_;             ///< first of what makes files: with any of them the run can be stopped
  std::unique_ptr<RunLock> lock_; ///< of the first rank
  Manifest manifest_;             ///< of the first rank
  History history_;
  Progress progress_;
  std::unique_ptr<WatchPage> watch_; ///< of the first rank, if it is asked for
  std::string unwritten_;            ///< why the history could not be written
  bool folderLost_ = false;          ///< another run has taken the folder; the same on all ranks
  bool stopRequested_ = false;       ///< a signal to some rank has ended the run
  std::string signalName_;           ///< of the signal that has stopped the run
  std::string toGoOn_;               ///< how a run that a signal has stopped continues
  Checkpoints checkpoints_;
  Retries retries_;
  bool continued_;
  std::vector<std::string> warnings_;
};

} // namespace Rhegma::program
