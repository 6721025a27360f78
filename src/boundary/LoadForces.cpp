#include "boundary/LoadForces.hpp"

#include "archive/Archive.hpp"
#include "base/InOrder.hpp"

#include <string>

namespace Rhegma
{

namespace
{

/// Impulses and mean forces of the loads.
template <int D>
struct LoadForces
{
  double last = 0.0;              ///< time of the last sample [s]
  std::vector<Vector<D>> impulse; ///< of each load since then [N s]
  /// Mean between the last two samples, in equilibrium that of the last [N]; before the first not a number.
  std::vector<Vector<D>> force;

  void resize(std::size_t loads)
  {
    impulse.resize(loads, Vector<D>{});
    force.resize(loads, notANumber<D>());
  }
};

} // namespace

template <int D>
void addLoadForces(Effect<D>& effect, const std::shared_ptr<std::vector<Load<D>>>& loads)
{
  const auto known = std::make_shared<LoadForces<D>>();
  effect.call(Stage::AfterSolve, "impulse of loads", {}, {}, {},
              [=](State<D>& state)
              {
                known->resize(loads->size());
                for (std::size_t k = 0; k < loads->size(); ++k)
                  if (state.method.equilibrium())
                    known->force[k] = (*loads)[k].force();
                  else
                    known->impulse[k] = known->impulse[k] + state.clock.dt * (*loads)[k].force();
              });
  effect.call(Stage::Observe, "forces of loads", {}, {}, {},
              [=](State<D>& state)
              {
                const char* columns[] = {".force_x", ".force_y", ".force_z"};
                const double duration = state.clock.time - known->last;
                known->last = state.clock.time;
                known->resize(loads->size());
                for (std::size_t k = 0; k < loads->size(); ++k)
                {
                  if (!state.method.equilibrium())
                    known->force[k] = (duration > 0.0 ? 1.0 / duration : 0.0) * known->impulse[k];
                  known->impulse[k] = Vector<D>{};
                  for (int d = 0; d < D; ++d)
                    state.sample.row.emplace_back((*loads)[k].name() + columns[d], known->force[k][d]);
                }
              });
  effect.memory = inOrder(effect.memory,
                          [=](State<D>&, Archive& archive)
                          {
                            const Archive::Group group(archive, "loads");
                            archive("last_sample", known->last);
                            known->resize(loads->size());
                            for (std::size_t k = 0; k < loads->size(); ++k)
                            {
                              const Archive::Group one(archive, std::to_string(k));
                              archive("impulse", known->impulse[k]);
                              archive("force", known->force[k]);
                            }
                          });
  effect.report = inOrder(effect.report,
                          [=](const State<D>&, nlohmann::json& summary)
                          {
                            known->resize(loads->size());
                            for (std::size_t k = 0; k < loads->size(); ++k)
                              summary["boundaries"].push_back(
                                  {{"name", (*loads)[k].name()},
                                   {"force", std::vector<double>(known->force[k].c, known->force[k].c + D)}});
                          });
}

template void addLoadForces(Effect<2>&, const std::shared_ptr<std::vector<Load<2>>>&);
template void addLoadForces(Effect<3>&, const std::shared_ptr<std::vector<Load<3>>>&);

} // namespace Rhegma
