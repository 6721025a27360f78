#include "plausibility/LoadEstimate.hpp"

#include "base/ReadList.hpp"
#include "boundary/BodySurface.hpp"
#include "boundary/NodesInBoxes.hpp"
#include "boundary/TouchedNodes.hpp"
#include "scene/PositionFunction.hpp"
#include "scene/TimeFunction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace Rhegma
{

const LoadEstimate* largestStrain(const std::vector<LoadEstimate>& loads)
{
  const LoadEstimate* most = nullptr;
  for (const LoadEstimate& load : loads)
    if (std::isfinite(load.strain) && std::isfinite(load.stress) &&
        (most == nullptr || load.strain > most->strain))
      most = &load;
  return most;
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
  return {where, stress / body.moduli.young, stress, stress, body.linear};
}

/// Across the longest axis a force bends, along it, it pulls at one side of the section at most. A hook or a
/// ring is thinner than its box by the part that it fills, and bends also along the longest axis.
template <int D>
LoadEstimate ofForce(const std::string& where, const Vector<D>& force, const BodyMeasure<D>& body)
{
  const Vector<D> extents = body.upper - body.lower;
  const int longest = static_cast<int>(std::max_element(extents.c, extents.c + D) - extents.c);
  const double size = norm(force), wide = body.volume / body.shortest, narrow = body.volume / body.longest;
  const bool along = std::fabs(force[longest]) > 0.9 * size;
  constexpr double full = 0.75; // a disk
  const double lever =
      along && body.fill > full ? 4.0 : 1.0 + 6.0 * body.longest / (body.fill * body.shortest);
  return {where, size / wide / body.moduli.young, size / wide, size / narrow * lever, body.linear};
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
      : scene_(scene),
        state_(state),
        bodies_(bodies),
        end_(scene.isSublist("Time") ? scene.sublist("Time").get<double>("Final Time") : 0.0),
        boundaries_(scene.isSublist("Boundaries") ? scene.sublist("Boundaries") : ParameterList())
  {
    for (const BodyMeasure<D>& body : bodies)
    {
      byName_.emplace(body.name, &body);
      stiffest_ = std::max(stiffest_, body.density * body.speed);
    }
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
      {
        const double acceleration = norm(readVector<D>(list, "Acceleration")) * factor(list).largest;
        for (const BodyMeasure<D>& body : bodies_)
          add(even(where, acceleration * body.density * body.longest, body));
      }
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

  /// The larger of what a load does to two bodies is kept.
  void add(const LoadEstimate& estimate)
  {
    if (found_.empty() || found_.back().where != estimate.where)
      return found_.push_back(estimate);
    const double highest = std::max(found_.back().highest, estimate.highest);
    if (estimate.strain > found_.back().strain)
      found_.back() = estimate;
    found_.back().highest = highest;
  }

  /// Force per area of a traction [Pa].
  double tractionOf(const ParameterList& list) const
  {
    if (list.isParameter("Pressure"))
      return std::fabs(list.get<double>("Pressure"));
    if (list.isParameter("Stress"))
      return norm(readVector<D>(list, "Stress"));
    const double area = measureSurface<D>(scene_, list, "Boundaries").area;
    return area > 0.0 ? norm(readVector<D>(list, "Force")) / area : 0.0;
  }

  void load(const ParameterList& list, const std::string& type, const std::string& where)
  {
    const auto at = byName_.find(list.get<std::string>("Body"));
    if (at == byName_.end())
      return;
    const BodyMeasure<D>& body = *at->second;
    const double factor = this->factor(list).largest;
    const Vector<D> force = factor * forceOf<D>(scene_, list);
    const LoadEstimate estimate = ofForce<D>(where, force, body);
    if (type != "Traction")
      return add(estimate);
    const double stress = factor * tractionOf(list);
    LoadEstimate spread = even(where, stress, body);
    spread.highest = std::max(stress, estimate.highest);
    add(spread);
  }

  /// How far supports move apart along each axis, and how fast they push.
  void supports()
  {
    const std::vector<Vector<D>> positions = touchedNodes(state_);
    const NodesInBoxes<D> nodes(positions, supports_.size());
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
        apart(most, least, d);
      else if (any && most.by != 0.0) // only inertia resists
        impact(most.where, true);
    }
  }

  /// Calls see(Moved) for every node that a support holds along an axis.
  template <class See>
  void moves(const std::string& name, int axis, const NodesInBoxes<D>& nodes, const See& see)
  {
    const ParameterList& list = boundaries_.sublist(name);
    const std::string where = "Boundaries > " + name;
    if (list.get<std::string>("Type") == "Symmetry")
    {
      const double position = list.get<double>("Position");
      constexpr double far = std::numeric_limits<double>::max();
      Geometry::Bounds<D> plane;
      std::fill_n(plane.lower.c, D, -far);
      std::fill_n(plane.upper.c, D, far);
      plane.lower[axis] = position - 0.5 * state_.mesh.grid.spacing;
      plane.upper[axis] = position + 0.5 * state_.mesh.grid.spacing;
      if (list.get<std::string>("Axis")[0] == 'x' + axis)
        nodes.visit(plane, false, [&](const Vector<D>&) { see({0.0, where}); });
      return;
    }
    if (list.get<std::string>("Components").find(static_cast<char>('x' + axis)) == std::string::npos)
      return;
    const HistoryRange range = factor(list);
    const Vector<D> lower = readVector<D>(list, "Lower Corner"), upper = readVector<D>(list, "Upper Corner");
    const bool varies = list.isParameter("Field");
    const PositionFunction field =
        PositionFunction::parse(varies ? list.get<std::string>("Field") : (D == 2 ? "0, 0" : "0, 0, 0"), D);
    const double value = varies ? 0.0 : readVector<D>(list, "Value")[axis];
    const bool outside = list.get<std::string>("Nodes") == "Outside";
    fastest_ = 0.0;
    nodes.visit({lower, upper}, outside,
                [&](const Vector<D>& x)
                {
                  const double v = varies ? field(x)[axis] : value;
                  if (!std::isfinite(v))
                    return;
                  fastest_ = std::max(fastest_, std::fabs(v) * range.largest);
                  see({v * range.integral, where});
                });
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
    if (!freely)
      return add({where, 0.0, 0.0, stiffest_ * fastest_, false});
    for (const BodyMeasure<D>& body : bodies_)
    {
      const double wave = body.density * body.speed * fastest_;
      const double slow = body.density * body.longest * fastest_ * rise_ / largest_;
      const double nominal = 0.5 * std::min(wave, slow);
      add({where, nominal / body.moduli.young, nominal, wave, body.linear});
    }
  }

  /// Along its longest axis supports stretch a body, across it a crack may let arms bend.
  void apart(const Moved& one, const Moved& other, int axis)
  {
    const double by = one.by - other.by;
    const std::string& where = one.by > -other.by ? one.where : other.where;
    for (const BodyMeasure<D>& body : bodies_)
    {
      const bool along = body.upper[axis] - body.lower[axis] >= (1.0 - 1e-9) * body.longest;
      const double strain = by / body.longest * (along ? 1.0 : body.shortest / body.longest);
      add({where, strain, strain * body.moduli.young, by / body.shortest * body.moduli.young, body.linear});
    }
  }

  const ParameterList& scene_;
  const State<D>& state_;
  const std::vector<BodyMeasure<D>>& bodies_;
  double end_;
  ParameterList boundaries_;
  std::unordered_map<std::string, const BodyMeasure<D>*> byName_;
  std::vector<std::string> supports_;
  std::vector<LoadEstimate> found_;
  double stiffest_ = 0.0;                             ///< largest impedance of the bodies [Pa s/m]
  double fastest_ = 0.0, rise_ = 0.0, largest_ = 0.0; ///< of the last support that was looked at
};

/// Bodies that hit something, and bodies that spin.
template <int D>
void addVelocities(const ParameterList& scene, const std::vector<BodyMeasure<D>>& bodies,
                   std::vector<LoadEstimate>& found)
{
  if (!scene.isSublist("Bodies") || bodies.empty())
    return;
  const bool obstacles = bodies.size() > 1 || scene.isSublist("Boundaries");
  auto next = bodies.begin(); // they are in the order of the section
  for (const auto& entry : scene.sublist("Bodies"))
  {
    const auto* const list = valueIf<ParameterList>(entry.second);
    if (list == nullptr || next == bodies.end())
      continue;
    const BodyMeasure<D>& body = *next++;
    const std::string where = "Bodies > " + body.name;
    const double v = norm(readVector<D>(*list, "Velocity"));
    const double impact = body.density * body.speed * v;
    if (v > 0.0 && obstacles)
      found.push_back(
          {where + " > Velocity", 0.5 * impact / body.moduli.young, 0.5 * impact, 2.0 * impact, body.linear});
    double spin = 0.0;
    for (const double w : *valueIf<Teuchos::Array<double>>(*list, "Angular Velocity"))
      spin += w * w;
    if (spin > 0.0)
      found.push_back(even(where + " > Angular Velocity",
                           0.25 * body.density * spin * body.longest * body.longest, body));
  }
}

} // namespace

template <int D>
Vector<D> forceOf(const ParameterList& scene, const ParameterList& list)
{
  if (list.isParameter("Force"))
    return readVector<D>(list, "Force");
  if (list.get<std::string>("Type") != "Traction")
    return {};
  const SurfaceMeasure<D> surface = measureSurface<D>(scene, list, "Boundaries");
  return list.isParameter("Pressure") ? -list.get<double>("Pressure") * surface.outward
                                      : surface.area * readVector<D>(list, "Stress");
}

template <int D>
double chosenArea(const ParameterList& scene, const ParameterList& list)
{
  return choosesSurface(list) ? measureSurface<D>(scene, list, "Boundaries").area : 0.0;
}

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

template <int D>
std::vector<LoadEstimate> estimatePressures(const std::map<std::string, std::string>& pressures, double end,
                                            const std::vector<BodyMeasure<D>>& bodies)
{
  std::vector<LoadEstimate> found;
  const auto soft = std::min_element(bodies.begin(), bodies.end(),
                                     [](const BodyMeasure<D>& a, const BodyMeasure<D>& b)
                                     { return a.moduli.young < b.moduli.young; });
  for (const auto& [path, history] : pressures)
    if (const double largest = rangeOf(history, end).largest; soft != bodies.end() && largest > 0.0)
      found.push_back(even(path, largest, *soft));
  return found;
}

template std::vector<LoadEstimate> estimatePressures(const std::map<std::string, std::string>&, double,
                                                     const std::vector<BodyMeasure<2>>&);
template std::vector<LoadEstimate> estimatePressures(const std::map<std::string, std::string>&, double,
                                                     const std::vector<BodyMeasure<3>>&);
template std::vector<LoadEstimate> estimateLoads(const ParameterList&, const State<2>&,
                                                 const std::vector<BodyMeasure<2>>&);
template std::vector<LoadEstimate> estimateLoads(const ParameterList&, const State<3>&,
                                                 const std::vector<BodyMeasure<3>>&);

template Vector<2> forceOf(const ParameterList&, const ParameterList&);
template Vector<3> forceOf(const ParameterList&, const ParameterList&);
template double chosenArea<2>(const ParameterList&, const ParameterList&);
template double chosenArea<3>(const ParameterList&, const ParameterList&);

} // namespace Rhegma
