#pragma once
/// watch.html: a page of a run that goes on, which reloads itself in a browser.

#include "output/Progress.hpp"
#include "output/SmallPlot.hpp"

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace Rhegma
{

/// Keeps watch.html in the folder of a run: the progress line, the last values of the fronts and of the
/// energy balance, and plots of both over time. The page needs no other file, no network and no script. It is
/// replaced at once, at most every two seconds. Where it can't be written, the run goes on without it.
class WatchPage
{
public:
  using Row = Progress::Row;
  using Clock = Progress::Clock;

  /// Writes the first page, with the samples of history.csv in the folder, of a run that continues.
  /// \param folder of the output \param scene path of its file \param progress must outlive this
  WatchPage(const std::string& folder, const std::string& scene, const Progress& progress);
  WatchPage(const std::string& folder, const std::string& scene, const Progress& progress, Clock clock);

  /// Adds a sample to the plots. \param time [s] \param row of the history
  void sample(double time, const Row& row);

  /// Replaces the page if that is due.
  void update();

  /// Replaces the page by its last one, which does not reload. \param failure why the run failed; empty if it
  /// did not
  void finish(const std::string& failure);

private:
  void readHistory(const std::string& path);
  void write(const std::string& status, bool goesOn);
  std::string page(const std::string& status, bool goesOn) const;
  std::string table() const;

  std::string folder_, scene_;
  const Progress& progress_;
  Clock clock_;
  double written_; ///< when, by the clock [s]
  bool lost_ = false;
  SmallPlot releases_, energies_;
  std::vector<std::pair<std::string, double>> last_; ///< values for the table
  double time_ = 0.0;                                ///< of the last sample [s]
};

} // namespace Rhegma
