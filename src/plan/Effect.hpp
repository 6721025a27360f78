#pragma once
/// An effect: a value that lists the fields it needs and adds, and the calls of each stage.

#include "base/Field.hpp"
#include "geometry/Cuts.hpp"
#include "plan/Quantity.hpp"
#include "plan/RunOptions.hpp"
#include "scene/Schema.hpp"
#include "state/State.hpp"

#include <Teuchos_ParameterList.hpp>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <type_traits>
#include <vector>

namespace Rhegma
{

class Archive;

/// Stages of a step, in the order of MUSL. USF runs AfterProjection and OnParticles right after Scatter;
/// USAVG runs their calls that are `ofEachPass` there too.
enum class Stage
{
  BetweenSteps,    ///< before the length of the step is known
  Scatter,         ///< particles to nodes
  BeforeSolve,     ///< nodes have mass, momentum and force
  Solve,           ///< new velocity of the nodes
  AfterSolve,      ///< changes of the new velocity
  Gather,          ///< nodes to particles
  AfterProjection, ///< nodes have the velocity that strains the particles
  OnParticles,     ///< strain, stress and what follows
  Observe          ///< only in steps that end with a sample
};

/// A function that runs in a stage. Calls of one stage are ordered so that the writer of a quantity runs
/// before its readers; quantities that several calls add to (nodal force) commute. What a call reads must be
/// written by some call of the plan, in any stage, unless it is read `ifWritten`.
template <int D>
struct Call
{
  Stage stage;                        ///< when it runs
  std::string label;                  ///< for plan and timings
  std::vector<Read> reads;            ///< quantities
  Quantities writes;                  ///< quantities
  Quantities addsTo;                  ///< quantities
  std::function<void(State<D>&)> run; ///< what it does
  /// Whether it belongs to each pass that strains particles (Clock::strainPass), and not to the step.
  bool ofEachPass = false;
};

/// An effect of a scene, or a part of the core.
template <int D>
struct Effect
{
  std::string name;                  ///< its section's
  std::vector<Field> adds;           ///< particle fields that it adds
  std::vector<NodalField> addsNodal; ///< nodal fields that it adds (parallel/NodalFieldTable.hpp)
  std::vector<std::string> needs;    ///< particle fields that another effect must add
  std::vector<Call<D>> calls;        ///< of all stages
  Quantities provides;               ///< what it writes outside of calls
  std::vector<std::string> balance;  ///< entries of the energy balance that it contributes to, as columns
  /// Surfaces that divide bodies into particles at the start, as far as they can be known without particles:
  /// the state has its lattice. Errors are those of atStart, which follows. Empty: there are none.
  std::function<Geometry::Cuts<D>(const State<D>&)> cuts;
  std::function<void(State<D>&)> atStart; ///< once, when all fields exist and particles are seeded
  /// Adds warnings of wrong physics, once, after all atStart. Where the scene has an error, some of those
  /// have failed or did not run: it may throw, but must not read what is not there.
  std::function<void(State<D>&)> judge;
  std::function<void(const State<D>&, nlohmann::json&)> report; ///< adds to summary.json

  std::function<double(const State<D>&)> timeStepLimit; ///< [s]; none if empty

  /// Saves or loads data of the effect that persist between steps, in addition to fields of particles and
  /// nodes (archive/Archive.hpp); empty if there are none. Loading happens after atStart and after the core
  /// has loaded its own data.
  std::function<void(State<D>&, Archive&)> memory;

  /// Takes its data from an equilibrium in the same cells, in which the run starts, in addition to fields of
  /// particles; empty if there are none.
  std::function<void(State<D>&, const State<D>& equilibrium)> takeOver;

  void call(Call<D> c) { calls.push_back(std::move(c)); } ///< adds to `calls`
  /// The same, of the parts of a Call.
  void call(Stage stage, std::string label, std::vector<Read> reads, Quantities writes, Quantities addsTo,
            std::function<void(State<D>&)> run, bool ofEachPass = false)
  {
    call(Call<D>{stage, std::move(label), std::move(reads), std::move(writes), std::move(addsTo),
                 std::move(run), ofEachPass});
  }
};

/// Makes an effect from a scene, which has its section and those of the core, and from what other effects
/// declare. A function of the scene alone is accepted too.
template <int D>
class MakeEffect
{
public:
  MakeEffect() = default;
  /// \param make of the scene, or of the scene and the options
  template <class Function>
  MakeEffect(const Function& make)
      : make_(
            [make](const Teuchos::ParameterList& scene, const RunOptions& options)
            {
              if constexpr (std::is_invocable_v<Function, const Teuchos::ParameterList&, const RunOptions&>)
                return make(scene, options);
              else
                return (void)options, make(scene);
            })
  {
  }
  /// Makes the effect of a scene. \param scene validated \param options of all effects of the run
  Effect<D> operator()(const Teuchos::ParameterList& scene, const RunOptions& options = {}) const
  {
    return make_(scene, options);
  }
  explicit operator bool() const { return static_cast<bool>(make_); } ///< whether there is a function

private:
  std::function<Effect<D>(const Teuchos::ParameterList&, const RunOptions&)> make_;
};

/// Entry of the registry: the section of an effect, and how to make it for each dimension.
struct EffectEntry
{
  Section section;      ///< its schema; the section's name is the effect's name
  CrossCheck check;     ///< checks of several parameters together; may be empty
  MakeEffect<2> make2;  ///< 2D
  MakeEffect<3> make3;  ///< 3D
  bool onRanks = false; ///< whether it works on more than one rank
  /// Sets the options that other effects read; may be empty.
  std::function<void(const Teuchos::ParameterList& section, RunOptions&)> declare{};
  /// Its needs for the cells that Domain > Accuracy chooses.
  CellHook cells{};
};

/// Every effect that the program knows (packages/Registry.cpp.in).
const std::vector<EffectEntry>& knownEffects();

/// Sections of effects planned for a later version (packages/Registry.cpp.in).
const std::vector<std::string>& effectsToCome();

} // namespace Rhegma
