#include "energy_release/ModeRatios.hpp"

#include <cmath>

namespace Rhegma::energy_release
{

template <int D>
void reportModeRatios(const State<D>& state, const FrontSample<D>& sample,
                      const std::vector<MirrorPlane>& mirrors, nlohmann::json& entry)
{
  const std::vector<char> atSurface = nodesAtSurface(state, sample.front, mirrors);
  double largest = 0.0, two = FrontSample<D>::notYet, three = FrontSample<D>::notYet;
  for (std::size_t k = 0; k < sample.J.size() && !sample.front.ended; ++k)
  {
    if (atSurface[k] != 0 || !(sample.J[k] > largest))
      continue;
    largest = sample.J[k];
    const bool opens = sample.modeI[k] > 0.0;
    two = opens ? sample.modeII[k] / sample.modeI[k] : FrontSample<D>::notYet;
    three = opens && D == 3 ? sample.modeIII[k] / sample.modeI[k] : FrontSample<D>::notYet;
  }
  entry["K_II_over_K_I"] = two;
  if (D == 3)
    entry["K_III_over_K_I"] = three;
}

template void reportModeRatios(const State<2>&, const FrontSample<2>&, const std::vector<MirrorPlane>&,
                               nlohmann::json&);
template void reportModeRatios(const State<3>&, const FrontSample<3>&, const std::vector<MirrorPlane>&,
                               nlohmann::json&);

} // namespace Rhegma::energy_release
