#include "plausibility/LoadEstimate.hpp"

#include "base/ReadList.hpp"
#include "boundary/TouchedNodes.hpp"
#include "geometry/Cross.hpp"
#include "scene/PositionFunction.hpp"
#include "scene/TimeFunction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Rhegma
{

HistoryRange rangeOf(const std::string& history, double end)
{
  constexpr int times = 257; // as many as supports are compared at (boundary/Contradictions.cpp)
  const TimeFunction f = TimeFunction::parse(history);
  HistoryRange range;
  double integral = 0.0, before = f(0.0);
  for (int k = 0; k < times; ++k)
  {
    const double now = f(end * k / (times - 1));
    integral += k == 0 ? 0.0 : 0.5 * (before + now) * end / (times - 1);
    range.largest = std::max(range.largest, std::fabs(now));
    range.integral = std::max(range.integral, std::fabs(integral));
    before = now;
  }
  return range;
}

const LoadEstimate* largestStrain(const std::vector<LoadEstimate>& loads)
{
  const auto most =
      std::max_element(loads.begin(), loads.end(),
                       [](const LoadEstimate& a, const LoadEstimate& b) { return a.strain < b.strain; });
  return most == loads.end() ? nullptr : &*most;
}

namespace
{

using Teuchos::ParameterList;

/// What moves a node along an axis, and by how much during the run.
struct Moved
{
  double by;
  std::string where;
};

/// A stress that acts evenly on a body.
template <int D>
LoadEstimate even(const std::string& where, double stress, const BodyMeasure<D>& body)
{
  return {where, stress / body.moduli.young, stress, stress};
}

/// Normal of the loaded surface, as long as its area [m2].
Vector<2> surfaceOf(const ParameterList& list, const Vector<2>&, double thickness)
{
  const Vector<2> along = readVector<2>(list, "To") - readVector<2>(list, "From");
  return thickness * Vector<2>{along[1], -along[0]};
}
Vector<3> surfaceOf(const ParameterList& list, const Vector<3>&, double)
{
  return cross(readVector<3>(list, "Edge 1"), readVector<3>(list, "Edge 2"));
}

/// Across the longest axis a force bends, along it, it pulls at one side of the section at most.
template <int D>
LoadEstimate ofForce(const std::string& where, const Vector<D>& force, const BodyMeasure<D>& body)
{
  const Vector<D> extents = body.upper - body.lower;
  const int longest = static_cast<int>(std::max_element(extents.c, extents.c + D) - extents.c);
  const double size = norm(force), wide = body.volume / body.shortest, narrow = body.volume / body.longest;
  const bool along = std::fabs(force[longest]) > 0.9 * size;
  const double lever = along ? 4.0 : 1.0 + 6.0 * body.longest / body.shortest;
  return {where, size / wide / body.moduli.young, size / wide, size / narrow * lever};
}

/// Largest rate at which a history changes [1/s].
double steepest(const std::string& history, double end)
{
  constexpr int times = 257;
  const TimeFunction f = TimeFunction::parse(history);
  double rate = f(0.0) == 0.0 ? 0.0 : std::numeric_limits<double>::infinity(); // all bodies start at rest
  for (int k = 1; k < times; ++k)
    rate = std::max(rate, std::fabs(f(end * k / (times - 1)) - f(end * (k - 1) / (times - 1))) *
                              ((times - 1) / end));
  return rate;
}

/// Estimates of the section Boundaries.
template <int D>
class OfBoundaries
{
public:
  OfBoundaries(const ParameterList& scene, const State<D>& state, const std::vector<BodyMeasure<D>>& bodies)
      : state_(state),
        bodies_(bodies),
        end_(scene.isSublist("Time") ? scene.sublist("Time").get<double>("Final Time") : 0.0),
        boundaries_(scene.isSublist("Boundaries") ? scene.sublist("Boundaries") : ParameterList())
  {
  }

  std::vector<LoadEstimate> all()
  {
    for (const std::string& name : sublistNames(boundaries_))
    {
      const ParameterList& list = boundaries_.sublist(name);
      const std::string type = list.get<std::string>("Type"), where = "Boundaries > " + name;
      if (type == "Traction" || type == "Point Load" || type == "Line Load")
        load(list, type, where);
      else if (type == "Gravity")
        for (const BodyMeasure<D>& body : bodies_)
          found_.push_back(even(where,
                                norm(readVector<D>(list, "Acceleration")) * factor(list).largest *
                                    body.density * body.longest,
                                body));
      else if (type == "Velocity" || type == "Symmetry")
        supports_.push_back(name);
    }
    if (!supports_.empty())
      supports();
    return found_;
  }

private:
  HistoryRange factor(const ParameterList& list) const
  {
    return rangeOf(list.get<std::string>("History"), end_);
  }

  void load(const ParameterList& list, const std::string& type, const std::string& where)
  {
    for (const BodyMeasure<D>& body : bodies_)
    {
      if (body.name != list.get<std::string>("Body"))
        continue;
      const double most = factor(list).largest;
      if (type != "Traction")
        found_.push_back(ofForce<D>(where, most * readVector<D>(list, "Force"), body));
      else
      {
        const Vector<D> surface = surfaceOf(list, body.lower, state_.method.thickness);
        const Vector<D> force = list.isParameter("Pressure")
                                    ? most * list.get<double>("Pressure") * surface
                                    : most * norm(surface) * readVector<D>(list, "Stress");
        const double stress = norm(force) / norm(surface);
        LoadEstimate estimate = even(where, stress, body);
        estimate.highest = std::max(stress, ofForce<D>(where, force, body).highest);
        found_.push_back(estimate);
      }
    }
  }

  /// How far supports move apart along each axis, and how fast they push.
  void supports()
  {
    const std::vector<Vector<D>> nodes = touchedNodes(state_);
    for (int d = 0; d < D; ++d)
    {
      const Moved none{0.0, {}};
      Moved most = none, least = none;
      bool any = false;
      for (const std::string& name : supports_)
        moves(name, d, nodes,
              [&](const Moved& moved)
              {
                most = !any || moved.by > most.by ? moved : most;
                least = !any || moved.by < least.by ? moved : least;
                any = true;
              });
      if (any && most.by > least.by)
        apart(most, least);
      else if (any && most.by != 0.0) // only inertia resists
        impact(most.where, true);
    }
  }

  /// Calls see(Moved) for every node that a support holds along an axis.
  template <class See>
  void moves(const std::string& name, int axis, const std::vector<Vector<D>>& nodes, const See& see)
  {
    const ParameterList& list = boundaries_.sublist(name);
    const std::string where = "Boundaries > " + name;
    if (list.get<std::string>("Type") == "Symmetry")
    {
      const double position = list.get<double>("Position");
      if (list.get<std::string>("Axis")[0] == 'x' + axis)
        for (const Vector<D>& x : nodes)
          if (std::fabs(x[axis] - position) < 0.5 * state_.mesh.grid.spacing)
            see({0.0, where});
      return;
    }
    if (list.get<std::string>("Components").find(static_cast<char>('x' + axis)) == std::string::npos)
      return;
    const HistoryRange range = factor(list);
    const Vector<D> lower = readVector<D>(list, "Lower Corner"), upper = readVector<D>(list, "Upper Corner");
    const bool varies = list.isParameter("Field");
    const PositionFunction field =
        PositionFunction::parse(varies ? list.get<std::string>("Field") : (D == 2 ? "0, 0" : "0, 0, 0"), D);
    fastest_ = 0.0;
    for (const Vector<D>& x : nodes)
    {
      bool in = true;
      for (int d = 0; d < D; ++d)
        in = in && x[d] >= lower[d] && x[d] <= upper[d];
      if (in == (list.get<std::string>("Nodes") == "Outside"))
        continue;
      const double v = varies ? field(x)[axis] : readVector<D>(list, "Value")[axis];
      if (!std::isfinite(v))
        continue;
      fastest_ = std::max(fastest_, std::fabs(v) * range.largest);
      see({v * range.integral, where});
    }
    rise_ = steepest(list.get<std::string>("History"), end_);
    largest_ = range.largest;
    impact(where, false);
  }

  /// The last support that moved pushes a body. \param freely whether only inertia resists: then the body has
  /// the stress of its wave, or of its acceleration where that is slower
  void impact(const std::string& where, bool freely)
  {
    if (fastest_ == 0.0)
      return;
    for (const BodyMeasure<D>& body : bodies_)
    {
      const double wave = body.density * body.speed * fastest_;
      const double slow = body.density * body.longest * fastest_ * rise_ / largest_;
      const double nominal = freely ? 0.5 * std::min(wave, slow) : 0.0;
      found_.push_back({where, nominal / body.moduli.young, nominal, wave});
    }
  }

  void apart(const Moved& one, const Moved& other)
  {
    const double by = one.by - other.by;
    const std::string& where = one.by > -other.by ? one.where : other.where;
    for (const BodyMeasure<D>& body : bodies_)
    {
      const double bent = by * body.shortest / (body.longest * body.longest); // a crack may let arms bend
      found_.push_back({where, bent, bent * body.moduli.young, by / body.shortest * body.moduli.young});
    }
  }

  const State<D>& state_;
  const std::vector<BodyMeasure<D>>& bodies_;
  double end_;
  ParameterList boundaries_;
  std::vector<std::string> supports_;
  std::vector<LoadEstimate> found_;
  double fastest_ = 0.0, rise_ = 0.0, largest_ = 0.0; ///< of the last support that was looked at
};

/// Bodies that hit something, and bodies that spin.
template <int D>
void addVelocities(const ParameterList& scene, const std::vector<BodyMeasure<D>>& bodies,
                   std::vector<LoadEstimate>& found)
{
  if (!scene.isSublist("Bodies"))
    return;
  const ParameterList& section = scene.sublist("Bodies");
  const bool obstacles = bodies.size() > 1 || scene.isSublist("Boundaries");
  for (const BodyMeasure<D>& body : bodies)
  {
    const ParameterList& list = section.sublist(body.name);
    const std::string where = "Bodies > " + body.name;
    const double v = norm(readVector<D>(list, "Velocity"));
    const double impact = body.density * body.speed * v;
    if (v > 0.0 && obstacles)
      found.push_back({where + " > Velocity", 0.5 * impact / body.moduli.young, 0.5 * impact, 2.0 * impact});
    double spin = 0.0;
    for (const double w : list.get<Teuchos::Array<double>>("Angular Velocity"))
      spin += w * w;
    if (spin > 0.0)
      found.push_back(even(where + " > Angular Velocity",
                           0.25 * body.density * spin * body.longest * body.longest, body));
  }
}

} // namespace

template <int D>
std::vector<LoadEstimate> estimateLoads(const ParameterList& scene, const State<D>& state,
                                        const std::vector<BodyMeasure<D>>& bodies)
{
  std::vector<LoadEstimate> found = OfBoundaries<D>(scene, state, bodies).all();
  addVelocities(scene, bodies, found);
  found.erase(
      std::remove_if(found.begin(), found.end(), [](const LoadEstimate& l) { return l.highest == 0.0; }),
      found.end());
  return found;
}

template std::vector<LoadEstimate> estimateLoads(const ParameterList&, const State<2>&,
                                                 const std::vector<BodyMeasure<2>>&);
template std::vector<LoadEstimate> estimateLoads(const ParameterList&, const State<3>&,
                                                 const std::vector<BodyMeasure<3>>&);

} // namespace Rhegma
