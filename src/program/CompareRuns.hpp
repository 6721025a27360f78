#pragma once
/// How far the answers of a run move when its cells are halved.

#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <vector>

namespace Rhegma::program
{

/// Columns of a history.csv by their names; empty where there is no such file.
using HistoryColumns = std::map<std::string, std::vector<double>>;
HistoryColumns readHistory(const std::string& path);

/// What a run left; its summary has its end (RunEnd.hpp).
struct RunResults
{
  nlohmann::json summary;
  HistoryColumns history;
};

/// Compares two runs of a scene.
/// \param asIs, half of the scene as it is, and with cells of half the size
/// \return {"answers": [{"name", "unit", "as_is", "half", "change" or "cells", "extrapolated",
/// "extrapolated_order_2", "order",
/// "resolved", "verdict"}], "resolved", "verdict", "open", "cell" [m], "runs": {"as_is", "half": {"end",
/// "status", "time" [s], "steps"}}}. An answer is resolved where it moves by at most 5 %; a path or position
/// where it moves by at most a cell of the first run. Runs that stopped are never resolved as a whole.
nlohmann::json compareRuns(const RunResults& asIs, const RunResults& half);

/// The comparison as a table for a terminal, its last line the verdict.
std::string comparisonAsText(const nlohmann::json& comparison);

} // namespace Rhegma::program
