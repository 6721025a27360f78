#include "output/CoreRow.hpp"

#include "material/Materials.hpp"
#include "state/EnergySums.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>

namespace Rhegma
{

namespace
{

bool canDissipate(const std::vector<Properties>& materials)
{
  return std::any_of(materials.begin(), materials.end(), dissipates);
}

struct Entry
{
  const char* column;
  double value;
  bool ofEffect = true; ///< present only if an effect contributes to it (Effect::balance)
  bool sampled = false; ///< a sum over particles, which samples take; others are recorded in every step
};

std::vector<Entry> entries(const EnergyBalance& energy)
{
  return {{"kinetic", energy.kinetic, false, true},
          {"strain", energy.strain, false, true},
          {"tools", energy.tools},
          {"thermal", energy.thermal, true, true},
          {"heat", energy.heat},
          {"external_work", energy.externalWork, false},
          {"damped", energy.damped},
          {"contact", energy.contact},
          {"fracture", energy.fracture},
          {"merged", energy.merged},
          {"stabilised", energy.stabilised},
          {"combustion", energy.combustion},
          {"residual", energy.residual(), false, true}};
}

/// kinetic + strain + tools + plastic energy when the run began [J], which the residual counts; only in the
/// summary
constexpr const char* atStart = "start";

} // namespace

template <int D>
void coreRow(State<D>& state, const std::set<std::string>& given)
{
  measureEnergy(state);
  sumEnergyBalance(state);
  HistoryRow row;
  for (const Entry& entry : entries(state.energy))
    if (!entry.ofEffect || given.count(entry.column) > 0)
      row.emplace_back(entry.column, entry.value);
  if (canDissipate(state.materials.properties))
    row.emplace_back("plastic", state.energy.plastic);
  if (state.method.picFraction > 0.0)
    row.emplace_back("filtered", state.energy.filtered);
  const char* names[] = {"momentum_x", "momentum_y", "momentum_z"};
  for (int d = 0; d < D; ++d)
    row.emplace_back(names[d], state.sample.momentum[d]);
  state.sample.row.insert(state.sample.row.begin(), row.begin(), row.end());
}

template <int D>
void coreReport(const State<D>& state, nlohmann::json& summary)
{
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN(); // null in the summary
  const bool known = state.sample.step > 0 || state.clock.step == 0;
  nlohmann::json& energy = summary["energy"];
  for (const Entry& entry : entries(state.energy))
    energy[entry.column] = known || !entry.sampled ? entry.value : unknown;
  if (canDissipate(state.materials.properties))
    energy["plastic"] = known ? state.energy.plastic : unknown;
  if (state.method.picFraction > 0.0)
    energy["filtered"] = state.energy.filtered;
  energy[atStart] = state.energy.start;
  summary["cells"] = {{"largest", state.mesh.grid.spacing}, {"smallest", state.mesh.smallestSpacing()}};
  nlohmann::json& momentum = summary["momentum"];
  momentum = nlohmann::json::array();
  for (int d = 0; d < D; ++d)
    momentum.push_back(known ? state.sample.momentum[d] : unknown);
}

template void coreRow(State<2>&, const std::set<std::string>&);
template void coreRow(State<3>&, const std::set<std::string>&);
template void coreReport(const State<2>&, nlohmann::json&);
template void coreReport(const State<3>&, nlohmann::json&);

} // namespace Rhegma
