#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "base/ShortNumber.hpp"
#include "geometry/NearBoxes.hpp"
#include "plan/BoundaryType.hpp"
#include "plausibility/Bonds.hpp"
#include "plausibility/Judges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace Rhegma
{

namespace
{

using Geometry::Bounds;
using Teuchos::ParameterList;

/// A support that moves, and with it the bodies that are all inside of it.
template <int D>
struct MovingSupport
{
  Bounds<D> box;
  std::string axes;
  Vector<D> velocity; ///< mean over the run [m/s]
};

template <int D>
std::vector<MovingSupport<D>> movingSupports(const ParameterList& scene, double end)
{
  std::vector<MovingSupport<D>> supports;
  for (const BoundaryRegion& region : boundaryRegions(scene))
  {
    const ParameterList& list = scene.sublist("Boundaries").sublist(region.name);
    if (region.kind != BoundaryRegion::Kind::Held || !list.isParameter("Value"))
      continue;
    MovingSupport<D> support{{}, region.axes, {}};
    const double mean = rangeOf(list.get<std::string>("History"), end).integral / end;
    support.velocity = mean * readVector<D>(list, "Value");
    for (int d = 0; d < D; ++d)
    {
      support.box.lower[d] = region.from[d];
      support.box.upper[d] = region.to[d];
    }
    supports.push_back(support);
  }
  return supports;
}

template <int D>
bool contains(const Bounds<D>& box, const BodyMeasure<D>& body)
{
  for (int d = 0; d < D; ++d)
    if (box.lower[d] > body.lower[d] || box.upper[d] < body.upper[d])
      return false;
  return true;
}

/// Velocities of the bodies while nothing acts on them but supports that hold all of them [m/s].
template <int D>
std::vector<Vector<D>> velocities(const JudgedScene<D>& judged, double end)
{
  std::vector<Vector<D>> all;
  const auto supports = movingSupports<D>(judged.scene, end);
  for (const BodyMeasure<D>& body : judged.bodies)
  {
    Vector<D> v = body.velocity;
    for (const MovingSupport<D>& support : supports)
      for (int d = 0; d < D; ++d)
        if (contains(support.box, body) && support.axes.find(static_cast<char>('x' + d)) != std::string::npos)
          v[d] = support.velocity[d];
    all.push_back(v);
  }
  return all;
}

/// When the bounds of two bodies come within a distance of each other; nothing where they are so at the start
/// or never are. \param v velocity of the first relative to the second [m/s] \param distance [m]
template <int D>
std::optional<double> meet(const BodyMeasure<D>& one, const BodyMeasure<D>& other, const Vector<D>& v,
                           double distance)
{
  double first = 0.0, last = std::numeric_limits<double>::infinity();
  for (int d = 0; d < D; ++d)
  {
    // Distances that the first body goes along the axis until they are near, and until they are no more.
    const double to = other.lower[d] - one.upper[d] - distance,
                 past = other.upper[d] - one.lower[d] + distance;
    if (v[d] == 0.0)
    {
      if (to > 0.0 || past < 0.0)
        return {};
      continue;
    }
    first = std::max(first, (v[d] > 0.0 ? to : past) / v[d]);
    last = std::min(last, (v[d] > 0.0 ? past : to) / v[d]);
  }
  if (first <= 0.0 || first > last)
    return {};
  return first;
}

template <int D>
class Meetings
{
  static constexpr double sharing = 2.0; ///< cells between bodies that may have nodes in common
public:
  explicit Meetings(const JudgedScene<D>& judged)
      : judged_(judged),
        end_(judged.scene.sublist("Time").template get<double>("Final Time")),
        cell_(judged.state.mesh.grid.spacing),
        velocity_(velocities(judged, end_)),
        bonded_(bondedPairs(judged.scene))
  {
  }

  Messages judge() const
  {
    Messages messages;
    if (!std::any_of(velocity_.begin(), velocity_.end(), [](const Vector<D>& v) { return norm(v) > 0.0; }))
      return messages;
    std::vector<Bounds<D>> swept;
    for (std::size_t b = 0; b < judged_.bodies.size(); ++b)
      swept.push_back(sweptBy(static_cast<int>(b)));
    const Geometry::NearBoxes<D> boxes(swept);
    long looks = 1'000'000; // at pairs; so many bodies on their way have met by then
    for (int b = 0; b < static_cast<int>(swept.size()) && looks > 0; ++b)
      if (norm(velocity_[b]) > 0.0)
        for (const int other : boxes.near(swept[b], sharing * cell_))
          if (--looks > 0 && other != b && (other > b || norm(velocity_[other]) == 0.0))
            judgePair(b, other, messages);
    return messages;
  }

private:
  /// All that a body passes while it is in the domain.
  Bounds<D> sweptBy(int body) const
  {
    Bounds<D> bounds{judged_.bodies[body].lower, judged_.bodies[body].upper};
    const auto& grid = judged_.state.mesh.grid;
    for (int d = 0; d < D; ++d)
    {
      const double travel = end_ * velocity_[body][d], domain = grid.cells[d] * grid.spacing;
      bounds.lower[d] += std::clamp(travel, -domain, 0.0);
      bounds.upper[d] += std::clamp(travel, 0.0, domain);
    }
    return bounds;
  }

  void judgePair(int one, int other, Messages& messages) const
  {
    const auto [first, second] = std::minmax(one, other);
    const BodyMeasure<D>&a = judged_.bodies[first], &b = judged_.bodies[second];
    const Vector<D> v = velocity_[first] - velocity_[second];
    const std::optional<double> shared = meet(a, b, v, sharing * cell_), touch = meet(a, b, v, 0.0);
    if (!shared || *shared > end_ || bonded_.count({a.name, b.name}) > 0)
      return;
    messages.push_back(
        "Bodies > " + b.name + ": it and Bodies > " + a.name + " approach each other at " +
        formatShort(norm(v)) + " m/s" +
        (touch && *touch <= end_ ? " and meet at about t = " + readableTime(*touch) : std::string()) +
        ". Bodies have no contact law: once they are less than one to two cells (" + readableLength(cell_) +
        ") apart, from about t = " + readableTime(*shared) +
        " on, they share one motion, which resists not only compression but also sliding and separation; "
        "use smaller cells to shorten that distance, and do not rely on what follows from sliding or "
        "parting");
  }

  const JudgedScene<D>& judged_;
  double end_;  ///< of the run [s]
  double cell_; ///< largest [m]
  std::vector<Vector<D>> velocity_;
  std::set<std::pair<std::string, std::string>> bonded_;
};

} // namespace

template <int D>
Messages judgeMeetings(const JudgedScene<D>& judged)
{
  if (!judged.state.method.mechanics || judged.bodies.size() < 2)
    return {};
  return Meetings<D>(judged).judge();
}

template Messages judgeMeetings(const JudgedScene<2>&);
template Messages judgeMeetings(const JudgedScene<3>&);

} // namespace Rhegma
