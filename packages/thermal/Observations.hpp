#pragma once
/// Temperatures for the history and the summary.

#include "state/State.hpp"

#include <string>

namespace Rhegma::thermal
{

template <int D>
struct Extremes
{
  double highest = 0.0, lowest = 0.0; ///< of the particles [K]
  Vector<D> where{};                  ///< the hottest particle [m]
};

/// Collective.
template <int D>
Extremes<D> extremes(const State<D>& state);

/// The highest temperature of the samples so far.
template <int D>
struct PeakTemperature
{
  double value = 0.0; ///< [K]; 0: no sample yet
  Vector<D> where{};  ///< position of the particle then [m]
  double time = 0.0;  ///< [s]

  void sample(const Extremes<D>& now, double at);

  /// Such as "peak temperature 512 K (rise 219 K) at 0.01, 0.02 m, t = 3 ms".
  /// \param initial temperature [K] \param last highest temperature at the end [K], which is said where it
  /// is lower
  std::string asText(double initial, double last) const;

  void serialize(Archive& archive);
};

/// Temperature at a position, from the nearest particle and its gradient [K]. Collective.
template <int D>
double temperatureAt(const State<D>& state, const Vector<D>& position);

} // namespace Rhegma::thermal
