#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "base/ShortNumber.hpp"
#include "geometry/NearBoxes.hpp"
#include "plausibility/Judges.hpp"
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

/// Bodies that move as one, for they share nodes.
template <int D>
struct Cluster
{
  Bounds<D> bounds;
  double mass = 0.0;         ///< [kg]
  std::vector<int> bodies{}; ///< their numbers
  Vector<D> moment{};        ///< of all its loads [kg m]
  double moments = 0.0;      ///< sum of their amounts [kg m]
  const Push<D>* hardest{};  ///< the largest of them
};

template <int D>
std::vector<Bounds<D>> boundsOf(const std::vector<BodyMeasure<D>>& bodies)
{
  std::vector<Bounds<D>> bounds;
  bounds.reserve(bodies.size());
  for (const BodyMeasure<D>& body : bodies)
    bounds.push_back({body.lower, body.upper});
  return bounds;
}

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
        pushes.push_back(
            {"Boundaries > " + name, body->second, twice * forceOf<D>(list, judged.state.method.thickness)});
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
        supports_(boundaryRegions(judged.scene)),
        cell_(judged.state.mesh.grid.spacing),
        bounds_(boundsOf(judged.bodies)),
        boxes_(bounds_),
        clusterOf_(judged.bodies.size(), -1)
  {
    supports_.erase(std::remove_if(supports_.begin(), supports_.end(),
                                   [](const BoundaryRegion& region)
                                   { return region.kind == BoundaryRegion::Kind::Force; }),
                    supports_.end());
    for (const Push<D>& push : pushes)
      add(push);
  }

  Messages judge() const
  {
    Messages messages;
    for (std::size_t c = 0; c < clusters_.size(); ++c)
      judgeOne(static_cast<int>(c), messages);
    return messages;
  }

private:
  void add(const Push<D>& push)
  {
    if (clusterOf_[push.body] < 0)
      gather(push.body);
    Cluster<D>& cluster = clusters_[clusterOf_[push.body]];
    cluster.moment = cluster.moment + push.moment;
    cluster.moments += norm(push.moment);
    if (cluster.hardest == nullptr || norm(push.moment) > norm(cluster.hardest->moment))
      cluster.hardest = &push;
  }

  /// The cluster of a body.
  void gather(int first)
  {
    const int number = static_cast<int>(clusters_.size());
    Cluster<D> cluster{bounds_[first]};
    cluster.bodies.push_back(first);
    clusterOf_[first] = number;
    for (std::size_t k = 0; k < cluster.bodies.size(); ++k)
    {
      const int body = cluster.bodies[k];
      cluster.bounds.include(bounds_[body]);
      cluster.mass += judged_.bodies[body].mass;
      for (const int other : boxes_.near(bounds_[body], 2.0 * cell_))
        if (clusterOf_[other] < 0)
        {
          clusterOf_[other] = number;
          cluster.bodies.push_back(other);
        }
    }
    clusters_.push_back(cluster);
  }

  bool isHeld(const Cluster<D>& cluster, int axis) const
  {
    return std::any_of(supports_.begin(), supports_.end(),
                       [&](const BoundaryRegion& support)
                       {
                         return support.axes.find(static_cast<char>('x' + axis)) != std::string::npos &&
                                std::any_of(cluster.bodies.begin(), cluster.bodies.end(),
                                            [&](int body) { return reaches(support, bounds_[body], cell_); });
                       });
  }

  bool isThrown(const Cluster<D>& cluster) const
  {
    const ParameterList& section = judged_.scene.sublist("Bodies");
    for (const int body : cluster.bodies)
      for (const char* const motion : {"Velocity", "Angular Velocity"})
        for (const double v :
             section.sublist(judged_.bodies[body].name).template get<Teuchos::Array<double>>(motion))
          if (v != 0.0)
            return true;
    return false;
  }

  /// Whether a support or another body is in the way.
  bool hits(int number, const Vector<D>& by) const
  {
    const Cluster<D>& cluster = clusters_[number];
    Bounds<D> swept = cluster.bounds;
    swept.include({cluster.bounds.lower + by, cluster.bounds.upper + by});
    for (const BoundaryRegion& support : supports_)
      if (!reaches(support, cluster.bounds, cell_) && reaches(support, swept, cell_))
        return true;
    const std::vector<int> near = boxes_.near(swept, cell_);
    return std::any_of(near.begin(), near.end(), [&](int body) { return clusterOf_[body] != number; });
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

  /// How far the loads of a cluster would stretch its hardest-loaded body if they balanced [m]: by their mean
  /// force over its section.
  double stretchOf(const Cluster<D>& cluster) const
  {
    const BodyMeasure<D>& body = judged_.bodies[cluster.hardest->body];
    const double force = 2.0 * cluster.moments / (end_ * end_);
    const double density = body.moduli.constrainedModulus / (body.speed * body.speed);
    return force * body.longest * body.longest * density / (body.mass * body.moduli.young);
  }

  void judgeOne(int number, Messages& messages) const
  {
    const Cluster<D>& cluster = clusters_[number];
    Vector<D> by = (1.0 / cluster.mass) * cluster.moment;
    std::string axes;
    for (int d = 0; d < D; ++d)
      if (isHeld(cluster, d))
        by[d] = 0.0;
      else
        axes += std::string(axes.empty() ? "" : ", ") + "xyz"[d];
    const Vector<D> extents = cluster.bounds.upper - cluster.bounds.lower;
    const double size = *std::max_element(extents.c, extents.c + D), far = norm(by);
    // Fifty times its stretch is where waves have crossed the body ten times: c^2 T^2 / (2 L^2).
    constexpr double flies = 50.0, unbalanced = 0.1, visible = 0.03; // of its length
    const double stretch = stretchOf(cluster);
    const bool carried = far > std::max(flies * stretch, visible * size) &&
                         norm(by) * cluster.mass > unbalanced * cluster.moments;
    if (!std::isfinite(far) || (far <= size && !carried) || isThrown(cluster) || hits(number, by) ||
        hasRoom(cluster.bounds, by))
      return;
    messages.push_back(
        cluster.hardest->where + ": no load balances it, and nothing supports Bodies > " +
        judged_.bodies[cluster.hardest->body].name + " along " + axes + ", so it moves by " +
        readableLength(far) + " up to the end (without damping), " + formatShort(far / size) +
        " times its length of " + readableLength(size) + ", where its loads would stretch it by " +
        readableLength(stretch) +
        "; add a support (Velocity, Symmetry) or the opposite load, and check its unit (N, Pa)");
  }

  const JudgedScene<D>& judged_;
  double end_;
  std::vector<BoundaryRegion> supports_;
  double cell_;                   ///< [m]
  std::vector<Bounds<D>> bounds_; ///< of the bodies
  Geometry::NearBoxes<D> boxes_;
  std::vector<int> clusterOf_; ///< by body; -1: no load pushes it
  std::vector<Cluster<D>> clusters_;
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
