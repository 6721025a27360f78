#include "step/Preload.hpp"

#include "base/ReadList.hpp"
#include "step/Run.hpp"

#include <algorithm>
#include <stdexcept>

namespace Rhegma
{

namespace
{

/// The scene of the equilibrium: what makes no forces at rest is left out.
Teuchos::ParameterList sceneOfEquilibrium(const Teuchos::ParameterList& scene, bool cracks)
{
  Teuchos::ParameterList other(scene);
  other.setName(scene.name());
  Teuchos::ParameterList& time = other.sublist("Time");
  time.set("Analysis", std::string("Preload"));
  time.set("Initial State", std::string(initialState::unloaded));
  for (const char* const name : {"Combustion", "Contact", "Damping", "Energy Release", "Load Balance",
                                 "Mass Matrix", "Measure", "Propagation", "Sub-Cycling"})
    other.remove(name, false);
  if (!cracks)
    for (const char* const name : {"Cracks", "Face Pressure"})
      other.remove(name, false);
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

} // namespace

template <int D>
void startInEquilibrium(const Teuchos::ParameterList& scene, const Plan<D>& plan, State<D>& state)
{
  const bool cracks = scene.sublist("Time").get<std::string>("Initial State") == initialState::equilibrium;
  Run<D> run(sceneOfEquilibrium(scene, cracks));
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
  catch (const RunError& error)
  {
    throw std::invalid_argument(std::string("Time > Initial State: ") + error.what());
  }
  const State<D>& equal = run.state();
  const std::vector<int> rows = rowsById(equal.particles, state.particles);
  if (equal.particles.size() != state.particles.size() ||
      std::find(rows.begin(), rows.end(), -1) != rows.end())
    throw std::invalid_argument(
        "Time > Initial State: the equilibrium has other particles than the run at its start (" +
        std::to_string(equal.particles.size()) + " and " + std::to_string(state.particles.size()) +
        "), because its cells are refined elsewhere; refine with boxes instead of Adaptivity > "
        "Front Cells");
  copyFields(equal.particles, state.particles, rows);
  for (const Effect<D>& effect : plan.effects)
    if (effect.takeOver)
      effect.takeOver(state, equal);
  state.particles.sorted = false;
}

template void startInEquilibrium(const Teuchos::ParameterList&, const Plan<2>&, State<2>&);
template void startInEquilibrium(const Teuchos::ParameterList&, const Plan<3>&, State<3>&);

} // namespace Rhegma
