#include "boundary/Boundaries.hpp"

#include "base/Attempts.hpp"
#include "base/ReadList.hpp"
#include "boundary/BodyForce.hpp"
#include "boundary/Contradictions.hpp"
#include "boundary/LoadForces.hpp"
#include "boundary/ReadLoad.hpp"
#include "boundary/Supports.hpp"
#include "plan/LastStage.hpp"

#include <memory>
#include <stdexcept>

namespace Rhegma
{

namespace
{

/// What an effect that carries heat takes care of.
bool isOfHeat(const std::string& type)
{
  return type == "Temperature" || type == "Heat Flux" || type == "Convection";
}

template <int D>
void addGravity(Effect<D>& effect, const Teuchos::ParameterList& list, const Teuchos::ParameterList& scene)
{
  const Vector<D> acceleration = readVector<D>(list, "Acceleration");
  const TimeFunction history = TimeFunction::parse(list.get<std::string>("History"));
  const auto now = [=](const State<D>& state)
  { return history(state.clock.time + 0.5 * state.clock.dt) * acceleration; };
  effect.call({Stage::BeforeSolve, "gravity", {"nodal mass"}, {}, {"nodal force"}, [now](State<D>& state) {
                 addBodyForce(state.mesh.nodes, now(state));
               }});
  effect.call({stageOfWays(scene),
               "work of gravity",
               {projectsLast(scene) ? "projection" : "nodal motion"},
               {},
               {},
               [now](State<D>& state) { state.energy.externalWork += bodyForceWork(state, now(state)); }});
}

/// Compares supports again when cells have changed: refined ones have nodes of their own.
template <int D>
void watchCells(Effect<D>& effect, const std::shared_ptr<std::vector<TimedConstraint<D>>>& constraints,
                double finalTime)
{
  const auto seen = std::make_shared<int>(0);
  effect.call({Stage::Scatter,
               "supports of changed cells",
               {},
               {},
               {},
               [=](State<D>& state)
               {
                 if (*seen == state.mesh.tree.generation)
                   return;
                 *seen = state.mesh.tree.generation;
                 const std::string wrong = contradictions(*constraints, state, finalTime);
                 if (state.failure.empty())
                   state.failure = wrong;
               }});
}

} // namespace

template <int D>
Effect<D> makeBoundaries(const Teuchos::ParameterList& scene)
{
  Effect<D> effect;
  effect.name = boundariesName;
  if (!scene.isSublist("Boundaries"))
    return effect;
  const Teuchos::ParameterList& section = scene.sublist("Boundaries");
  const double finalTime = scene.sublist("Time").get<double>("Final Time");
  const auto constraints = std::make_shared<std::vector<TimedConstraint<D>>>();
  const auto loads = std::make_shared<std::vector<Load<D>>>();
  std::vector<std::string> loadNames, constraintNames;
  for (const std::string& name : sublistNames(section))
  {
    const Teuchos::ParameterList& list = section.sublist(name);
    const std::string type = list.get<std::string>("Type");
    if (isOfHeat(type))
      continue;
    if (type == "Gravity")
      addGravity(effect, list, scene);
    else if (type == "Velocity" || type == "Symmetry")
      constraintNames.push_back(name);
    else
      loadNames.push_back(name);
  }
  if (!constraintNames.empty())
  {
    addConstraints(effect, constraints);
    addReactions(effect, constraints);
    if (scene.isSublist("Adaptivity"))
      watchCells(effect, constraints, finalTime);
  }
  if (!loadNames.empty())
  {
    effect.call({Stage::BeforeSolve,
                 "loads",
                 {"nodal mass"},
                 {},
                 {"nodal force"},
                 [loads](State<D>& state)
                 {
                   for (Load<D>& load : *loads)
                     load.apply(state);
                 }});
    effect.call({stageOfWays(scene),
                 "work of loads",
                 {projectsLast(scene) ? "projection" : "nodal motion"},
                 {},
                 {},
                 [loads](State<D>& state)
                 {
                   for (const Load<D>& load : *loads)
                     state.energy.externalWork += load.work(state);
                 }});
    addLoadForces(effect, loads);
  }
  effect.atStart = [=, section = Teuchos::ParameterList(section)](State<D>& state)
  {
    Attempts attempts;
    for (const std::string& name : constraintNames)
      attempts.attempt([&]
                       { constraints->push_back(readConstraint<D>(section.sublist(name), state, name)); });
    attempts.attempt(
        [&]
        {
          const std::string wrong = contradictions(*constraints, state, finalTime);
          if (!wrong.empty())
            throw std::invalid_argument(wrong);
        });
    for (const std::string& name : loadNames)
      attempts.attempt([&] { loads->push_back(readLoad<D>(section.sublist(name), state, name)); });
    attempts.complain();
  };
  return effect;
}

template Effect<2> makeBoundaries(const Teuchos::ParameterList&);
template Effect<3> makeBoundaries(const Teuchos::ParameterList&);

} // namespace Rhegma
