#include "mass_matrix/RowLists.hpp"

#include "base/SmallLoops.hpp"

namespace Rhegma::mass_matrix
{

template <int D>
void startLists(const State<D>& state, const ConsistentFraction<D>& fraction, MassSystem<D>& system)
{
  system.numExtra = 0;
  if (state.stored.count == 0)
    return;
  const View<int*> extraOf = system.extraOf, rowOf = system.rowOf, particle = state.stored.particle;
  const StencilTable<D> table = state.stored.table;
  const auto position = state.particles.template real<D>(fields::position);
  parallelForSmall(
      "rhegma::mass::chooseLists", 0, state.stored.count, KOKKOS_LAMBDA(const int r) {
        if (fraction(&position(particle(r), 0)) == 0.0)
          return;
        for (int k = 0; k < table.count(r); ++k)
        {
          const int row = rowOf(table.node(r, k));
          if (row >= 0)
            extraOf(row) = chosen;
        }
      });
  int count = 0;
  parallelScanSmall(
      "rhegma::mass::numberLists", system.first, system.last,
      KOKKOS_LAMBDA(const int row, int& at, const bool final) {
        if (extraOf(row) == -1)
          return;
        if (final)
          extraOf(row) = at;
        ++at;
      },
      count);
  system.numExtra = count;
  const int wide = system.listCapacity;
  if (static_cast<int>(system.extraCount.extent(0)) < count ||
      static_cast<int>(system.extra.extent(1)) != wide)
  {
    const int capacity = count + count / 4 + 16;
    system.extraCount = View<int*>("rhegma::massExtraCount", capacity);
    system.extra = View<double**>("rhegma::massExtra", capacity, wide);
    system.extraColumn = View<int**>("rhegma::massExtraColumn", capacity, wide);
  }
  const auto values = system.extra;
  const auto columns = system.extraColumn;
  const bool hashed = system.hashed;
  parallelForSmall(
      "rhegma::mass::clearLists", 0, count, KOKKOS_LAMBDA(const int list) {
        for (int k = 0; k < wide && hashed; ++k)
          columns(list, k) = -1;
        for (int k = 0; k < wide && !hashed; ++k)
          values(list, k) = 0.0;
      });
}

template <int D>
int fullestListOf(const MassSystem<D>& system)
{
  const View<int*> number = system.extraCount;
  int most = 0;
  Kokkos::parallel_reduce(
      "rhegma::mass::fullestList", Kokkos::RangePolicy<ExecSpace>(0, system.numExtra),
      KOKKOS_LAMBDA(const int list, int& largest) {
        largest = number(list) > largest ? number(list) : largest;
      },
      Kokkos::Max<int>(most));
  return most;
}

template <int D>
void chooseLists(bool refined, MassSystem<D>& system)
{
  if (system.listCapacity == 0 || system.hashed != refined)
    system.listCapacity = listCapacityOf<D>(system.slots, refined);
  system.hashed = refined;
  if (refined && system.overflow.data() == nullptr)
    system.overflow = View<int>("rhegma::massOverflow");
}

template <int D>
int listCapacityOf(int slots, bool refined)
{
  // On a lattice each slot in either of two fields.
  return refined ? (D == 2 ? 64 : 256) : 2 * slots;
}

template <int D>
bool growLists(MassSystem<D>& system)
{
  if (!system.hashed)
    return false;
  int full = 0;
  Kokkos::deep_copy(full, system.overflow);
  if (full == 0)
    return false;
  system.listCapacity *= 2;
  Kokkos::deep_copy(system.overflow, 0);
  return true;
}

template int listCapacityOf<2>(int, bool);
template int listCapacityOf<3>(int, bool);
template bool growLists(MassSystem<2>&);
template bool growLists(MassSystem<3>&);
template void chooseLists(bool, MassSystem<2>&);
template void chooseLists(bool, MassSystem<3>&);
template void startLists(const State<2>&, const ConsistentFraction<2>&, MassSystem<2>&);
template void startLists(const State<3>&, const ConsistentFraction<3>&, MassSystem<3>&);
template int fullestListOf(const MassSystem<2>&);
template int fullestListOf(const MassSystem<3>&);

} // namespace Rhegma::mass_matrix
