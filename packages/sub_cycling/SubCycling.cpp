#include "sub_cycling/SubCycling.hpp"

#include "scene/RoundBodies.hpp"
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
  refuseAxisymmetric(s, "substeps have no hoop stress");
  s.refuse({when::present("Sub-Cycling"), when::equilibrium()},
           "an equilibrium analysis has no time step to divide; remove this section");
  s.integer("Levels").range(1, 6).byDefault(6).meaning(
      "Number of refinement levels with their own time step, counted from the finest; at most all levels. "
      "The full step is 2^Levels substeps of the finest cells.");
  s.refuse({when::present("Sub-Cycling"), when::isNot("Time", "Update Scheme", {"MUSL"})},
           "substeps need Time > Update Scheme = MUSL; write that");
  s.refuse(
      {when::present("Sub-Cycling"), when::isNot("Mass Matrix", "Type", {"Lumped", "Partial"})},
      "substeps need Mass Matrix > Type = Lumped or Partial; write one of them, or remove one of the two "
      "sections");
  s.refuse(
      {when::present("Sub-Cycling"), when::isNot("Mass Matrix", "Velocity Update", {"FLIP"})},
      "substeps need Mass Matrix > Velocity Update = FLIP; write that, or remove one of the two sections");
  // The degree of the polynomial that approximates the inverse grows without bound towards 0.
  s.refuse({when::present("Sub-Cycling"), when::is("Mass Matrix", "Type", {"Partial"}),
            when::below("Mass Matrix", "Lumped Fraction", 0.05)},
           "Sub-Cycling needs at least 0.05; write 0.1 or remove Sub-Cycling", 2);
  s.needs("Adaptivity", "all cells have one size; add the section Adaptivity or remove this section");
  return s;
}

template <int D>
Effect<D> make(const Teuchos::ParameterList& scene, const RunOptions& options)
{
  const Teuchos::ParameterList& list = scene.sublist("Sub-Cycling");
  const int levels = list.get<int>("Levels");
  const auto steps = std::make_shared<LocalSteps<D>>();
  Effect<D> effect;
  effect.name = "Sub-Cycling";
  if (options.heat())
    effect.adds.push_back(
        {fields::firstFraction, 1, "-", "fraction of the full step in which its initial force acts"});
  for (int k = 0; k < levels; ++k)
    effect.addsNodal.push_back(
        {{meanForceField(k), D + 1, "N",
          k == 0 ? "mean force of particles that take the whole step, and step number"
                 : "the same of particles that take 2^-" + std::to_string(k) + " of it"},
         OnRemesh::Keep,
         true});
  effect.atStart = [=](State<D>& state) { state.mesh.subcycledLevels = levels; };
  effect.call(
      Stage::Scatter, "particles of fine cells",
      {quantity::nodalMass, ifWritten(quantity::springStiffness), ifWritten(quantity::prescribedMotion)},
      {quantity::substeps}, {},
      [=](State<D>& state)
      {
        const int last = state.mesh.tree.deepest, first = last - std::min(levels, last) + 1;
        steps->begin(state, first, last);
      });
  effect.call(Stage::Solve, "substeps of fine cells", {quantity::substeps}, {}, {quantity::nodalForce},
              [=](State<D>& state)
              {
                const double before = steps->extraSteps();
                steps->evolve(state);
                state.particles.particleSteps += steps->extraSteps() - before;
              });
  effect.call(Stage::Solve, "velocity of substeps", {quantity::nodalMotion, quantity::substeps}, {}, {},
              [=](State<D>& state) { steps->correctMotion(state); });
  effect.call(Stage::AfterProjection, "motion of substeps", {quantity::substeps}, {}, {quantity::projection},
              [=](State<D>& state) { steps->correctProjection(state); });
  effect.memory = [=](State<D>&, Archive& archive) { steps->serialize(archive); };
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
  EffectEntry entry{section(), {}, make<2>, make<3>, true};
  entry.cells.addNeeds = [](const auto&, CellNeeds& needs, auto&) { needs.equal = true; };
  entry.cells.refine = [](Teuchos::ParameterList& scene, const FrontRefinement& refinement)
  {
    if (refinement.moves)
      scene.sublist("Sub-Cycling");
  };
  return entry;
}

} // namespace Rhegma::sub_cycling
