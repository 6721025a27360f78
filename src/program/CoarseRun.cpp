#include "program/CoarseRun.hpp"

#include "Simulation.hpp"
#include "program/Budget.hpp"

#include <Teuchos_DefaultMpiComm.hpp>

#include <algorithm>
#include <new>
#include <stdexcept>

namespace Rhegma::program
{

void WorkCurve::add(double time, double steps, double work) { points_.push_back({time, steps, work}); }

/// Linear between steps; beyond the last one as in the last third of the time.
WorkCurve::Point WorkCurve::at(double time) const
{
  const auto before = [](const Point& p, double t) { return p.time < t; };
  auto later = std::lower_bound(points_.begin() + 1, points_.end(), time, before);
  auto earlier = later - 1;
  if (later == points_.end())
  {
    later = points_.end() - 1;
    earlier = std::lower_bound(points_.begin(), later - 1, later->time * (2.0 / 3.0), before);
  }
  const double t = (time - earlier->time) / (later->time - earlier->time);
  return {time, earlier->steps + t * (later->steps - earlier->steps),
          earlier->work + t * (later->work - earlier->work)};
}

std::optional<Growth> WorkCurve::growth(const Part& part, double end) const
{
  constexpr std::size_t fewest = 8;
  if (points_.size() <= fewest || !(part.to > part.from))
    return {};
  const Point first = at(part.from), second = at(part.to), last = at(end);
  const double longer = (end - part.to) / (part.to - part.from);
  return Growth{(last.steps - second.steps) / (second.steps - first.steps) / longer,
                (last.work - second.work) / (second.work - first.work) / longer};
}

bool isNoticeable(const Growth& growth)
{
  constexpr double factor = 1.25;
  const auto differs = [](double ratio) { return ratio > factor || ratio < 1.0 / factor; };
  return differs(growth.steps) || differs(growth.work);
}

std::optional<Growth> growthByCoarseRun(const Teuchos::ParameterList& scene, const Part& part,
                                        const Ranks& ranks, double seconds)
try
{
  const auto coarse = Teuchos::rcp(new Teuchos::ParameterList(scene));
  Teuchos::ParameterList& domain = coarse->sublist("Domain");
  domain.set("Cell Size", 2.0 * domain.get<double>("Cell Size"));
  domain.remove("Accuracy", false);
  const double whole = scene.sublist("Time").get<double>("Final Time");
  Simulation simulation(Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD)), coarse, true);
  simulation.initialize();
  WorkCurve curve;
  const Budget budget(ranks);
  while (simulation.time() < whole && !simulation.ended() && budget.less(seconds))
  {
    // A step, which ends a little early: where it would end only rounding decides.
    simulation.advance(std::min(whole, simulation.time() + 0.999 * simulation.stableTimeStep()));
    curve.add(simulation.time(), static_cast<double>(simulation.steps()), simulation.particleSteps());
  }
  // A curve that ends before it says anything new.
  if (curve.end() < std::min(whole, 1.5 * part.to))
    return {};
  return curve.growth(part, whole);
}
catch (const std::invalid_argument&)
{
  return {};
}
catch (const RunError&)
{
  return {};
}
catch (const std::bad_alloc&)
{
  return {};
}

} // namespace Rhegma::program
