/// The fields of groups of bodies in stencils.

#include "base/SmallLoops.hpp"
#include "body_contact/SharedNodes.hpp"

namespace Rhegma::body_contact
{

namespace
{

/// The group of a point: as given, or that of the bodies which the crack next to it cuts; 0: not known.
struct GroupOfPoint
{
  View<int*> group, side, ofCrack;

  KOKKOS_INLINE_FUNCTION int operator()(int r) const
  {
    const int given = group.extent(0) > 0 ? group(r) : 0, name = side(r) > 0 ? side(r) : -side(r);
    return given != 0 || name == 0 || ofCrack.extent(0) == 0 ? given : ofCrack(name - 1);
  }
};

} // namespace

template <int D>
void findFieldsNextToCracks(const State<D>& state, const SharedNodes<D>& shared)
{
  if (state.cracks.bodyGroupOf.extent(0) == 0)
    return;
  const SharedNodes<D> at = shared;
  const StencilTable<D> table = state.stored.table;
  const View<int*> row = state.stored.row;
  parallelForSmall(
      "rhegma::findFieldsNextToCracks", shared.count, KOKKOS_LAMBDA(const int s) {
        const int second = at.second(s);
        for (int k = at.firstParticle(s); second >= 0 && k < at.firstParticle(s + 1); ++k)
        {
          const int r = at.field(k) == at.node(s) ? row(at.particle(k)) : -1,
                    count = r < 0 ? 0 : table.count(r);
          for (int e = 0; e < count; ++e)
            if (table.node(r, e) == second)
              at.field(k) = second;
        }
      });
}

template <int D>
void useFieldsOfGroups(const State<D>& state, const SharedNodes<D>& shared, const ObservedPoints<D>& points,
                       const StencilTable<D>& table)
{
  if (shared.indexOf.extent(0) == 0 || shared.count == 0)
    return;
  const SharedNodes<D> at = shared;
  const int lattice = state.mesh.nodes.numLattice;
  const GroupOfPoint groupOf{points.group, points.side, state.cracks.bodyGroupOf};
  parallelForSmall(
      "rhegma::useFieldsOfGroups", points.count, KOKKOS_LAMBDA(const int r) {
        const int group = groupOf(r), count = group != 0 ? table.count(r) : 0;
        for (int k = 0; k < count; ++k)
        {
          const int n = table.node(r, k);
          if (n >= lattice || at.groups(n, 0) == 0 || at.groups(n, 0) == group)
            continue;
          int field = 1;
          while (field < mostGroups && at.groups(n, field) != group)
            ++field;
          if (field < mostGroups)
          {
            table.node(r, k) = at.row(at.indexOf(n)) + field - 1;
            continue;
          }
          table.weight(r, k) = 0.0;
          for (int d = 0; d < D; ++d)
            table.slope(r, k, d) = 0.0;
        }
      });
}

template void findFieldsNextToCracks(const State<2>&, const SharedNodes<2>&);
template void findFieldsNextToCracks(const State<3>&, const SharedNodes<3>&);
template void useFieldsOfGroups(const State<2>&, const SharedNodes<2>&, const ObservedPoints<2>&,
                                const StencilTable<2>&);
template void useFieldsOfGroups(const State<3>&, const SharedNodes<3>&, const ObservedPoints<3>&,
                                const StencilTable<3>&);

} // namespace Rhegma::body_contact
