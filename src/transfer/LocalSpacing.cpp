#include "transfer/LocalSpacing.hpp"

namespace Rhegma
{

template <int D>
double spacingAt(const State<D>& state, const Vector<D>& x)
{
  if (!state.tree.refined())
    return state.grid.spacing;
  const TreeSight<D> sight(state.grid, state.tree);
  double spacing = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::spacingAt", Kokkos::RangePolicy<ExecSpace>(0, 1),
      KOKKOS_LAMBDA(const int, double& sum) { sum += sight.spacingAt(x); }, spacing);
  return spacing;
}

template double spacingAt(const State<2>&, const Vector<2>&);
template double spacingAt(const State<3>&, const Vector<3>&);

} // namespace Rhegma
