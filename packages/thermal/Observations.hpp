#pragma once
/// Temperatures for the history and the summary.

#include "state/State.hpp"

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

/// Temperature at a position, from the nearest particle and its gradient [K]. Collective.
template <int D>
double temperatureAt(const State<D>& state, const Vector<D>& position);

} // namespace Rhegma::thermal
