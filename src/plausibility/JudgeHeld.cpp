#include "base/ReadList.hpp"
#include "boundary/TouchedNodes.hpp"
#include "plan/BoundaryType.hpp"
#include "plausibility/Judges.hpp"

#include <algorithm>
#include <cmath>
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

/// Whether a support prescribes the motion of all of a body.
template <int D>
bool holdsAll(const BoundaryRegion& support, const BodyMeasure<D>& body, double slack)
{
  if (support.kind == BoundaryRegion::Kind::Held)
    return holdsAt<D>(support, body.lower, slack) && holdsAt<D>(support, body.upper, slack);
  bool apart = false; // from the box that is free
  for (int d = 0; d < D; ++d)
    apart = apart || body.upper[d] <= support.from[d] + slack || body.lower[d] >= support.to[d] - slack;
  return apart;
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
    const Vector<D> force =
        gravity ? readVector<D>(list, "Acceleration") : forceOf<D>(list, judged.state.method.thickness);
    if (!(norm(force) > 0.0) || (gravity && judged.bodies.size() != 1))
      continue;
    const auto body = gravity ? numbers.begin() : numbers.find(list.get<std::string>("Body"));
    if (body == numbers.end())
      continue;
    Loaded<D> load{"Boundaries > " + name, body->second, {}};
    for (int d = 0; d < D; ++d)
      load.along[d] = std::fabs(force[d]) > 1e-6 * norm(force);
    loads.push_back(load);
  }
  return loads;
}

/// Supports with a box.
std::vector<BoundaryRegion> boxesOf(const ParameterList& scene)
{
  std::vector<BoundaryRegion> supports = boundaryRegions(scene);
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
      : judged_(judged), supports_(boxesOf(judged.scene)), slack_(1e-6 * judged.state.mesh.grid.spacing)
  {
  }

  bool any() const { return !supports_.empty(); }

  /// Name of the support that holds all of a body along an axis, or of one of those that do it together;
  /// empty: none does. Of several supports only those of a single body are looked at.
  std::string of(int number, int axis)
  {
    const BodyMeasure<D>& body = judged_.bodies[number];
    const auto has = [axis](const BoundaryRegion& support)
    { return support.axes.find(static_cast<char>('x' + axis)) != std::string::npos; };
    for (const BoundaryRegion& support : supports_)
      if (has(support) && holdsAll(support, body, slack_))
        return support.name;
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

private:
  const JudgedScene<D>& judged_;
  std::vector<BoundaryRegion> supports_;
  double slack_; ///< [m]
  std::vector<Vector<D>> nodes_;
};

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
    std::string axes, holder;
    for (int d = 0; d < D && said[load.body] == 0; ++d)
      if (const std::string name = load.along[d] ? holders.of(load.body, d) : std::string(); !name.empty())
      {
        axes += std::string(axes.empty() ? "" : ", ") + "xyz"[d];
        holder = name;
      }
    if (axes.empty())
      continue;
    said[load.body] = 1;
    messages.push_back("Boundaries > " + holder + ": it prescribes the motion of all of Bodies > " +
                       judged.bodies[load.body].name + " along " + axes + ", so that " + load.where +
                       " does not strain it; hold a part of the body only (Lower Corner, Upper Corner), or "
                       "fewer Components");
  }
  return messages;
}

template Messages judgeHeld(const JudgedScene<2>&);
template Messages judgeHeld(const JudgedScene<3>&);

} // namespace Rhegma
