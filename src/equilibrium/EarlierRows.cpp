#include "equilibrium/EarlierRows.hpp"

namespace Rhegma::equilibrium
{

namespace
{

/// Fraction of the rows that may be new to the multigrid of an earlier system.
constexpr double mostNewRows = 0.2;

} // namespace

EarlierRows EarlierRows::match(const Ranks& ranks, const std::vector<int>& now,
                               const std::vector<int>& earlier, int perNode)
{
  const View<int*> unknown("rhegma::equilibrium::earlierUnknown", perNode * now.size());
  double rows[] = {0.0, static_cast<double>(now.size())}; // missing, all
  for (std::size_t r = 0, then = 0; r < now.size(); ++r)
  {
    while (then < earlier.size() && earlier[then] < now[r])
      ++then;
    const bool found = then < earlier.size() && earlier[then] == now[r];
    rows[0] += found ? 0.0 : 1.0;
    for (int d = 0; d < perNode; ++d)
      unknown(perNode * r + d) = found ? perNode * static_cast<int>(then) + d : -1;
  }
  ranks.sum(rows, 2);
  if (rows[0] > mostNewRows * rows[1])
    return {};
  return {unknown, Values("rhegma::equilibrium::earlierIn", perNode * earlier.size()),
          Values("rhegma::equilibrium::earlierOut", perNode * earlier.size()), true};
}

void EarlierRows::apply(const Multigrid& multigrid, const View<double*>& diagonal,
                        const BorrowedView<const double*>& x, const BorrowedView<double*>& y) const
{
  const View<int*> to = unknown;
  const Values right = in, cycled = out;
  const Kokkos::RangePolicy<ExecSpace> all(0, to.extent(0));
  Kokkos::deep_copy(right, 0.0);
  Kokkos::parallel_for(
      "rhegma::equilibrium::toEarlier", all, KOKKOS_LAMBDA(const int r) {
        if (to(r) >= 0)
          right(to(r)) = x(r);
      });
  multigrid.apply(BorrowedView<const double*>(right.data(), right.extent(0)),
                  BorrowedView<double*>(cycled.data(), cycled.extent(0)));
  Kokkos::parallel_for(
      "rhegma::equilibrium::fromEarlier", all,
      KOKKOS_LAMBDA(const int r) { y(r) = to(r) >= 0 ? cycled(to(r)) : x(r) / diagonal(r); });
}

void divideByDiagonal(const View<double*>& diagonal, const BorrowedView<const double*>& x,
                      const BorrowedView<double*>& y)
{
  Kokkos::parallel_for(
      "rhegma::equilibrium::diagonal", Kokkos::RangePolicy<ExecSpace>(0, diagonal.extent(0)),
      KOKKOS_LAMBDA(const int r) { y(r) = x(r) / diagonal(r); });
}

} // namespace Rhegma::equilibrium
