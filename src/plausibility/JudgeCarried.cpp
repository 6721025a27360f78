#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "base/ShortNumber.hpp"
#include "plausibility/BodyGroups.hpp"
#include "plausibility/Judges.hpp"
#include "plausibility/Pieces.hpp"
#include "plausibility/SupportReach.hpp"
#include "scene/TimeFunction.hpp"

#include <algorithm>
#include <cmath>
#include <map>
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

  bool holds(int axis) const { return region->axes.find(static_cast<char>('x' + axis)) != std::string::npos; }
};

template <int D>
Prescribed<D> prescribedBy(const BoundaryRegion& region, const ParameterList& list)
{
  Prescribed<D> prescribed{&region};
  if (region.kind == BoundaryRegion::Kind::Mirror)
  {
    prescribed.known = true;
    return prescribed;
  }
  prescribed.history = list.get<std::string>("History");
  prescribed.known = list.isParameter("Value");
  if (prescribed.known)
    prescribed.value = readVector<D>(list, "Value");
  return prescribed;
}

/// Whether two supports prescribe the same motion along an axis.
template <int D>
bool agree(const Prescribed<D>& one, const Prescribed<D>& other, int axis)
{
  constexpr double rounding = 1e-9;
  const double a = one.value[axis], b = other.value[axis];
  return one.known && other.known && std::fabs(a - b) <= rounding * (std::fabs(a) + std::fabs(b)) &&
         (a == 0.0 || one.history == other.history);
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
      supports_.push_back(prescribedBy<D>(region, judged.scene.sublist("Boundaries").sublist(region.name)));
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

  /// Whether supports hold both ends of a group along an axis, none of them all of it.
  bool gripBothEnds(const Bounds<D>& group, const std::vector<int>& movers, int axis) const
  {
    const double gap = 2.0 * cell_;
    bool low = false, high = false;
    for (const int k : movers)
    {
      const Bounds<D> part = partIn(group, regions_[k]);
      const bool atLow =
          part.lower[axis]<group.lower[axis] + gap, atHigh = part.upper[axis]> group.upper[axis] - gap;
      if (atLow && atHigh)
        return false;
      low = low || atLow;
      high = high || atHigh;
    }
    return low && high;
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
      if (supports_[k].holds(axis) && supports_[k].value[axis] != 0.0 &&
          regions_[k].kind == BoundaryRegion::Kind::Held)
        movers.push_back(k);
    const BodyGroup<D>& group = groups_[number];
    if (movers.size() < 2 || !allAgree(supports) || isLoaded(group) ||
        !gripBothEnds(group.bounds, movers, axis))
      return false;
    const Prescribed<D>& first = supports_[movers[0]];
    const double far = std::fabs(first.value[axis]) * rangeOf(first.history, end_).integral;
    Vector<D> by{};
    by[axis] = first.value[axis] > 0.0 ? far : -far;
    if (!(far > 0.0) || !std::isfinite(far) || groups_.isStopped(number, by, regions_))
      return false;
    const char letter = static_cast<char>('x' + axis);
    messages.push_back("Boundaries > " + first.region->name + ": it and Boundaries > " +
                       supports_[movers.back()].region->name + " move both ends of Bodies > " +
                       judged_.bodies[group.bodies.front()].name + " the same distance along " + letter +
                       ", " + readableLength(far) + " (Value = " + formatShort(first.value[axis]) +
                       " m/s for both), so that " +
                       (judged_.state.method.equilibrium() ? "nothing" : "only its inertia") +
                       " strains it; to pull it, change the sign of "
                       "one Value, or set one to zero");
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
                              list->isParameter("Value") && norm(readVector<D>(*list, "Value")) > 0.0;
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
