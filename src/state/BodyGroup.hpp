#pragma once
/// Groups of bodies that are kept apart at common nodes, and what stencils know of them.

#include "base/FieldTable.hpp"
#include "state/State.hpp"

#include <string>

namespace Rhegma
{

namespace fields
{
/// Number, from 1 on, of the group of bonded bodies to which a particle belongs; only where an effect keeps
/// groups apart.
inline const std::string bodyGroup = "body group";
} // namespace fields

/// What particles know of cuts, for points that lie where they do.
struct ParticleSides
{
  BorrowedView<int*> side;  ///< fields::side
  BorrowedView<int*> group; ///< fields::bodyGroup
  bool hasSide;             ///< whether particles have the former
  bool hasGroup;            ///< whether particles have the latter

  /// \param particles of a run
  explicit ParticleSides(const FieldTable& particles)
      : hasSide(particles.has(fields::side)), hasGroup(particles.has(fields::bodyGroup))
  {
    if (hasSide)
      side = particles.integer(fields::side);
    if (hasGroup)
      group = particles.integer(fields::bodyGroup);
  }

  /// Gives points room for them. \param label of the view \param count of points \param points that get it
  template <int D>
  void reserve(const std::string& label, int count, ObservedPoints<D>& points) const
  {
    if (hasGroup && static_cast<int>(points.group.extent(0)) < count)
      points.group = View<int*>(label, count);
  }

  /// Copies those of particle p to point k.
  template <int D>
  KOKKOS_INLINE_FUNCTION void copy(int p, const ObservedPoints<D>& points, int k) const
  {
    if (hasSide)
      points.side(k) = side(p);
    if (hasGroup)
      points.group(k) = group(p);
  }
};

/// The particles that a crack may cut: all, or where groups are kept apart those of its group.
struct ParticlesOfGroup
{
  BorrowedView<int*> of; ///< group of each particle
  int group = 0;         ///< 0: all particles

  ParticlesOfGroup() = default;
  /// \param particles of a run \param number of the group; not used where there are no groups
  ParticlesOfGroup(const FieldTable& particles, int number)
      : group(particles.has(fields::bodyGroup) ? number : 0)
  {
    if (group != 0)
      of = particles.integer(fields::bodyGroup);
  }
  /// Whether particle p is one of them.
  KOKKOS_INLINE_FUNCTION bool hold(int p) const { return group == 0 || of(p) == group; }
};

/// The particles that a crack may cut. \param state of a run \param crack its index; -1: any
template <int D>
ParticlesOfGroup particlesOfCrack(const State<D>& state, int crack)
{
  const int cracks = static_cast<int>(state.cracks.cracks.size());
  return {state.particles, crack >= 0 && crack < cracks ? state.cracks.cracks[crack].bodyGroup : 0};
}

} // namespace Rhegma
