/// An effect with a memory on nodes: docs/how-to/add-an-effect-with-nodal-memory.md.

#include "Bristles.hpp"

#include <boundary/LoadVelocity.hpp>
#include <plan/LastStage.hpp>

#include <cmath>

using namespace Rhegma;

namespace
{

const std::string deflection = "bristle deflection"; ///< the nodal field [m]

/// Adds the force of the bristles: -stiffness times nodal mass times deflection.
template <int D>
void push(const State<D>& state, double stiffness)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const auto bent = state.mesh.nodalFields.template real<D>(deflection);
  Kokkos::parallel_for(
      "rhegma::bristles::push", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(nodes, i);
        for (int d = 0; d < D && isOwnedByThisRank(nodes, n); ++d)
          nodes.sums(n, Nodes<D>::forceAt + d) -=
              stiffness * nodes.sums(n, Nodes<D>::massAt) * bent(latticeNode(nodes, n), d);
      });
}

/// Bends the bristles by the motion of the step. \return the work of their force over the step [J]
template <int D>
double bend(const State<D>& state, double stiffness)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const auto bent = state.mesh.nodalFields.template real<D>(deflection);
  const LoadVelocity<D> velocity(state);
  const double dt = state.clock.dt;
  double work = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::bristles::bend", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i, double& sum) {
        const int n = activeNode(nodes, i);
        for (int d = 0; d < D; ++d)
        {
          double& own = bent(latticeNode(nodes, n), d);
          if (isOwnedByThisRank(nodes, n))
            sum -= dt * stiffness * nodes.sums(n, Nodes<D>::massAt) * own * velocity(n, d);
          own += dt * nodes.motion(n, d);
        }
      },
      work);
  return work;
}

template <int D>
Effect<D> makeBristles(const Teuchos::ParameterList& scene)
{
  const double stiffness = scene.sublist("Bristles").get<double>("Stiffness");
  Effect<D> effect;
  effect.name = "Bristles";
  effect.addsNodal.push_back({{deflection, D, "m", "how far the bristles are bent"}, OnRemesh::Interpolate});
  effect.call({Stage::BeforeSolve,
               "bristles",
               {quantity::nodalMass},
               {},
               {quantity::nodalForce},
               [=](State<D>& state) { push(state, stiffness); }});
  effect.call({stageOfFaceVelocity(scene),
               "deflection of bristles",
               {projectsLast(scene) ? quantity::projection : quantity::nodalMotion},
               {},
               {},
               [=](State<D>& state) { state.energy.externalWork += bend(state, stiffness); }});
  effect.timeStepLimit = [=](const State<D>&) { return 0.1 / std::sqrt(stiffness); }; // a tenth of a radian
  return effect;
}

} // namespace

EffectEntry bristles()
{
  Section section("Bristles",
                  "Elastic bristles on the grid nodes, bent by the material that moves over them.");
  section.real("Stiffness").unit("1/s2").positive().meaning("Force per deflection and mass.");
  section.refuse({when::present("Bristles"), when::equilibrium()},
                 "in equilibrium nothing moves; remove this section");
  EffectEntry entry{section, {}, makeBristles<2>, makeBristles<3>};
  entry.onRanks = true;
  return entry;
}
