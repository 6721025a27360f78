#pragma once
/// How close cracks that do not grow come to a toughness.

#include "energy_release/FrontSample.hpp"
#include "plan/RunOptions.hpp"
#include "state/State.hpp"

#include <map>
#include <utility>
#include <vector>

namespace Rhegma::energy_release
{

/// Compares the energy release rate of all samples with a toughness, node by node along fronts, and in 2D K
/// of the largest hoop stress with that of the toughness, sqrt(E' Gc) (Erdogan and Sih, J. Basic Eng. 85
/// (1963) 519). A mode I that closes faces drives no crack. Values at nodes without G are left out.
class ToughnessReached
{
public:
  ToughnessReached() = default;
  /// \param toughness [J/m2]; 0: there is none
  explicit ToughnessReached(double toughness) : toughness_(toughness) {}

  /// \param samples of all fronts at one time
  template <int D>
  void add(const State<D>& state, const std::vector<FrontSample<D>>& samples);

  /// Adds `closest_to_initiation` to the entries of fronts, in 2D also `closest_by_hoop_stress`, an answer
  /// for each front, and the entry `start_of_growth`. \return the factor on all loads at which the first
  /// crack starts; 1 where loads and G are in no fixed proportion, or no front has G
  template <int D>
  double report(const State<D>& state, const RunOptions& run, nlohmann::json& summary) const;

  /// Saves or loads what was reached.
  void serialize(Archive& archive);

private:
  struct Reached
  {
    double release = 0.0;   ///< largest G over the toughness
    double intensity = 0.0; ///< largest K of the largest hoop stress over that of the toughness; 0 in 3D
  };
  double toughness_ = 0.0;
  std::map<std::pair<int, int>, Reached> reached_; ///< by crack and number of the front
};

} // namespace Rhegma::energy_release
