#pragma once
/// How close cracks that do not grow come to a toughness.

#include "energy_release/FrontSample.hpp"
#include "energy_release/SurfaceNodes.hpp"
#include "plan/RunOptions.hpp"
#include "state/State.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace Rhegma::energy_release
{

/// When G of a front reaches its toughness, from samples in time.
class StartTime
{
public:
  /// Takes the next sample. G is in proportion to the square of a load, so that between two samples its root
  /// is taken to be linear in time. \param ratio G over the toughness; not a number: it is not known
  void add(double time, double ratio);

  bool isKnown() const { return std::isfinite(time_); }
  double time() const { return time_; } ///< not a number: it has not reached it [s]
  /// Such as "; G came to the toughness at about t = 3 ms", or that the first sample exceeds it already;
  /// empty where it has not been reached.
  std::string asText() const;

  static constexpr int width = 4; ///< of a row
  std::vector<double> row() const { return {time_, isFirst_ ? 1.0 : 0.0, lastTime_, lastRatio_}; }
  /// As a row has it. \param row of this width
  static StartTime of(const double* row);

private:
  static constexpr double none = std::numeric_limits<double>::quiet_NaN();
  double time_ = none;
  bool isFirst_ = false;                      ///< the first sample has reached it already
  double lastTime_ = none, lastRatio_ = none; ///< of the last sample
};

/// Compares the energy release rate of all samples with a toughness, node by node along fronts, and in 2D K
/// of the largest hoop stress with that of the toughness, sqrt(E' Gc) (Erdogan and Sih, J. Basic Eng. 85
/// (1963) 519). A mode I that closes faces drives no crack. Values at nodes without G are left out, and those
/// of nodes at the surface of the body are kept apart.
class ToughnessReached
{
public:
  ToughnessReached() = default;
  /// \param toughness [J/m2]; 0: there is none \param criticalIntensity K_Ic that it is from [Pa m^0.5]; 0:
  /// it was not given
  ToughnessReached(double toughness, std::vector<MirrorPlane> mirrors, double criticalIntensity = 0.0)
      : toughness_(toughness), criticalIntensity_(criticalIntensity), mirrors_(std::move(mirrors))
  {
  }

  /// Planes of symmetry of the scene.
  const std::vector<MirrorPlane>& mirrors() const { return mirrors_; }

  /// \param samples of all fronts at one time
  template <int D>
  void add(const State<D>& state, const std::vector<FrontSample<D>>& samples);

  /// The factors at which the first crack starts; 1 where loads and G are in no fixed proportion, or no front
  /// has G.
  struct Factors
  {
    double ofNow = 1.0;     ///< on what acts at the end of the run
    double ofScene = 1.0;   ///< on the loads of the scene: a static run that ends early has a part of them
    double toughness = 0.0; ///< with which G is compared [J/m2]; 0: none
  };

  /// Takes K_Ic = sqrt(E' Gc) where the scene gives the toughness, and all its materials have one E' at small
  /// strain and no preferred direction.
  void assumeIntensity(const std::vector<Properties>& materials);

  /// Adds `closest_to_initiation` and `time_of_toughness` to the entries of fronts, in 2D also
  /// `closest_by_hoop_stress`, in 3D `closest_at_surface`, an answer for each front, and the entry
  /// `start_of_growth`, its `load_factor` without nodes at the surface, and `K_Ic` where it is known.
  template <int D>
  Factors report(const State<D>& state, const RunOptions& run, nlohmann::json& summary) const;

  /// Saves or loads what was reached.
  void serialize(Archive& archive);

private:
  struct Reached
  {
    double release = 0.0;   ///< largest G over the toughness
    double atSurface = 0.0; ///< the same of nodes at the surface of the body
    double intensity = 0.0; ///< largest K of the largest hoop stress over that of the toughness; 0 in 3D
    StartTime start;        ///< of G without nodes at the surface
  };
  std::string reachedAsText(const Reached& reached) const;

  double toughness_ = 0.0;
  double criticalIntensity_ = 0.0;
  std::vector<MirrorPlane> mirrors_;
  std::map<std::pair<int, int>, Reached> reached_; ///< by crack and number of the front
};

} // namespace Rhegma::energy_release
