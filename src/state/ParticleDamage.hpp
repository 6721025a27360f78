#pragma once
/// Damage of a single particle.

#include "material/Materials.hpp"
#include "state/State.hpp"

namespace Rhegma
{

/// Whether a law of the run has a damage.
template <int D>
bool hasDamage(const State<D>& state)
{
  for (const Properties& material : state.materials.properties)
    if (damages(material))
      return true;
  return false;
}

/// The damage as a function of the particle, from 0 of a whole to 1 of a broken material; 0 where the law has
/// none.
template <int D>
struct DamageOf
{
  BorrowedView<int*> material;    ///< of each particle
  BorrowedView<double**> history; ///< of the laws
  View<Properties*> materials;    ///< by number

  /// \param state of a run with a law that has a damage
  explicit DamageOf(const State<D>& state)
      : material(state.particles.integer(fields::material)),
        history(state.particles.table(fields::history)),
        materials(state.materials.device)
  {
  }

  /// \param p a particle
  KOKKOS_INLINE_FUNCTION double operator()(int p) const
  {
    return damageOf<D>(materials(material(p)), &history(p, 0));
  }
};

} // namespace Rhegma
