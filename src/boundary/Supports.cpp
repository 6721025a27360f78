#include "boundary/Supports.hpp"

#include "archive/Archive.hpp"
#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "boundary/Boundaries.hpp"
#include "boundary/HeldMarks.hpp"
#include "state/Subdomain.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Rhegma
{

namespace
{

int axisNumber(char letter) { return letter - 'x'; }

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

/// The scene's function of place at the nodes that the constraint holds, those of refined cells included.
/// Throws std::invalid_argument where it is not finite.
template <int D>
View<double* [D]> fieldAtNodes(const PlaceFunction& function, const NodeConstraint<D>& constraint,
                               const State<D>& state, const std::string& where)
{
  const int count = state.mesh.grid.numNodes + state.mesh.tree.numFine;
  View<double* [D]> field("rhegma::prescribedField", count);
  const auto host = Kokkos::create_mirror_view(field);
  const auto fine = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.mesh.tree.finePlace);
  for (int n = 0; n < count; ++n)
  {
    Vector<D> place;
    if (n < state.mesh.grid.numNodes)
      place = state.mesh.grid.nodePosition(n);
    else
      for (int d = 0; d < D; ++d)
        place[d] = fine(n - state.mesh.grid.numNodes, d);
    if (!constraint.appliesAt(place))
      continue;
    const Vector<D> value = function(place);
    for (int d = 0; d < D; ++d)
    {
      host(n, d) = value[d];
      if (constraint.holds[d] && !std::isfinite(value[d]))
        throw std::invalid_argument(where + " > Field: it is not finite at the node {" + inWords<D>(place) +
                                    "}; write a function that is finite at every prescribed node");
    }
  }
  Kokkos::deep_copy(field, host);
  return field;
}

/// Gives the nodes of cells that have changed their velocities.
template <int D>
void followCells(TimedConstraint<D>& timed, State<D>& state)
{
  if (!timed.field || timed.generation == state.mesh.tree.generation)
    return;
  timed.generation = state.mesh.tree.generation;
  try
  {
    timed.constraint.field =
        fieldAtNodes<D>(*timed.field, timed.constraint, state, "Boundaries > " + timed.name);
  }
  catch (const std::invalid_argument& wrong)
  {
    // The run stops after this stage; until then the nodes are at rest.
    timed.constraint.field =
        View<double* [D]>("rhegma::prescribedField", state.mesh.grid.numNodes + state.mesh.tree.numFine);
    if (state.failure.empty())
      state.failure = wrong.what();
  }
}

template <int D>
TimedConstraint<D> readVelocity(const Teuchos::ParameterList& list, const State<D>& state,
                                const std::string& where)
{
  const Grid<D>& grid = state.mesh.grid;
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
    throw std::invalid_argument(where + ": the box contains no grid node inside the domain, so nothing is "
                                        "prescribed; make it at least a cell thick or move it");
  for (const char letter : list.get<std::string>("Components"))
    if (letter >= 'x' && letter < 'x' + D)
      timed.constraint.holds[axisNumber(letter)] = true;
  if (list.isParameter("Value"))
    timed.value = readVector<D>(list, "Value");
  else
  {
    timed.field = PlaceFunction::parse(list.get<std::string>("Field"), D);
    timed.generation = state.mesh.tree.generation;
    timed.constraint.field = fieldAtNodes<D>(*timed.field, timed.constraint, state, where);
  }
  return timed;
}

template <int D>
TimedConstraint<D> readSymmetry(const Teuchos::ParameterList& list, State<D>& state, const std::string& where)
{
  const Grid<D>& grid = state.mesh.grid;
  TimedConstraint<D> timed{{}, {}, TimeFunction::parse("0"), {}};
  const int axis = axisNumber(list.get<std::string>("Axis")[0]);
  const double position = list.get<double>("Position");
  const double slack = 1e-6 * grid.spacing;
  if (position < grid.lower[axis] - slack || position > grid.upper[axis] + slack)
    throw std::invalid_argument(where +
                                " > Position: the plane lies outside the domain, which reaches from " +
                                formatReal(grid.lower[axis]) + " to " + formatReal(grid.upper[axis]) +
                                " m along " + "xyz"[axis] + "; write a position between");
  const double cells = grid.inCells(position, axis), off = std::fabs(cells - std::round(cells));
  if (off > 1e-3)
    state.warnings.push_back(
        where + " > Position: the plane lies " + formatReal(off) +
        " cells away from the nearest plane of grid nodes, so the body meets its mirror image up to a cell "
        "too late; move the plane onto grid nodes, or move Domain > Lower Corner");
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

} // namespace

template <int D>
TimedConstraint<D> readConstraint(const Teuchos::ParameterList& list, State<D>& state,
                                  const std::string& name)
{
  const std::string where = "Boundaries > " + name;
  TimedConstraint<D> timed = list.get<std::string>("Type") == "Velocity"
                                 ? readVelocity<D>(list, state, where)
                                 : readSymmetry<D>(list, state, where);
  timed.name = name;
  return timed;
}

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
                 const double duration = state.clock.time - *last;
                 *last = state.clock.time;
                 for (auto& timed : *constraints)
                 {
                   state.ranks.sum(timed.impulse.c, D);
                   timed.takenInAll += state.ranks.sum(timed.taken);
                   timed.taken = 0.0;
                   timed.force = (duration > 0.0 ? 1.0 / duration : 0.0) * timed.impulse;
                   timed.impulse = Vector<D>{};
                   for (int d = 0; d < D; ++d)
                     if (timed.constraint.holds[d])
                       state.sample.row.emplace_back(timed.name + columns[d], timed.force[d]);
                 }
               }});
  effect.memory = [constraints, last](State<D>&, Archive& archive)
  {
    archive("last_sample", *last);
    for (std::size_t c = 0; c < constraints->size(); ++c)
    {
      const Archive::Group group(archive, std::to_string(c));
      archive.parts("impulse", (*constraints)[c].impulse);
      archive("force", (*constraints)[c].force);
      archive.parts("taken", (*constraints)[c].taken);
      archive("taken_in_all", (*constraints)[c].takenInAll);
    }
  };
  effect.report = [constraints](const State<D>&, nlohmann::json& summary)
  {
    nlohmann::json& boundaries = summary["boundaries"];
    boundaries = nlohmann::json::array();
    for (const auto& timed : *constraints)
      boundaries.push_back({{"name", timed.name},
                            {"force", std::vector<double>(timed.force.c, timed.force.c + D)},
                            {"energy_taken_from_short_waves", timed.takenInAll}});
  };
}

template <int D>
void addConstraints(Effect<D>& effect, const std::shared_ptr<std::vector<TimedConstraint<D>>>& constraints)
{
  // Not between steps: only after them is the step known.
  effect.call({Stage::Scatter,
               "values of prescribed motion",
               {},
               {"prescribed values"},
               {},
               [constraints](State<D>& state)
               {
                 state.motion.constraints.clear();
                 for (auto& timed : *constraints)
                 {
                   followCells(timed, state);
                   state.motion.constraints.push_back(timed.at(state.clock.time + state.clock.dt));
                 }
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
                   const Reaction<D> reaction = constrainMotion(state, state.motion.constraints[c],
                                                                (*constraints)[c].at(state.clock.time));
                   state.energy.externalWork += reaction.work;
                   (*constraints)[c].impulse = (*constraints)[c].impulse + reaction.impulse;
                 }
               }});
  effect.call({Stage::AfterProjection,
               "prescribed strain velocity",
               {},
               {"projection"},
               {},
               [constraints, held = std::make_shared<View<char**>>()](State<D>& state)
               {
                 if (constraints->size() > 1)
                   clearMarks(state, *held);
                 const bool atStart = state.clock.strainPass.before;
                 for (auto& timed : *constraints)
                 {
                   const double work = constrainProjection(
                       state, timed.at(atStart ? state.clock.time : state.clock.time + state.clock.dt),
                       timed.at(state.clock.time), *held);
                   state.energy.externalWork += work;
                   timed.taken -= work;
                 }
               },
               true});
}

template TimedConstraint<2> readConstraint(const Teuchos::ParameterList&, State<2>&, const std::string&);
template TimedConstraint<3> readConstraint(const Teuchos::ParameterList&, State<3>&, const std::string&);
template void addConstraints(Effect<2>&, const std::shared_ptr<std::vector<TimedConstraint<2>>>&);
template void addConstraints(Effect<3>&, const std::shared_ptr<std::vector<TimedConstraint<3>>>&);
template void addReactions(Effect<2>&, const std::shared_ptr<std::vector<TimedConstraint<2>>>&);
template void addReactions(Effect<3>&, const std::shared_ptr<std::vector<TimedConstraint<3>>>&);

} // namespace Rhegma
