/// Damping in proportion to mass.

#include "boundary/HeldMarks.hpp"
#include "damping/Damping.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::damping
{

template <int D>
double dampVelocity(State<D>& state, double rate)
{
  const auto velocity = state.particles.template real<D>(fields::velocity);
  const auto mass = state.particles.scalar(fields::mass);
  const double factor = std::exp(-rate * state.clock.dt);
  const int particles = state.particles.size();
  double loss = 0.0;
  // A sum for each lane, as a single sum could not be vectorised.
  Kokkos::parallel_reduce(
      "rhegma::dampVelocity", Kokkos::RangePolicy<ExecSpace>(0, (particles + lanes - 1) / lanes),
      KOKKOS_LAMBDA(const int bundle, double& sum) {
        const int begin = bundle * lanes;
        const int count = begin + lanes < particles ? lanes : particles - begin;
        double energy[lanes] = {}; // twice the kinetic
        for (int d = 0; d < D; ++d)
          for (int l = 0; l < count; ++l)
          {
            const double before = velocity(begin + l, d);
            velocity(begin + l, d) = factor * before;
            energy[l] += mass(begin + l) * before * before;
          }
        for (int width = lanes / 2; width > 0; width /= 2)
          for (int l = 0; l < width; ++l)
            energy[l] += energy[l + width];
        sum += 0.5 * (1.0 - factor * factor) * energy[0];
      },
      loss);
  return loss;
}

template <int D>
void dampMomentum(const State<D>& state, double rate)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const double factor = std::exp(-rate * state.clock.dt);
  Kokkos::parallel_for(
      "rhegma::dampMomentum", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i) {
        for (int d = 0; d < D; ++d)
          nodes.sums(activeNode(nodes, i), Nodes<D>::momentumAt + d) *= factor;
      });
}

template <int D>
double lossToStresses(const State<D>& state, double rate, View<char**>& heldNodes)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const NodePositions<D> positions = nodePositions(state);
  clearMarks(state, heldNodes);
  const View<char**> held = heldNodes;
  for (const NodeConstraint<D>& constraint : state.motion.constraints)
    Kokkos::parallel_for(
        "rhegma::markHeldNodes", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
        KOKKOS_LAMBDA(const int i) {
          const int n = activeNode(nodes, i);
          if (constraint.appliesAt(positions(latticeNode(nodes, n))))
            for (int d = 0; d < D; ++d)
              held(n, d) = constraint.holds[d] ? char(1) : held(n, d);
        });
  // Where nodes move in substeps the stress at the start acts on the velocity that was damped in the first
  // of them only.
  const NodeSlots subcycled = state.motion.substeps.nodes;
  const View<int*> coupledRow = state.motion.coupledRow;
  const double fraction = state.motion.substeps.length / state.clock.dt;
  double power = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::powerOfStresses", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i, double& sum) {
        const int n = activeNode(nodes, i);
        const double mass = nodes.sums(n, Nodes<D>::massAt);
        const bool coupled = coupledRow.extent(0) > 0 && coupledRow(n) >= 0;
        for (int d = 0; d < D && mass > 0.0; ++d)
          if (coupled || held(n, d) == 0)
            sum += (subcycled.moves(n) ? fraction : 1.0) * nodes.sums(n, Nodes<D>::forceAt + d) *
                   nodes.sums(n, Nodes<D>::momentumAt + d) / mass;
      },
      power);
  // Beyond this exponent momenta have vanished, and the factor would overflow.
  constexpr double most = 700.0;
  return 0.5 * std::expm1(std::min(rate * state.clock.dt, most)) * state.clock.dt * power;
}

template double dampVelocity(State<2>&, double);
template double dampVelocity(State<3>&, double);
template void dampMomentum(const State<2>&, double);
template void dampMomentum(const State<3>&, double);
template double lossToStresses(const State<2>&, double, View<char**>&);
template double lossToStresses(const State<3>&, double, View<char**>&);

} // namespace Rhegma::damping
