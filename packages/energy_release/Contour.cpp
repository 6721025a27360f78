#include "energy_release/Contour.hpp"

#include "transfer/ParticleViews.hpp"

#include <algorithm>

namespace Rhegma::energy_release
{

namespace
{

template <int D, ShapeKind S>
void sumVolume(const State<D>& state, const Vector<D>& centre, double radius, const View<double*>& volume)
{
  const Connectivity<D, S, false> unbroken = connectivity<D, S, false>(state);
  const auto position = state.particles.template real<D>(fields::position);
  const auto initial = state.particles.scalar(fields::volume);
  Kokkos::parallel_for(
      "rhegma::contourVolume", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p) {
        double square = 0.0;
        for (int d = 0; d < D; ++d)
          square += (position(p, d) - centre[d]) * (position(p, d) - centre[d]);
        if (square < radius * radius)
          unbroken.visit(p, [&](int node, double weight, const double*)
                         { Kokkos::atomic_add(&volume(node), weight * initial(p)); });
      });
}

} // namespace

template <int D>
double clearRadius(const State<D>& state, const Vector<D>& centre, double radius)
{
  const Grid<D> grid = state.grid;
  const View<double*> volume("rhegma::contourVolume", grid.numNodes);
  const double reach = radius + 3.0 * grid.spacing;
  if (state.shape == ShapeKind::Linear)
    sumVolume<D, ShapeKind::Linear>(state, centre, reach, volume);
  else
    sumVolume<D, ShapeKind::Gimp>(state, centre, reach, volume);
  double full = D == 2 ? state.thickness : 1.0;
  for (int d = 0; d < D; ++d)
    full *= grid.spacing;
  double nearest = radius;
  Kokkos::parallel_reduce(
      "rhegma::clearRadius", Kokkos::RangePolicy<ExecSpace>(0, grid.numNodes),
      KOKKOS_LAMBDA(const int n, double& smallest) {
        if (volume(n) > 0.6 * full)
          return;
        const double r = norm(grid.nodePosition(n) - centre);
        smallest = r < smallest ? r : smallest;
      },
      Kokkos::Min<double>(nearest));
  return std::min(nearest, radius);
}

template <int D>
double largestContour(const State<D>& state, const CrackFront<D>& front, double radius)
{
  double clear = clearRadius(state, front.position, radius);
  for (const CrackFront<D>& other : state.cracks.fronts)
    if (other.crack != front.crack || other.number != front.number)
      clear = std::min(clear, norm(other.position - front.position));
  return clear;
}

template double clearRadius(const State<2>&, const Vector<2>&, double);
template double clearRadius(const State<3>&, const Vector<3>&, double);
template double largestContour(const State<2>&, const CrackFront<2>&, double);
template double largestContour(const State<3>&, const CrackFront<3>&, double);

} // namespace Rhegma::energy_release
