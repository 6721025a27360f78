#include "program/RunEnd.hpp"

#include <array>
#include <stdexcept>
#include <utility>

namespace Rhegma::program
{

namespace
{

constexpr std::array<std::pair<RunEnd, const char*>, 5> names{{{RunEnd::Finished, "finished"},
                                                               {RunEnd::NotAtRest, "not at rest"},
                                                               {RunEnd::CutOff, "cut off"},
                                                               {RunEnd::Stopped, "stopped"},
                                                               {RunEnd::Signalled, "stopped by a signal"}}};

} // namespace

const char* nameOf(RunEnd end)
{
  for (const auto& [one, name] : names)
    if (one == end)
      return name;
  throw std::logic_error("an end of a run without a name");
}

void writeEnd(RunEnd end, const std::string& failure, nlohmann::json& summary)
{
  summary["end"] = nameOf(end);
  summary["status"] = !isFinished(end)        ? failure
                      : end == RunEnd::CutOff ? "finished at Time > Maximum Steps"
                                              : "finished";
}

RunEnd endOf(const nlohmann::json& summary)
{
  const auto found = summary.is_object() ? summary.find("end") : summary.end();
  if (found != summary.end() && found->is_string())
    for (const auto& [end, name] : names)
      if (*found == name)
        return end;
  throw std::invalid_argument("the summary of a run does not say how the run ended");
}

} // namespace Rhegma::program
