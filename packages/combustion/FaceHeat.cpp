#include "combustion/FaceHeat.hpp"

#include "material/ThermoTables.hpp"
#include "state/Subdomain.hpp"
#include "transfer/PushNodes.hpp"

namespace Rhegma::combustion
{

template <int D>
void FaceHeat<D>::measure(const State<D>& state, const FacePoints<D>& points)
{
  const std::size_t rows = state.mesh.nodes.sums.extent(0);
  if (nodes_.extent(0) < rows)
  {
    nodes_ = View<double * [D + 3]>("rhegma::combustion::heatOfNodes", rows);
    demand_ = View<double* [5]>("rhegma::combustion::heatAsked", rows);
  }
  if (static_cast<int>(atFaces_.extent(0)) != points.count())
    atFaces_ = View<double* [2]>("rhegma::combustion::faceTemperature", points.count());
  clear(state);
  weigh(state);
  sumOverRanks(state, nodes_.data(), D + 3, 0, D + 2);
  findTemperatures(state);
  checkFaces(state, points);
  sumParts(state, View<double*>(atFaces_.data(), 2 * points.count()));
}

template <int D>
void FaceHeat<D>::clear(const State<D>& state) const
{
  const Nodes<D> nodes = state.mesh.nodes;
  const auto sums = nodes_;
  const auto demand = demand_;
  Kokkos::parallel_for(
      "rhegma::combustion::clearHeat", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(nodes, i);
        for (int k = 0; k < D + 3; ++k)
          sums(n, k) = 0.0;
        for (int k = 0; k < 5; ++k)
          demand(n, k) = 0.0;
      });
}

template <int D>
void FaceHeat<D>::weigh(const State<D>& state) const
{
  const StencilTable<D> table = state.stored.table;
  const View<int*> particle = state.stored.particle;
  const ThermoTables tables = state.materials.thermo;
  const auto sums = nodes_;
  const Vector<D> origin =
      state.mesh.subdomain ? state.mesh.subdomain->division.lattice.origin : state.mesh.grid.origin;
  const auto volume = state.particles.scalar(fields::volume);
  const auto temperature = state.particles.scalar(fields::temperature);
  const auto gradient = state.particles.template real<D>(fields::temperatureGradient);
  const auto position = state.particles.template real<D>(fields::position);
  const auto material = state.particles.integer(fields::material);
  forEachPushing(
      "rhegma::combustion::weighHeat", state.stored.count, KOKKOS_LAMBDA(const int r) {
        const int p = particle(r);
        const double c = volume(p) * ThermoPoint(tables, material(p), temperature(p)).capacity();
        double T = temperature(p);
        for (int d = 0; d < D; ++d)
          T -= gradient(p, d) * (position(p, d) - origin[d]);
        for (int e = 0; e < table.count(r); ++e)
        {
          const int n = table.node(r, e);
          const double fraction = table.weight(r, e) * c;
          Kokkos::atomic_add(&sums(n, capacityAt), fraction);
          Kokkos::atomic_add(&sums(n, heatAt), fraction * T);
          for (int d = 0; d < D; ++d)
            Kokkos::atomic_add(&sums(n, momentAt + d), fraction * gradient(p, d));
        }
      });
}

template <int D>
void FaceHeat<D>::findTemperatures(const State<D>& state) const
{
  const Nodes<D> nodes = state.mesh.nodes;
  const NodePositions<D> positions = nodePositions(state);
  const auto sums = nodes_;
  const Vector<D> origin =
      state.mesh.subdomain ? state.mesh.subdomain->division.lattice.origin : state.mesh.grid.origin;
  Kokkos::parallel_for(
      "rhegma::combustion::findTemperatures", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(nodes, i);
        if (!(sums(n, capacityAt) > 0.0))
          return;
        const Vector<D> x = positions(latticeNode(nodes, n)) - origin;
        double heat = sums(n, heatAt);
        for (int d = 0; d < D; ++d)
          heat += x[d] * sums(n, momentAt + d);
        sums(n, temperatureAt) = heat / sums(n, capacityAt);
      });
}

namespace
{

/// Temperature of the nodes of one face at a point, those without capacity left out [K]; 0 without nodes.
template <int D, class Table>
KOKKOS_INLINE_FUNCTION double atFace(const StencilTable<D>& face, int k, const Table& nodes, int capacityAt,
                                     int temperatureAt)
{
  double sum = 0.0, weight = 0.0;
  for (int e = 0; e < face.count(k); ++e)
  {
    const int n = face.node(k, e);
    if (!(nodes(n, capacityAt) > 0.0))
      continue;
    sum += face.weight(k, e) * nodes(n, temperatureAt);
    weight += face.weight(k, e);
  }
  return weight > 0.0 ? sum / weight : 0.0;
}

} // namespace

template <int D>
void FaceHeat<D>::checkFaces(const State<D>&, const FacePoints<D>& points) const
{
  const FacePoints<D> p = points;
  const auto sums = nodes_;
  const auto at = atFaces_;
  Kokkos::parallel_for(
      "rhegma::combustion::lookAtFaces", Kokkos::RangePolicy<ExecSpace>(0, points.count()),
      KOKKOS_LAMBDA(const int k) {
        at(k, 0) = atFace(p.below, k, sums, capacityAt, temperatureAt);
        at(k, 1) = atFace(p.above, k, sums, capacityAt, temperatureAt);
      });
}

template <int D>
void FaceHeat<D>::give(State<D>& state, const FacePoints<D>& points, int crack, const FaceHeating& heating,
                       const View<double*>& heatToFaces)
{
  sumDemand(state, points, crack, heating);
  sumOverRanks(state, demand_.data(), 5, 0, 3);
  change(state);
  charge(state, points, crack, heating, heatToFaces);
  sumParts(state, heatToFaces);
  state.energy.heat += toParticles(state);
}

template <int D>
void FaceHeat<D>::sumDemand(const State<D>& state, const FacePoints<D>& points, int crack,
                            const FaceHeating& heating) const
{
  const FacePoints<D> p = points;
  const FaceHeating heat = heating;
  const auto demand = demand_;
  const double thickness = state.method.thickness;
  const Nodes<D> nodes = state.mesh.nodes;
  Kokkos::parallel_for(
      "rhegma::combustion::clearAsked", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i) {
        for (int k = 0; k < 5; ++k)
          demand(activeNode(nodes, i), k) = 0.0;
      });
  forEachPushing(
      "rhegma::combustion::askHeat", points.count(), KOKKOS_LAMBDA(const int k) {
        if (p.crack(k) != crack)
          return;
        const double area = p.currentSize(k) * thickness;
        const double H = heat.conductance(k) * area, F = heat.given(k) * area;
        for (int side = 0; side < 2; ++side)
        {
          const StencilTable<D>& face = side == 0 ? p.below : p.above;
          for (int e = 0; e < face.count(k); ++e)
          {
            const int n = face.node(k, e);
            Kokkos::atomic_add(&demand(n, 0), face.weight(k, e) * H);
            Kokkos::atomic_add(&demand(n, 1), face.weight(k, e) * H * heat.gasTemperature(k));
            Kokkos::atomic_add(&demand(n, 2), face.weight(k, e) * F);
          }
        }
      });
}

template <int D>
void FaceHeat<D>::change(const State<D>& state) const
{
  const Nodes<D> nodes = state.mesh.nodes;
  const auto sums = nodes_;
  const auto demand = demand_;
  Kokkos::parallel_for(
      "rhegma::combustion::changeOfNodes", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(nodes, i);
        const double C = sums(n, capacityAt), H = demand(n, 0);
        if (!(C > 0.0))
          return;
        const double fraction = H > 0.0 ? -std::expm1(-H / C) * C / H : 0.0;
        const double heat = fraction * (demand(n, 1) - H * sums(n, temperatureAt)) + demand(n, 2);
        demand(n, fractionAt) = fraction;
        demand(n, changeAt) = heat / C;
      });
}

template <int D>
void FaceHeat<D>::charge(const State<D>& state, const FacePoints<D>& points, int crack,
                         const FaceHeating& heating, const View<double*>& heatToFaces) const
{
  const FacePoints<D> p = points;
  const FaceHeating heat = heating;
  const auto sums = nodes_;
  const auto demand = demand_;
  const double thickness = state.method.thickness;
  Kokkos::parallel_for(
      "rhegma::combustion::chargeGas", Kokkos::RangePolicy<ExecSpace>(0, points.count()),
      KOKKOS_LAMBDA(const int k) {
        heatToFaces(k) = 0.0;
        if (p.crack(k) != crack)
          return;
        const double area = p.currentSize(k) * thickness;
        for (int side = 0; side < 2; ++side)
        {
          const StencilTable<D>& face = side == 0 ? p.below : p.above;
          for (int e = 0; e < face.count(k); ++e)
          {
            const int n = face.node(k, e);
            if (sums(n, capacityAt) > 0.0)
              heatToFaces(k) += face.weight(k, e) * area *
                                (demand(n, fractionAt) * heat.conductance(k) *
                                     (heat.gasTemperature(k) - sums(n, temperatureAt)) +
                                 heat.given(k));
          }
        }
      });
}

template <int D>
double FaceHeat<D>::toParticles(State<D>& state) const
{
  const StencilTable<D> table = state.stored.table;
  const View<int*> particle = state.stored.particle;
  const ThermoTables tables = state.materials.thermo;
  const auto demand = demand_;
  const auto volume = state.particles.scalar(fields::volume);
  const auto temperature = state.particles.scalar(fields::temperature);
  const auto internal = state.particles.scalar(fields::internalEnergy);
  const auto material = state.particles.integer(fields::material);
  double heat = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::combustion::heatParticles", Kokkos::RangePolicy<ExecSpace>(0, state.stored.count),
      KOKKOS_LAMBDA(const int r, double& sum) {
        const int p = particle(r);
        double rise = 0.0;
        for (int e = 0; e < table.count(r); ++e)
          rise += table.weight(r, e) * demand(table.node(r, e), changeAt);
        if (rise == 0.0)
          return;
        const double c = ThermoPoint(tables, material(p), temperature(p)).capacity();
        internal(p) += c * rise;
        temperature(p) += rise;
        sum += volume(p) * c * rise;
      },
      heat);
  return heat;
}

template class FaceHeat<2>;
template class FaceHeat<3>;

} // namespace Rhegma::combustion
