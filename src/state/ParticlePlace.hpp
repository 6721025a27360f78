#pragma once
/// Where particles are and were.

#include "state/State.hpp"

namespace Rhegma
{

/// Positions of particles in the deformed and in the undeformed body [m]. The field `position` is where they
/// are in the cells: that is the deformed body, unless the cells lie in the undeformed one, where
/// displacements are a field of their own.
template <int D>
struct ParticlePlace
{
  BorrowedView<double* [D]> position;     ///< in the cells
  BorrowedView<double* [D]> reference;    ///< in the undeformed body
  BorrowedView<double* [D]> displacement; ///< empty where the cells lie in the deformed body

  ParticlePlace() = default;

  /// \param particles of a run
  explicit ParticlePlace(const FieldTable& particles)
      : position(particles.template real<D>(fields::position)),
        reference(particles.template real<D>(fields::reference))
  {
    if (particles.has(fields::displacement))
      displacement = particles.template real<D>(fields::displacement);
  }

  /// Displacement of a particle since the start along an axis [m].
  KOKKOS_FORCEINLINE_FUNCTION double moved(int p, int axis) const
  {
    return displacement.extent(0) > 0 ? displacement(p, axis) : position(p, axis) - reference(p, axis);
  }

  /// Position in the deformed body [m].
  KOKKOS_FORCEINLINE_FUNCTION double now(int p, int axis) const
  {
    return displacement.extent(0) > 0 ? reference(p, axis) + displacement(p, axis) : position(p, axis);
  }
};

} // namespace Rhegma
