#pragma once
/// The largest energy release rate of each front during a run.

#include "energy_release/FrontSample.hpp"

#include <map>
#include <utility>
#include <vector>

namespace Rhegma::energy_release
{

/// The largest G_J (in 3D the largest mean along the front) of all samples of a run, and when it was: under a
/// load that is not steady, the last G says little about whether a crack runs.
class LargestRelease
{
public:
  struct Peak
  {
    double release; ///< [J/m2]
    double time;    ///< [s]
  };

  /// \param samples of all fronts \param time of them [s]
  template <int D>
  void add(const std::vector<FrontSample<D>>& samples, double time);

  /// Of a front; a release that is not a number where it has had none. \param crack, number of the front
  Peak of(int crack, int number) const;

  /// Of all fronts [J/m2]; zero where there is none.
  double ever() const;

  /// Saves or loads it.
  void serialize(Archive& archive);

private:
  std::map<std::pair<int, int>, Peak> peaks_;
};

} // namespace Rhegma::energy_release
