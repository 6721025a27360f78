#pragma once
/// Where a field of the particles is largest and smallest.

#include "state/State.hpp"

#include <string>
#include <vector>

namespace Rhegma::measure
{

/// Names of the fields whose extremes can be measured, as in scenes.
const std::vector<std::string>& measurableFields();

/// A value and where it is.
template <int D>
struct Extreme
{
  double value = 0.0; ///< in the unit of the field; not a number where no particle is measured
  Vector<D> where{};  ///< position of the particle; of one of them where several have this value [m]
};

/// The extremes of a field now.
template <int D>
struct Extremes
{
  Extreme<D> largest, smallest;
};

/// Collective.
/// \param field one of measurableFields(): principal and von Mises stress [Pa], energy density [J/m3],
/// damage, speed [m/s], displacement [m], temperature [K]
/// \param body only its particles count; -1: those of all bodies
template <int D>
Extremes<D> extremesOf(const State<D>& state, const std::string& field, int body);

} // namespace Rhegma::measure
