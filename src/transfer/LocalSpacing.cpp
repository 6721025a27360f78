#include "transfer/LocalSpacing.hpp"

#include "state/Subdomain.hpp"

namespace Rhegma
{

namespace
{

/// Whether a position lies in the domain and is finite: after an unstable step that of a front may not.
template <int D>
bool isInside(const Grid<D>& lattice, const Vector<D>& x)
{
  bool inside = true;
  for (int d = 0; d < D; ++d)
  {
    const double cell = lattice.inCells(x[d], d);
    inside = inside && cell >= 0.0 && cell < lattice.cells[d];
  }
  return inside;
}

/// The same on all ranks, wherever the position lies.
template <int D>
double spacingOfAllRanks(const Branches<D>& refined, const Vector<D>& x)
{
  const Grid<D>& lattice = refined.grid();
  for (int level = 0;; ++level)
  {
    typename Branches<D>::Cell cell;
    for (int d = 0; d < D; ++d)
      cell[d] = static_cast<int>(std::ldexp(lattice.inCells(x[d], d), level));
    if (!refined.isRefined(level, cell))
      return std::ldexp(lattice.spacing, -level);
  }
}

} // namespace

template <int D>
double spacingAt(const State<D>& state, const Vector<D>& x)
{
  if (!state.mesh.tree.refined() ||
      !isInside(state.mesh.subdomain ? state.mesh.subdomain->refined.grid() : state.mesh.grid, x))
    return state.mesh.grid.spacing;
  if (state.mesh.subdomain)
    return spacingOfAllRanks(state.mesh.subdomain->refined, x);
  const TreeSight<D> sight(state.mesh.grid, state.mesh.tree);
  double spacing = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::spacingAt", Kokkos::RangePolicy<ExecSpace>(0, 1),
      KOKKOS_LAMBDA(const int, double& sum) { sum += sight.spacingAt(x); }, spacing);
  return spacing;
}

template double spacingAt(const State<2>&, const Vector<2>&);
template double spacingAt(const State<3>&, const Vector<3>&);

} // namespace Rhegma
