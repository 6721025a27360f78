#include "body_contact/BodyContact.hpp"

#include "archive/Archive.hpp"
#include "base/ReadList.hpp"
#include "body_contact/ContactRecord.hpp"
#include "body_contact/HeatOfContact.hpp"
#include "body_contact/InterfacePoints.hpp"
#include "body_contact/PressedPairs.hpp"
#include "scene/FrictionSection.hpp"
#include "scene/RoundBodies.hpp"
#include "state/BodyGroup.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace Rhegma::body_contact
{

namespace
{

void refuseCombinations(Section& s)
{
  const Condition self = when::present("Body Contact");
  s.refuse(
      {self, when::equilibrium()},
      "bodies meet in motion only, and an equilibrium has none; write Time > Analysis = Dynamic or remove "
      "this section");
  s.refuse({self, when::isNot("Time", "Initial State", {"Unloaded"})},
           "the equilibrium at the start does not include contact of bodies; write Time > Initial State = "
           "Unloaded");
  s.refuse(
      {self, when::is("Domain", "Formulation", {"Total Lagrangian"})},
      "cells that lie in the undeformed body do not see other bodies; write Domain > Formulation = Updated "
      "Lagrangian");
  s.refuse({self, when::isNot("Time", "Update Scheme", {"MUSL"})},
           "bodies that touch strain by the velocity that MUSL projects at the end of a step; write MUSL");
  s.refuse(
      {self, when::above("Time", "PIC Fraction", 0.0)},
      "a PIC fraction smooths velocities after contact, and its loss would be recorded as contact; write 0");
  s.refuse(
      {self, when::isNot("Mass Matrix", "Type", {"Lumped"})},
      "impulses at a node need a lumped mass; write Mass Matrix > Type = Lumped or remove one of the two "
      "sections");
  s.refuse({self, when::isNot("Mass Matrix", "Velocity Update", {"FLIP"})},
           "the energy of contact needs Mass Matrix > Velocity Update = FLIP; write that");
  s.refuse({self, when::present("Adaptivity")},
           "fields of bodies exist on nodes of equal cells only; remove one of the two sections");
  s.refuse({self, when::isNot("Cracks", "Formulation", {"Dual Field"})},
           "bodies meet cracked ones at nodes with a field for each side of the crack; write Cracks > "
           "Formulation = Dual Field");
  s.refuse(
      {self, when::present("Combustion")},
      "gas that leaves a crack does not see a body that covers its open end; remove one of the two sections");
  s.refuse({when::satisfies("Body Contact", "with a pair of Law = Interface", hasInterfaces),
            when::present("Cracks")},
           "springs of an interface do not see the two sides of a crack; join the bodies with Bonded To, or "
           "remove "
           "one of the two");
  s.refuse({when::satisfies("Body Contact", "with a pair of Law = Interface", hasInterfaces),
            when::is("Domain", "Shape Functions", {"Linear"})},
           "springs act on nodes with hardly any material where a particle has just come over a row of "
           "nodes, and runs "
           "become unstable; write Domain > Shape Functions = GIMP");
  s.refuse({self, when::is("Thermal", "Mechanics", {"false"})},
           "bodies that do not move do not press on each other, so no heat would pass between them; write "
           "Thermal > Mechanics = true or remove this section");
  s.refuse({when::satisfies("Body Contact", "with Conductance", hasConductance),
            when::unprovided(capability::heat)},
           "faces conduct where bodies have temperatures; add the section Thermal, or remove Conductance", 0);
}

Section section()
{
  Section s("Body Contact",
            "Contact of bodies: bodies that are not bonded (Bodies > Bonded To) move on their own, "
            "and press and slide on each other where they touch. Without this section, bodies less "
            "than one to two cells apart share one motion.");
  refuseAxisymmetric(s, "bodies press on each other per thickness, not around a circle");
  addFrictionLaw(s);
  addConductance(s, false);
  Section pair("pair of bodies",
               "A pair of bodies with a law of its own; its forces are columns of the history.");
  pair.text("Bodies").notEmpty().meaning(
      "Names of the two bodies, with a comma between them. The law also holds for bodies bonded to them.");
  addInterfaceLawOfList(pair);
  addConductance(pair, true);
  s.namedByUser(pair);
  refuseCombinations(s);
  return s;
}

/// What the calls of the effect have in common.
template <int D>
struct Parts
{
  Teuchos::ParameterList scene;           ///< all of it
  Teuchos::ParameterList section, bodies; ///< of the scene
  SharedNodes<D> shared;
  NodalPairs<D> pairs;
  PairLaws laws;
  InterfacePoints<D> interfaces;
  HeatOfContact<D> heat;
  std::unique_ptr<ContactRecord<D>> record;
  std::size_t editor = 0; ///< index of its stencil editor

  explicit Parts(const Teuchos::ParameterList& all)
      : scene(all), section(scene.sublist("Body Contact")), bodies(scene.sublist("Bodies"))
  {
  }
};

/// Groups of particles count from 1 on.
template <int D>
void setBodyGroups(const BondedGroups& groups, State<D>& state)
{
  const View<int*> groupOf("rhegma::groupsOfBodies", groups.of.size());
  const auto host = Kokkos::create_mirror_view(groupOf);
  std::copy(groups.of.begin(), groups.of.end(), host.data());
  Kokkos::deep_copy(groupOf, host);
  const auto bodyGroup = state.particles.integer(fields::bodyGroup),
             body = state.particles.integer(fields::body);
  Kokkos::parallel_for(
      "rhegma::setBodyGroups", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p) { bodyGroup(p) = groupOf(body(p)) + 1; });
}

template <int D>
void start(const std::shared_ptr<Parts<D>>& parts, State<D>& state)
{
  std::vector<std::string> names;
  for (const BodyInfo<D>& body : state.bodies.info)
    names.push_back(body.name);
  const BondedGroups groups = bondedGroups(parts->bodies, names);
  const std::vector<NamedPair> named = namedPairs(parts->section, groups, names);
  parts->laws = readLaws(parts->section, named, groups.count());
  parts->heat.used = state.particles.has(fields::temperature);
  parts->heat.conductance = readConductances(parts->section, named, groups.count());
  parts->record = std::make_unique<ContactRecord<D>>(named, groups, parts->heat.used);
  setBodyGroups(groups, state);
  parts->interfaces = placeInterfaces(parts->scene, named, groups, state);
  StencilEditor<D> editor;
  editor.edit = [parts](const State<D>& s, const ObservedPoints<D>& points, const StencilTable<D>& table)
  { useFieldsOfGroups(s, parts->shared, points, table); };
  parts->editor = state.stored.editors.size();
  state.stored.editors.push_back(std::move(editor));
}

/// Stencils are stored only while groups are near each other.
template <int D>
void watch(const std::shared_ptr<Parts<D>>& parts, State<D>& state)
{
  auto& prepare = state.stored.editors[parts->editor].prepare;
  if (!areApart(state, parts->shared))
    prepare = [parts](State<D>& s, const View<int*>& row) { findSharedNodes(s, parts->shared, row); };
  else if (prepare)
  {
    prepare = nullptr;
    clearSharedNodes(parts->shared);
  }
}

template <int D>
void touch(Parts<D>& parts, const State<D>& state)
{
  parts.pairs.count = 0;
  if (parts.shared.count == 0)
  {
    releaseInterfaces(parts.interfaces);
    return;
  }
  findFieldsNextToCracks(state, parts.shared);
  listPairs(parts.shared, parts.pairs);
  if (parts.interfaces.count > 0)
    sumSprings(state, parts.shared, parts.pairs, parts.interfaces);
  findGaps(state, parts.shared, parts.pairs);
  exchangeImpulses(state, parts.shared, parts.pairs, parts.laws);
}

template <int D>
Effect<D> make(const Teuchos::ParameterList& scene)
{
  const auto parts = std::make_shared<Parts<D>>(scene);
  Effect<D> effect;
  effect.name = "Body Contact";
  effect.balance = {"contact"};
  effect.atStart = [parts](State<D>& state) { start(parts, state); };
  effect.adds.push_back(
      {fields::bodyGroup, 1, "", "group of bodies that are bonded to each other, from 1 on", true});
  effect.addsNodal = pressedPairsFields(bondedGroups(parts->bodies, sublistNames(parts->bodies)).count());
  effect.call(Stage::BetweenSteps, "bodies near each other", {quantity::particleOrder}, {}, {},
              [parts](State<D>& s) { watch(parts, s); });
  effect.call(Stage::Solve, "impulses between bodies",
              {quantity::stencils, ifWritten(quantity::prescribedMotion)}, {}, {quantity::nodalMotion},
              [parts](State<D>& s) { touch(*parts, s); });
  effect.call(Stage::AfterProjection, "strain velocity of bodies that touch", {quantity::nodalMotion}, {},
              {quantity::projection},
              [parts](State<D>& s)
              {
                if (parts->pairs.count > 0)
                {
                  joinProjection(s, parts->shared, parts->pairs);
                  keepPressedPairs(s, parts->laws.groups, parts->shared, parts->pairs);
                  if (parts->heat.used)
                    passHeat(s, parts->shared, parts->pairs, parts->heat);
                  moveInterfaces(s, parts->pairs, parts->interfaces);
                }
                parts->record->add(s, parts->pairs, parts->interfaces);
              });
  effect.call(Stage::Observe, "forces between bodies", {quantity::energyBalance}, {}, {},
              [parts](State<D>& s) { parts->record->sample(s); });
  effect.memory = [parts](State<D>&, Archive& archive)
  {
    parts->shared.sorts = -1;
    parts->record->serialize(archive);
    if (parts->interfaces.count > 0)
      serialize(parts->interfaces, archive);
  };
  effect.report = [parts](const State<D>&, nlohmann::json& summary)
  {
    parts->record->report(summary);
    if (parts->heat.used && !hasConductance(parts->section))
      parts->record->warnOfInsulation(summary);
  };
  return effect;
}

} // namespace

EffectEntry bodyContactEntry()
{
  EffectEntry entry{section(), checkLaws, make<2>, make<3>, false};
  entry.declare = [](const Teuchos::ParameterList&, RunOptions& options) { options.bodiesKeptApart = true; };
  entry.cells.addNeeds = [](const auto&, CellNeeds& needs, auto&) { needs.equal = true; };
  return entry;
}

} // namespace Rhegma::body_contact
