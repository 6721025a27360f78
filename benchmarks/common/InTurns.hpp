#pragma once
/// Benchmarks that run variants of one scene alternately.

#include "common/CommandLine.hpp"
#include "common/Program.hpp"

#include <string>
#include <utility>
#include <vector>

namespace Rhegma::benchmarks
{

/// Reads the common options, --json, --steps, --rounds, --warm-up and the scene, next to those of `more`;
/// measures, and prints what was found. \param example a scene, for the usage message \param measure of the
/// scene and the effort \param more adds options of the benchmark: called with the command line and the
/// effort
template <class Effort, class Measure, class More>
void runInTurns(const std::vector<std::string>& arguments, const std::string& example, const Measure& measure,
                void (*table)(const nlohmann::json&), const More& more)
{
  Effort effort;
  std::string scene;
  bool json = false;
  CommandLine line;
  line.flag("--json", json)
      .number("--steps", effort.steps)
      .number("--rounds", effort.rounds)
      .number("--warm-up", effort.warmUp)
      .scene(scene, example);
  more(line, effort);
  line.read(arguments);
  placeThreads();
  print(withKokkos([&] { return measure(scene, effort); }), json, table);
}

template <class Effort, class Measure>
void runInTurns(const std::vector<std::string>& arguments, const std::string& example, const Measure& measure,
                void (*table)(const nlohmann::json&))
{
  runInTurns<Effort>(arguments, example, measure, table, [](CommandLine&, Effort&) {});
}

} // namespace Rhegma::benchmarks
