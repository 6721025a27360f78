#include "transfer/NearestMaterial.hpp"

#include "state/Subdomain.hpp"
#include "transfer/BlocksInReach.hpp"

namespace Rhegma
{

namespace
{

using Reducer = Kokkos::MinLoc<double, int>;
using Nearest = typename Reducer::value_type;

/// The particle of this rank that is nearest to x, of those in the blocks around it.
template <int D>
Nearest nearestParticle(const State<D>& state, const Vector<D>& x, const ParticlesOfGroup& among,
                        double reach)
{
  const auto position = state.particles.template real<D>(fields::position);
  BlocksInReach<D> blocks;
  blocks.find(state, {boxAround(x, reach)});
  const View<int* [2]> range = blocks.ranges();
  Nearest nearest;
  Kokkos::parallel_reduce(
      "rhegma::nearestParticle", Kokkos::RangePolicy<ExecSpace>(0, blocks.count()),
      KOKKOS_LAMBDA(const int b, Nearest& best) {
        for (int p = range(b, 0); p < range(b, 1); ++p)
        {
          double square = 0.0;
          for (int d = 0; d < D; ++d)
            square += (position(p, d) - x[d]) * (position(p, d) - x[d]);
          if (square < best.val && among.hold(p))
          {
            best.val = square;
            best.loc = p;
          }
        }
      },
      Reducer(nearest));
  return nearest;
}

} // namespace

template <int D>
int materialAt(const State<D>& state, const Vector<D>& x, const ParticlesOfGroup& among)
{
  if (state.materials.properties.size() == 1)
    return 0;
  double reach = 2.0 * state.mesh.grid.spacing;
  Nearest nearest = nearestParticle(state, x, among, reach);
  if (!(nearest.val <= reach * reach)) // others may be nearer
    nearest = nearestParticle(state, x, among, 1e300);
  double closeness = -nearest.val; // least where this rank has no particle
  maxParts(state, &closeness, 1);
  int own = 0;
  if (state.particles.size() > 0 && closeness == -nearest.val)
    Kokkos::deep_copy(own, Kokkos::subview(state.particles.integer(fields::material), nearest.loc));
  double index = own;
  maxParts(state, &index, 1);
  return static_cast<int>(index);
}

template int materialAt(const State<2>&, const Vector<2>&, const ParticlesOfGroup&);
template int materialAt(const State<3>&, const Vector<3>&, const ParticlesOfGroup&);

} // namespace Rhegma
