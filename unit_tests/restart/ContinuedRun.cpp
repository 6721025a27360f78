#include "restart/ContinuedRun.hpp"

#include "checkpoint/CheckpointFile.hpp"

#include <Teuchos_DefaultMpiComm.hpp>

#include <cstdio>
#include <cstring>
#include <string>
#include <unistd.h>

using namespace Rhegma;

namespace
{

/// Breaks off a run after a step.
struct Enough
{
};

std::string fileOfMine() { return "rhegma_restart_" + std::to_string(getpid()) + ".h5"; }

Record stateOf(Simulation& simulation)
{
  const std::string path = fileOfMine();
  simulation.checkpoint(path);
  Record record = readCheckpoint(path);
  std::remove(path.c_str());
  record.erase("wall_seconds");
  record.erase("run/stage_seconds");
  record.erase("effects/Load Balance/seconds");
  return record;
}

/// Makes a run and its continuation sample at the same times. Of load steps there are few.
double samplingOf(const Simulation& simulation, const Teuchos::ParameterList& scene)
{
  const bool dynamic = scene.sublist("Time").get<std::string>("Analysis") == "Dynamic";
  return (dynamic ? 7.0 : 2.0) * simulation.stableTimeStep();
}

bool sameBits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

} // namespace

Simulation simulationOf(const Teuchos::ParameterList& scene)
{
  return Simulation(Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD)),
                    Teuchos::rcp(new Teuchos::ParameterList(scene)));
}

namespace
{

void finish(Simulation& simulation, Trace& trace)
{
  trace.report = simulation.report();
  trace.report.erase("load_balance"); // has seconds
  trace.state = stateOf(simulation);
}

} // namespace

void runTo(Simulation& simulation, long steps, double interval, Trace& trace)
{
  simulation.sampleEvery(interval,
                         [&](double time, const Simulation::Row& row)
                         {
                           trace.times.push_back(time);
                           trace.rows.push_back(row);
                         });
  simulation.onStep(
      [&](double, long step)
      {
        if (step >= steps)
          throw Enough();
      });
  try
  {
    simulation.advance(1e9);
  }
  catch (const Enough&)
  {
  }
  finish(simulation, trace);
}

Trace unbroken(const Teuchos::ParameterList& scene, long steps)
{
  Simulation simulation = simulationOf(scene);
  simulation.initialize();
  Trace trace;
  runTo(simulation, steps, samplingOf(simulation, scene), trace);
  return trace;
}

Trace continued(const Teuchos::ParameterList& scene, long broken, long steps)
{
  const std::string path = fileOfMine();
  Trace trace;
  double interval = 0.0;
  {
    Simulation first = simulationOf(scene);
    first.initialize();
    interval = samplingOf(first, scene);
    runTo(first, broken, interval, trace);
    first.checkpoint(path);
  }
  Simulation second = simulationOf(scene);
  second.restore(path);
  std::remove(path.c_str());
  runTo(second, steps, interval, trace);
  return trace;
}

Record recordAfter(const Teuchos::ParameterList& scene, long steps, Trace* left)
{
  const std::string path = fileOfMine();
  Simulation simulation = simulationOf(scene);
  simulation.initialize();
  Trace trace;
  runTo(simulation, steps, samplingOf(simulation, scene), trace);
  trace.times.clear();
  trace.rows.clear();
  if (left != nullptr)
    *left = trace;
  simulation.checkpoint(path);
  Record record = readCheckpoint(path);
  std::remove(path.c_str());
  return record;
}

Trace continuedFrom(const Teuchos::ParameterList& scene, const Record& record, long steps)
{
  const std::string path = fileOfMine();
  Simulation start = simulationOf(scene);
  start.initialize();
  const double interval = samplingOf(start, scene);
  writeCheckpoint(path, record);
  Simulation simulation = simulationOf(scene);
  simulation.restore(path);
  std::remove(path.c_str());
  Trace trace;
  if (steps > 0)
    runTo(simulation, steps, interval, trace);
  else
    finish(simulation, trace);
  return trace;
}

std::string difference(const Trace& a, const Trace& b)
{
  if (a.times != b.times)
    return "samples at other times";
  for (std::size_t k = 0; k < a.rows.size(); ++k)
  {
    if (a.rows[k].size() != b.rows[k].size())
      return "other columns";
    for (std::size_t c = 0; c < a.rows[k].size(); ++c)
      if (a.rows[k][c].first != b.rows[k][c].first || !sameBits(a.rows[k][c].second, b.rows[k][c].second))
        return "row " + std::to_string(k) + " of the history: " + a.rows[k][c].first;
  }
  for (const auto& [path, table] : a.state)
    if (b.state.count(path) == 0 || !(b.state.at(path) == table))
      return "the state: " + path;
  if (a.state.size() != b.state.size())
    return "what the state holds";
  return a.report.dump() == b.report.dump()
             ? ""
             : "the report: " + nlohmann::json::diff(a.report, b.report).dump();
}
