#include "contact/Balance.hpp"

#include "contact/SideEnergy.hpp"

#include <algorithm>

namespace Rhegma::contact
{

namespace
{

/// Sum of momentum times acceleration of the nodes [W].
double power(const Nodes<2>& nodes)
{
  double total = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::contact::power", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i, double& sum) {
        const int n = activeNode(nodes, i);
        for (int d = 0; d < 2; ++d)
          sum += nodes.sums(n, Nodes<2>::momentumAt + d) * nodes.motion(n, Nodes<2>::accelerationAt + d);
      },
      total);
  return total;
}

} // namespace

void Balance::begin(const State<2>& state) { workBefore_ = state.energy.externalWork; }

void Balance::measure(const State<2>& state, double stored)
{
  found_ = totalEnergy(state) + 0.5 * state.dt * power(state.nodes) + stored;
}

void Balance::compare(const State<2>& state, double lost)
{
  const double in = state.energy.start + 0.5 * (workBefore_ + state.energy.externalWork) - lost;
  scale_ = std::max(scale_, in);
  last_ = found_ - in;
  smallest_ = std::min(smallest_, last_);
  largest_ = std::max(largest_, last_);
}

} // namespace Rhegma::contact
