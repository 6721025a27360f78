#pragma once
/// Energies of a single particle.

#include "material/Materials.hpp"
#include "state/State.hpp"

namespace Rhegma
{

/// What a kernel needs for the energies of particles: velocity [m/s], mass [kg], undeformed volume [m3],
/// deformation gradient and the memory of the laws.
template <int D>
struct ParticleEnergy
{
  BorrowedView<double* [D]> velocity;
  BorrowedView<double*> mass, volume;
  BorrowedView<double * [gradientSize<D>]> deformation;
  BorrowedView<int*> material;
  BorrowedView<double**> history; ///< empty where no law has a memory
  View<Properties*> materials;

  explicit ParticleEnergy(const State<D>& state)
      : velocity(state.particles.template real<D>(fields::velocity)),
        mass(state.particles.scalar(fields::mass)),
        volume(state.particles.scalar(fields::volume)),
        deformation(state.particles.template real<gradientSize<D>>(fields::deformation)),
        material(state.particles.integer(fields::material)),
        materials(state.materials)
  {
    if (state.particles.has(fields::history))
      history = state.particles.table(fields::history);
  }

  /// m v.v / 2 [J]
  KOKKOS_INLINE_FUNCTION double kinetic(int p) const
  {
    double square = 0.0;
    for (int d = 0; d < D; ++d)
      square += velocity(p, d) * velocity(p, d);
    return 0.5 * mass(p) * square;
  }

  /// V0 W [J]
  KOKKOS_INLINE_FUNCTION double strain(int p) const
  {
    return volume(p) * storedEnergy<D>(materials(material(p)), &deformation(p, 0), memory(p));
  }

  /// Plastic work per undeformed volume so far, times V0 [J].
  KOKKOS_INLINE_FUNCTION double dissipated(int p) const
  {
    return volume(p) * dissipatedEnergy<D>(materials(material(p)), memory(p));
  }

  KOKKOS_INLINE_FUNCTION const double* memory(int p) const
  {
    return history.extent(1) > 0 ? &history(p, 0) : nullptr;
  }
};

} // namespace Rhegma
