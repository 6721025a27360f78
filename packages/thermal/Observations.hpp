#pragma once
/// Temperatures for the history and the summary.

#include "state/State.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace Rhegma::thermal
{

/// Temperatures of all particles at one time.
template <int D>
struct Extremes
{
  double highest = 0.0, lowest = 0.0; ///< of the particles [K]
  Vector<D> hottest{}, coldest{};     ///< where they are [m]
  double difference = 0.0;            ///< the largest between two particles of one body [K]
  int body = 0;                       ///< number of that body
};

/// Collective.
template <int D>
Extremes<D> extremes(const State<D>& state);

/// An extreme temperature of the samples so far.
template <int D>
struct ExtremeTemperature
{
  double value = 0.0; ///< [K]; 0: no sample yet
  Vector<D> where{};  ///< position of the particle then [m]
  double time = 0.0;  ///< [s]

  /// Takes a sample where it is more extreme. \param sign 1: the highest is kept, -1: the lowest
  void sample(double temperature, const Vector<D>& position, double at, double sign);

  nlohmann::json asJson() const; ///< `value`, `time` and `where`
  void serialize(Archive& archive);
};

/// What the samples of a run say of its temperatures.
template <int D>
struct TemperatureRecord
{
  ExtremeTemperature<D> highest, lowest;
  double difference = 0.0; ///< the largest at one time between two particles of one body [K]
  int body = 0;            ///< number of that body
  double time = 0.0;       ///< of the difference [s]

  void sample(const Extremes<D>& now, double at);

  /// Lines such as "peak temperature 512 K (rise 219 K) at 0.01, 0.02 m, t = 3 ms", the same of the lowest
  /// temperature (with its fall), and "largest difference of temperature within a body 80 K (Plate) at t = 1
  /// ms". Of highest and lowest that one is left out that moved next to nothing from the initial temperature
  /// next to the other, such as the peak in a body that is only cooled.
  /// \param initial temperature [K] \param last temperatures at the end, which are said where they are less
  /// extreme
  std::vector<std::string> asText(const State<D>& state, double initial, const Extremes<D>& last) const;

  /// Adds `highest`, `coldest` and `largest_difference` to the entry of temperatures.
  void report(const State<D>& state, nlohmann::json& temperature) const;

  /// Saves or loads it.
  void serialize(Archive& archive);
};

/// Temperature at a position, from the nearest particle and its gradient [K]. Collective.
template <int D>
double temperatureAt(const State<D>& state, const Vector<D>& position);

} // namespace Rhegma::thermal
