#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "base/ShortNumber.hpp"
#include "plausibility/BodyGroups.hpp"
#include "plausibility/Judges.hpp"
#include "plausibility/Pieces.hpp"
#include "plausibility/SupportReach.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace Rhegma
{

namespace
{

using Geometry::Bounds;
using Teuchos::ParameterList;

/// A load on a body, and how far it moves a unit of mass along each axis up to the end [kg m].
template <int D>
struct Push
{
  std::string where;
  int body;
  Vector<D> moment; ///< force times its history, integrated twice
};

/// What loads do to bodies that move as one.
template <int D>
struct Pushed
{
  Vector<D> moment{};       ///< of all its loads [kg m]
  double moments = 0.0;     ///< sum of their amounts [kg m]
  const Push<D>* hardest{}; ///< the largest of them
};

/// Loads of a scene. \param end of the run [s] \param pushes gets them \return whether all that acts is known
template <int D>
bool readPushes(const JudgedScene<D>& judged, double end, std::vector<Push<D>>& pushes)
{
  if (!judged.scene.isSublist("Boundaries"))
    return true;
  std::unordered_map<std::string, int> numbers;
  for (const BodyMeasure<D>& body : judged.bodies)
    numbers.emplace(body.name, static_cast<int>(numbers.size()));
  const ParameterList& section = judged.scene.sublist("Boundaries");
  for (const std::string& name : sublistNames(section))
  {
    const ParameterList& list = section.sublist(name);
    const std::string type = list.get<std::string>("Type");
    if (type == "Traction" || type == "Point Load" || type == "Line Load")
    {
      const double twice = rangeOf(list.get<std::string>("History"), end).twice;
      if (const auto body = numbers.find(list.get<std::string>("Body")); body != numbers.end())
        pushes.push_back({"Boundaries > " + name, body->second, twice * forceOf<D>(judged.scene, list)});
    }
    else if (type != "Gravity" && type != "Velocity" && type != "Symmetry")
      return false;
  }
  return true;
}

template <int D>
class Flights
{
public:
  /// \param end of the run [s]
  Flights(const JudgedScene<D>& judged, const std::vector<Push<D>>& pushes, double end)
      : judged_(judged),
        end_(end),
        supports_(supportRegions(judged.scene)),
        cell_(judged.state.mesh.grid.spacing),
        groups_(judged.bodies, cell_)
  {
    for (const Push<D>& push : pushes)
      add(push);
  }

  Messages judge() const
  {
    Messages messages;
    for (int c = 0; c < groups_.count(); ++c)
      judgeOne(c, messages);
    return messages;
  }

private:
  void add(const Push<D>& push)
  {
    const std::size_t group = groups_.of(push.body);
    pushed_.resize(std::max(pushed_.size(), group + 1));
    Pushed<D>& pushed = pushed_[group];
    pushed.moment = pushed.moment + push.moment;
    pushed.moments += norm(push.moment);
    if (pushed.hardest == nullptr || norm(push.moment) > norm(pushed.hardest->moment))
      pushed.hardest = &push;
  }

  bool isHeld(const BodyGroup<D>& group, int axis) const
  {
    return std::any_of(supports_.begin(), supports_.end(),
                       [&](const BoundaryRegion& support)
                       {
                         return support.axes.find(static_cast<char>('x' + axis)) != std::string::npos &&
                                std::any_of(group.bodies.begin(), group.bodies.end(),
                                            [&](int body)
                                            {
                                              const BodyMeasure<D>& one = judged_.bodies[body];
                                              return reaches<D>(support, {one.lower, one.upper}, cell_);
                                            });
                       });
  }

  /// Whether the domain reaches as far as the body flies, and further than on the other side: it is made for
  /// it.
  bool hasRoom(const Bounds<D>& box, const Vector<D>& by) const
  {
    const ParameterList& domain = judged_.scene.sublist("Domain");
    const Vector<D> lower = readVector<D>(domain, "Lower Corner"),
                    upper = readVector<D>(domain, "Upper Corner");
    bool room = true, oneSided = false;
    for (int d = 0; d < D; ++d)
    {
      const double below = box.lower[d] - lower[d], above = upper[d] - box.upper[d];
      const double ahead = by[d] > 0.0 ? above : below, behind = by[d] > 0.0 ? below : above;
      room = room && ahead >= std::fabs(by[d]);
      oneSided = oneSided || (std::fabs(by[d]) > 0.5 * norm(by) && ahead > 2.0 * behind);
    }
    return room && oneSided;
  }

  /// How far loads would stretch the hardest-loaded body if they balanced [m]: by their mean force over its
  /// section.
  double stretchOf(const Pushed<D>& pushed) const
  {
    const BodyMeasure<D>& body = judged_.bodies[pushed.hardest->body];
    const double force = 2.0 * pushed.moments / (end_ * end_);
    const double density = body.moduli.constrainedModulus / (body.speed * body.speed);
    return force * body.longest * body.longest * density / (body.mass * body.moduli.young);
  }

  void judgeOne(int number, Messages& messages) const
  {
    const BodyGroup<D>& group = groups_[number];
    const Pushed<D>& pushed = pushed_[number];
    Vector<D> by = (1.0 / group.mass) * pushed.moment;
    std::string axes;
    for (int d = 0; d < D; ++d)
      if (isHeld(group, d))
        by[d] = 0.0;
      else
        axes += std::string(axes.empty() ? "" : ", ") + "xyz"[d];
    const Vector<D> extents = group.bounds.upper - group.bounds.lower;
    const double size = *std::max_element(extents.c, extents.c + D), far = norm(by);
    // Fifty times its stretch is where waves have crossed the body ten times: c^2 T^2 / (2 L^2).
    constexpr double flies = 50.0, unbalanced = 0.1;
    // Of its length; a run that waits for rest gets there only without any such motion.
    const double visible = judged_.state.clock.stopWhenSettled ? 0.0 : 0.03;
    const double stretch = stretchOf(pushed);
    const bool carried =
        far > std::max(flies * stretch, visible * size) && far * group.mass > unbalanced * pushed.moments;
    if (!std::isfinite(far) || (far <= size && !carried) ||
        isThrown(judged_.scene, judged_.bodies, group.bodies) || groups_.isStopped(number, by, supports_) ||
        hasRoom(group.bounds, by))
      return;
    messages.push_back(
        pushed.hardest->where + ": no load balances it, and nothing supports Bodies > " +
        judged_.bodies[pushed.hardest->body].name + " along " + axes + ", so it moves by " +
        readableLength(far) + " up to the end (without damping; a mean acceleration of " +
        formatShort(2.0 * far / (end_ * end_)) + " m/s2), " + formatShort(far / size) +
        " times its length of " + readableLength(size) + ", where its loads would stretch it by " +
        readableLength(stretch) +
        "; add a support (Velocity, Symmetry) or the opposite load, and check its unit (N, Pa)");
  }

  const JudgedScene<D>& judged_;
  double end_;
  std::vector<BoundaryRegion> supports_;
  double cell_; ///< [m]
  BodyGroups<D> groups_;
  std::vector<Pushed<D>> pushed_; ///< by group
};

} // namespace

template <int D>
Messages judgeFlight(const JudgedScene<D>& judged)
{
  const Method& method = judged.state.method;
  if (!method.mechanics || method.equilibrium())
    return {};
  const double all = judged.scene.sublist("Time").template get<double>("Final Time");
  const double steps = judged.state.clock.maximumSteps * judged.step;
  std::vector<Push<D>> pushes;
  const double end = std::isfinite(steps) ? std::min(all, steps) : all;
  const bool known = readPushes(judged, end, pushes);
  return known && !pushes.empty() ? Flights<D>(judged, pushes, end).judge() : Messages{};
}

template Messages judgeFlight(const JudgedScene<2>&);
template Messages judgeFlight(const JudgedScene<3>&);

} // namespace Rhegma
