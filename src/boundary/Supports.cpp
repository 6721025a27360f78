#include "boundary/Supports.hpp"

#include "archive/Archive.hpp"
#include "base/InOrder.hpp"
#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "boundary/Boundaries.hpp"
#include "boundary/HeldMarks.hpp"
#include "plan/LoadOverStep.hpp"
#include "state/Subdomain.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Rhegma
{

namespace
{

template <int D>
std::string asText(const Vector<D>& position)
{
  std::string text = formatReal(position[0]);
  for (int d = 1; d < D; ++d)
    text += ", " + formatReal(position[d]);
  return text;
}

/// The scene's function of position at the nodes that the constraint holds, those of refined cells included.
/// Throws std::invalid_argument where it is not finite.
template <int D>
View<double* [D]> fieldAtNodes(const PositionFunction& function, const NodeConstraint<D>& constraint,
                               const State<D>& state, const std::string& where)
{
  const int count = state.mesh.grid.numNodes + state.mesh.tree.numFine;
  View<double* [D]> field("rhegma::prescribedField", count);
  const auto host = Kokkos::create_mirror_view(field);
  const auto fine = onHost(state.mesh.tree.finePosition);
  for (int n = 0; n < count; ++n)
  {
    Vector<D> position;
    if (n < state.mesh.grid.numNodes)
      position = state.mesh.grid.nodePosition(n);
    else
      for (int d = 0; d < D; ++d)
        position[d] = fine(n - state.mesh.grid.numNodes, d);
    if (!constraint.appliesAt(position))
      continue;
    const Vector<D> value = function(position);
    for (int d = 0; d < D; ++d)
    {
      host(n, d) = value[d];
      if (constraint.holds[d] && !std::isfinite(value[d]))
        throw std::invalid_argument(where + " > Field: it is not finite at the node {" + asText<D>(position) +
                                    "}; write a function that is finite at every prescribed node");
    }
  }
  Kokkos::deep_copy(field, host);
  return field;
}

} // namespace

template <int D>
void setFieldAtNodes(TimedConstraint<D>& timed, const State<D>& state)
{
  timed.generation = state.mesh.tree.generation;
  timed.constraint.field =
      fieldAtNodes<D>(*timed.field, timed.constraint, state, "Boundaries > " + timed.name);
}

namespace
{

/// Particles of all ranks in the box of a support, or outside of it where that holds those nodes.
template <int D>
double particlesIn(const NodeConstraint<D>& box, const State<D>& state)
{
  const auto position = state.particles.template real<D>(fields::position);
  int count = 0;
  Kokkos::parallel_reduce(
      "rhegma::particlesInBox", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, int& sum) {
        Vector<D> x;
        for (int d = 0; d < D; ++d)
          x[d] = position(p, d);
        sum += box.appliesAt(x) ? 1 : 0;
      },
      count);
  return state.ranks.sum(static_cast<double>(count));
}

} // namespace

template <int D>
bool boxMoves(const TimedConstraint<D>& timed, const std::string& choice, const State<D>& state)
{
  const bool requested = choice == "With Material" || choice == "With Grid";
  NodeConstraint<D> reached = timed.constraint; // nodes of its box are touched from a cell away
  for (int d = 0; d < D; ++d)
  {
    reached.lower[d] -= state.mesh.grid.spacing;
    reached.upper[d] += state.mesh.grid.spacing;
  }
  if (state.method.totalLagrangian && !reached.outside && !(particlesIn(reached, state) > 0.0))
    throw std::invalid_argument(
        "Boundaries > " + timed.name +
        ": no particle is near the box at the start, and bodies do not move through the "
        "cells, so it would never hold anything; move the box, or write Domain > "
        "Formulation = Updated Lagrangian");
  if (timed.field || (!requested && (choice == "Fixed" || !timed.hasMotion())))
    return false;
  const bool holdsMaterial = particlesIn(timed.constraint, state) > 0.0;
  if (requested && !holdsMaterial)
    throw std::invalid_argument("Boundaries > " + timed.name +
                                ": no particle is in the box at the start, so it can't move with material; "
                                "extend it by a cell into the body, or set Box Motion to Fixed");
  return holdsMaterial;
}

template <int D>
bool leavesBox(const TimedConstraint<D>& timed, const State<D>& state)
{
  if (timed.boxMoves || timed.field || timed.constraint.outside || state.method.totalLagrangian ||
      !timed.hasMotion())
    return false;
  NodeConstraint<D> widened = timed.constraint; // a column of nodes at an edge moves along itself
  for (int d = 0; d < D; ++d)
    if (!timed.constraint.holds[d] || timed.value[d] == 0.0)
    {
      widened.lower[d] -= state.mesh.grid.spacing;
      widened.upper[d] += state.mesh.grid.spacing;
    }
  return !(particlesIn(widened, state) > 0.0);
}

namespace
{

/// Updates the velocities at nodes after cells have changed.
template <int D>
void updateCells(TimedConstraint<D>& timed, State<D>& state)
{
  if (!timed.field || timed.generation == state.mesh.tree.generation)
    return;
  try
  {
    setFieldAtNodes(timed, state);
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

} // namespace

namespace
{

/// Columns of a support that moves as a whole, in equilibrium.
template <int D>
void addDisplacements(const TimedConstraint<D>& timed, State<D>& state)
{
  const char* columns[] = {".displacement_x", ".displacement_y", ".displacement_z"};
  const bool listed = state.method.equilibrium() || state.method.handsOver;
  for (int d = 0; d < D && listed && !timed.field; ++d)
    if (timed.constraint.holds[d] && timed.value[d] != 0.0)
      state.sample.row.emplace_back(timed.name + columns[d], timed.displacement[d]);
}

} // namespace

template <int D>
void addReactions(Effect<D>& effect, const std::shared_ptr<std::vector<TimedConstraint<D>>>& constraints)
{
  const auto last = std::make_shared<double>(0.0);
  effect.call(Stage::Observe, "forces of supports", {quantity::constrainedMotion}, {}, {},
              [constraints, last](State<D>& state)
              {
                const char* columns[] = {".force_x", ".force_y", ".force_z"};
                const double duration = state.clock.time - *last;
                *last = state.clock.time;
                for (auto& timed : *constraints)
                {
                  state.ranks.sum(timed.impulse.c, D);
                  timed.absorbedTotal += state.ranks.sum(timed.absorbed);
                  timed.absorbed = 0.0;
                  if (!state.method.equilibrium())
                    timed.force = (duration > 0.0 ? 1.0 / duration : 0.0) * timed.impulse;
                  timed.impulse = Vector<D>{};
                  for (int d = 0; d < D; ++d)
                    if (timed.constraint.holds[d] && timed.reported)
                      state.sample.row.emplace_back(timed.name + columns[d], timed.force[d]);
                  addDisplacements(timed, state);
                }
              });
  effect.memory = inOrder(effect.memory,
                          [constraints, last](State<D>&, Archive& archive)
                          {
                            archive("last_sample", *last);
                            for (std::size_t c = 0; c < constraints->size(); ++c)
                            {
                              const Archive::Group group(archive, std::to_string(c));
                              archive.parts("impulse", (*constraints)[c].impulse);
                              archive("displacement", (*constraints)[c].displacement);
                              archive("force", (*constraints)[c].force);
                              archive.parts("absorbed", (*constraints)[c].absorbed);
                              archive("absorbed_total", (*constraints)[c].absorbedTotal);
                            }
                          });
  effect.report = inOrder(effect.report,
                          [constraints](const State<D>&, nlohmann::json& summary)
                          {
                            for (const auto& timed : *constraints)
                              if (timed.reported)
                                summary["boundaries"].push_back(
                                    {{"name", timed.name},
                                     {"force", std::vector<double>(timed.force.c, timed.force.c + D)},
                                     {"energy_absorbed_from_short_waves", timed.absorbedTotal}});
                          });
}

namespace
{

/// Impulse of the forces of supports, which a step of equilibrium leaves at the nodes that they hold; where
/// two supports hold a node the first gets the force.
template <int D>
void collectReactions(State<D>& state, std::vector<TimedConstraint<D>>& constraints)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const NodePositions<D> positions = nodePositions(state);
  for (std::size_t c = 0; c < constraints.size(); ++c)
  {
    const NodeConstraint<D> constraint = state.motion.constraints[c];
    for (int d = 0; d < D; ++d)
    {
      if (!constraint.holds[d])
        continue;
      double force = 0.0;
      Kokkos::parallel_reduce(
          "rhegma::collectReactions", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
          KOKKOS_LAMBDA(const int i, double& sum) {
            const int n = activeNode(nodes, i);
            if (!constraint.appliesAt(positions(latticeNode(nodes, n))))
              return;
            sum += isOwnedByThisRank(nodes, n) ? nodes.sums(n, Nodes<D>::forceAt + d) : 0.0;
            nodes.sums(n, Nodes<D>::forceAt + d) = 0.0;
          },
          force);
      sumParts(state, &force, 1);
      constraints[c].force[d] = force;
    }
    constraints[c].displace(state.clock.dt * constraint.value);
  }
}

/// The calls in equilibrium: the solve holds the nodes, and records the work of their forces.
template <int D>
void addHeldDisplacements(Effect<D>& effect,
                          const std::shared_ptr<std::vector<TimedConstraint<D>>>& constraints)
{
  effect.call(Stage::Scatter, "displacement of supports", {}, {quantity::prescribedMotion}, {},
              [constraints](State<D>& state)
              {
                state.motion.constraints.clear();
                for (auto& timed : *constraints)
                {
                  updateCells(timed, state);
                  state.motion.constraints.push_back(timed.withFactor(meanOverStep(state, timed.history)));
                }
              });
  effect.call(Stage::AfterSolve, "forces of held nodes", {quantity::nodalMotion, quantity::prescribedMotion},
              {quantity::constrainedMotion}, {},
              [constraints](State<D>& state) { collectReactions(state, *constraints); });
}

} // namespace

template <int D>
void addConstraints(Effect<D>& effect, const std::shared_ptr<std::vector<TimedConstraint<D>>>& constraints,
                    bool isEquilibrium)
{
  if (isEquilibrium)
    return addHeldDisplacements(effect, constraints);
  // Not between steps: the length of the step is known only afterwards.
  effect.call(Stage::Scatter, "values of prescribed motion", {}, {quantity::prescribedMotion}, {},
              [constraints](State<D>& state)
              {
                state.motion.constraints.clear();
                for (auto& timed : *constraints)
                {
                  updateCells(timed, state);
                  state.motion.constraints.push_back(timed.at(state.clock.time + state.clock.dt));
                  const Vector<D> by = timed.displace(state.clock.dt * state.motion.constraints.back().value);
                  if (timed.gridMoves)
                    state.mesh.ahead = by;
                }
              });
  effect.call(Stage::AfterSolve, "prescribed motion",
              {quantity::nodalMotion, quantity::prescribedMotion, ifWritten(quantity::massMatrix)},
              {quantity::constrainedMotion}, {},
              [constraints](State<D>& state)
              {
                for (std::size_t c = 0; c < constraints->size(); ++c)
                {
                  const Reaction<D> reaction = constrainMotion(state, state.motion.constraints[c],
                                                               (*constraints)[c].at(state.clock.time));
                  state.energy.externalWork += reaction.work;
                  (*constraints)[c].impulse = (*constraints)[c].impulse + reaction.impulse;
                }
              });
  effect.call(
      Stage::AfterProjection, "prescribed strain velocity", {}, {quantity::projection}, {},
      [constraints, held = std::make_shared<View<char**>>()](State<D>& state)
      {
        if (constraints->size() > 1)
          clearMarks(state, *held);
        const bool atStart = state.clock.strainPass.before;
        for (std::size_t c = 0; c < constraints->size(); ++c)
        {
          TimedConstraint<D>& timed = (*constraints)[c];
          // The nodes that the solve held: the box has moved on since.
          NodeConstraint<D> now = state.motion.constraints[c];
          now.factor = timed.history(atStart ? state.clock.time : state.clock.time + state.clock.dt);
          now.value = now.factor * timed.value;
          const double work = constrainProjection(state, now, timed.at(state.clock.time), *held);
          state.energy.externalWork += work;
          timed.absorbed -= work;
        }
      },
      true);
}

template bool leavesBox(const TimedConstraint<2>&, const State<2>&);
template bool leavesBox(const TimedConstraint<3>&, const State<3>&);
template bool boxMoves(const TimedConstraint<2>&, const std::string&, const State<2>&);
template bool boxMoves(const TimedConstraint<3>&, const std::string&, const State<3>&);
template void setFieldAtNodes(TimedConstraint<2>&, const State<2>&);
template void setFieldAtNodes(TimedConstraint<3>&, const State<3>&);
template void addConstraints(Effect<2>&, const std::shared_ptr<std::vector<TimedConstraint<2>>>&, bool);
template void addConstraints(Effect<3>&, const std::shared_ptr<std::vector<TimedConstraint<3>>>&, bool);
template void addReactions(Effect<2>&, const std::shared_ptr<std::vector<TimedConstraint<2>>>&);
template void addReactions(Effect<3>&, const std::shared_ptr<std::vector<TimedConstraint<3>>>&);

} // namespace Rhegma
