#include "cracks/Overlap.hpp"

#include "base/Numbers.hpp"
#include "cracks/Opening.hpp"
#include "state/Subdomain.hpp"

#include <cmath>

namespace Rhegma::cracks
{

namespace
{

/// Root mean square of Green's strain of the particles next to a crack.
template <int D>
double strainNextTo(const State<D>& state, int crack)
{
  const auto side = state.particles.integer(fields::side);
  const auto F = state.particles.template real<gradientSize<D>>(fields::deformation);
  const int name = crack + 1;
  double found[2] = {0.0, 0.0}; // sum of squares, number of particles
  Kokkos::parallel_reduce(
      "rhegma::cracks::strainNextTo", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, double& sum, double& number) {
        if (side(p) != name && side(p) != -name)
          return;
        for (int i = 0; i < D; ++i)
          for (int j = 0; j < D; ++j)
          {
            double strain = i == j ? -0.5 : 0.0;
            for (int k = 0; k < D; ++k)
              strain += 0.5 * F(p, k * D + i) * F(p, k * D + j);
            sum += strain * strain;
          }
        number += 1.0;
      },
      found[0], found[1]);
  sumParts(state, found, 2);
  return found[1] > 0.0 ? std::sqrt(found[0] / found[1]) : 0.0;
}

} // namespace

template <int D>
std::string warningOfOverlap(const State<D>& state, int crack)
{
  constexpr double fraction = 1.0; ///< of length times strain
  const Opening opening = measureOpening(state.cracks, crack);
  const double length = D == 2 ? opening.size : std::sqrt(opening.size);
  const double overlap = -opening.smallest;
  if (!state.ranks.many() && !(overlap > 1e-9 * state.mesh.grid.spacing))
    return {}; // without a look at all particles
  if (!(overlap > fraction * length * strainNextTo(state, crack)) ||
      !(overlap > 1e-9 * state.mesh.grid.spacing))
    return {};
  return "crack " + state.cracks.cracks[crack].name +
         ": its faces overlap at t = " + readableTime(state.clock.time) + " by up to " +
         readableLength(overlap) + ", because the scene has no contact; G and K are wrong from then on; " +
         (state.method.equilibrium()
              ? "add a section Contact, or run it with Time > Analysis = Dynamic and Contact"
              : "add a section Contact");
}

template std::string warningOfOverlap(const State<2>&, int);
template std::string warningOfOverlap(const State<3>&, int);

} // namespace Rhegma::cracks
