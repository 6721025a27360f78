#pragma once
/// What a run tells of the pressure in a crack, whatever gives it.

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

/// What summary.json has of it. \param pressure [Pa]
inline void reportPressure(nlohmann::json& summary, int crack, double pressure)
{
  summary["cracks"][crack]["pressure"] = pressure;
}

} // namespace Rhegma
