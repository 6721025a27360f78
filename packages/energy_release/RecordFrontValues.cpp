#include "energy_release/RecordFrontValues.hpp"

#include "energy_release/FrontLine.hpp"

namespace Rhegma::energy_release
{

void recordFrontValues(State<2>&, const std::vector<FrontSample<2>>&, const Options&) {}

void recordFrontValues(State<3>& state, const std::vector<FrontSample<3>>& samples, const Options& options)
{
  state.sample.fronts.clear();
  if (!options.contour)
    return;
  for (const FrontSample<3>& s : samples)
  {
    const FrontLine line = lineOf(s.front);
    FrontValues values{
        state.cracks.cracks[s.front.crack].name, s.front.number, line.line, line.arc, {}, {}, {}, {}, {}, {}};
    for (std::size_t k = 0; k < line.nodes.size(); ++k)
    {
      values.position.push_back(line.nodes[k].position);
      values.release.push_back(s.J[k]);
      values.modeI.push_back(s.modeI[k]);
      values.modeII.push_back(s.modeII[k]);
      values.modeIII.push_back(s.modeIII[k]);
      values.speed.push_back(line.nodes[k].speed);
    }
    state.sample.fronts.push_back(std::move(values));
  }
}

} // namespace Rhegma::energy_release
