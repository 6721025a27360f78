#include "boundary/Boundaries.hpp"

#include "base/Attempts.hpp"
#include "base/InOrder.hpp"
#include "base/ReadList.hpp"
#include "boundary/BoundaryParts.hpp"
#include "boundary/Contradictions.hpp"
#include "boundary/GridMotion.hpp"
#include "boundary/IdleSupports.hpp"
#include "boundary/LoadDisplacements.hpp"
#include "boundary/LoadForces.hpp"
#include "boundary/SurfaceReport.hpp"
#include "plan/LastStage.hpp"

#include <memory>
#include <stdexcept>

namespace Rhegma
{

namespace
{

/// Compares supports again when cells have changed: refined ones have nodes of their own.
template <int D>
void watchCells(Effect<D>& effect, const std::shared_ptr<std::vector<TimedConstraint<D>>>& constraints,
                double finalTime)
{
  const auto seen = std::make_shared<int>(0);
  effect.call(Stage::Scatter, "supports of changed cells", {ifWritten(quantity::cells)}, {}, {},
              [=](State<D>& state)
              {
                if (*seen == state.mesh.tree.generation)
                  return;
                *seen = state.mesh.tree.generation;
                const std::string wrong = contradictions(*constraints, state, finalTime);
                if (state.failure.empty())
                  state.failure = wrong;
              });
}

/// The calls of loads.
template <int D>
void addLoads(Effect<D>& effect, const Teuchos::ParameterList& scene,
              const std::shared_ptr<std::vector<Load<D>>>& loads)
{
  effect.call(Stage::BeforeSolve, "loads", {quantity::nodalMass}, {}, {quantity::nodalForce},
              [loads](State<D>& state)
              {
                for (Load<D>& load : *loads)
                  load.apply(state);
              });
  effect.call(stageOfFaceVelocity(scene), "work of loads",
              {projectsLast(scene) ? quantity::projection : quantity::nodalMotion}, {}, {},
              [loads](State<D>& state)
              {
                for (const Load<D>& load : *loads)
                  load.addWork(state);
              });
  addLoadForces(effect, loads);
  if (isEquilibrium(scene) || handsOver(scene))
    addLoadDisplacements(effect, scene, loads);
}

} // namespace

template <int D>
Effect<D> makeBoundaries(const Teuchos::ParameterList& scene, bool cellsChange)
{
  Effect<D> effect;
  effect.name = boundariesName;
  if (!scene.isSublist("Boundaries"))
    return effect;
  const Teuchos::ParameterList& section = scene.sublist("Boundaries");
  const double finalTime = scene.sublist("Time").get<double>("Final Time");
  const auto constraints = std::make_shared<std::vector<TimedConstraint<D>>>();
  const auto loads = std::make_shared<std::vector<Load<D>>>();
  BoundaryParts<D> parts{effect, scene};
  for (const std::string& name : sublistNames(section))
  {
    const Teuchos::ParameterList& list = section.sublist(name);
    const BoundaryType& type = boundaryType(list.get<std::string>("Type"));
    if constexpr (D == 2)
    {
      if (type.add2)
        type.add2(parts, list, name);
    }
    else if (type.add3)
      type.add3(parts, list, name);
  }
  if (!parts.supports.empty())
  {
    addConstraints(effect, constraints, isEquilibrium(scene));
    addReactions(effect, constraints);
    if (cellsChange)
      watchCells(effect, constraints, finalTime);
  }
  if (!parts.loads.empty())
    addLoads(effect, scene, loads);
  const auto surfaces = std::make_shared<nlohmann::json>();
  effect.report = inOrder(effect.report,
                          [surfaces](const State<D>&, nlohmann::json& summary)
                          {
                            if (!surfaces->empty())
                              summary["surfaces"] = *surfaces;
                          });
  effect.atStart = inOrder(effect.atStart,
                           [constraints, loads, surfaces, finalTime, cellsChange, supports = parts.supports,
                            placed = parts.loads, all = &scene](State<D>& state)
                           {
                             Attempts attempts;
                             for (const auto& read : supports)
                               attempts.attempt([&] { constraints->push_back(read(state)); });
                             attempts.attempt([&] { prepareGridMotion(*constraints, state, cellsChange); });
                             attempts.attempt(
                                 [&]
                                 {
                                   const std::string wrong = contradictions(*constraints, state, finalTime);
                                   if (!wrong.empty())
                                     throw std::invalid_argument(wrong);
                                 });
                             for (const auto& read : placed)
                               attempts.attempt([&] { loads->push_back(read(state)); });
                             attempts.throwIfAny();
                             *surfaces = surfacesOf<D>(*all);
                             warnOfIdleSupports(*all, *constraints, state);
                           });
  return effect;
}

template Effect<2> makeBoundaries(const Teuchos::ParameterList&, bool);
template Effect<3> makeBoundaries(const Teuchos::ParameterList&, bool);

} // namespace Rhegma
