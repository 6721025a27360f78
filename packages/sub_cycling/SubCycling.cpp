#include "sub_cycling/SubCycling.hpp"

#include "sub_cycling/LocalSteps.hpp"
#include "transfer/LaneHeat.hpp"

#include <algorithm>
#include <memory>

namespace Rhegma::sub_cycling
{

namespace
{

Section section()
{
  Section s("Sub-Cycling", "Subcycling: fine cells take smaller time steps (substeps) than coarse cells.");
  s.integer("Levels").range(1, 6).byDefault(6).meaning(
      "Number of refinement levels with their own time step, counted from the finest; at most all levels. "
      "The full step is 2^Levels substeps of the finest cells.");
  return s;
}

void check(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors)
{
  if (!scene.isSublist("Sub-Cycling"))
    return;
  if (scene.isSublist("Time") && scene.sublist("Time").isType<std::string>("Update Scheme") &&
      scene.sublist("Time").get<std::string>("Update Scheme") != "MUSL")
    errors.push_back({"Sub-Cycling", "substeps need Time > Update Scheme = MUSL; write that"});
  if (scene.isSublist("Mass Matrix"))
  {
    const Teuchos::ParameterList& mass = scene.sublist("Mass Matrix");
    const auto text = [&](const char* name, const char* usual)
    { return mass.isType<std::string>(name) ? mass.get<std::string>(name) : std::string(usual); };
    const std::string type = text("Type", "Lumped");
    if ((type != "Lumped" && type != "Partial") || text("Velocity Update", "FLIP") != "FLIP")
      errors.push_back({"Sub-Cycling", "substeps need Mass Matrix > Type = Lumped or Partial with Velocity "
                                       "Update = FLIP; write these, or remove one of the two sections"});
    // The degree of the polynomial that stands for the inverse grows without bound towards 0.
    if (type == "Partial" && mass.isType<double>("Lumped Fraction") &&
        mass.get<double>("Lumped Fraction") < 0.05)
      errors.push_back({"Mass Matrix > Lumped Fraction",
                        "Sub-Cycling needs at least 0.05; write 0.1 or remove Sub-Cycling"});
  }
  if (!scene.isSublist("Adaptivity"))
    errors.push_back(
        {"Sub-Cycling", "all cells have one size; add the section Adaptivity or remove this section"});
}

template <int D>
Effect<D> make(const Teuchos::ParameterList& scene)
{
  const Teuchos::ParameterList& list = scene.sublist("Sub-Cycling");
  const int levels = list.get<int>("Levels");
  const auto steps = std::make_shared<LocalSteps<D>>();
  Effect<D> effect;
  effect.name = "Sub-Cycling";
  if (scene.isSublist("Thermal"))
    effect.adds.push_back(
        {fields::firstShare, 1, "-", "share of the long step that the force of its start acts"});
  effect.atStart = [=](State<D>& state) { state.mesh.subcycledLevels = levels; };
  effect.call({Stage::Scatter,
               "particles of small cells",
               {"nodal mass", "stiffness of ties", "prescribed values"},
               {"short steps"},
               {},
               [=](State<D>& state)
               {
                 const int last = state.mesh.tree.deepest, first = last - std::min(levels, last) + 1;
                 steps->begin(state, first, last);
               }});
  effect.call({Stage::Solve,
               "short steps of small cells",
               {},
               {},
               {"nodal force"},
               [=](State<D>& state)
               {
                 const double before = steps->extraSteps();
                 steps->evolve(state);
                 state.particles.stepsTaken += steps->extraSteps() - before;
               }});
  effect.call({Stage::Solve, "velocity of short steps", {"nodal motion"}, {}, {}, [=](State<D>& state) {
                 steps->correctMotion(state);
               }});
  effect.call({Stage::AfterProjection, "motion of short steps", {}, {}, {"projection"}, [=](State<D>& state) {
                 steps->correctProjection(state);
               }});
  effect.memory = [=](State<D>& state, Archive& archive) { steps->keep(state, archive); };
  effect.report = [=](const State<D>& state, nlohmann::json& summary)
  {
    summary["subcycling"] = {{"levels", std::min(levels, state.mesh.tree.deepest)},
                             {"extra_particle_steps", steps->extraSteps()}};
  };
  return effect;
}

} // namespace

EffectEntry subCyclingEntry()
{
  EffectEntry entry{section(), check, make<2>, make<3>, true};
  entry.cells.tell = [](const auto&, CellNeeds& needs, auto&) { needs.equal = true; };
  entry.cells.refine = [](Teuchos::ParameterList& scene, int) { scene.sublist("Sub-Cycling"); };
  return entry;
}

} // namespace Rhegma::sub_cycling
