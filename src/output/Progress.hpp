#pragma once
/// The progress line of a run.

#include <functional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace Rhegma
{

/// On a terminal one line that is overwritten a few times a second; elsewhere a line each tenth of the run.
/// Percent done, time left, step, and G of the first crack front where samples have it.
class Progress
{
public:
  using Row = std::vector<std::pair<std::string, double>>;
  /// Seconds from any start.
  using Clock = std::function<double()>;

  /// \param stream null: no output \param finalTime [s]
  Progress(std::ostream* stream, double finalTime, bool terminal);
  Progress(std::ostream* stream, double finalTime, bool terminal, Clock clock);

  /// A new sample of the history; the first column that ends in .G_J is shown.
  void sample(const Row& row);

  /// A step has been taken. \param time [s]
  void step(double time, long step);

  /// Prints where the run ended, unless that was just printed, and ends the line.
  void finish();

private:
  std::string line(double done, bool running) const;
  void print(bool running);

  std::ostream* stream_;
  double finalTime_;
  bool terminal_;
  Clock clock_;
  double startClock_;
  double startTime_ = 0.0; ///< where a continued run began [s]
  bool begun_ = false;
  double time_ = 0.0;
  long step_ = 0;
  bool hasG_ = false;
  double g_ = 0.0; ///< [J/m2]
  double lastPrint_;
  int lastTenth_ = 0;
  std::size_t width_ = 0; ///< of the line on the terminal
  bool open_ = false;
  bool stale_ = false; ///< steps were taken since the line was printed
};

} // namespace Rhegma
