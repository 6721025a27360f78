#include "step/Preload.hpp"

#include "base/ReadList.hpp"
#include "base/StopRequest.hpp"
#include "plan/EffectSchema.hpp"
#include "plan/KnownEffects.hpp"
#include "scene/Compatibility.hpp"
#include "step/Run.hpp"
#include "step/TransferRun.hpp"

#include <algorithm>
#include <memory>
#include <set>
#include <stdexcept>

namespace Rhegma
{

namespace
{

std::set<std::string> errorsOf(const Teuchos::ParameterList& scene)
{
  std::vector<SceneError> errors;
  checkRules(scene, effectSchema(), errors);
  std::set<std::string> where;
  for (const SceneError& error : errors)
    where.insert(error.where);
  return where;
}

/// Removes the sections of effects that errors are about, until none are left. \param whole only errors about
/// a whole section count \param known errors that do not count
void removeRefused(Teuchos::ParameterList& scene, bool whole, const std::set<std::string>& known)
{
  for (bool changed = true; changed;)
  {
    changed = false;
    for (const std::string& where : errorsOf(scene))
      for (const EffectEntry& effect : knownEffects())
      {
        const std::string& name = effect.section.name;
        const bool about = where == name || (!whole && where.rfind(name + " > ", 0) == 0);
        if (!about || known.count(where) > 0 || !scene.isSublist(name))
          continue;
        scene.remove(name);
        changed = true;
      }
  }
}

/// The scene of the equilibrium, without effects that equilibrium refuses.
Teuchos::ParameterList sceneOfEquilibrium(const Teuchos::ParameterList& scene, bool cracks)
{
  Teuchos::ParameterList other(scene);
  other.setName(scene.name());
  Teuchos::ParameterList& time = other.sublist("Time");
  time.set("Analysis", std::string("Preload"));
  time.set("Initial State", std::string(initialState::unloaded));
  removeRefused(other, true, {});
  if (!cracks)
  {
    const std::set<std::string> known = errorsOf(other);
    for (const EffectEntry& effect : knownEffects())
    {
      const auto& provides = effect.section.provides;
      if (std::find(provides.begin(), provides.end(), capability::cracks) != provides.end())
        other.remove(effect.section.name, false);
    }
    removeRefused(other, false, known);
  }
  for (const std::string& name : sublistNames(other.sublist("Bodies")))
    for (const char* const motion : {"Velocity", "Angular Velocity"})
    {
      Teuchos::ParameterList& body = other.sublist("Bodies").sublist(name);
      const auto size = body.get<Teuchos::Array<double>>(motion).size();
      body.set(motion, Teuchos::Array<double>(size, 0.0));
    }
  return other;
}

/// Row of each of the state's particles in another table, by their ids.
std::vector<int> rowsById(const FieldTable& from, const FieldTable& to)
{
  const auto there = onHost(from.integer(fields::id)), here = onHost(to.integer(fields::id));
  std::vector<std::pair<int, int>> known(from.size());
  for (int p = 0; p < from.size(); ++p)
    known[p] = {there(p), p};
  std::sort(known.begin(), known.end());
  std::vector<int> rows(to.size(), -1);
  for (int p = 0; p < to.size(); ++p)
  {
    const auto at = std::lower_bound(known.begin(), known.end(), std::make_pair(here(p), -1));
    if (at != known.end() && at->first == here(p))
      rows[p] = at->second;
  }
  return rows;
}

void copyFields(const FieldTable& from, const FieldTable& to, const std::vector<int>& rows)
{
  for (const Field& field : to.fields())
  {
    if (field.integer || field.name == fields::velocity || !from.has(field.name))
      continue;
    const auto source = onHost(from.table(field.name)), target = onHost(to.table(field.name));
    for (int p = 0; p < to.size(); ++p)
      for (int k = 0; k < field.components; ++k)
        target(p, k) = source(rows[p], k);
    Kokkos::deep_copy(to.table(field.name), target);
  }
}

/// The run on this rank alone, with all particles, from one that is divided among ranks. Collective.
template <int D>
std::unique_ptr<Run<D>> onOneRank(Run<D>& divided, const Teuchos::ParameterList& scene,
                                  const MotionToCome& motion)
{
  const Record record = recordOf(divided);
  auto whole = std::make_unique<Run<D>>(scene);
  whole->startsMotion(motion);
  whole->initialize();
  loadRecord(record, *whole);
  return whole;
}

} // namespace

template <int D>
void startInEquilibrium(const Teuchos::ParameterList& scene, const MotionToCome& motion, const Plan<D>& plan,
                        State<D>& state)
{
  const bool cracks = scene.sublist("Time").get<std::string>("Initial State") == initialState::equilibrium;
  const Teuchos::ParameterList other = sceneOfEquilibrium(scene, cracks);
  auto owned = std::make_unique<Run<D>>(other, std::vector<Effect<D>>{}, state.ranks);
  Run<D>& run = *owned;
  run.startsMotion(motion);
  try
  {
    run.initialize();
    const std::size_t before = run.state().warnings.size();
    while (run.state().clock.time < run.state().clock.finalTime)
      run.step(run.state().clock.finalTime, false);
    const auto& said = run.state().warnings;
    state.warnings.insert(state.warnings.end(), said.begin() + static_cast<std::ptrdiff_t>(before),
                          said.end());
  }
  catch (const StopRequested&)
  {
    throw;
  }
  catch (const RunError& error)
  {
    throw std::invalid_argument(std::string("Time > Initial State: ") + error.what());
  }
  if (state.ranks.many())
    owned = onOneRank(run, other, motion);
  const State<D>& equal = owned->state();
  const std::vector<int> rows = rowsById(equal.particles, state.particles);
  if (equal.particles.size() != state.particles.size() ||
      std::find(rows.begin(), rows.end(), -1) != rows.end())
    throw std::invalid_argument(
        "Time > Initial State: the particles of the equilibrium differ from those at the start of the run (" +
        std::to_string(equal.particles.size()) + " and " + std::to_string(state.particles.size()) +
        "), because its cells are refined elsewhere; refine with boxes instead of Adaptivity > "
        "Front Cells");
  copyFields(equal.particles, state.particles, rows);
  for (const Effect<D>& effect : plan.effects)
    if (effect.takeOver)
      effect.takeOver(state, equal);
  state.particles.sorted = false;
}

template void startInEquilibrium(const Teuchos::ParameterList&, const MotionToCome&, const Plan<2>&,
                                 State<2>&);
template void startInEquilibrium(const Teuchos::ParameterList&, const MotionToCome&, const Plan<3>&,
                                 State<3>&);

} // namespace Rhegma
