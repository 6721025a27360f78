#include "output/CoreRow.hpp"

#include "material/Materials.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace Rhegma
{

namespace
{

/// Sums of all particles: kinetic, strain, plastic, momentum. An array reduction, so that one pass over the
/// particles gives all.
template <int D>
struct ParticleSums
{
  using value_type = double[];
  using size_type = int;
  using execution_space = ExecSpace;

  int value_count = 3 + D;
  BorrowedView<double* [D]> velocity;
  BorrowedView<double*> mass;
  BorrowedView<double*> volume;
  BorrowedView<double * [gradientSize<D>]> deformation;
  BorrowedView<double**> history;
  BorrowedView<int*> material;
  View<Properties*> materials;

  explicit ParticleSums(const State<D>& state)
      : velocity(state.particles.template real<D>(fields::velocity)),
        mass(state.particles.scalar(fields::mass)),
        volume(state.particles.scalar(fields::volume)),
        deformation(state.particles.template real<gradientSize<D>>(fields::deformation)),
        material(state.particles.integer(fields::material)),
        materials(state.materials)
  {
    if (state.particles.has(fields::history))
      history = state.particles.table(fields::history);
  }

  KOKKOS_INLINE_FUNCTION void operator()(const int p, double* sum) const
  {
    double speedSquared = 0.0;
    for (int d = 0; d < D; ++d)
    {
      speedSquared += velocity(p, d) * velocity(p, d);
      sum[3 + d] += mass(p) * velocity(p, d);
    }
    const Properties& properties = materials(material(p));
    const double* memory = history.extent(1) > 0 ? &history(p, 0) : nullptr;
    sum[0] += 0.5 * mass(p) * speedSquared;
    sum[1] += volume(p) * storedEnergy<D>(properties, &deformation(p, 0), memory);
    sum[2] += volume(p) * dissipatedEnergy<D>(properties, memory);
  }
};

bool canFlow(const std::vector<Properties>& materials)
{
  return std::any_of(materials.begin(), materials.end(),
                     [](const Properties& m) { return m.kind == LawKind::J2Plastic; });
}

struct Entry
{
  const char* column;
  double value;
  const char* effect; ///< that gives it; empty: the method itself
};

std::vector<Entry> entries(const EnergyLedger& energy)
{
  return {{"kinetic", energy.kinetic, ""},
          {"strain", energy.strain, ""},
          {"thermal", energy.thermal, "Thermal"},
          {"external_work", energy.externalWork, ""},
          {"damped", energy.damped, "Damping"},
          {"contact", energy.contact, "Contact"},
          {"fracture", energy.fracture, "Propagation"},
          {"merged", energy.merged, "Adaptivity"},
          {"combustion", energy.combustion, "Combustion"},
          {"residual", energy.residual(), ""}};
}

} // namespace

template <int D>
void measureEnergy(State<D>& state)
{
  double sum[3 + D] = {};
  Kokkos::parallel_reduce("rhegma::measureEnergy", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
                          ParticleSums<D>(state), sum);
  state.energy.kinetic = sum[0];
  state.energy.strain = sum[1];
  state.energy.plastic = sum[2];
  for (int d = 0; d < D; ++d)
    state.momentum[d] = sum[3 + d];
}

template <int D>
void coreRow(State<D>& state, const std::set<std::string>& effects)
{
  measureEnergy(state);
  HistoryRow row;
  for (const Entry& entry : entries(state.energy))
    if (*entry.effect == '\0' || effects.count(entry.effect) > 0)
      row.emplace_back(entry.column, entry.value);
  if (canFlow(state.materialList))
    row.emplace_back("plastic", state.energy.plastic);
  const char* names[] = {"momentum_x", "momentum_y", "momentum_z"};
  for (int d = 0; d < D; ++d)
    row.emplace_back(names[d], state.momentum[d]);
  state.row.insert(state.row.begin(), row.begin(), row.end());
}

template <int D>
void coreReport(const State<D>& state, nlohmann::json& summary)
{
  nlohmann::json& energy = summary["energy"];
  for (const Entry& entry : entries(state.energy))
    energy[entry.column] = entry.value;
  if (canFlow(state.materialList))
    energy["plastic"] = state.energy.plastic;
  nlohmann::json& momentum = summary["momentum"];
  momentum = nlohmann::json::array();
  for (int d = 0; d < D; ++d)
    momentum.push_back(state.momentum[d]);
}

template void measureEnergy(State<2>&);
template void measureEnergy(State<3>&);
template void coreRow(State<2>&, const std::set<std::string>&);
template void coreRow(State<3>&, const std::set<std::string>&);
template void coreReport(const State<2>&, nlohmann::json&);
template void coreReport(const State<3>&, nlohmann::json&);

} // namespace Rhegma
