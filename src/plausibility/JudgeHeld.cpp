#include "base/ReadList.hpp"
#include "boundary/BodySurface.hpp"
#include "boundary/TouchedNodes.hpp"
#include "geometry/NearBoxes.hpp"
#include "plan/BoundaryType.hpp"
#include "plausibility/Judges.hpp"
#include "plausibility/SupportReach.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace Rhegma
{

namespace
{

using Teuchos::ParameterList;

/// A load on a body, and the axes along which it acts.
template <int D>
struct Loaded
{
  std::string where;
  int body;
  bool along[D];
  std::vector<Vector<D>> ends; ///< corners of the line or surface on which it acts; none of gravity [m]
};

/// Whether a support prescribes the motion of a position.
template <int D>
bool holdsAt(const BoundaryRegion& support, const Vector<D>& x, double slack)
{
  bool inside = true, strictly = true;
  for (int d = 0; d < D; ++d)
  {
    inside = inside && x[d] >= support.from[d] - slack && x[d] <= support.to[d] + slack;
    strictly = strictly && x[d] > support.from[d] + slack && x[d] < support.to[d] - slack;
  }
  return support.kind == BoundaryRegion::Kind::HeldOutside ? !strictly : inside;
}

/// Whether a support prescribes the motion of all of a box.
template <int D>
bool holdsBox(const BoundaryRegion& support, const Geometry::Bounds<D>& box, double slack)
{
  if (support.kind == BoundaryRegion::Kind::Held)
    return holdsAt<D>(support, box.lower, slack) && holdsAt<D>(support, box.upper, slack);
  bool apart = false; // from the box that is free
  for (int d = 0; d < D; ++d)
    apart = apart || box.upper[d] <= support.from[d] + slack || box.lower[d] >= support.to[d] - slack;
  return apart;
}

/// Whether a support prescribes the motion of all of a body.
template <int D>
bool holdsAll(const BoundaryRegion& support, const BodyMeasure<D>& body, double slack)
{
  return holdsBox<D>(support, {body.lower, body.upper}, slack);
}

/// Corners of the line or surface on which a load acts, or points all over it.
template <int D>
std::vector<Vector<D>> endsOf(const ParameterList& scene, const ParameterList& list)
{
  if (choosesSurface(list))
  {
    std::vector<Vector<D>> ends;
    for (const auto& point : chosenSurface<D>(scene, list, "Boundaries"))
      ends.push_back(point.x);
    return ends;
  }
  if (list.isParameter("Point"))
    return {readVector<D>(list, "Point")};
  if (list.isParameter("From"))
    return {readVector<D>(list, "From"), readVector<D>(list, "To")};
  if (!list.isParameter("Edge 1"))
    return {};
  const Vector<D> corner = readVector<D>(list, "Corner"), one = readVector<D>(list, "Edge 1"),
                  other = readVector<D>(list, "Edge 2");
  return {corner, corner + one, corner + other, corner + one + other};
}

/// Loads with an axis, those of gravity only where it acts on one body: another may be held on purpose.
template <int D>
std::vector<Loaded<D>> readLoaded(const JudgedScene<D>& judged)
{
  std::vector<Loaded<D>> loads;
  std::unordered_map<std::string, int> numbers;
  for (const BodyMeasure<D>& body : judged.bodies)
    numbers.emplace(body.name, static_cast<int>(numbers.size()));
  const ParameterList& section = judged.scene.sublist("Boundaries");
  for (const std::string& name : sublistNames(section))
  {
    const ParameterList& list = section.sublist(name);
    const bool gravity = list.get<std::string>("Type") == "Gravity";
    const Vector<D> force = gravity ? readVector<D>(list, "Acceleration") : forceOf<D>(judged.scene, list);
    if (!(norm(force) > 0.0) || (gravity && judged.bodies.size() != 1))
      continue;
    const auto body = gravity ? numbers.begin() : numbers.find(list.get<std::string>("Body"));
    if (body == numbers.end())
      continue;
    Loaded<D> load{"Boundaries > " + name, body->second, {}, {}};
    if (!gravity)
      load.ends = endsOf<D>(judged.scene, list);
    for (int d = 0; d < D; ++d)
      load.along[d] = std::fabs(force[d]) > 1e-6 * norm(force);
    loads.push_back(load);
  }
  return loads;
}

/// Supports with a box. A plane of symmetry is a flat one.
template <int D>
std::vector<BoundaryRegion> boxesOf(const ParameterList& scene)
{
  std::vector<BoundaryRegion> supports = boundaryRegions(scene);
  for (BoundaryRegion& region : supports)
    if (region.kind == BoundaryRegion::Kind::Mirror && !region.axes.empty())
    {
      const int axis = region.axes[0] - 'x';
      const double at = region.from[axis];
      region.kind = BoundaryRegion::Kind::Held;
      for (int d = 0; d < D; ++d)
      {
        region.from[d] = d == axis ? at : -std::numeric_limits<double>::infinity();
        region.to[d] = d == axis ? at : std::numeric_limits<double>::infinity();
      }
    }
  supports.erase(std::remove_if(supports.begin(), supports.end(),
                                [](const BoundaryRegion& region) {
                                  return region.kind != BoundaryRegion::Kind::Held &&
                                         region.kind != BoundaryRegion::Kind::HeldOutside;
                                }),
                 supports.end());
  return supports;
}

/// Which supports leave a body no motion of its own.
template <int D>
class Holders
{
public:
  explicit Holders(const JudgedScene<D>& judged)
      : judged_(judged),
        supports_(boxesOf<D>(judged.scene)),
        slack_(1e-6 * judged.state.mesh.grid.spacing),
        inside_(boxesOfSupports<D>(supports_))
  {
    for (const BoundaryRegion& support : supports_)
      if (support.kind == BoundaryRegion::Kind::HeldOutside)
        outside_.push_back(static_cast<int>(&support - supports_.data()));
  }

  bool any() const { return !supports_.empty(); }

  /// Name of the support that holds all of a body along an axis, or of one of those that do it together;
  /// empty: none does. Of several supports only those of a single body are looked at.
  std::string of(int number, int axis)
  {
    const BodyMeasure<D>& body = judged_.bodies[number];
    const auto has = [axis](const BoundaryRegion& support)
    { return support.axes.find(static_cast<char>('x' + axis)) != std::string::npos; };
    for (const BoundaryRegion* support : near({body.lower, body.upper}))
      if (has(*support) && holdsAll(*support, body, slack_))
        return support->name;
    if (judged_.bodies.size() != 1 || std::count_if(supports_.begin(), supports_.end(), has) < 2)
      return {};
    if (nodes_.empty())
      nodes_ = touchedNodes(judged_.state);
    std::string last;
    for (const Vector<D>& x : nodes_)
    {
      bool inside = true;
      for (int d = 0; d < D; ++d)
        inside = inside && x[d] >= body.lower[d] - slack_ && x[d] <= body.upper[d] + slack_;
      if (!inside)
        continue;
      const auto holder = std::find_if(supports_.begin(), supports_.end(),
                                       [&](const BoundaryRegion& support)
                                       { return has(support) && holdsAt(support, x, slack_); });
      if (holder == supports_.end())
        return {};
      last = holder->name;
    }
    return last;
  }

  /// Name of a support that holds along an axis what lies between points of a body; empty: none does.
  std::string of(const std::vector<Vector<D>>& ends, int axis) const
  {
    Geometry::Bounds<D> bounds = Geometry::emptyBounds<D>();
    for (const Vector<D>& x : ends)
      bounds.include(x);
    for (const BoundaryRegion* support : near(bounds))
      if (!ends.empty() && support->axes.find(static_cast<char>('x' + axis)) != std::string::npos &&
          holdsBox<D>(*support, bounds, slack_))
        return support->name;
    return {};
  }

private:
  /// Supports that may hold a part of a box.
  std::vector<const BoundaryRegion*> near(const Geometry::Bounds<D>& box) const
  {
    std::vector<const BoundaryRegion*> found;
    for (const int k : inside_.near(box, slack_))
      found.push_back(&supports_[k]);
    for (const int k : outside_)
      found.push_back(&supports_[k]);
    return found;
  }

  const JudgedScene<D>& judged_;
  std::vector<BoundaryRegion> supports_;
  double slack_;                  ///< [m]
  Geometry::NearBoxes<D> inside_; ///< of the supports
  std::vector<int> outside_;      ///< numbers of those that hold the outside of a box
  std::vector<Vector<D>> nodes_;
};

/// What holds a load, and along which of its axes; axes are empty where nothing does.
struct Holder
{
  std::string axes, support;
};

/// \param nameOf name of what holds it along an axis, or empty
template <int D, class NameOf>
Holder holderOf(const Loaded<D>& load, const NameOf& nameOf)
{
  Holder holder;
  for (int d = 0; d < D; ++d)
    if (const std::string name = load.along[d] ? nameOf(d) : std::string(); !name.empty())
    {
      holder.axes += std::string(holder.axes.empty() ? "" : ", ") + "xyz"[d];
      holder.support = name;
    }
  return holder;
}

} // namespace

template <int D>
Messages judgeHeld(const JudgedScene<D>& judged)
{
  Messages messages;
  if (!judged.state.method.mechanics || !judged.scene.isSublist("Boundaries"))
    return messages;
  Holders<D> holders(judged);
  if (!holders.any())
    return messages;
  std::vector<char> said(judged.bodies.size(), 0);
  for (const Loaded<D>& load : readLoaded(judged))
  {
    const std::string body = "Bodies > " + judged.bodies[load.body].name;
    const auto byBody = [&](int d) { return holders.of(load.body, d); };
    const auto byEnds = [&](int d) { return holders.of(load.ends, d); };
    if (const Holder all = said[load.body] == 0 ? holderOf(load, byBody) : Holder{}; !all.axes.empty())
    {
      said[load.body] = 1;
      messages.push_back("Boundaries > " + all.support + ": it prescribes the motion of all of " + body +
                         " along " + all.axes + ", so that " + load.where +
                         " does not strain the body along " + all.axes +
                         "; hold a part of it only (Lower Corner, Upper Corner), or fewer Components");
    }
    else if (const Holder part = said[load.body] == 0 ? holderOf(load, byEnds) : Holder{}; !part.axes.empty())
      messages.push_back(load.where + ": it acts where Boundaries > " + part.support +
                         " prescribes the motion along " + part.axes + ", so that the support takes it and " +
                         body + " is hardly strained by it along " + part.axes +
                         "; load another part, or hold a smaller one");
  }
  return messages;
}

template Messages judgeHeld(const JudgedScene<2>&);
template Messages judgeHeld(const JudgedScene<3>&);

} // namespace Rhegma
