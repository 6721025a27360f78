#pragma once
/// What a function of time reaches in a run, and at the times that count for its analysis.

#include "plan/LoadOverStep.hpp"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace Rhegma
{

/// Times of a run at which its loads count.
struct ActingTimes
{
  double end = 0.0; ///< of the run [s]
  /// Load steps at whose ends loads count; 0: at all times.
  int steps = 0;
  /// A factor on the loads of the end is found, so that their size does not matter.
  bool scaled = false;
};

/// In dynamics all times; in Quasi-Static the ends of the load steps; in Static, and where the loads have a
/// factor, only the end. \param scene its section Time
template <int D>
ActingTimes actingTimes(const Teuchos::ParameterList& scene, const State<D>& state)
{
  const double end = scene.sublist("Time").get<double>("Final Time");
  if (!state.method.equilibrium() || state.method.analysis == Analysis::Preload)
    return {end, 0};
  if (state.method.analysis != Analysis::QuasiStatic)
    return {end, 1, state.method.analysis == Analysis::LoadFactor};
  constexpr double most = 4096.0; // as many as are looked at
  const double steps = end / largestLoadStep(scene);
  return {end, steps < most ? static_cast<int>(std::lround(steps)) : 0};
}

/// Largest absolute value of a function of time, and of its integral [s], from 0 to the end of a run. Looked
/// at are 4096 times of an expression, 256 of a table and all its corners, and the ends of load steps.
struct HistoryRange
{
  double largest = 0.0;
  double integral = 0.0;
  double twice = 0.0;          ///< the integral of its integral up to the end, with its sign [s2]
  double acting = 0.0;         ///< `largest` at the times that count
  double actingIntegral = 0.0; ///< `integral` at the times that count [s]
};

/// \param corners times of corners of the function [s], in order; of an expression none
HistoryRange rangeOf(const std::function<double(double)>& function, const std::vector<double>& corners,
                     const ActingTimes& times);

/// The same of a text. Ranges of many texts are kept, because many loads have the same.
HistoryRange rangeOf(const std::string& history, const ActingTimes& times);

/// The same where all times count.
inline HistoryRange rangeOf(const std::string& history, double end)
{
  return rangeOf(history, ActingTimes{end, 0});
}

} // namespace Rhegma
