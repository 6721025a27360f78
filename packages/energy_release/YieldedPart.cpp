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
#include <utility>
#include <vector>

namespace Rhegma::energy_release
{

namespace
{

/// The contours of all front nodes: position, and outer radius squared.
template <int D>
View<double* [D + 1]> contoursOf(const std::vector<FrontSample<D>>& samples)
{
  std::size_t count = 0;
  for (const FrontSample<D>& sample : samples)
    count += sample.front.nodes.size();
  View<double * [D + 1]> contours("rhegma::energy_release::contours", count);
  const auto host = Kokkos::create_mirror_view(contours);
  std::size_t k = 0;
  for (const FrontSample<D>& sample : samples)
    for (const FrontNode<D>& node : sample.front.nodes)
    {
      for (int d = 0; d < D; ++d)
        host(k, d) = node.position[d];
      host(k++, D) = sample.tube.radii.outer * sample.tube.radii.outer;
    }
  Kokkos::deep_copy(contours, host);
  return contours;
}

/// Von Mises stresses of a body clear of fronts.
template <int D>
struct ClearStress
{
  ParticleStress<D> stress;
  BorrowedView<int*> bodyOf;
  BorrowedView<double* [D]> position; ///< of particles [m]
  View<double * [D + 1]> contours;
  int body;
  double factor; ///< on the stresses

  /// That of a particle if it is above a limit; else 0, as of one of another body or next to a front [Pa].
  KOKKOS_INLINE_FUNCTION double above(double limit, int p) const
  {
    if (bodyOf(p) != body)
      return 0.0;
    const double here = factor * stress.vonMises(p);
    return here > limit && !isAtFront(p) ? here : 0.0;
  }

  KOKKOS_INLINE_FUNCTION bool isAtFront(int p) const
  {
    for (std::size_t k = 0; k < contours.extent(0); ++k)
    {
      double square = 0.0;
      for (int d = 0; d < D; ++d)
        square += (position(p, d) - contours(k, d)) * (position(p, d) - contours(k, d));
      if (square < contours(k, D))
        return true;
    }
    return false;
  }
};

template <int D>
ClearStress<D> clearStress(const State<D>& state, const std::vector<FrontSample<D>>& samples, int body,
                           double factor)
{
  return {ParticleStress<D>(state.particles),
          state.particles.integer(fields::body),
          state.particles.template real<D>(fields::position),
          contoursOf(samples),
          body,
          factor};
}

/// Of the particles of a body on this rank, without the position. \param limit stress up to which particles
/// are not looked at [Pa]
template <int D>
YieldedPart<D> yieldedHere(const State<D>& state, const ClearStress<D>& stress, double yield, double limit)
{
  YieldedPart<D> part;
  const auto volume = state.particles.scalar(fields::volume);
  Kokkos::parallel_reduce(
      "rhegma::energy_release::yielded", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, double& sum, double& whole, double& top) {
        if (stress.bodyOf(p) != stress.body)
          return;
        whole += volume(p);
        const double here = stress.above(top > limit ? (top < yield ? top : yield) : limit, p);
        sum += here > yield ? volume(p) : 0.0;
        top = here > top ? here : top;
      },
      part.volume, part.all, Kokkos::Max<double>(part.largest));
  part.largest = part.largest > 0.0 ? part.largest : 0.0; // of no particle
  return part;
}

/// The particle of this rank with the largest stress.
template <int D>
int particleOfLargest(const State<D>& state, const ClearStress<D>& stress)
{
  using Most = Kokkos::MaxLoc<double, int>;
  Most::value_type most;
  Kokkos::parallel_reduce(
      "rhegma::energy_release::largestStress", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, Most::value_type& top) {
        const double here = stress.above(top.val, p);
        if (here > top.val)
        {
          top.val = here;
          top.loc = p;
        }
      },
      Most(most));
  return most.loc;
}

/// What yields on all ranks, but for its position, and whether the largest stress is that of this rank.
template <int D>
struct Found
{
  YieldedPart<D> part;
  bool here = false;
};

/// Of all particles of each body with a yield stress. Collective. \param limits stresses of bodies up to
/// which particles are not looked at, none above the yield stress [Pa]
template <int D>
std::vector<Found<D>> yieldedParts(const State<D>& state, const std::vector<FrontSample<D>>& samples,
                                   double factor, const std::vector<double>& yield,
                                   const std::vector<double>& limits)
{
  const std::size_t count = yield.size();
  std::vector<Found<D>> found(count);
  std::vector<double> sums(2 * count), largest(count);
  for (std::size_t b = 0; b < count; ++b)
  {
    if (yield[b] > 0.0)
      found[b].part =
          yieldedHere(state, clearStress(state, samples, static_cast<int>(b), factor), yield[b], limits[b]);
    sums[2 * b] = found[b].part.volume;
    sums[2 * b + 1] = found[b].part.all;
    largest[b] = found[b].part.largest;
  }
  state.ranks.sum(sums.data(), static_cast<int>(2 * count));
  state.ranks.max(largest.data(), static_cast<int>(count));
  for (std::size_t b = 0; b < count; ++b)
    found[b] = {{sums[2 * b], sums[2 * b + 1], largest[b], {}}, found[b].part.largest == largest[b]};
  return found;
}

/// Where the largest stress of a body is; the mean where several ranks have it. Collective.
template <int D>
Vector<D> positionOfLargest(const State<D>& state, const ClearStress<D>& stress, bool here)
{
  double sums[1 + D] = {};
  if (here)
  {
    const int p = particleOfLargest(state, stress);
    const auto row = onHost(Kokkos::subview(stress.position, std::make_pair(p, p + 1), Kokkos::ALL));
    sums[0] = 1.0;
    for (int d = 0; d < D; ++d)
      sums[1 + d] = row(0, d);
  }
  state.ranks.sum(sums, 1 + D);
  Vector<D> at;
  for (int d = 0; d < D; ++d)
    at[d] = sums[1 + d] / sums[0];
  return at;
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

constexpr double least = 1e-3; ///< of the volume of a body that yields: a warning

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
              : formatShort(part.largest / yield) + " of the yield stress of " + formatShort(yield) + " Pa") +
         (part.volume > 0.0 ? "; " + formatShort(100.0 * part.volume / part.all) +
                                  " % of the body is above the yield stress, too little for a warning (" +
                                  formatShort(100.0 * least) + " %)"
                            : "");
}

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
  // Stresses up to the largest of the record neither yield more nor come closer to it.
  std::vector<double> limits;
  for (std::size_t b = 0; b < yield.size(); ++b)
    limits.push_back(std::min(yield[b], records_[b].part.largest));
  const std::vector<Found<D>> found = yieldedParts(state, samples, 1.0, yield, limits);
  for (std::size_t b = 0; b < yield.size(); ++b)
  {
    const YieldedPart<D>& now = found[b].part;
    const YieldedPart<D>& most = records_[b].part;
    if (now.volume > most.volume || (now.volume == most.volume && now.largest > most.largest))
    {
      records_[b] = {now, state.clock.time,
                     state.method.analysis == Analysis::LoadFactor ? state.clock.factor.end : 1.0};
      records_[b].part.at =
          positionOfLargest(state, clearStress(state, samples, static_cast<int>(b), 1.0), found[b].here);
    }
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
  const std::vector<Found<D>> found =
      yieldedParts(state, samples, start.ofNow, yield, std::vector<double>(yield.size()));
  for (std::size_t b = 0; b < yield.size(); ++b)
  {
    if (!(found[b].part.largest > 0.0))
      continue;
    YieldedPart<D> part = found[b].part;
    part.at = positionOfLargest(state, clearStress(state, samples, static_cast<int>(b), start.ofNow),
                                found[b].here);
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
