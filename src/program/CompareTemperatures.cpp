#include "program/CompareTemperatures.hpp"

namespace Rhegma::program
{

using nlohmann::json;

namespace
{

/// Whether bodies are only cooled: the highest temperature rises by next to nothing where the lowest falls.
bool isOnlyCooled(const json& run)
{
  constexpr double little =
      0.02; // of the fall: conduction overshoots by half of it (docs/explanation/heat.md)
  const double rise = numberOrNone(run["temperature"], "peak_rise");
  const double fall = numberOrNone(run["temperature"], "largest_fall");
  return fall > 0.0 && rise <= little * fall;
}

} // namespace

void compareTemperatures(Comparison& comparison, const json& asIs, const json& half)
{
  if (!asIs.contains("temperature") || !half.contains("temperature"))
    return;
  if (isOnlyCooled(asIs) && isOnlyCooled(half))
    // The coldest particle is a part of a cell away from the surface that is cooled: the first order.
    return comparison.value("largest fall of temperature", "K",
                            numberOrNone(asIs["temperature"], "largest_fall"),
                            numberOrNone(half["temperature"], "largest_fall"), 1);
  // Sources are resolved to the second order (docs/explanation/verification/accuracy-and-cost.md).
  comparison.value("peak rise of temperature", "K", numberOrNone(asIs["temperature"], "peak_rise"),
                   numberOrNone(half["temperature"], "peak_rise"), 2);
}

} // namespace Rhegma::program
