#include "mass_matrix/AngularMomentum.hpp"

#include "state/ParticlePlace.hpp"
#include "state/Subdomain.hpp"

namespace Rhegma::mass_matrix
{

template <int D>
Vector<3> angularMomentum(const State<D>& state)
{
  const auto mass = state.particles.scalar(fields::mass);
  const ParticlePlace<D> place(state.particles);
  const auto velocity = state.particles.template real<D>(fields::velocity);
  Vector<3> total{{0.0, 0.0, 0.0}};
  Kokkos::parallel_reduce(
      "rhegma::mass::angularMomentum", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, double& aboutX, double& aboutY, double& aboutZ) {
        const double m = mass(p);
        if constexpr (D == 3)
        {
          aboutX += m * (place.now(p, 1) * velocity(p, 2) - place.now(p, 2) * velocity(p, 1));
          aboutY += m * (place.now(p, 2) * velocity(p, 0) - place.now(p, 0) * velocity(p, 2));
        }
        aboutZ += m * (place.now(p, 0) * velocity(p, 1) - place.now(p, 1) * velocity(p, 0));
      },
      total[0], total[1], total[2]);
  sumParts(state, total.c, 3);
  return total;
}

template Vector<3> angularMomentum(const State<2>&);
template Vector<3> angularMomentum(const State<3>&);

} // namespace Rhegma::mass_matrix
