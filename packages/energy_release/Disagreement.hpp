#pragma once
/// Whether G and K of a front agree.

#include "energy_release/FrontSample.hpp"

#include <string>
#include <vector>

namespace Rhegma::energy_release
{

/// Whether K_I and K_II of a sample give another G than the domain integral, by more than 10 % of it: not
/// where a number is missing, nor in 3D, where K is scaled to J.
bool disagrees(const State<2>& state, const FrontSample<2>& sample);
bool disagrees(const State<3>& state, const FrontSample<3>& sample);

/// A warning for each front at rest in a linear elastic material whose K_I and K_II give another G than the
/// domain integral, by more than 10 % of it: (K_I^2 + K_II^2) / E' = J (Irwin 1957) holds for every load.
/// Both are integrals over the same particles, and where these are few, or next to a surface or another
/// crack, their errors differ. Fronts that have grown have waves and cohesive faces inside the integral,
/// which K sees otherwise than J. Nothing is said of a G below a twentieth of the largest or of the usual
/// one. In 3D K is scaled to J, so nothing is said.
///
/// \param samples the last ones
/// \param time of them [s]
template <int D>
std::vector<std::string> warningsOfDisagreement(const State<D>& state,
                                                const std::vector<FrontSample<D>>& samples, double time);

} // namespace Rhegma::energy_release
