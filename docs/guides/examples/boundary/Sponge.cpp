/// A boundary type in one file: docs/how-to/add-a-boundary.md.

#include "Sponge.hpp"

#include <base/ReadList.hpp>
#include <boundary/BoundaryParts.hpp>
#include <boundary/LoadVelocity.hpp>
#include <plan/LastStage.hpp>

#include <algorithm>

using namespace Rhegma;

namespace
{

/// What a scene says of one sponge.
template <int D>
struct Sponge
{
  Vector<D> lower, upper; ///< corners of its box [m]
  double rate;            ///< force per momentum [1/s]
};

/// Calls act(node, axis, force, sum) for each axis of the nodes in the box that this rank owns, with the
/// force of the sponge [N]. \return the sum
template <int D, class Act>
double inBox(const State<D>& state, const Sponge<D>& sponge, const Act& act)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const NodePositions<D> positions = nodePositions(state);
  double sum = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::sponge::inBox", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i, double& all) {
        const int n = activeNode(nodes, i);
        const Vector<D> x = positions(latticeNode(nodes, n));
        bool inside = isOwnedByThisRank(nodes, n);
        for (int d = 0; d < D; ++d)
          inside = inside && x[d] >= sponge.lower[d] && x[d] <= sponge.upper[d];
        for (int d = 0; d < D && inside; ++d)
          act(n, d, -sponge.rate * nodes.sums(n, Nodes<D>::momentumAt + d), all);
      },
      sum);
  return sum;
}

template <int D>
void push(const State<D>& state, const Sponge<D>& sponge)
{
  const Nodes<D> nodes = state.mesh.nodes;
  inBox(
      state, sponge,
      KOKKOS_LAMBDA(int n, int d, double force, double&) { nodes.sums(n, Nodes<D>::forceAt + d) += force; });
}

/// Work of the sponge over the step [J], negative.
template <int D>
double work(const State<D>& state, const Sponge<D>& sponge)
{
  const LoadVelocity<D> velocity(state);
  const double dt = state.clock.dt;
  return inBox(
      state, sponge,
      KOKKOS_LAMBDA(int n, int d, double force, double& all) { all += dt * force * velocity(n, d); });
}

/// One boundary of this type: calls in the step.
template <int D>
void add(BoundaryParts<D>& parts, const Teuchos::ParameterList& list, const std::string& /*name*/)
{
  const Sponge<D> sponge{readVector<D>(list, "Lower Corner"), readVector<D>(list, "Upper Corner"),
                         list.get<double>("Rate")};
  const double own = 1.0 / sponge.rate; // half the largest stable step [s]
  parts.effect.timeStepLimit = [before = parts.effect.timeStepLimit, own](const State<D>& state)
  { return before ? std::min(before(state), own) : own; };
  parts.effect.call({Stage::BeforeSolve,
                     "sponge",
                     {quantity::nodalMomentum},
                     {},
                     {quantity::nodalForce},
                     [=](State<D>& state) { push(state, sponge); }});
  parts.effect.call({stageOfFaceVelocity(parts.scene),
                     "work of the sponge",
                     {projectsLast(parts.scene) ? quantity::projection : quantity::nodalMotion},
                     {},
                     {},
                     [=](State<D>& state) { state.energy.externalWork += work(state, sponge); }});
}

void check(SectionChecks& checks, const Teuchos::ParameterList& list, const std::string& where)
{
  checks.corners(list, where, false);
  if (checks.scene().isSublist("Time") && isEquilibrium(checks.scene()))
    checks.report(where, "a sponge slows what moves, and in equilibrium nothing moves; remove it");
}

} // namespace

BoundaryType sponge()
{
  Section s("Sponge", "Slows all material in a box by a force opposite to its momentum.");
  s.realArray("Lower Corner").unit("m").perAxis().meaning("Corner of the box with the smallest coordinates.");
  s.realArray("Upper Corner").unit("m").perAxis().meaning("Corner of the box with the largest coordinates.");
  s.real("Rate").unit("1/s").positive().meaning("Force over momentum.");
  return {s, check, add<2>, add<3>};
}
