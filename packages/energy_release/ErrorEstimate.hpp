#pragma once
/// Estimates of the numerical error of G and of stress intensities.

#include "energy_release/FrontSample.hpp"
#include "energy_release/ReadOptions.hpp"

#include <string>
#include <vector>

namespace Rhegma::energy_release
{

/// Parts of the error of G of a front, as fractions of it.
struct ErrorParts
{
  double frontCell = 0.0; ///< the end of the crack in the cell of its front
  double field = 0.0;     ///< stress away from the front: bending, edges that cut cells, coarse cells
  double contour = 0.0;   ///< the same integral over a smaller domain
  double closure = 0.0;   ///< crack closure (2D)
  double modes = 0.0;     ///< (K_I^2 + K_II^2) / E' against G_J; of stress intensities alone (2D)
  double scatter = 0.0;   ///< largest along the front; of its extremes alone (3D)
};

/// Estimate of the error of a front's quantities.
struct ErrorEstimate
{
  std::string none;                               ///< why there is no estimate; empty where there is one
  double release = FrontSample<2>::notYet;        ///< of G_J [J/m2]
  double largestRelease = FrontSample<2>::notYet; ///< of the extremes of G_J along a front in 3D [J/m2]
  double closure = FrontSample<2>::notYet;        ///< of G_closure [J/m2]
  double intensity = FrontSample<2>::notYet; ///< of each K: K_I and K_II are two components of one vector,
                                             ///< and an error turns and stretches it [Pa m^0.5]
  double largestIntensity = FrontSample<2>::notYet; ///< of their extremes along a front in 3D [Pa m^0.5]
  ErrorParts parts;

  /// Saves or loads it.
  void serialize(Archive& archive);
};

/// Whether the numerical errors of the answers for a front can be estimated: why not, or nothing.
template <int D>
std::string reasonForNoEstimate(const State<D>& state, const FrontSample<D>& sample, const Options& options);

/// Combines the parts: they have different causes and unknown signs, so that their squares add.
/// \param sample with J and stress intensities \param modulus E' at the front [Pa]
template <int D>
void combineParts(const FrontSample<D>& sample, double modulus, ErrorEstimate& estimate);

/// Estimates for the fronts of the last samples, from the state of that time alone. Nothing is kept between
/// steps; costs two integrals over the disk or tube of each front and three transfers. Collective.
///
/// Let U_e be the strain energy of the error of the displacements. At given loads the energy U_h of the
/// approximation is U - U_e (orthogonality), and as G = dU/da for crack area a,
///
///     G_h - G = -dU_e/da.
///
/// U_e has two parts. That of the cell of the front is G c: the crack in the cells behaves like one that is c
/// shorter. c is the mean offset of the tips of the crack's fronts that reciprocity gives
/// (DomainIntegral::tipOffset), and in addition what that does not see, 0.03 cells, the rms of fronts at
/// random positions in their cells; in 3D 0.1 cells:
///
///     dG / G = c (dln G / da),    dln G / da = 1 / a + m / b   (or that of a beam, FrontLengths::slope),
///
/// a the length of the crack per front, b the ligament, m = 3 for a crack that ends at a surface, whose short
/// ligament is bent, and 1 for one with fronts at both ends, whose ligament is pulled: G is proportional to a
/// for a crack in a field of stress, and to b^-m (Tada, Paris and Irwin, 2.11, 9.1 and 2.1). The part away
/// from the cells of fronts is that of energyOfStressError, proportional to a^D and b^-m:
///
///     dG = U_e (D / a + m / b) / (length of the fronts of the crack)
///
/// In it the error of a particle counts as the crack changes the stress there: fully within a, and by
/// (a / r)^D at a distance r beyond, as the stress of a crack in a uniform field falls.
///
/// The difference of J from another domain, and of crack closure from J, show what these two do not: loads
/// and surfaces near the integral, and deflections that are not small. Source: for G and the error in energy
/// Rueter and Stein, Comput. Methods Appl. Mech. Eng. 195 (2006) 251.
template <int D>
std::vector<ErrorEstimate> estimateErrors(const State<D>& state, const std::vector<FrontSample<D>>& samples,
                                          const Options& options);

/// Adds the estimate of a front to its entry in the summary: null where there is none, and then
/// `no_error_estimate` says why.
template <int D>
void reportError(const FrontSample<D>& sample, const Options& options, const ErrorEstimate& estimate,
                 nlohmann::json& entry);

} // namespace Rhegma::energy_release
