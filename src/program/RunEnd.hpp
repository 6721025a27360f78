#pragma once
/// How a run ended. Its name in files is written and read here only.

#include <nlohmann/json.hpp>

#include <string>

namespace Rhegma::program
{

/// From the best to the worst.
enum class RunEnd
{
  Finished,  ///< at the end of its scene
  NotAtRest, ///< at the end of its scene, which was to stop when settled (Damping > Stop When Settled)
  CutOff,    ///< by Time > Maximum Steps
  Stopped,   ///< it could not go on
  Signalled  ///< a signal stopped it
};

/// Its name in summary.json and twice.json.
const char* nameOf(RunEnd end);

/// Whether it came to the end of its scene or to Time > Maximum Steps.
constexpr bool isFinished(RunEnd end) { return end < RunEnd::Stopped; }

/// The entries "status" and "end" of a summary. \param failure why the run could not go on; empty if it could
void writeEnd(RunEnd end, const std::string& failure, nlohmann::json& summary);

/// The end in a summary. Throws std::invalid_argument where it has none.
RunEnd endOf(const nlohmann::json& summary);

} // namespace Rhegma::program
