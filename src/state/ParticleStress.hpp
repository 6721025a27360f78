#pragma once
/// Stress and stored energy density of a single particle.

#include "material/PrincipalStress.hpp"
#include "state/ParticleEnergy.hpp"

namespace Rhegma
{

/// Views for values of particles, in a run with mechanics.
template <int D>
struct ParticleStress
{
  BorrowedView<double * [gradientSize<D>]> deformation; ///< deformation gradient
  BorrowedView<double * [symmetricSize<D>]> stress;     ///< Kirchhoff stress [Pa]

  /// \param particles of the run, with their stress
  explicit ParticleStress(const FieldTable& particles)
      : deformation(particles.template real<gradientSize<D>>(fields::deformation)),
        stress(particles.template real<symmetricSize<D>>(fields::stress))
  {
  }

  /// Cauchy stress xx yy zz xy yz xz [Pa]. \param p a particle \param s becomes its six numbers
  KOKKOS_INLINE_FUNCTION void cauchy(int p, double* s) const
  {
    cauchyStress<D>(&deformation(p, 0), &stress(p, 0), s);
  }

  /// Largest principal Cauchy stress, that across the plane included [Pa].
  KOKKOS_INLINE_FUNCTION double principal(int p) const
  {
    double s[6];
    cauchy(p, s);
    return largestPrincipalStress(s);
  }

  /// Von Mises stress [Pa].
  KOKKOS_INLINE_FUNCTION double vonMises(int p) const
  {
    double s[6];
    cauchy(p, s);
    return vonMisesStress(s);
  }
};

/// Elastic energy of a particle per undeformed volume [J/m3]: the sum over particles of this times their
/// undeformed volume is the strain energy of the history, but for that of front springs.
template <int D>
KOKKOS_INLINE_FUNCTION double energyDensity(const ParticleEnergy<D>& energy, int p)
{
  return energy.strain(p) / energy.volume(p);
}

/// The largest principal stress as a function of the particle [Pa].
template <int D>
struct PrincipalStressOf
{
  ParticleStress<D> stress; ///< of the particles

  /// \param p a particle
  KOKKOS_INLINE_FUNCTION double operator()(int p) const { return stress.principal(p); }
};

/// The elastic energy per undeformed volume as a function of the particle [J/m3].
template <int D>
struct EnergyDensityOf
{
  ParticleEnergy<D> energy; ///< of the particles

  /// \param p a particle
  KOKKOS_INLINE_FUNCTION double operator()(int p) const { return energyDensity(energy, p); }
};

} // namespace Rhegma
