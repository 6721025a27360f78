#pragma once
/// Scenes of benchmarks, and comparisons of their runs.

#include "common/TimedRun.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace Rhegma::benchmarks
{

/// Reads a scene, without its references. Throws std::runtime_error where the file can't be read, and
/// std::invalid_argument, with `hint` in it, where it has no section of that name.
Teuchos::RCP<Teuchos::ParameterList> readScene(const std::string& file, const std::string& section,
                                               const std::string& hint = "");

/// A run that samples as often as the history of its scene, but stores no sample.
TimedRun sampledRun(const std::string& name, const Teuchos::RCP<Teuchos::ParameterList>& scene,
                    const Teuchos::RCP<const Teuchos::Comm<int>>& comm = Teuchos::null);

/// The least wall time of a batch [s].
double leastSeconds(const TimedRun& run);

/// {particles, threads, runs} of runs that were timed in batches, those of the first of `steps` steps: name,
/// us (wall time for what a step of the first simulates), ratio to the first of that, and ratio_of_steps,
/// that of step to step, each of the least of all batches; ratio_of_processor, the median over the rounds of
/// the ratio of the times that processors worked on both for the same simulated time, which others who use
/// the machine disturb less.
nlohmann::json nextToFirst(const std::vector<TimedRun>& runs, int steps);

} // namespace Rhegma::benchmarks
