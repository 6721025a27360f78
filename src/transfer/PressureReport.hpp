#pragma once
/// Reports of the pressure in a crack.

#include "state/State.hpp"

#include <nlohmann/json.hpp>

namespace Rhegma
{

/// A sample of history.csv. \param pressure [Pa]
template <int D>
void samplePressure(State<D>& state, int crack, double pressure)
{
  state.sample.row.emplace_back(state.cracks.cracks[crack].name + ".pressure", pressure);
}

/// Entry of summary.json. \param pressure [Pa]
inline void reportPressure(nlohmann::json& summary, int crack, double pressure)
{
  summary["cracks"][crack]["pressure"] = pressure;
}

} // namespace Rhegma
