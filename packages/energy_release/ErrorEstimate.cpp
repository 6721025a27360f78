#include "energy_release/ErrorEstimate.hpp"

#include "archive/Archive.hpp"
#include "energy_release/Disagreement.hpp"
#include "energy_release/DomainIntegral.hpp"
#include "energy_release/FrontDisk.hpp"
#include "energy_release/FrontIntegral.hpp"
#include "energy_release/FrontLengths.hpp"
#include "energy_release/StressError.hpp"
#include "material/LawStiffness.hpp"
#include "state/NodalValues.hpp"
#include "transfer/LocalSpacing.hpp"
#include "transfer/NearestMaterial.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace Rhegma::energy_release
{

namespace
{

double square(double x) { return x * x; }

/// The radii of the smaller domain, as fractions of the larger one.
constexpr double smaller = 2.0 / 3.0;

/// The end of the crack in the cells ahead of its front, mean of the fronts of its crack [m].
double meanOffset(const std::vector<FrontSample<2>>& samples, int crack)
{
  double sum = 0.0;
  int count = 0;
  for (const FrontSample<2>& sample : samples)
    if (sample.front.crack == crack && !sample.front.ended && std::isfinite(sample.tipOffset))
    {
      sum += sample.tipOffset;
      ++count;
    }
  return count > 0 ? sum / count : 0.0;
}

/// How far the crack in the cells ends from its front [m].
double offsetOfEnd(const State<2>& state, const std::vector<FrontSample<2>>& samples,
                   const FrontSample<2>& of)
{
  constexpr double scatter = 0.03; // cells, rms of the tables in docs/explanation/verification/cracks-2d.md
  return std::hypot(meanOffset(samples, of.front.crack), scatter * spacingAt(state, of.front.position));
}
double offsetOfEnd(const State<3>& state, const std::vector<FrontSample<3>>&, const FrontSample<3>& of)
{
  constexpr double withSprings = 0.1,
                   without =
                       0.25; // cells: penny cracks of 6 cells, docs/explanation/verification/cracks-2d.md
  return (state.cracks.frontSprings ? withSprings : without) * spacingAt(state, of.front.position);
}

/// J over the smaller domain, in 3D its mean along the front [J/m2].
double releaseOfSmaller(const State<2>& state, const FrontSample<2>& sample,
                        InternalAcceleration<2>& acceleration)
{
  const double cell = spacingAt(state, sample.front.position);
  ContourRadii radii = sample.tube.radii;
  radii.outer = std::max(smaller * radii.outer, std::min(2.0 * cell, radii.outer));
  radii.inner = std::min(std::max(smaller * radii.inner, cell), 0.5 * radii.outer);
  const auto& rows = acceleration.around(state, accelerationRange(state, sample.front, radii));
  return integrateRelease(state, sample.front, radii, rows).value_or(FrontSample<2>::notYet);
}

double releaseOfSmaller(const State<3>& state, const FrontSample<3>& sample,
                        InternalAcceleration<3>& acceleration)
{
  FrontTube tube = sample.tube;
  tube.radii.outer *= smaller;
  tube.radii.inner *= smaller;
  Along release;
  for (const std::optional<double>& J :
       integrateAlongFront(state, sample.front.crack, lineOf(sample.front), tube, acceleration))
    release.push_back(J.value_or(FrontSample<3>::notYet));
  return meanAlong(sample.front, release);
}

double modulusAt(const State<2>& state, const CrackFront<2>& front)
{
  return elasticity(lawAtFront(state, front)).effectiveModulus;
}
double modulusAt(const State<3>& state, const CrackFront<3>& front)
{
  return elasticity(state.materials.properties[materialAt(state, front.position)]).effectiveModulus;
}

/// Where errors of the stress count: away from the cells of fronts, and within the length of a crack; beyond
/// it, where the crack has changed a uniform stress by (a / r)^D, by this fraction.
template <int D>
std::vector<ErrorSight<D>> sightsOf(const State<D>& state, const std::vector<FrontSample<D>>& samples,
                                    const std::vector<FrontLengths>& lengths)
{
  constexpr double cells = 2.0;
  std::vector<ErrorSight<D>> sights;
  for (std::size_t k = 0; k < samples.size(); ++k)
    for (const FrontNode<D>& node : samples[k].front.nodes)
      if (!samples[k].front.ended)
        sights.push_back(
            {node.position, cells * spacingAt(state, samples[k].front.position), lengths[k].crack});
  return sights;
}

/// The largest scatter to be expected along a front, over the mean: sqrt(2 ln n) times the rms of n
/// independent errors. That rms is sqrt(2 / 3) times the rms of the values about the mean of their
/// neighbours. Source: Cramer, Mathematical Methods of Statistics, 28.6.
double scatterAlong(const Along& values, double mean)
{
  double sum = 0.0;
  int count = 0;
  for (std::size_t k = 1; k + 1 < values.size(); ++k)
  {
    const double from = values[k] - 0.5 * (values[k - 1] + values[k + 1]);
    if (!std::isfinite(from))
      continue;
    sum += square(from);
    ++count;
  }
  if (count < 2)
    return 0.0;
  return std::sqrt(2.0 * std::log(count)) * std::sqrt(sum / (1.5 * count)) / std::fabs(mean);
}

template <int D>
double sumOfSquares(const FrontSample<D>& s)
{
  return square(meanAlong(s.front, s.modeI)) + square(meanAlong(s.front, s.modeII)) +
         (D == 3 ? square(meanAlong(s.front, s.modeIII)) : 0.0);
}

} // namespace

void ErrorEstimate::serialize(Archive& archive)
{
  archive("none", none);
  for (const auto& [name, value] : {std::pair<const char*, double*>{"G", &release},
                                    {"G_extremes", &largestRelease},
                                    {"G_closure", &closure},
                                    {"K", &intensity},
                                    {"K_extremes", &largestIntensity},
                                    {"front_cell", &parts.frontCell},
                                    {"field", &parts.field},
                                    {"contour", &parts.contour},
                                    {"closure", &parts.closure},
                                    {"modes", &parts.modes},
                                    {"scatter", &parts.scatter}})
    archive(name, *value);
}

template <int D>
std::string reasonForNoEstimate(const State<D>& state, const FrontSample<D>& sample, const Options& options)
{
  const double release = sample.J.empty() ? FrontSample<D>::notYet : meanAlong(sample.front, sample.J);
  bool same = true;
  std::string other; // a material with another law
  std::string anisotropic;
  for (std::size_t m = 0; m < state.materials.properties.size(); ++m)
  {
    const Properties& one = state.materials.properties[m];
    if (other.empty() && !isLinear(one))
      other = state.materials.names[m];
    if (anisotropic.empty() && isAnisotropic(one))
      anisotropic = state.materials.names[m];
    same = same && one.mu == state.materials.properties[0].mu &&
           one.planeLambda == state.materials.properties[0].planeLambda;
  }
  if (sample.front.ended)
    return "it has reached a surface or another crack";
  if (!options.contour || !std::isfinite(release) || !haveNodalValues(state) || !state.failure.empty())
    return "G_J is not known at the end of the run";
  if (sample.front.grown || sample.front.speed() > 0.0)
    return "the front has grown";
  if (!state.method.equilibrium() && !state.clock.settled)
    return "the bodies are not known to be at rest (Damping > Stop When Settled)";
  if (!state.materials.thermo.empty())
    return "temperatures act on the material";
  if (state.cracks.pressure.extent(0) > 0 ||
      options.pushed.count(state.cracks.cracks[sample.front.crack].name))
    return "pressure acts on crack faces";
  if (state.cracks.tractions)
    return "crack faces may touch";
  if (!state.cracks.dualField)
    return "nodes next to cracks have a single field (Cracks > Formulation)";
  if (!other.empty())
    return "Materials > " + other +
           " > Model is not Linear Elastic; at small strains without yield that law gives the same G, and an "
           "estimate";
  if (!anisotropic.empty())
    return "Materials > " + anisotropic +
           " is anisotropic, and the energy of errors of the stress is that of isotropic bodies";
  if (!same)
    return "the bodies have different stiffness";
  if (!(release > 0.0))
    return "G_J is not positive";
  if (sample.isClosed())
    return "the crack is closed there (K_I < 0), and its faces pass through one another without Contact";
  if (disagrees(state, sample))
    return "K_I and K_II give another G than G_J";
  return {};
}

template <int D>
void combineParts(const FrontSample<D>& sample, double modulus, ErrorEstimate& estimate)
{
  const double release = meanAlong(sample.front, sample.J), K2 = sumOfSquares(sample);
  ErrorParts& parts = estimate.parts;
  const double squares =
      square(parts.frontCell) + square(parts.field) + square(parts.contour) + square(parts.closure);
  if constexpr (D == 2)
    parts.modes = std::fabs(K2 / modulus / release - 1.0);
  else
    parts.scatter = scatterAlong(sample.J, release);
  const double relative = std::sqrt(squares);
  const double ofExtremes =
      relative + parts.scatter; // the mean has its error, which all nodes have in common
  estimate.release = estimate.closure = relative * release;
  estimate.largestRelease = ofExtremes * release;
  // K^2 / E' is J (1 + modes), so that K has half of the sum of both relative errors.
  estimate.intensity = 0.5 * (relative + parts.modes) * std::sqrt(K2);
  estimate.largestIntensity = 0.5 * ofExtremes * std::sqrt(K2);
}

template <int D>
std::vector<ErrorEstimate> estimateErrors(const State<D>& state, const std::vector<FrontSample<D>>& samples,
                                          const Options& options)
{
  std::vector<ErrorEstimate> estimates(samples.size());
  bool any = false;
  for (std::size_t k = 0; k < samples.size(); ++k)
  {
    estimates[k].none = reasonForNoEstimate(state, samples[k], options);
    any = any || estimates[k].none.empty();
  }
  if (!any)
    return estimates;
  const NodeCover<D> cover = coverOfNodes(state, Vector<D>{}, 1e300);
  std::vector<FrontLengths> lengths;
  lengths.reserve(samples.size());
  for (const FrontSample<D>& sample : samples)
    lengths.push_back(sample.front.ended ? FrontLengths{} : lengthsAt(state, sample.front, cover));
  const double energy = energyOfStressError(state, sightsOf(state, samples, lengths));
  InternalAcceleration<D> acceleration;
  for (std::size_t k = 0; k < samples.size(); ++k)
  {
    ErrorEstimate& estimate = estimates[k];
    const FrontSample<D>& sample = samples[k];
    if (!estimate.none.empty())
      continue;
    const double release = meanAlong(sample.front, sample.J);
    const FrontLengths& of = lengths[k];
    const double ofLigament = (of.ends == 1 ? 3.0 : 1.0) / of.ligament;
    estimate.parts.frontCell = offsetOfEnd(state, samples, sample) * of.slope();
    estimate.parts.field = energy * (D / of.crack + ofLigament) / of.front / release;
    estimate.parts.contour = std::fabs(releaseOfSmaller(state, sample, acceleration) / release - 1.0);
    if (sample.closed && std::isfinite(sample.closure.chosen))
      estimate.parts.closure = std::fabs(sample.closure.chosen / release - 1.0);
    combineParts(sample, modulusAt(state, sample.front), estimate);
    if (!(estimate.release < release))
    {
      estimate = ErrorEstimate();
      estimate.none =
          "its parts add to more than G_J: see whether the cells resolve the crack and its surroundings";
    }
  }
  return estimates;
}

template <int D>
void reportError(const FrontSample<D>& sample, const Options& options, const ErrorEstimate& estimate,
                 nlohmann::json& entry)
{
  if (!options.contour)
    return;
  const bool known = estimate.none.empty();
  const auto add = [&](const char* name, double error)
  { entry[name] = known ? nlohmann::json(error) : nullptr; };
  add("G_J_error_estimate", estimate.release);
  if (sample.closed && options.openingKnown)
    add("G_closure_error_estimate", estimate.closure);
  for (const char* name : {"K_I_error_estimate", "K_II_error_estimate"})
    add(name, estimate.intensity);
  if constexpr (D == 3)
  {
    add("K_III_error_estimate", estimate.intensity);
    add("G_J_extremes_error_estimate", estimate.largestRelease);
    add("K_extremes_error_estimate", estimate.largestIntensity);
  }
  if (!known)
    entry["no_error_estimate"] = estimate.none;
  else
    entry["error_parts"] = {{"front_cell", estimate.parts.frontCell}, {"field", estimate.parts.field},
                            {"contour", estimate.parts.contour},      {"closure", estimate.parts.closure},
                            {"modes", estimate.parts.modes},          {"scatter", estimate.parts.scatter}};
}

template std::string reasonForNoEstimate(const State<2>&, const FrontSample<2>&, const Options&);
template std::string reasonForNoEstimate(const State<3>&, const FrontSample<3>&, const Options&);
template void combineParts(const FrontSample<2>&, double, ErrorEstimate&);
template void combineParts(const FrontSample<3>&, double, ErrorEstimate&);
template std::vector<ErrorEstimate> estimateErrors(const State<2>&, const std::vector<FrontSample<2>>&,
                                                   const Options&);
template std::vector<ErrorEstimate> estimateErrors(const State<3>&, const std::vector<FrontSample<3>>&,
                                                   const Options&);
template void reportError(const FrontSample<2>&, const Options&, const ErrorEstimate&, nlohmann::json&);
template void reportError(const FrontSample<3>&, const Options&, const ErrorEstimate&, nlohmann::json&);

} // namespace Rhegma::energy_release
