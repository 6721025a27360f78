#pragma once
/// Whether an energy release rate can be one.

#include "energy_release/FrontSample.hpp"

#include <string>
#include <vector>

namespace Rhegma::energy_release
{

/// 2 pi a U / V, the G of a crack of the extent a in a body that has the mean density of energy U / V
/// everywhere (Griffith 1921), or, where that is less as in slender arms, U over the area of the crack
/// [J/m2]. Collective.
template <int D>
double usualRelease(const State<D>& state, int crack);

/// A warning for each front whose G_J (in 3D its mean) is negative by more than noise: that of a crack that
/// is free of tractions, of inertia too, is K^2 / E'. Noise is a twentieth of the largest G of all fronts and
/// of the run, and of the usual one. Collective.
/// \param samples the last ones, in the order of the fronts \param time of them [s]
/// \param largestEver of all samples of the run [J/m2]
template <int D>
std::vector<std::string> warningsOfNegativeRelease(const State<D>& state,
                                                   const std::vector<FrontSample<D>>& samples, double time,
                                                   double largestEver);

} // namespace Rhegma::energy_release
