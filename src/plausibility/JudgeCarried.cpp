#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "base/ShortNumber.hpp"
#include "plausibility/BodyGroups.hpp"
#include "plausibility/Judges.hpp"
#include "plausibility/Pieces.hpp"
#include "plausibility/SupportReach.hpp"
#include "scene/PositionFunction.hpp"
#include "scene/TimeFunction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>

namespace Rhegma
{

namespace
{

using Geometry::Bounds;
using Teuchos::ParameterList;

/// Bodies on which something else than supports acts; everything, if what acts is not known.
template <int D>
struct OtherLoads
{
  bool everywhere = false;
  std::set<std::string> bodies{};
};

template <int D>
OtherLoads<D> readLoads(const ParameterList& section)
{
  OtherLoads<D> loads;
  for (const std::string& name : sublistNames(section))
  {
    const ParameterList& list = section.sublist(name);
    const std::string type = list.get<std::string>("Type");
    if (list.isType<std::string>("Body"))
      loads.bodies.insert(list.get<std::string>("Body"));
    else
      loads.everywhere = loads.everywhere || (type != "Velocity" && type != "Symmetry");
  }
  return loads;
}

/// What a support prescribes.
template <int D>
struct Prescribed
{
  const BoundaryRegion* region;
  bool known = false; ///< a velocity that is the same at all nodes
  Vector<D> value{};  ///< at a factor of 1 [m/s]
  std::string history{};
  std::vector<double> factors{}; ///< of the history, at times from 0 to the end of the run

  bool holds(int axis) const { return region->axes.find(static_cast<char>('x' + axis)) != std::string::npos; }
  bool moves(int axis) const { return value[axis] != 0.0 && region->kind == BoundaryRegion::Kind::Held; }

  /// Whether it goes back and forth as a shaking table does, or comes and goes as a blow: neither constant
  /// nor a ramp, so that inertia is meant. \param largest absolute value of the history, at its corners too
  bool jolts(double largest) const
  {
    constexpr double rounding = 1e-9;
    const auto [least, most] = std::minmax_element(factors.begin(), factors.end());
    const bool ramp =
        std::is_sorted(factors.begin(), factors.end()) || std::is_sorted(factors.rbegin(), factors.rend());
    const double ends = std::max(std::fabs(factors.front()), std::fabs(factors.back()));
    return !ramp || (*least < 0.0 && *most > 0.0) || largest > (1.0 + rounding) * ends;
  }
};

/// The velocity of a field that is the same at points all over a part of its box; none of another one. The
/// points are not equidistant along any axis, so that no wave has the same value at all of them: multiples of
/// powers of the root of z^(D + 1) = z + 1, the golden ratio in one dimension, as parts of an edge.
template <int D>
std::optional<Vector<D>> uniformValue(const std::string& field, const Bounds<D>& part)
{
  constexpr int points = 256;
  constexpr double root = D == 2 ? 1.32471795724474602596 : 1.22074408460575947536;
  constexpr double rounding = 1e-9;
  const PositionFunction velocity = PositionFunction::parse(field, D);
  std::optional<Vector<D>> first;
  for (int k = 0; k < points; ++k)
  {
    Vector<D> x;
    double multiple = k;
    for (int d = 0; d < D; ++d)
    {
      multiple /= root;
      x[d] = part.lower[d] + (multiple - std::floor(multiple)) * (part.upper[d] - part.lower[d]);
    }
    const Vector<D> here = velocity(x);
    if (!(norm(here) < std::numeric_limits<double>::infinity()) ||
        (first && norm(here - *first) > rounding * norm(*first)))
      return {};
    first = first ? first : here;
  }
  return first;
}

/// \param domain with all nodes \param end of the run [s]
template <int D>
Prescribed<D> prescribedBy(const BoundaryRegion& region, const ParameterList& list, const Bounds<D>& domain,
                           double end)
{
  constexpr int times = 64;
  Prescribed<D> prescribed{&region};
  if (region.kind == BoundaryRegion::Kind::Mirror)
  {
    prescribed.known = true;
    return prescribed;
  }
  prescribed.history = list.get<std::string>("History");
  const TimeFunction history = TimeFunction::parse(prescribed.history);
  for (int k = 0; k <= times; ++k)
    prescribed.factors.push_back(history(end * k / times));
  std::optional<Vector<D>> value;
  if (list.isParameter("Value"))
    value = readVector<D>(list, "Value");
  else if (list.isType<std::string>("Field") && region.kind == BoundaryRegion::Kind::Held)
  {
    Bounds<D> part = domain;
    for (int d = 0; d < D; ++d)
    {
      part.lower[d] = std::max(part.lower[d], region.from[d]);
      part.upper[d] = std::min(part.upper[d], region.to[d]);
    }
    value = uniformValue<D>(list.get<std::string>("Field"), part);
  }
  prescribed.known = value.has_value();
  prescribed.value = value.value_or(Vector<D>{});
  return prescribed;
}

/// Whether two supports prescribe the same motion along an axis.
template <int D>
bool agree(const Prescribed<D>& one, const Prescribed<D>& other, int axis)
{
  constexpr double rounding = 1e-9;
  const double a = one.value[axis], b = other.value[axis];
  if (!one.known || !other.known)
    return false;
  if (a == 0.0 || b == 0.0)
    return a == b;
  double most = 0.0, apart = 0.0;
  for (std::size_t k = 0; k < one.factors.size(); ++k)
  {
    most = std::max(most, std::fabs(a * one.factors[k]));
    apart = std::max(apart, std::fabs(a * one.factors[k] - b * other.factors[k]));
  }
  return apart <= rounding * most;
}

/// The bodies that supports move.
template <int D>
class Carried
{
public:
  explicit Carried(const JudgedScene<D>& judged)
      : judged_(judged),
        regions_(supportRegions(judged.scene)),
        loads_(readLoads<D>(judged.scene.sublist("Boundaries"))),
        cell_(judged.state.mesh.grid.spacing),
        end_(judged.scene.sublist("Time").template get<double>("Final Time")),
        groups_(judged.bodies, cell_)
  {
    for (const BoundaryRegion& region : regions_)
      supports_.push_back(prescribedBy<D>(region, judged.scene.sublist("Boundaries").sublist(region.name),
                                          {judged.state.mesh.grid.lower, judged.state.mesh.grid.upper},
                                          end_));
    for (std::size_t k = 0; k < supports_.size(); ++k)
      gather(static_cast<int>(k));
  }

  Messages judge() const
  {
    Messages messages;
    for (const auto& [group, supports] : holding_)
      for (int d = 0; d < D; ++d)
        if (judgeOne(group, supports, d, messages))
          break;
    return messages;
  }

private:
  /// Adds a support to the groups of bodies that it reaches.
  void gather(int number)
  {
    const BoundaryRegion& region = regions_[number];
    Bounds<D> reach;
    for (int d = 0; d < D; ++d)
    {
      const bool box =
          region.kind == BoundaryRegion::Kind::Held ||
          (region.kind == BoundaryRegion::Kind::Mirror && region.axes[0] == static_cast<char>('x' + d));
      reach.lower[d] = box ? region.from[d] : judged_.state.mesh.grid.lower[d];
      reach.upper[d] = box ? region.to[d] : judged_.state.mesh.grid.upper[d];
    }
    for (const int body : groups_.near(reach, cell_))
      holding_[groups_.of(body)].insert(number);
  }

  /// The part of a group in the box of a support.
  Bounds<D> partIn(const Bounds<D>& group, const BoundaryRegion& region) const
  {
    Bounds<D> part = group;
    for (int d = 0; d < D; ++d)
    {
      part.lower[d] = std::max(part.lower[d], region.from[d]);
      part.upper[d] = std::min(part.upper[d], region.to[d]);
    }
    return part;
  }

  /// The axis along which supports hold both ends of a group, none of them all of it; -1: there is none.
  int grippedAxis(const Bounds<D>& group, const std::vector<int>& movers) const
  {
    const double gap = 2.0 * cell_;
    for (int axis = 0; axis < D; ++axis)
    {
      bool low = false, high = false, all = false;
      for (const int k : movers)
      {
        const Bounds<D> part = partIn(group, regions_[k]);
        const bool atLow = part.lower[axis] - group.lower[axis] < gap,
                   atHigh = group.upper[axis] - part.upper[axis] < gap;
        all = all || (atLow && atHigh);
        low = low || atLow;
        high = high || atHigh;
      }
      if (low && high && !all)
        return axis;
    }
    return -1;
  }

  bool isLoaded(const BodyGroup<D>& group) const
  {
    return loads_.everywhere ||
           std::any_of(group.bodies.begin(), group.bodies.end(),
                       [&](int b) { return loads_.bodies.count(judged_.bodies[b].name) > 0; }) ||
           isThrown(judged_.scene, judged_.bodies, group.bodies);
  }

  /// Whether all supports of a group prescribe the same along each axis.
  bool allAgree(const std::set<int>& supports) const
  {
    for (int d = 0; d < D; ++d)
    {
      int first = -1;
      for (const int k : supports)
        if (supports_[k].holds(d))
        {
          first = first < 0 ? k : first;
          if (!agree(supports_[first], supports_[k], d))
            return false;
        }
    }
    return true;
  }

  bool judgeOne(int number, const std::set<int>& supports, int axis, Messages& messages) const
  {
    std::vector<int> movers;
    for (const int k : supports)
      if (supports_[k].holds(axis) && supports_[k].moves(axis))
        movers.push_back(k);
    const BodyGroup<D>& group = groups_[number];
    if (movers.size() < 2 || !allAgree(supports) || isLoaded(group) || grippedAxis(group.bounds, movers) < 0)
      return false;
    const Prescribed<D>&first = supports_[movers.front()], &last = supports_[movers.back()];
    const bool atRest = judged_.state.method.equilibrium();
    const HistoryRange range = rangeOf(first.history, end_);
    if (!atRest && first.jolts(range.largest))
      return false;
    const double far = std::fabs(first.value[axis]) * range.integral;
    const double sum = first.value[axis] * std::accumulate(first.factors.begin(), first.factors.end(), 0.0);
    Vector<D> by{};
    by[axis] = sum > 0.0 ? far : -far;
    if (!(far > 0.0) || !std::isfinite(far) || groups_.isStopped(number, by, regions_))
      return false;
    const bool sameValue = first.history == last.history && first.value[axis] == last.value[axis];
    messages.push_back(
        "Boundaries > " + first.region->name + ": it and Boundaries > " + last.region->name +
        " move both ends of Bodies > " + judged_.bodies[group.bodies.front()].name +
        " the same distance along " + static_cast<char>('x' + axis) + ", " + readableLength(far) +
        (sameValue ? " (" + formatShort(first.value[axis]) + " m/s for both)" : " (at the same velocity)") +
        ", so that " + (atRest ? "nothing" : "only its inertia") +
        " strains it; to strain it, change the sign of one of the velocities (Value, Field, History), or set "
        "one to zero");
    return true;
  }

  const JudgedScene<D>& judged_;
  std::vector<BoundaryRegion> regions_;
  OtherLoads<D> loads_;
  double cell_, end_; ///< [m, s]
  BodyGroups<D> groups_;
  std::vector<Prescribed<D>> supports_;  ///< in the order of the regions
  std::map<int, std::set<int>> holding_; ///< supports of each group
};

/// Supports with a Value along an axis that they leave free.
template <int D>
void judgeComponents(const ParameterList& section, Messages& messages)
{
  for (const std::string& name : sublistNames(section))
  {
    const ParameterList& list = section.sublist(name);
    if (list.get<std::string>("Type") != "Velocity" || !list.isParameter("Value"))
      continue;
    const std::string axes = list.get<std::string>("Components");
    const Vector<D> value = readVector<D>(list, "Value");
    for (int d = 0; d < D; ++d)
      if (const char axis = static_cast<char>('x' + d);
          value[d] != 0.0 && axes.find(axis) == std::string::npos)
      {
        messages.push_back("Boundaries > " + name + " > Value: its " + std::string(1, axis) +
                           " component of " + formatShort(value[d]) + " m/s has no effect, because " +
                           "Components = " + axes + " leaves this axis free; write Components = " + axes +
                           axis + ", or 0");
        break;
      }
  }
}

template <int D>
bool anyMoves(const ParameterList& section)
{
  return std::any_of(section.begin(), section.end(),
                     [&](const auto& entry)
                     {
                       const auto* const list = valueIf<ParameterList>(entry.second);
                       return list != nullptr && list->template get<std::string>("Type") == "Velocity" &&
                              (list->isParameter("Field") ||
                               (list->isParameter("Value") && norm(readVector<D>(*list, "Value")) > 0.0));
                     });
}

} // namespace

template <int D>
Messages judgeCarried(const JudgedScene<D>& judged)
{
  Messages messages;
  if (!judged.state.method.mechanics || !judged.scene.isSublist("Boundaries"))
    return messages;
  const ParameterList& section = judged.scene.sublist("Boundaries");
  judgeComponents<D>(section, messages);
  if (judged.driven || judged.bodies.empty() || !anyMoves<D>(section))
    return messages;
  for (const std::string& message : Carried<D>(judged).judge())
    messages.push_back(message);
  return messages;
}

template Messages judgeCarried(const JudgedScene<2>&);
template Messages judgeCarried(const JudgedScene<3>&);

} // namespace Rhegma
