#include "body_contact/HeatOfContact.hpp"

#include "base/SmallLoops.hpp"
#include "body_contact/NearBlocks.hpp"
#include "material/Tensors.hpp"
#include "state/State.hpp"

namespace Rhegma::body_contact
{

namespace
{

/// Sums over the particles of a field at a node.
template <int D>
struct HeatOfField
{
  double capacity = 0.0;     ///< C [J/K]
  double heat = 0.0;         ///< C times its temperature [J]
  double volume = 0.0;       ///< sum N V [m3]
  double conductivity = 0.0; ///< sum N V k [W m2/K]
  double end = 0.0;          ///< sum V grad N . n [m2]

  KOKKOS_INLINE_FUNCTION double temperature() const { return heat / capacity; }
  KOKKOS_INLINE_FUNCTION double effusivity() const
  {
    return volume > 0.0 ? std::sqrt(conductivity / volume * (capacity / volume)) : 0.0;
  }
};

template <int D, class Connect>
struct FindHeat
{
  Connect connect;
  Grid<D> grid;
  SharedNodes<D> shared;
  NodalPairs<D> pairs;
  Conductances conductance;
  ThermoTables tables;
  BorrowedView<double*[D]> position, gradient;
  BorrowedView<double*> volume, temperature;
  BorrowedView<double * [gradientSize<D>]> deformation;
  BorrowedView<int*> material;
  View<double*> change;
  double dt;

  KOKKOS_INLINE_FUNCTION void operator()(const int s) const
  {
    for (int q = pairs.first(s); q < pairs.first(s + 1); ++q)
    {
      pairs.heat(q, 0) = pairs.heat(q, 1) = 0.0;
      if (presses(q))
        exchange(s, q);
    }
  }

  KOKKOS_INLINE_FUNCTION bool presses(int q) const
  {
    bool any = pairs.springs.join(q);
    for (int d = 0; d < D; ++d)
      any = any || pairs.impulse(q, d) != 0.0;
    return any;
  }

  KOKKOS_INLINE_FUNCTION void exchange(int s, int q) const
  {
    const int a = pairs.row(q, 0), b = pairs.row(q, 1);
    const HeatOfField<D> one = sumsOf(s, q, a, 1.0), two = sumsOf(s, q, b, -1.0);
    if (!(one.capacity > 0.0) || !(two.capacity > 0.0))
      return;
    const double byFriction = pairs.taken(q, 1);
    const double e1 = one.effusivity(), e2 = two.effusivity();
    const double part = e1 + e2 > 0.0 ? e1 / (e1 + e2) : one.capacity / (one.capacity + two.capacity);
    change(a) += part * byFriction / one.capacity;
    change(b) += (1.0 - part) * byFriction / two.capacity;
    const double area = std::fmax(0.0, std::fmin(one.end, two.end));
    const double through = dt * area * conductance(pairs.group(q, 0), pairs.group(q, 1));
    double passed = 0.0;
    if (through > 0.0)
      passed = (one.temperature() + change(a) - two.temperature() - change(b)) /
               (1.0 / through + 1.0 / one.capacity + 1.0 / two.capacity);
    change(a) -= passed / one.capacity;
    change(b) += passed / two.capacity;
    pairs.heat(q, 0) = byFriction;
    pairs.heat(q, 1) = passed;
  }

  /// \param row of the field \param sign of the normal that points out of it
  KOKKOS_INLINE_FUNCTION HeatOfField<D> sumsOf(int s, int q, int row, double sign) const
  {
    HeatOfField<D> sums;
    const Vector<D> node = grid.nodePosition(shared.node(s));
    for (int k = shared.firstParticle(s); k < shared.firstParticle(s + 1); ++k)
      if (shared.field(k) == row)
      {
        const int p = shared.particle(k);
        const ThermoPoint at(tables, material(p), temperature(p));
        double T = temperature(p);
        for (int d = 0; d < D; ++d)
          T += gradient(p, d) * (node[d] - position(p, d));
        const double now = determinant<D>(&deformation(p, 0)) * volume(p);
        connect.visit(p,
                      [&](int n, double weight, const double* slope)
                      {
                        if (n != row || !(weight > leastWeight))
                          return;
                        const double part = weight * volume(p);
                        sums.capacity += part * at.capacity();
                        sums.heat += part * at.capacity() * T;
                        sums.volume += part;
                        sums.conductivity += part * at.conductivity();
                        for (int d = 0; d < D; ++d)
                          sums.end += sign * now * slope[d] * pairs.normal(q, d);
                      });
      }
    return sums;
  }
};

/// Gives the particles the changes of their nodes.
template <int D, class Connect>
struct HeatParticles
{
  Connect connect;
  View<char*> touching;
  View<double*> change;
  ThermoTables tables;
  BorrowedView<double*> temperature, internal;
  BorrowedView<int*> material;

  KOKKOS_INLINE_FUNCTION void operator()(int p) const
  {
    if (touching(p) == 0)
      return;
    double sum = 0.0;
    connect.visit(p, [&](int node, double weight, const double*)
                  { sum += weight > leastWeight ? weight * change(node) : 0.0; });
    if (sum == 0.0)
      return;
    internal(p) += ThermoPoint(tables, material(p), temperature(p)).capacity() * sum;
    temperature(p) += sum; // with the stress, it follows from the internal energy
  }
};

template <int D>
void clearChanges(const SharedNodes<D>& shared, const View<double*>& change)
{
  parallelForSmall(
      "rhegma::clearHeatOfContact", shared.count, KOKKOS_LAMBDA(const int s) {
        const int groups = numGroups(shared.groups, shared.node(s));
        for (int k = 0; k < groups; ++k)
          change(rowOfField(shared, s, k)) = 0.0;
        if (shared.second(s) >= 0)
          change(shared.second(s)) = 0.0;
      });
}

} // namespace

template <int D>
void passHeat(State<D>& state, const SharedNodes<D>& shared, NodalPairs<D>& pairs, HeatOfContact<D>& heat)
{
  if (pairs.heat.extent(0) < pairs.gap.extent(0))
    pairs.heat = View<double* [2]>("rhegma::heatOfPairs", pairs.gap.extent(0));
  const std::size_t rows = state.mesh.nodes.sums.extent(0);
  if (heat.change.extent(0) < rows)
    heat.change = View<double*>("rhegma::heatOfContact", rows);
  const FieldTable& table = state.particles;
  const auto temperature = table.scalar(fields::temperature);
  const auto material = table.integer(fields::material);
  withConnectivity(
      state,
      [&](const auto& connect)
      {
        using Connect = std::decay_t<decltype(connect)>;
        parallelForSmall("rhegma::findHeatOfContact", shared.count,
                         FindHeat<D, Connect>{connect, state.mesh.grid, shared, pairs, heat.conductance,
                                              state.materials.thermo, table.real<D>(fields::position),
                                              table.real<D>(fields::temperatureGradient),
                                              table.scalar(fields::volume), temperature,
                                              table.real<gradientSize<D>>(fields::deformation), material,
                                              heat.change, state.clock.dt});
        forEachParticleIn("rhegma::heatParticlesInContact", state, shared.nearBlock, shared.cells.meets,
                          HeatParticles<D, Connect>{connect, shared.touching, heat.change,
                                                    state.materials.thermo, temperature,
                                                    table.scalar(fields::internalEnergy), material});
      });
  clearChanges(shared, heat.change);
}

template void passHeat(State<2>&, const SharedNodes<2>&, NodalPairs<2>&, HeatOfContact<2>&);
template void passHeat(State<3>&, const SharedNodes<3>&, NodalPairs<3>&, HeatOfContact<3>&);

} // namespace Rhegma::body_contact
