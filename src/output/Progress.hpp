#pragma once
/// The progress line of a run.

#include "output/RestForecast.hpp"
#include "output/SampleFigures.hpp"

#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace Rhegma
{

/// On a terminal one line that is overwritten a few times a second; elsewhere a line in the first seconds and
/// one each tenth of the run. Percent done, time left, step, and of the last sample G of each front (of
/// more than four the largest), over their toughness where that is known, how far cracks have come if
/// asked to, and the residual of the energy balance. Time left is by the pace of the last quarter to half of
/// the run so far.
class Progress
{
public:
  using Row = std::vector<std::pair<std::string, double>>;
  /// Seconds from any start.
  using Clock = std::function<double()>;

  /// \param stream null: no output \param finalTime [s]
  Progress(std::ostream* stream, double finalTime, bool terminal);
  Progress(std::ostream* stream, double finalTime, bool terminal, Clock clock);

  /// The run stops once it is at rest: says when that will be. Call before the first sample.
  /// \param ratio, drift  of Damping's criterion \param notBefore time from which on samples count [s]
  void stopsAtRest(double ratio, double drift, double notBefore = 0.0)
  {
    rest_.emplace(ratio, drift);
    notBefore_ = notBefore;
  }

  /// Shows G over the toughness at which fronts initiate [J/m2], where they grow.
  void setToughness(std::optional<double> toughness) { toughness_ = toughness; }

  /// Shows the lengths of cracks, in 3D their areas, as that of more than four the largest.
  void showExtents() { showsExtents_ = true; }

  /// Follows the pace of the run though nothing is printed, for text().
  void follow() { followed_ = true; }

  /// What the line says now. \param running whether time is left
  std::string text(bool running = true) const;

  double finalTime() const { return finalTime_; } ///< of the scene [s]
  /// Fraction of the run that is done.
  double done() const { return finalTime_ > 0.0 ? time_ / finalTime_ : 1.0; }

  /// A new sample of the history. \param time [s]
  void sample(double time, const Row& row);

  /// A step has been taken. \param time [s]
  void step(double time, long step);

  /// A load step is being solved: every few seconds says how far it is. \param step its number, from 1; 0:
  /// the run has only one \param iteration of Newton's method, from 0 \param residual before it, as a
  /// fraction of the forces
  void iteration(long step, int iteration, double residual);

  /// Prints where the run ended, unless that was just printed, and ends the line.
  void finish();

private:
  std::string timeLeft() const;
  std::string releaseText() const;
  std::string extentText() const;
  void followPace(double now);
  void print(bool running);
  void write(std::string text);

  /// How far the run was, and when.
  struct Mark
  {
    double clock = 0.0, time = 0.0;
  };

  std::ostream* stream_;
  double finalTime_;
  bool terminal_;
  Clock clock_;
  double startClock_;
  double startTime_ = 0.0; ///< where a continued run began [s]
  Mark older_, newer_;     ///< the pace is that since the older one
  std::optional<RestForecast> rest_;
  double notBefore_ = 0.0; ///< [s]
  bool early_ = false;     ///< the line of the first seconds is printed
  bool begun_ = false;
  double time_ = 0.0;
  long step_ = 0;
  bool followed_ = false;
  std::optional<double> toughness_; ///< of initiation [J/m2]
  std::vector<double> releases_;    ///< of the fronts in the last sample [J/m2]
  bool showsExtents_ = false;
  CrackExtents extents_;           ///< of the last sample
  std::optional<double> residual_; ///< of the last sample, over the largest energy
  double lastPrint_;
  double lastIteration_; ///< when an iteration was printed, or the last step was taken
  int lastTenth_ = 0;
  std::size_t width_ = 0; ///< of the line on the terminal
  bool open_ = false;
  bool stale_ = false; ///< steps were taken since the line was printed
};

} // namespace Rhegma
