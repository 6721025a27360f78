#include "boundary/LoadDisplacements.hpp"

#include "archive/Archive.hpp"
#include "base/InOrder.hpp"
#include "plan/LastStage.hpp"
#include "state/Subdomain.hpp"

namespace Rhegma
{

template <int D>
void addLoadDisplacements(Effect<D>& effect, const Teuchos::ParameterList& scene,
                          const std::shared_ptr<std::vector<Load<D>>>& loads)
{
  const auto moved = std::make_shared<std::vector<double>>();
  effect.call(stageOfFaceVelocity(scene), "displacement of loads",
              {projectsLast(scene) ? quantity::projection : quantity::nodalMotion}, {}, {},
              [=](State<D>& state)
              {
                moved->resize(loads->size(), 0.0);
                for (std::size_t k = 0; k < loads->size(); ++k)
                {
                  double more = (*loads)[k].shift(state);
                  sumParts(state, &more, 1);
                  (*moved)[k] += more;
                }
              });
  effect.call(Stage::Observe, "displacements of loads", {}, {}, {},
              [=](State<D>& state)
              {
                moved->resize(loads->size(), 0.0);
                for (std::size_t k = 0; k < loads->size(); ++k)
                  state.sample.row.emplace_back((*loads)[k].name() + ".displacement", (*moved)[k]);
              });
  effect.memory =
      inOrder(effect.memory, [=](State<D>&, Archive& archive) { archive("load_displacements", *moved); });
  effect.report = inOrder(effect.report,
                          [=](const State<D>&, nlohmann::json& summary)
                          {
                            moved->resize(loads->size(), 0.0);
                            for (std::size_t k = 0; k < moved->size(); ++k)
                              for (nlohmann::json& entry : summary["boundaries"])
                                if (entry["name"] == (*loads)[k].name())
                                  entry["displacement"] = (*moved)[k];
                          });
}

template void addLoadDisplacements(Effect<2>&, const Teuchos::ParameterList&,
                                   const std::shared_ptr<std::vector<Load<2>>>&);
template void addLoadDisplacements(Effect<3>&, const Teuchos::ParameterList&,
                                   const std::shared_ptr<std::vector<Load<3>>>&);

} // namespace Rhegma
