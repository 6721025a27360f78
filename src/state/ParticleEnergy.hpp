#pragma once
/// Energies of a single particle.

#include "material/ThermoLaw.hpp"
#include "state/State.hpp"

namespace Rhegma
{

/// Views for the energies of particles: velocity [m/s], mass [kg], undeformed volume [m3], deformation
/// gradient and the history of the laws.
template <int D>
struct ParticleEnergy
{
  BorrowedView<double* [D]> velocity;
  BorrowedView<double*> mass, volume;
  BorrowedView<double * [gradientSize<D>]> deformation;
  BorrowedView<int*> material;
  BorrowedView<double**> history; ///< empty where no law has a history
  View<Properties*> materials;
  ThermoTables thermo; ///< empty without heat
  BorrowedView<double*> temperature;
  bool mechanics;

  explicit ParticleEnergy(const State<D>& state)
      : mass(state.particles.scalar(fields::mass)),
        volume(state.particles.scalar(fields::volume)),
        deformation(state.particles.template real<gradientSize<D>>(fields::deformation)),
        material(state.particles.integer(fields::material)),
        materials(state.materials.device),
        thermo(state.materials.thermo),
        mechanics(state.method.mechanics)
  {
    if (mechanics)
      velocity = state.particles.template real<D>(fields::velocity);
    if (!thermo.empty())
      temperature = state.particles.scalar(fields::temperature);
    if (state.particles.has(fields::history))
      history = state.particles.table(fields::history);
  }

  /// m v.v / 2 [J]
  KOKKOS_INLINE_FUNCTION double kinetic(int p) const
  {
    double square = 0.0;
    for (int d = 0; d < D && mechanics; ++d)
      square += velocity(p, d) * velocity(p, d);
    return 0.5 * mass(p) * square;
  }

  /// V0 W [J]
  KOKKOS_INLINE_FUNCTION double strain(int p) const
  {
    if (!mechanics)
      return 0.0;
    const Properties& law = materials(material(p));
    if (thermo.empty())
      return volume(p) * storedEnergy<D>(law, &deformation(p, 0), memory(p));
    return volume(p) * withLaw<D>(law.law, law.plane,
                                  ThermoEnergy{ThermoPoint(thermo, material(p), temperature(p)),
                                               &deformation(p, 0), memory(p)});
  }

  /// Plastic work per undeformed volume so far, less what became heat, times V0 [J].
  KOKKOS_INLINE_FUNCTION double dissipated(int p) const
  {
    if (!mechanics)
      return 0.0;
    const double kept = thermo.empty() ? 1.0 : 1.0 - thermo.material(material(p)).plasticHeat;
    return kept * volume(p) * dissipatedEnergy<D>(materials(material(p)), memory(p));
  }

  KOKKOS_INLINE_FUNCTION const double* memory(int p) const
  {
    return history.extent(1) > 0 ? &history(p, 0) : nullptr;
  }
};

} // namespace Rhegma
