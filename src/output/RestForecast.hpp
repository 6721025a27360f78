#pragma once
/// When a damped run will be at rest, by the samples so far.

#include <string>
#include <utility>
#include <vector>

namespace Rhegma
{

/// Follows what Damping's criterion of a settled run looks at: kinetic over strain energy, and the first
/// energy release rate (the strain energy where a sample has none).
class RestForecast
{
public:
  using Row = std::vector<std::pair<std::string, double>>;

  /// \param ratio Damping > Settled Energy Ratio \param drift Damping > Settled Drift
  RestForecast(double ratio, double drift) : ratio_(ratio), drift_(drift) {}

  /// \param time of the sample [s]
  void sample(double time, const Row& row);

  /// Time until both criteria hold, counted from the last sample [s]; infinity where that is not known yet.
  double left() const;

private:
  double ratio_, drift_;
  double interval_ = 0.0, time_ = 0.0; ///< [s]
  std::vector<double> ratios_, watched_;
};

} // namespace Rhegma
