#include "boundary/Boundaries.hpp"

#include "boundary/BodyForce.hpp"
#include "boundary/Loads.hpp"
#include "scene/Attempts.hpp"
#include "scene/Numbers.hpp"
#include "scene/PlaceFunction.hpp"
#include "scene/ReadList.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

namespace Rhegma
{

namespace
{

int axisNumber(char letter) { return letter - 'x'; }

/// A constraint, the time function of its value, and the force that holds it.
template <int D>
struct TimedConstraint
{
  NodeConstraint<D> constraint;
  Vector<D> value;
  TimeFunction history;
  std::string name;
  Vector<D> impulse{}; ///< on the body since the last sample [N s]
  Vector<D> force{};   ///< mean between the last two samples [N]

  NodeConstraint<D> at(double time) const
  {
    NodeConstraint<D> now = constraint;
    now.factor = history(time);
    now.value = now.factor * value;
    return now;
  }
};

template <int D>
bool holdsNode(const Grid<D>& grid, const Vector<D>& lower, const Vector<D>& upper)
{
  for (int d = 0; d < D; ++d)
  {
    const double from = std::max(lower[d], grid.lower[d]), to = std::min(upper[d], grid.upper[d]);
    if (!(std::ceil(grid.inCells(from, d) - 1e-9) <= grid.inCells(to, d) + 1e-9))
      return false;
  }
  return true;
}

template <int D>
std::string inWords(const Vector<D>& place)
{
  std::string text = formatReal(place[0]);
  for (int d = 1; d < D; ++d)
    text += ", " + formatReal(place[d]);
  return text;
}

/// The scene's function of place at the nodes that the constraint holds.
template <int D>
View<double* [D]> readField(const Teuchos::ParameterList& list, const NodeConstraint<D>& constraint,
                            const Grid<D>& grid, const std::string& where)
{
  View<double* [D]> field("rhegma::prescribedField", grid.numNodes);
  const auto host = Kokkos::create_mirror_view(field);
  const PlaceFunction function = PlaceFunction::parse(list.get<std::string>("Field"), D);
  for (int n = 0; n < grid.numNodes; ++n)
  {
    const Vector<D> place = grid.nodePosition(n);
    if (!constraint.appliesAt(place))
      continue;
    const Vector<D> value = function(place);
    for (int d = 0; d < D; ++d)
    {
      host(n, d) = value[d];
      if (constraint.holds[d] && !std::isfinite(value[d]))
        throw std::invalid_argument(where + " > Field: it is not finite at the node {" + inWords<D>(place) +
                                    "}; write a function that is finite at every node that is held");
    }
  }
  Kokkos::deep_copy(field, host);
  return field;
}

template <int D>
TimedConstraint<D> readVelocity(const Teuchos::ParameterList& list, const Grid<D>& grid,
                                const std::string& where)
{
  TimedConstraint<D> timed{{}, {}, TimeFunction::parse(list.get<std::string>("History")), {}};
  timed.constraint.lower = readVector<D>(list, "Lower Corner");
  timed.constraint.upper = readVector<D>(list, "Upper Corner");
  timed.constraint.outside = list.get<std::string>("Nodes") == "Outside";
  // Nodes on the rim count as held whatever the rounding.
  const double rim = (timed.constraint.outside ? -1e-9 : 1e-9) * grid.spacing;
  for (int d = 0; d < D; ++d)
  {
    timed.constraint.lower[d] -= rim;
    timed.constraint.upper[d] += rim;
    timed.constraint.holds[d] = false;
    timed.value[d] = 0.0;
  }
  if (!timed.constraint.outside && !holdsNode(grid, timed.constraint.lower, timed.constraint.upper))
    throw std::invalid_argument(where +
                                ": the box holds no node of the cells inside the domain, so nothing is "
                                "prescribed; make it a cell thick or move it");
  for (const char letter : list.get<std::string>("Components"))
    if (letter >= 'x' && letter < 'x' + D)
      timed.constraint.holds[axisNumber(letter)] = true;
  if (list.isParameter("Value"))
    timed.value = readVector<D>(list, "Value");
  else
    timed.constraint.field = readField<D>(list, timed.constraint, grid, where);
  return timed;
}

template <int D>
TimedConstraint<D> readSymmetry(const Teuchos::ParameterList& list, const Grid<D>& grid,
                                const std::string& where)
{
  TimedConstraint<D> timed{{}, {}, TimeFunction::parse("0"), {}};
  const int axis = axisNumber(list.get<std::string>("Axis")[0]);
  const double position = list.get<double>("Position");
  const double slack = 1e-6 * grid.spacing;
  if (position < grid.lower[axis] - slack || position > grid.upper[axis] + slack)
    throw std::invalid_argument(where +
                                " > Position: the plane lies outside of the domain, which reaches from " +
                                formatReal(grid.lower[axis]) + " to " + formatReal(grid.upper[axis]) +
                                " m along " + "xyz"[axis] + "; write a place between");
  const double huge = 1e300;
  for (int d = 0; d < D; ++d)
  {
    timed.constraint.lower[d] = -huge;
    timed.constraint.upper[d] = huge;
    timed.constraint.holds[d] = d == axis;
    timed.value[d] = 0.0;
  }
  // The plane and all beyond it. The body lies on the side where the domain reaches further, unless the scene
  // says.
  const bool lower = list.isParameter("Side") ? list.get<std::string>("Side") == "Lower"
                                              : position - grid.lower[axis] < grid.upper[axis] - position;
  if (lower)
    timed.constraint.upper[axis] = position + 1e-9 * grid.spacing;
  else
    timed.constraint.lower[axis] = position - 1e-9 * grid.spacing;
  return timed;
}

template <int D>
using Points = std::vector<LoadPoint<D>>;

template <int D>
struct PlacedLoad
{
  Points<D> points;
  Vector<D> force;
};

double length(const Vector<2>& a) { return norm(a); }

Vector<3> cross(const Vector<3>& a, const Vector<3>& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Traction over a segment of unit thickness times the thickness; a pressure pushes against the outward
/// normal, which is to the right of From -> To.
PlacedLoad<2> placeTraction(const Teuchos::ParameterList& list, const Seeds<2>& seeds, double thickness,
                            const std::string& where)
{
  const Vector<2> from = readVector<2>(list, "From"), to = readVector<2>(list, "To");
  const Vector<2> along = to - from;
  Vector<2> force;
  if (list.isParameter("Pressure"))
    force = -list.get<double>("Pressure") * thickness * Vector<2>{along[1], -along[0]};
  else
    force = length(along) * thickness * readVector<2>(list, "Stress");
  return {lineLoad<2>(seeds, from, to, Profile::Uniform, where), force};
}

PlacedLoad<3> placeTraction(const Teuchos::ParameterList& list, const Seeds<3>& seeds, double,
                            const std::string& where)
{
  const Vector<3> corner = readVector<3>(list, "Corner");
  const Vector<3> a = readVector<3>(list, "Edge 1"), b = readVector<3>(list, "Edge 2");
  const Vector<3> area = cross(a, b);
  Vector<3> force;
  if (list.isParameter("Pressure"))
    force = -list.get<double>("Pressure") * area;
  else
    force = norm(area) * readVector<3>(list, "Stress");
  return {faceLoad(seeds, corner, a, b, where), force};
}

template <int D>
PlacedLoad<D> placeLoad(const Teuchos::ParameterList& list, const std::string& type, const Seeds<D>& seeds,
                        double thickness, const std::string& where)
{
  if (type == "Traction")
    return placeTraction(list, seeds, thickness, where);
  const Vector<D> force = readVector<D>(list, "Force");
  if (type == "Point Load")
    return {pointLoad<D>(seeds, readVector<D>(list, "Point"), where), force};
  const Profile profile =
      list.get<std::string>("Profile") == "Parabolic" ? Profile::Parabolic : Profile::Uniform;
  return {lineLoad<D>(seeds, readVector<D>(list, "From"), readVector<D>(list, "To"), profile, where), force};
}

/// A body as its particles lie before the first step, in the order of their ids.
template <int D>
Seeds<D> seedsOf(const State<D>& state, int body, std::vector<int>& ids)
{
  const auto bodies =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.particles.integer(fields::body));
  const auto id =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.particles.integer(fields::id));
  const auto x = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{},
                                                     state.particles.template real<D>(fields::position));
  const auto edge = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{},
                                                        state.particles.template real<D>(fields::edge));
  Seeds<D> seeds{};
  for (int p = 0; p < state.particles.size(); ++p)
    if (bodies(p) == body)
    {
      Vector<D> at;
      for (int d = 0; d < D; ++d)
      {
        at[d] = x(p, d);
        seeds.edge[d] = edge(p, d);
      }
      seeds.position.push_back(at);
      ids.push_back(id(p));
    }
  seeds.volume = 1.0;
  for (int d = 0; d < D; ++d)
  {
    seeds.volume *= seeds.edge[d];
    for (int e = 0; e < D; ++e)
      seeds.axes[d][e] = state.bodies[body].axes[d][e];
  }
  return seeds;
}

template <int D>
TimedConstraint<D> readConstraint(const Teuchos::ParameterList& list, const State<D>& state,
                                  const std::string& name)
{
  const std::string where = "Boundaries > " + name;
  TimedConstraint<D> timed = list.get<std::string>("Type") == "Velocity"
                                 ? readVelocity<D>(list, state.grid, where)
                                 : readSymmetry<D>(list, state.grid, where);
  timed.name = name;
  return timed;
}

template <int D>
Load<D> readLoad(const Teuchos::ParameterList& list, const State<D>& state, const std::string& name)
{
  std::vector<int> ids;
  const Seeds<D> seeds = seedsOf(state, findBody(state, list.get<std::string>("Body")), ids);
  const PlacedLoad<D> placed =
      placeLoad<D>(list, list.get<std::string>("Type"), seeds, state.thickness, "Boundaries > " + name);
  std::vector<int> carriers;
  std::vector<Vector<D>> starts;
  for (const LoadPoint<D>& point : placed.points)
  {
    carriers.push_back(ids[point.particle]);
    starts.push_back(seeds.position[point.particle]);
  }
  return {name,   placed.points, carriers,
          starts, placed.force,  TimeFunction::parse(list.get<std::string>("History"))};
}

template <int D>
void addGravity(Effect<D>& effect, const Teuchos::ParameterList& list)
{
  const Vector<D> acceleration = readVector<D>(list, "Acceleration");
  const TimeFunction history = TimeFunction::parse(list.get<std::string>("History"));
  const auto now = [=](const State<D>& state) { return history(state.time + 0.5 * state.dt) * acceleration; };
  effect.call({Stage::BeforeSolve, "gravity", {"nodal mass"}, {}, {"nodal force"}, [now](State<D>& state) {
                 addBodyForce(state.nodes, now(state));
               }});
  effect.call({Stage::AfterSolve, "work of gravity", {"constrained motion"}, {}, {}, [now](State<D>& state) {
                 state.energy.externalWork += bodyForceWork(state.nodes, now(state), state.dt);
               }});
}

/// The force of each support on the bodies, as a mean over the time since the last sample, so that none of it
/// goes unseen.
template <int D>
void addReactions(Effect<D>& effect, const std::shared_ptr<std::vector<TimedConstraint<D>>>& constraints)
{
  const auto last = std::make_shared<double>(0.0);
  effect.call({Stage::Observe,
               "forces of supports",
               {},
               {},
               {},
               [constraints, last](State<D>& state)
               {
                 const char* columns[] = {".force_x", ".force_y", ".force_z"};
                 const double duration = state.time - *last;
                 *last = state.time;
                 for (auto& timed : *constraints)
                 {
                   timed.force = (duration > 0.0 ? 1.0 / duration : 0.0) * timed.impulse;
                   timed.impulse = Vector<D>{};
                   for (int d = 0; d < D; ++d)
                     if (timed.constraint.holds[d])
                       state.row.emplace_back(timed.name + columns[d], timed.force[d]);
                 }
               }});
  effect.report = [constraints](const State<D>&, nlohmann::json& summary)
  {
    nlohmann::json& boundaries = summary["boundaries"];
    boundaries = nlohmann::json::array();
    for (const auto& timed : *constraints)
      boundaries.push_back(
          {{"name", timed.name}, {"force", std::vector<double>(timed.force.c, timed.force.c + D)}});
  };
}

template <int D>
void addConstraints(Effect<D>& effect, const std::shared_ptr<std::vector<TimedConstraint<D>>>& constraints)
{
  effect.call({Stage::BetweenSteps,
               "values of prescribed motion",
               {},
               {},
               {},
               [constraints](State<D>& state)
               {
                 state.constraints.clear();
                 for (const auto& timed : *constraints)
                   state.constraints.push_back(timed.at(state.time + state.dt));
               }});
  effect.call({Stage::AfterSolve,
               "prescribed motion",
               {"nodal motion"},
               {"constrained motion"},
               {},
               [constraints](State<D>& state)
               {
                 for (std::size_t c = 0; c < constraints->size(); ++c)
                 {
                   const Reaction<D> reaction = constrainMotion(state, state.constraints[c]);
                   state.energy.externalWork += reaction.work;
                   (*constraints)[c].impulse = (*constraints)[c].impulse + reaction.impulse;
                 }
               }});
  effect.call({Stage::AfterProjection,
               "prescribed strain velocity",
               {},
               {"projection"},
               {},
               [](State<D>& state)
               {
                 for (const NodeConstraint<D>& constraint : state.constraints)
                   constrainProjection(state, constraint);
               }});
}

} // namespace

template <int D>
Effect<D> makeBoundaries(const Teuchos::ParameterList& scene)
{
  Effect<D> effect;
  effect.name = boundariesName;
  if (!scene.isSublist("Boundaries"))
    return effect;
  const Teuchos::ParameterList& section = scene.sublist("Boundaries");
  const auto constraints = std::make_shared<std::vector<TimedConstraint<D>>>();
  const auto loads = std::make_shared<std::vector<Load<D>>>();
  std::vector<std::string> loadNames, constraintNames;
  for (const std::string& name : sublistNames(section))
  {
    const Teuchos::ParameterList& list = section.sublist(name);
    const std::string type = list.get<std::string>("Type");
    if (type == "Gravity")
      addGravity(effect, list);
    else if (type == "Velocity" || type == "Symmetry")
      constraintNames.push_back(name);
    else
      loadNames.push_back(name);
  }
  if (!constraintNames.empty())
  {
    addConstraints(effect, constraints);
    addReactions(effect, constraints);
  }
  if (!loadNames.empty())
  {
    effect.call({Stage::BeforeSolve,
                 "loads",
                 {"nodal mass"},
                 {},
                 {"nodal force"},
                 [loads](State<D>& state)
                 {
                   for (Load<D>& load : *loads)
                     load.apply(state);
                 }});
    effect.call({Stage::AfterSolve,
                 "work of loads",
                 {"constrained motion"},
                 {},
                 {},
                 [loads](State<D>& state)
                 {
                   for (const Load<D>& load : *loads)
                     state.energy.externalWork += load.work(state);
                 }});
  }
  effect.atStart = [=, section = Teuchos::ParameterList(section)](State<D>& state)
  {
    Attempts attempts;
    for (const std::string& name : constraintNames)
      attempts.attempt([&]
                       { constraints->push_back(readConstraint<D>(section.sublist(name), state, name)); });
    for (const std::string& name : loadNames)
      attempts.attempt([&] { loads->push_back(readLoad<D>(section.sublist(name), state, name)); });
    attempts.complain();
  };
  return effect;
}

template Effect<2> makeBoundaries(const Teuchos::ParameterList&);
template Effect<3> makeBoundaries(const Teuchos::ParameterList&);

} // namespace Rhegma
