#pragma once
/// An effect: a value that says which fields it needs and adds, and what to call in which stage.

#include "scene/Schema.hpp"
#include "state/Field.hpp"
#include "state/State.hpp"

#include <Teuchos_ParameterList.hpp>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace Rhegma
{

class Archive;

/// Stages of a step, in the order of MUSL. USF runs OnParticles right after Scatter.
enum class Stage
{
  BetweenSteps,
  Scatter,
  BeforeSolve,
  Solve,
  AfterSolve,
  Gather,
  AfterProjection,
  OnParticles,
  Observe
};

/// Something that runs in a stage. Calls of one stage are ordered so that who writes a quantity runs before
/// who reads it; quantities that several calls add to (nodal force) commute. Names of quantities are free
/// text that calls share.
template <int D>
struct Call
{
  Stage stage;
  std::string label;
  std::vector<std::string> reads;
  std::vector<std::string> writes;
  std::vector<std::string> addsTo;
  std::function<void(State<D>&)> run;
};

/// An effect of a scene, or a part of the core.
template <int D>
struct Effect
{
  std::string name;
  std::vector<Field> adds;        ///< particle fields that it brings
  std::vector<std::string> needs; ///< particle fields that somebody else must bring
  std::vector<Call<D>> calls;
  std::function<void(State<D>&)> atStart; ///< once, when all fields exist and particles are seeded
  std::function<void(const State<D>&, nlohmann::json&)> report; ///< adds to summary.json

  std::function<double(const State<D>&)> timeStepLimit; ///< [s]; none if empty

  /// Saves or loads what it keeps from one step to the next beside the fields of the particles
  /// (checkpoint/Archive.hpp); empty if nothing. Loading comes after atStart and after the core's own, and
  /// leaves all as it was when it was saved.
  std::function<void(State<D>&, Archive&)> memory;

  void call(Call<D> c) { calls.push_back(std::move(c)); }
};

/// What the registry knows of an effect: its section, and how to make it for each dimension.
struct EffectEntry
{
  Section section;  ///< its schema; the section's name is the effect's name
  CrossCheck check; ///< what no single parameter can show wrong; may be empty
  std::function<Effect<2>(const Teuchos::ParameterList& scene)> make2;
  std::function<Effect<3>(const Teuchos::ParameterList& scene)> make3;
  bool onRanks = false; ///< whether it works on more than one rank
  /// Whether a scene that has it leaves the motion out (State::mechanics); empty: never.
  std::function<bool(const Teuchos::ParameterList& scene)> withoutMechanics{};
};

/// Every effect that the program knows (packages/Registry.cpp).
const std::vector<EffectEntry>& knownEffects();

/// Sections of effects that a later version will have (packages/Registry.cpp).
const std::vector<std::string>& effectsToCome();

} // namespace Rhegma
