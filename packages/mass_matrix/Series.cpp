#include "mass_matrix/Series.hpp"

namespace Rhegma::mass_matrix
{

namespace
{

Kokkos::RangePolicy<ExecSpace> range(int n) { return Kokkos::RangePolicy<ExecSpace>(0, n); }

/// L^-1 of the sums at `at`, and of `scale` times those at `alsoAt`.
template <int D>
void divide(const Nodes<D>& nodes, const MassSystem<D>& s, int at, int alsoAt, double scale,
            const View<double*>& term)
{
  Kokkos::parallel_for(
      "rhegma::mass::firstTerm", range(s.numRows), KOKKOS_LAMBDA(const int row) {
        const int n = s.nodeOf(row);
        const double inverse = s.lumped(row) > 0.0 ? 1.0 / s.lumped(row) : 0.0;
        for (int d = 0; d < D; ++d)
          term(row * D + d) = inverse * (nodes.sums(n, at + d) + scale * nodes.sums(n, alsoAt + d));
      });
}

} // namespace

template <int D>
void Series<D>::begin(const MassSystem<D>& system)
{
  const int unknowns = system.numRows * D;
  if (static_cast<int>(term_.extent(0)) >= unknowns)
    return;
  const int room = unknowns + unknowns / 4 + 16;
  term_ = View<double*>("rhegma::seriesTerm", room);
  image_ = View<double*>("rhegma::seriesImage", room);
  sum_ = View<double*>("rhegma::seriesSum", room);
}

template <int D>
void Series<D>::sum(const State<D>& state, const MassSystem<D>& system)
{
  const View<double*> term = term_, image = image_, sum = sum_;
  const MassSystem<D> s = system;
  Kokkos::parallel_for(
      "rhegma::mass::startSeries", range(s.numRows * D), KOKKOS_LAMBDA(const int i) { sum(i) = term(i); });
  for (int k = 1; k < order_; ++k)
  {
    multiply<D, D>(state, system, BorrowedView<const double*>(term.data(), term.extent(0)),
                   BorrowedView<double*>(image.data(), image.extent(0)));
    Kokkos::parallel_for(
        "rhegma::mass::nextTerm", range(s.numRows * D), KOKKOS_LAMBDA(const int i) {
          const double mass = s.lumped(i / D);
          term(i) = mass > 0.0 ? -image(i) / mass : 0.0;
          sum(i) += term(i);
        });
  }
}

template <int D>
void Series<D>::motion(State<D>& state, const MassSystem<D>& system)
{
  const Nodes<D> nodes = state.nodes;
  const MassSystem<D> s = system;
  const View<double*> result = sum_;
  const double dt = state.dt;
  divide(nodes, s, Nodes<D>::forceAt, Nodes<D>::forceAt, 0.0, term_);
  sum(state, system);
  Kokkos::parallel_for(
      "rhegma::mass::seriesAcceleration", range(s.numRows), KOKKOS_LAMBDA(const int row) {
        for (int d = 0; d < D; ++d)
          nodes.motion(s.nodeOf(row), Nodes<D>::accelerationAt + d) = result(row * D + d);
      });
  divide(nodes, s, Nodes<D>::momentumAt, Nodes<D>::momentumAt, 0.0, term_);
  sum(state, system);
  Kokkos::parallel_for(
      "rhegma::mass::seriesVelocity", range(s.numRows), KOKKOS_LAMBDA(const int row) {
        const int n = s.nodeOf(row);
        for (int d = 0; d < D; ++d)
          nodes.motion(n, d) = result(row * D + d) + dt * nodes.motion(n, Nodes<D>::accelerationAt + d);
      });
}

template <int D>
void Series<D>::updateVelocity(State<D>& state, const MassSystem<D>& system, bool withImpulse)
{
  const Nodes<D> nodes = state.nodes;
  const MassSystem<D> s = system;
  const View<double*> result = sum_;
  const double dt = state.dt;
  divide(nodes, s, Nodes<D>::momentumAt, Nodes<D>::forceAt, withImpulse ? dt : 0.0, term_);
  sum(state, system);
  Kokkos::parallel_for(
      "rhegma::mass::filteredVelocity", range(s.numRows), KOKKOS_LAMBDA(const int row) {
        const int n = s.nodeOf(row);
        for (int d = 0; d < D; ++d)
          nodes.motion(n, d) =
              result(row * D + d) + (withImpulse ? 0.0 : dt * nodes.motion(n, Nodes<D>::accelerationAt + d));
      });
}

template <int D>
void Series<D>::projection(State<D>& state, const MassSystem<D>& system)
{
  const Nodes<D> nodes = state.nodes;
  const MassSystem<D> s = system;
  const View<double*> term = term_, result = sum_;
  Kokkos::parallel_for(
      "rhegma::mass::projected", range(s.numRows), KOKKOS_LAMBDA(const int row) {
        for (int d = 0; d < D; ++d)
          term(row * D + d) = nodes.projection(s.nodeOf(row), d);
      });
  sum(state, system);
  Kokkos::parallel_for(
      "rhegma::mass::seriesProjection", range(s.numRows), KOKKOS_LAMBDA(const int row) {
        for (int d = 0; d < D; ++d)
          nodes.projection(s.nodeOf(row), d) = result(row * D + d);
      });
}

template class Series<2>;
template class Series<3>;

} // namespace Rhegma::mass_matrix
