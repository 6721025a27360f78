#include "rigid_tools/ToolHeat.hpp"

#include "base/SmallLoops.hpp"
#include "transfer/ParticleViews.hpp"

namespace Rhegma::rigid_tools
{

namespace
{

constexpr int capacityAt = 0, heatAt = 1;

/// Adds the heat capacity of a listed particle to the nodes that have heat.
template <int D, class Connect>
struct AddCapacity
{
  Connect connect;
  View<int*> particle;
  View<double* [2]> rows;
  ThermoTables tables;
  BorrowedView<double*> volume, temperature;
  BorrowedView<int*> material;

  KOKKOS_INLINE_FUNCTION void operator()(const int k) const
  {
    const int p = particle(k);
    const double capacity = volume(p) * ThermoPoint(tables, material(p), temperature(p)).capacity();
    connect.visit(p,
                  [&](int node, double weight, const double*)
                  {
                    if (weight > 0.0 && rows(node, heatAt) != 0.0)
                      Kokkos::atomic_add(&rows(node, capacityAt), weight * capacity);
                  });
  }
};

/// Heats a listed particle.
template <int D, class Connect>
struct HeatParticles
{
  AddCapacity<D, Connect> of;
  BorrowedView<double*> internal;

  KOKKOS_INLINE_FUNCTION void operator()(const int k, double& given) const
  {
    const int p = of.particle(k);
    double change = 0.0;
    of.connect.visit(p,
                     [&](int node, double weight, const double*)
                     {
                       if (weight > 0.0 && of.rows(node, capacityAt) > 0.0)
                         change += weight * of.rows(node, heatAt) / of.rows(node, capacityAt);
                     });
    if (change == 0.0)
      return;
    const double capacity = ThermoPoint(of.tables, of.material(p), of.temperature(p)).capacity();
    internal(p) += capacity * change;
    of.temperature(p) += change; // with the stress, it follows from the internal energy
    given += of.volume(p) * capacity * change;
  }
};

/// Sets the heat of the nodes of contacts, or clears it.
template <int D>
void setHeat(const ToolContacts<D>& contacts, double fraction, const View<double* [2]>& rows, bool clears)
{
  const ToolContacts<D> at = contacts;
  parallelForSmall(
      "rhegma::heatOfContactsOfTool", contacts.count, KOKKOS_LAMBDA(const int c) {
        for (int e = 0; e < at.parts(c); ++e)
        {
          const int row = at.partRow(c, e);
          if (clears)
            rows(row, capacityAt) = rows(row, heatAt) = 0.0;
          else
            Kokkos::atomic_add(&rows(row, heatAt), fraction * at.taken(c, 1) * at.part(c, e));
        }
      });
}

} // namespace

template <int D>
double heatByFriction(State<D>& state, const ToolContacts<D>& contacts, const CellsNearTool<D>& near,
                      double fraction, View<double* [2]>& rows)
{
  if (contacts.count == 0 || near.count == 0)
    return 0.0;
  if (rows.extent(0) < state.mesh.nodes.sums.extent(0))
    rows = View<double* [2]>("rhegma::heatAtTool", state.mesh.nodes.sums.extent(0));
  setHeat(contacts, fraction, rows, false);
  const FieldTable& table = state.particles;
  double given = 0.0;
  withConnectivity(state,
                   [&](const auto& connect)
                   {
                     using Connect = std::decay_t<decltype(connect)>;
                     const AddCapacity<D, Connect> add{connect,
                                                       near.particle,
                                                       rows,
                                                       state.materials.thermo,
                                                       table.scalar(fields::volume),
                                                       table.scalar(fields::temperature),
                                                       table.integer(fields::material)};
                     parallelForSmall("rhegma::capacityAtTool", near.count, add);
                     parallelSumSmall("rhegma::heatAtTool", 0, near.count,
                                      HeatParticles<D, Connect>{add, table.scalar(fields::internalEnergy)},
                                      given);
                   });
  setHeat(contacts, fraction, rows, true);
  return given;
}

template double heatByFriction(State<2>&, const ToolContacts<2>&, const CellsNearTool<2>&, double,
                               View<double* [2]>&);
template double heatByFriction(State<3>&, const ToolContacts<3>&, const CellsNearTool<3>&, double,
                               View<double* [2]>&);

} // namespace Rhegma::rigid_tools
