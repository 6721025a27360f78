#include "energy_release/YieldedPart.hpp"

#include "archive/Archive.hpp"
#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "material/Laws.hpp"
#include "material/MaterialTable.hpp"
#include "state/ParticleStress.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace Rhegma::energy_release
{

namespace
{

template <int D>
bool isAtFront(const std::vector<FrontSample<D>>& samples, const Vector<D>& x)
{
  return std::any_of(samples.begin(), samples.end(),
                     [&](const FrontSample<D>& sample)
                     {
                       const auto& nodes = sample.front.nodes;
                       return std::any_of(nodes.begin(), nodes.end(),
                                          [&](const FrontNode<D>& node)
                                          { return norm(node.position - x) < sample.tube.radii.outer; });
                     });
}

/// Of the particles on this rank. \param yield stresses of the bodies; 0: not looked at [Pa]
template <int D>
std::vector<YieldedPart<D>> yieldedHere(const State<D>& state, const std::vector<FrontSample<D>>& samples,
                                        double factor, const std::vector<double>& yield)
{
  const auto host = [](const auto& view)
  { return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, view); };
  const auto body = host(state.particles.integer(fields::body));
  const auto volume = host(state.particles.scalar(fields::volume));
  const auto x = host(state.particles.template real<D>(fields::position));
  const auto F = host(state.particles.template real<gradientSize<D>>(fields::deformation));
  const auto tau = host(state.particles.template real<symmetricSize<D>>(fields::stress));
  std::vector<YieldedPart<D>> parts(yield.size());
  for (int p = 0; p < state.particles.size(); ++p)
  {
    YieldedPart<D>& part = parts[body(p)];
    part.all += volume(p);
    if (!(yield[body(p)] > 0.0))
      continue;
    double s[6], f[gradientSize<D>], t[symmetricSize<D>];
    for (int k = 0; k < gradientSize<D>; ++k)
      f[k] = F(p, k);
    for (int k = 0; k < symmetricSize<D>; ++k)
      t[k] = tau(p, k);
    cauchyStress<D>(f, t, s);
    const double stress = factor * vonMisesStress(s);
    Vector<D> at;
    for (int d = 0; d < D; ++d)
      at[d] = x(p, d);
    const bool yields = stress > yield[body(p)];
    if (!(yields || stress > part.largest) || isAtFront(samples, at))
      continue;
    part.volume += yields ? volume(p) : 0.0;
    if (stress > part.largest)
    {
      part.largest = stress;
      part.at = at;
    }
  }
  return parts;
}

/// The sum over ranks, with the largest stress of all.
template <int D>
YieldedPart<D> onAllRanks(const State<D>& state, YieldedPart<D> part)
{
  const double largest = state.ranks.max(part.largest);
  double sums[3 + D] = {part.volume, part.all, largest == part.largest ? 1.0 : 0.0};
  for (int d = 0; d < D; ++d)
    sums[3 + d] = sums[2] * part.at[d];
  state.ranks.sum(sums, 3 + D);
  part = {sums[0], sums[1], largest, {}};
  for (int d = 0; d < D; ++d)
    part.at[d] = sums[3 + d] / sums[2];
  return part;
}

template <int D>
std::string positionAsText(const Vector<D>& x)
{
  std::string text;
  for (int d = 0; d < D; ++d)
  {
    text += d == 0 ? "" : ", ";
    text += formatShort(x[d]);
  }
  return text + " m";
}

/// Yield stresses of the bodies with a linear law; 0 where there is none.
template <int D>
std::vector<double> yieldOfBodies(const State<D>& state)
{
  std::vector<double> yield;
  for (const auto& body : state.bodies.info)
  {
    const Properties& material = state.materials.properties[body.material];
    yield.push_back(material.law == lawIndex<LinearElastic> ? firstYield(material) : 0.0);
  }
  return yield;
}

/// Where a body begins to yield. \param loads for which the stresses are, as text
template <int D>
std::string beginAsText(const std::string& body, const YieldedPart<D>& part, double yield,
                        const ToughnessReached::Factors& start, const std::string& loads)
{
  const bool scales = start.ofNow != 1.0 || start.ofScene != 1.0;
  return "Bodies > " + body + ": the largest von Mises stress outside of the contours of the fronts is " +
         formatShort(part.largest) + " Pa " + loads + ", at " + positionAsText<D>(part.at) + ": " +
         (scales
              ? "yield (" + formatShort(yield) + " Pa) begins there at " +
                    formatShort(start.ofScene * yield / part.largest) + " times the loads"
              : formatShort(part.largest / yield) + " of the yield stress of " + formatShort(yield) + " Pa");
}

constexpr double least = 1e-3; ///< of the volume of a body that yields: a warning

template <int D>
std::string warningOfYield(const State<D>& state, std::size_t b, double yield, const YieldedPart<D>& part,
                           const std::string& loads)
{
  const auto& body = state.bodies.info[b];
  return "Materials > " + state.materials.names[body.material] + " > Yield Stress is " + formatShort(yield) +
         " Pa, and " + loads + ", the von Mises stress is larger in " +
         formatShort(100.0 * part.volume / part.all) + " % of Bodies > " + body.name +
         " outside of the contours of the fronts, at most " + formatShort(part.largest) + " Pa at " +
         positionAsText<D>(part.at) +
         ": the part yields there, which its law, Linear Elastic, leaves out; use a smaller load, or Model = "
         "J2 Plastic";
}

} // namespace

template <int D>
void YieldRecords<D>::sample(const State<D>& state, const std::vector<FrontSample<D>>& samples)
{
  const std::vector<double> yield = yieldOfBodies(state);
  if (!state.method.mechanics || std::none_of(yield.begin(), yield.end(), [](double y) { return y > 0.0; }))
    return;
  records_.resize(yield.size());
  const std::vector<YieldedPart<D>> here = yieldedHere(state, samples, 1.0, yield);
  for (std::size_t b = 0; b < yield.size(); ++b)
  {
    const YieldedPart<D> now = onAllRanks(state, here[b]), &most = records_[b].part;
    if (now.volume > most.volume || (now.volume == most.volume && now.largest > most.largest))
      records_[b] = {now, state.clock.time,
                     state.method.analysis == Analysis::LoadFactor ? state.clock.factor.end : 1.0};
  }
}

template <int D>
void YieldRecords<D>::serialize(Archive& archive)
{
  constexpr std::size_t width = 5 + D;
  std::vector<double> rows;
  for (const YieldRecord<D>& r : records_)
  {
    rows.insert(rows.end(), {r.part.volume, r.part.all, r.part.largest, r.time, r.factor});
    rows.insert(rows.end(), r.part.at.c, r.part.at.c + D);
  }
  archive("yielded", rows, width);
  records_.clear();
  for (std::size_t k = 0; k + width <= rows.size(); k += width)
  {
    records_.push_back({{rows[k], rows[k + 1], rows[k + 2], {}}, rows[k + 3], rows[k + 4]});
    std::copy_n(&rows[k + 5], D, records_.back().part.at.c);
  }
}

template <int D>
void reportYield(const State<D>& state, const std::vector<FrontSample<D>>& samples,
                 const ToughnessReached::Factors& start, const YieldRecords<D>& records,
                 nlohmann::json& summary)
{
  const bool scales = start.ofNow != 1.0 || start.ofScene != 1.0;
  const std::string loads =
      scales ? "at " + formatShort(start.ofScene) + " times the loads, at which the cracks start"
             : "at the end";
  const std::vector<double> yield = yieldOfBodies(state);
  if (!state.method.mechanics || state.clock.step == 0 ||
      std::none_of(yield.begin(), yield.end(), [](double y) { return y > 0.0; }))
    return;
  const std::vector<YieldedPart<D>> here = yieldedHere(state, samples, start.ofNow, yield);
  for (std::size_t b = 0; b < yield.size(); ++b)
  {
    const YieldedPart<D> part = onAllRanks(state, here[b]);
    if (!(part.largest > 0.0))
      continue;
    const bool yields = part.volume > least * part.all;
    if (!yields)
      summary["answers"].push_back(beginAsText(state.bodies.info[b].name, part, yield[b], start, loads));
    const YieldRecord<D> most = b < records.all().size() && !scales ? records.all()[b] : YieldRecord<D>();
    if (most.part.volume > std::max(part.volume, least * most.part.all))
      summary["warnings"].push_back(
          warningOfYield(state, b, yield[b], most.part,
                         state.method.analysis == Analysis::LoadFactor
                             ? "at " + formatShort(most.factor) + " times the loads of Time > Final Time"
                             : "at t = " + readableTime(most.time)));
    else if (yields)
      summary["warnings"].push_back(warningOfYield(state, b, yield[b], part, loads));
  }
}

template class YieldRecords<2>;
template class YieldRecords<3>;
template void reportYield(const State<2>&, const std::vector<FrontSample<2>>&,
                          const ToughnessReached::Factors&, const YieldRecords<2>&, nlohmann::json&);
template void reportYield(const State<3>&, const std::vector<FrontSample<3>>&,
                          const ToughnessReached::Factors&, const YieldRecords<3>&, nlohmann::json&);

} // namespace Rhegma::energy_release
