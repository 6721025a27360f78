#include "cracks/ForgetSides.hpp"

#include "transfer/BlocksInReach.hpp"

#include <vector>

namespace Rhegma::cracks
{

template <int D>
void forgetSidesAhead(const State<D>& state, const CrackFront<D>& front, double reach)
{
  const int count = static_cast<int>(front.nodes.size());
  const View<double * [2 * D]> nodes("rhegma::cracks::frontNodes", count);
  const auto host = Kokkos::create_mirror_view(nodes);
  for (int k = 0; k < count; ++k)
    for (int d = 0; d < D; ++d)
    {
      host(k, d) = front.nodes[k].position[d];
      host(k, D + d) = front.nodes[k].direction[d];
    }
  Kokkos::deep_copy(nodes, host);
  const auto position = state.particles.template real<D>(fields::position);
  const auto side = state.particles.integer(fields::side);
  const int name = front.crack + 1;
  std::vector<AxisBox<D>> boxes;
  for (const FrontNode<D>& node : front.nodes)
    boxes.push_back(boxAround(node.position, reach));
  BlocksInReach<D> blocks;
  blocks.find(state, boxes);
  blocks.forEachParticle(
      "rhegma::cracks::forgetSidesAhead", KOKKOS_LAMBDA(const int p) {
        if (side(p) != name && side(p) != -name)
          return;
        double least = reach * reach, ahead = 0.0;
        for (int k = 0; k < count; ++k)
        {
          double square = 0.0, along = 0.0;
          for (int d = 0; d < D; ++d)
          {
            const double from = position(p, d) - nodes(k, d);
            square += from * from;
            along += from * nodes(k, D + d);
          }
          if (square < least)
          {
            least = square;
            ahead = along;
          }
        }
        if (ahead > 0.0)
          side(p) = 0;
      });
}

template void forgetSidesAhead(const State<2>&, const CrackFront<2>&, double);
template void forgetSidesAhead(const State<3>&, const CrackFront<3>&, double);

} // namespace Rhegma::cracks
