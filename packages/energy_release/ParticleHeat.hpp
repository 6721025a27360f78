#pragma once
/// The contribution of temperature to the integrals around a front.

#include "energy_release/CrackTipFields.hpp"
#include "material/ThermoLaw.hpp"
#include "state/State.hpp"
#include "transfer/ParticleViews.hpp"

namespace Rhegma::energy_release
{

/// Elastic energy of particles and its dependence on temperature.
template <int D>
struct ParticleHeat
{
  ThermoTables tables; ///< empty where no particle has heat
  BorrowedView<double*> temperature;
  BorrowedView<double* [D]> gradient;

  ParticleHeat() = default;
  explicit ParticleHeat(const State<D>& state) : tables(state.materials.thermo)
  {
    if (tables.empty())
      return;
    temperature = state.particles.scalar(fields::temperature);
    gradient = state.particles.template real<D>(fields::temperatureGradient);
  }

  /// Whether the stress of a material depends on the temperature.
  KOKKOS_INLINE_FUNCTION bool strains(int material) const
  {
    return !tables.empty() && tables.material(material).coupled;
  }

  /// W of the non-thermal part of F [J/m3].
  KOKKOS_INLINE_FUNCTION double energy(int p, int material, const Properties& law, const double* F,
                                       const double* history) const
  {
    if (!strains(material))
      return storedEnergy<D>(law, F, history);
    return withLaw<D>(law.law, law.plane,
                      ThermoEnergy{ThermoPoint(tables, material, temperature(p)), F, history});
  }

  /// Change of W along a direction at fixed strain, dW/dT T,1 [J/m4]: thermal strain and moduli together.
  /// \param image of the direction in the deformed body
  KOKKOS_INLINE_FUNCTION double energyAlong(int p, int material, const Properties& law, const double* F,
                                            const double* tau, const double* history,
                                            const Vector<D>& image) const
  {
    if (!strains(material))
      return 0.0;
    return alongImage(p, image) *
           withLaw<D>(law.law, law.plane,
                      ThermoSlope{ThermoPoint(tables, material, temperature(p)), F, tau, history});
  }

  /// Temperature's change along a direction of the undeformed body [K/m].
  KOKKOS_INLINE_FUNCTION double alongImage(int p, const Vector<D>& image) const
  {
    double sum = 0.0;
    for (int d = 0; d < D; ++d)
      sum += gradient(p, d) * image[d];
    return sum;
  }

  /// Thermal strain, and alpha [1/K].
  KOKKOS_INLINE_FUNCTION double strain(int p, int material) const
  {
    return strains(material) ? ThermoPoint(tables, material, temperature(p)).stretch() - 1.0 : 0.0;
  }
  KOKKOS_INLINE_FUNCTION double expansion(int p, int material) const
  {
    return strains(material) ? ThermoPoint(tables, material, temperature(p)).expansion() : 0.0;
  }
};

} // namespace Rhegma::energy_release
