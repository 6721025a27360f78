#include "base/ReadList.hpp"
#include "boundary/BoundaryParts.hpp"
#include "boundary/LoadVelocity.hpp"
#include "plan/LastStage.hpp"

namespace Rhegma
{

namespace
{

/// Adds m g to the force of every node [N]. \param acceleration g [m/s2]
template <int D>
void addBodyForce(const Nodes<D>& nodes, const Vector<D>& acceleration)
{
  Kokkos::parallel_for(
      "rhegma::addBodyForce", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(nodes, i);
        for (int d = 0; d < D && isOwnedByThisRank(nodes, n); ++d)
          nodes.sums(n, Nodes<D>::forceAt + d) += nodes.sums(n, Nodes<D>::massAt) * acceleration[d];
      });
}

/// Work [J] of m g over the step. \param velocity of a node along an axis [m/s]
template <int D, class Velocity>
double bodyForceWork(const State<D>& state, const Velocity& velocity, const Vector<D>& acceleration)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const double dt = state.clock.dt;
  double work = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::bodyForceWork", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i, double& sum) {
        const int n = activeNode(nodes, i);
        for (int d = 0; d < D && isOwnedByThisRank(nodes, n); ++d)
          sum += dt * acceleration[d] * nodes.sums(n, Nodes<D>::massAt) * velocity(n, d);
      },
      work);
  return work;
}

template <int D>
void addGravity(BoundaryParts<D>& parts, const Teuchos::ParameterList& list, const std::string& /*name*/)
{
  const Vector<D> acceleration = readVector<D>(list, "Acceleration");
  const TimeFunction history = TimeFunction::parse(list.get<std::string>("History"));
  const auto now = [=](const State<D>& state) { return loadOverStep(state, history); };
  parts.effect.call(Stage::BeforeSolve, "gravity", {quantity::nodalMass}, {}, {quantity::nodalForce},
                    [now, acceleration](State<D>& state)
                    { addBodyForce(state.mesh.nodes, now(state).acts * acceleration); });
  parts.effect.call(stageOfFaceVelocity(parts.scene), "work of gravity",
                    {projectsLast(parts.scene) ? quantity::projection : quantity::nodalMotion}, {}, {},
                    [now, acceleration](State<D>& state)
                    {
                      addWorkOfLoad(state, now(state),
                                    [&](const auto& velocity, double value)
                                    { return bodyForceWork(state, velocity, value * acceleration); });
                    });
}

} // namespace

BoundaryType gravityBoundary()
{
  Section s("Gravity", "A uniform body force on all mass.");
  s.realArray("Acceleration").unit("m/s2").perAxis().meaning("Acceleration of gravity: the force per mass.");
  describeHistory(s);
  return {s, {}, addGravity<2>, addGravity<3>};
}

} // namespace Rhegma
