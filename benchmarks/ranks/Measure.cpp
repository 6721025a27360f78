#include "ranks/Measure.hpp"

#include "common/Scenes.hpp"
#include "ranks/Messages.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <mpi.h>

#include <cmath>
#include <unistd.h>

namespace Rhegma::benchmarks
{

namespace
{

/// Waiting ranks release their processors.
void meetAsleep()
{
  MPI_Request request;
  MPI_Ibarrier(MPI_COMM_WORLD, &request);
  for (int done = 0; done == 0;)
  {
    usleep(200);
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
  }
}

TimedRun makeRun(const std::string& name, const std::string& file, const RanksEffort& effort,
                 const Teuchos::RCP<const Teuchos::Comm<int>>& comm)
{
  const auto scene = readScene(file, "Domain");
  Teuchos::ParameterList& domain = scene->sublist("Domain");
  domain.set("Cell Size", domain.get<double>("Cell Size") / effort.finer);
  return sampledRun(name, scene, comm);
}

nlohmann::json timesOf(const TimedRun& run, int particles)
{
  return {{"name", run.name},
          {"particles", particles},
          {"steps", run.batches.back().steps},
          {"us_per_step", 1e6 * leastSeconds(run) / run.batches.back().steps}};
}

double largest(double own)
{
  double most = 0.0;
  MPI_Allreduce(&own, &most, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  return most;
}

nlohmann::json messagesOf(const Messages& own, double steps)
{
  return {{"receivers", largest(own.receivers)},
          {"sent_per_step", largest(own.sent / steps)},
          {"bytes_per_step", largest(own.bytes / steps)},
          {"reductions_per_step", largest(own.reductions / steps)},
          {"reduced_bytes_per_step", largest(own.reducedBytes / steps)}};
}

/// Messages to neighbours follow one another; a reduction climbs and descends a tree of the ranks.
nlohmann::json modelOf(double work, const nlohmann::json& messages, const RanksEffort& effort)
{
  nlohmann::json model = nlohmann::json::array();
  for (const int ranks : {1, 10, 100, 1000})
  {
    const double levels = std::ceil(std::log2(static_cast<double>(ranks)));
    const double neighbours = ranks == 1 ? 0.0
                                         : messages.at("sent_per_step").get<double>() * effort.latency +
                                               messages.at("bytes_per_step").get<double>() / effort.bandwidth;
    const double all = 2.0 * levels *
                       (messages.at("reductions_per_step").get<double>() * effort.latency +
                        messages.at("reduced_bytes_per_step").get<double>() / effort.bandwidth);
    const double step = work + neighbours + all;
    model.push_back({{"ranks", ranks},
                     {"us_per_step", 1e6 * step},
                     {"us_to_neighbours", 1e6 * neighbours},
                     {"us_over_all", 1e6 * all},
                     {"work_fraction", work / step}});
  }
  return model;
}

} // namespace

nlohmann::json measureRanks(const std::string& sceneFile, const RanksEffort& effort)
{
  int rank = 0, size = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  std::vector<TimedRun> alone, together;
  if (rank == 0)
    alone.push_back(makeRun("one rank", sceneFile, effort, Teuchos::null));
  together.push_back(makeRun(std::to_string(size) + " ranks", sceneFile, effort,
                             Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD))));
  Messages messages;
  double steps = 0.0;
  for (int round = -1; round < effort.rounds; ++round) // the first lets the body move
  {
    meetAsleep();
    timeByTurns(alone, 1, effort.interval);
    meetAsleep();
    beginCount();
    timeByTurns(together, 1, effort.interval);
    messages = counted();
    steps = together[0].batches.back().steps;
    together[0].batches.back().seconds = largest(together[0].batches.back().seconds);
    if (round >= 0)
      continue;
    together[0].batches.clear();
    for (TimedRun& run : alone)
      run.batches.clear();
  }
  nlohmann::json all = {{"ranks", size}, {"messages", messagesOf(messages, steps)}};
  const auto particles = static_cast<int>(together[0].simulation->particles());
  all["runs"] = nlohmann::json::array({timesOf(together[0], particles)});
  if (rank > 0)
    return all;
  all["runs"].insert(all["runs"].begin(), timesOf(alone[0], particles));
  all["times_faster"] = leastSeconds(alone[0]) / leastSeconds(together[0]);
  all["model"] = modelOf(1e-6 * all["runs"][0].at("us_per_step").get<double>(), all["messages"], effort);
  return all;
}

} // namespace Rhegma::benchmarks
