#include "cracks/Cracks.hpp"

#include "archive/Archive.hpp"
#include "base/Attempts.hpp"
#include "base/ReadList.hpp"
#include "cracks/AdvectedFronts.hpp"
#include "cracks/BrokenCellsInEquilibrium.hpp"
#include "cracks/CellsForCracks.hpp"
#include "cracks/CloseCracks.hpp"
#include "cracks/CrackGrowth.hpp"
#include "cracks/CrackMemory.hpp"
#include "cracks/CrackMotion.hpp"
#include "cracks/CrackReport.hpp"
#include "cracks/CrackSection.hpp"
#include "cracks/CrackSetup.hpp"
#include "cracks/EndLigaments.hpp"
#include "cracks/FewParticles.hpp"
#include "cracks/FrontSprings.hpp"
#include "cracks/HeldFaces.hpp"
#include "cracks/IdleCracks.hpp"
#include "cracks/JudgeLength.hpp"
#include "cracks/JudgeLigaments.hpp"
#include "cracks/Normals.hpp"
#include "cracks/SpringsInEquilibrium.hpp"
#include "cracks/Visibility.hpp"
#include "plan/LastStage.hpp"
#include "scene/SceneBodies.hpp"
#include "state/AtRest.hpp"
#include "surface/CutsOfMeshes.hpp"

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace Rhegma::cracks
{

namespace
{

Formulation readFormulation(const Teuchos::ParameterList& section)
{
  const std::string name = section.get<std::string>("Formulation");
  return name == "Broken Cell"             ? Formulation::BrokenCell
         : name == "Corrected Broken Cell" ? Formulation::CorrectedBrokenCell
                                           : Formulation::DualField;
}

/// How many times smaller than the coarse cells edges of a surface's triangles are: as the cells at fronts,
/// but no smaller than those of the second level, as there are four times as many with each.
int piecesOfACell(const RunOptions& options) { return 1 << std::min(2, options.frontLevels); }

/// The shapes of a scene's bodies; none where one is wrong, which is said where bodies are placed.
template <int D>
std::shared_ptr<const CrackedBodies<D>> readBodies(const Teuchos::ParameterList& scene, bool keptApart)
{
  std::shared_ptr<const CrackedBodies<D>> bodies;
  Attempts hidden;
  if (scene.isSublist("Bodies"))
    hidden.attempt([&] { bodies = std::make_shared<CrackedBodies<D>>(scene, keptApart); });
  return bodies;
}

/// Whether steps of motion limit the stiffness of springs. Added inertia would have to be part of a mass
/// matrix, and of the first traction of a new face. It is for the law of FrontCell.hpp, which needs heat to
/// pass between the fields. \param options of the motion
bool hasLimitedSprings(const RunOptions& options, bool moves)
{
  return ((options.growth || options.contact) && moves) || options.nodalMass.lumpedFraction < 1.0 ||
         options.nodalMass.terms > 0 || !options.fieldsConduct;
}

/// What the calls of the effect have in common.
template <int D>
struct Parts
{
  const Teuchos::ParameterList& section;          ///< of the scene, which outlives the effect
  std::shared_ptr<const CrackedBodies<D>> bodies; ///< none where a shape is wrong: then nothing starts
  MirroredSides mirrored;
  std::vector<MirrorPlane> mirrors;
  std::vector<surface::CrackMesh<D>> meshes; ///< as they were read, until they are judged
  Formulation formulation;
  bool hasSprings; ///< behind fronts
  bool grows;
  bool moves;    ///< in the whole run, or in its last part: the law of springs is that of motion
  bool releases; ///< new faces open against a traction; in equilibrium they are free at once
  bool limited;  ///< hasLimitedSprings: steps of motion limit the stiffness of springs
  bool joins;    ///< cracks may end on others
  bool touching; ///< contact keeps faces apart
  bool startsInEquilibrium;
  bool startsWithoutCracks; ///< in an equilibrium without them, whose particles must be those of the run
  int pieces;               ///< of a cell, for edges of surfaces
  int levels;               ///< of finer cells at fronts
  bool adaptive;            ///< cells are refined after this effect has started
  Surroundings surroundings;
  Ghosts ghosts;
  CrackMotion<D> motion;
  AdvectedFronts<D> advected;
  std::vector<OverlapRecord> overlaps; ///< of each crack, in the samples so far
  FrontSprings<D> springs;
  Junctions junctions;
  CrackGrowth<D> growth;

  Parts(const Teuchos::ParameterList& scene, const RunOptions& options)
      : section(scene.sublist("Cracks")),
        bodies(readBodies<D>(scene, options.bodiesKeptApart)),
        mirrored(scene),
        mirrors(mirrorPlanes(scene)),
        formulation(readFormulation(section)),
        hasSprings(formulation == Formulation::DualField && section.get<bool>("Front Springs")),
        grows(options.growth),
        moves(!isEquilibrium(scene) || handsOver(scene) || options.motion),
        releases(grows && !isEquilibrium(scene)),
        limited(hasLimitedSprings(options.ofMotion(), moves)),
        joins(D == 2 && grows && sublistNames(section).size() > 1),
        touching(options.contact),
        startsInEquilibrium(scene.sublist("Time").get<std::string>("Initial State") == "Equilibrium"),
        startsWithoutCracks(scene.sublist("Time").get<std::string>("Initial State") ==
                            "Equilibrium Without Cracks"),
        pieces(piecesOfACell(options)),
        levels(options.frontLevels),
        adaptive(options.adaptive),
        springs(releases, limited),
        growth(mirrors)
  {
    // Where faces touch in motion, the contact of nodes near a front would store energy next to their
    // springs. A front that is held until a time starts with any G, and what its springs store then is lost
    // to its faces: by this law up to G times a cell, which may be a hundred times their toughness.
    const RunOptions& motion = options.ofMotion();
    const bool startsByTime = motion.growth && moves && motion.growthFrom > 0.0;
    surroundings.releases = releases;
    surroundings.law.ofCells = motion.fieldsConduct && !startsByTime && (!motion.contact || !moves);
  }
};

template <int D>
using Shared = std::shared_ptr<Parts<D>>;

/// Finds sides before the transfers of each step.
template <int D>
void prepareStencils(Parts<D>& parts, State<D>& state, const View<int*>& row)
{
  if constexpr (D == 2)
  {
    findSides(state, parts.surroundings, row, [&] { parts.junctions.claimNodes(state, parts.surroundings); });
    parts.junctions.markParticles(state, row);
  }
  else
    findSides(state, parts.surroundings, row);
  if (parts.bodies->areKeptApart())
    stopCracksThatMeet(state);
  if (parts.surroundings.stamp == 1)
    warnOfIdleCracks(state);
  if constexpr (D == 2) // other formulations are 2D only
  {
    if (parts.formulation == Formulation::CorrectedBrokenCell)
      findGhosts(state, row, parts.ghosts);
    if (parts.formulation == Formulation::BrokenCell)
      updateNormals(state, row);
  }
}

/// Length of the edges of a surface's triangles, and size of the cells at fronts [m].
template <int D>
std::pair<double, double> sizesOf(const Parts<D>& parts, const State<D>& state)
{
  const double cell = state.mesh.grid.spacing;
  return {cell / parts.pieces, std::ldexp(cell, -parts.levels)};
}

/// Whether cracks divide particles: where the law of springs was derived so, at rest or with that of
/// FrontCell.hpp at any angle; not where a run of motion follows from an equilibrium without cracks, whose
/// particles must be the same.
template <int D>
bool dividesParticles(const Parts<D>& parts, const State<D>& state)
{
  const bool inMotion = parts.hasSprings && parts.surroundings.law.ofCells && !parts.limited;
  return staysAtRest(state) || (inMotion && !parts.startsWithoutCracks);
}

/// Where the cracks divide particles. Nowhere if a crack is wrong, which is said where they are read again.
template <int D>
Geometry::Cuts<D> cutsOf(const Parts<D>& parts, const State<D>& state)
{
  Geometry::Cuts<D> cuts;
  if (parts.bodies == nullptr || !dividesParticles(parts, state))
    return cuts;
  std::vector<std::string> warnings;
  std::vector<int> bodyGroups;
  const auto [edge, front] = sizesOf(parts, state);
  Attempts hidden;
  hidden.attempt(
      [&, edge = edge, front = front]
      {
        cuts = surface::cutsOfMeshes(
            readMeshes(parts.section, *parts.bodies, state, edge, front, warnings, bodyGroups));
      });
  return cuts;
}

template <int D>
void start(const Shared<D>& parts, State<D>& state)
{
  state.cracks.dualField = parts->formulation == Formulation::DualField;
  state.cracks.frontSprings = parts->hasSprings;
  parts->surroundings.law.unlimited = staysAtRest(state) || !parts->limited;
  if (parts->hasSprings && state.method.equilibrium())
    state.motion.stepForces.push_back(std::make_shared<SpringsInEquilibrium<D>>());
  if (parts->formulation == Formulation::BrokenCell && state.method.equilibrium())
    state.motion.stepForces.push_back(std::make_shared<BrokenCellsInEquilibrium<D>>());
  if (parts->hasSprings)
    state.motion.displacementDependentForces.push_back(parts->springs.displacementDependentForce());
  const auto [edge, front] = sizesOf(*parts, state);
  parts->meshes = readCracks(parts->section, *parts->bodies, state, edge, front);
  if (!parts->adaptive) // else once cells are refined
    refuseCloseCracks(state);
  if (parts->hasSprings)
    parts->advected.start(state);
  StencilEditor<D> editor;
  editor.prepare = [=](State<D>& s, const View<int*>& row) { prepareStencils(*parts, s, row); };
  editor.keep = [=](State<D>&) { ++parts->surroundings.stamp; };
  editor.edit = [=](const State<D>& s, const ObservedPoints<D>& points, const StencilTable<D>& table)
  {
    if constexpr (D == 2)
      parts->junctions.hideNodes(s, points, table);
    editStencils(s, parts->formulation, parts->ghosts, points, table);
  };
  state.stored.editors.push_back(std::move(editor));
}

template <int D>
void addFields(const Parts<D>& parts, Effect<D>& effect)
{
  effect.adds.push_back(
      {fields::side, 1, "", "side of the nearest crack: its number + 1, negative on side -1", true});
  if (parts.formulation == Formulation::BrokenCell)
    effect.adds.push_back(
        {crackNormal, 2, "", "unit normal of the face near the particle, out of its material"});
  if (parts.joins)
    effect.adds.push_back({otherSide, 1, "", "the same of another crack that has joined it, or 0", true});
  if (parts.hasSprings)
    effect.addsNodal.push_back(springField<D>());
}

/// Energy per area that the last faces at a front require.
template <int D>
std::vector<double> toughnessOf(const Parts<D>& parts, const CrackSet<D>& set, int front)
{
  if constexpr (D == 3)
    return parts.growth.toughnessAlong(set, front);
  else
    return {set.fronts[front].budget.toughness};
}

template <int D>
void callSprings(const Shared<D>& parts, const Teuchos::ParameterList& scene, Effect<D>& effect)
{
  effect.balance.push_back("stabilised"); // what their damping takes
  // With USF, springs are stretched before forces are summed.
  effect.call(Stage::Scatter, "stiffness of springs behind crack fronts",
              {quantity::nodalMass, quantity::enrichedFields}, {quantity::springStiffness}, {},
              [=](State<D>& s) { parts->springs.prepare(s, parts->surroundings); });
  effect.call(Stage::BeforeSolve, "springs behind crack fronts",
              {quantity::springStiffness, quantity::springStretch, quantity::nodalMass,
               ifWritten(quantity::nodalMomentum)},
              {quantity::springForce}, {quantity::internalForce},
              [=](State<D>& s) { parts->springs.addForces(s); });
  if (parts->releases)
    effect.call(Stage::Solve, "cohesion of new crack faces", {quantity::springForce},
                {quantity::fractureEnergy}, {quantity::nodalForce},
                [=](State<D>& s)
                {
                  parts->springs.release(s, parts->surroundings,
                                         [&](const CrackSet<D>& set, int front)
                                         { return toughnessOf(*parts, set, front); });
                });
  effect.call(
      Stage::AfterProjection, "stretch of springs behind crack fronts",
      {quantity::nodalMotion, ifWritten(quantity::projection)}, {quantity::springStretch}, {},
      [=](State<D>& s) { parts->springs.advance(s); }, true);
  if (!isEquilibrium(scene))
    effect.call(stageOfFaceVelocity(scene), "damping of springs behind crack fronts",
                {quantity::springForce, projectsLast(scene) ? quantity::projection : quantity::nodalMotion},
                {}, {}, [=](State<D>& s) { parts->springs.recordDamping(s); });
}

/// In equilibrium fronts advance where their G is the toughness, so that new faces spend their energy at
/// once. That of a front that ends stays pending: a body that is cut through has no equilibrium under its
/// loads.
template <int D>
void recordGrowth(State<D>& state)
{
  state.cracks.growth.area = 0.0;
  for (CrackFront<D>& front : state.cracks.fronts)
  {
    state.cracks.growth.area += front.extension.area * (D == 2 ? state.method.thickness : 1.0);
    if (front.ended)
      continue;
    if (state.ranks.rank() == 0) // for all ranks
      state.energy.fracture += front.budget.pending;
    front.budget.release(front.budget.pending);
  }
}

template <int D>
void grow(Parts<D>& parts, State<D>& state)
{
  if constexpr (D == 2) // faces that open later by the motion of a body require the same energy
    for (const FrontAdvance<D>& advance : state.cracks.advances)
      state.cracks.fronts[advance.front].budget.toughness = advance.nodes[0].toughness;
  for (const Meeting& meeting : parts.growth.grow(state))
    if constexpr (D == 2)
      parts.junctions.add(state, meeting);
  if (!parts.releases)
    recordGrowth(state);
}

template <int D>
void move(Parts<D>& parts, State<D>& state)
{
  if (state.clock.step == 0 && state.cracks.dualField)
    warnOfHeldFaces(state, parts.surroundings);
  parts.motion.move(state);
  if (parts.hasSprings)
    parts.advected.update(state);
}

template <int D>
void report(const Parts<D>& parts, const State<D>& state, nlohmann::json& summary)
{
  if (parts.hasSprings)
    parts.advected.report(state, summary);
  if (parts.grows)
    summary["energy_in_flight"] = parts.springs.pendingEnergy(state, parts.surroundings.stamp);
  reportCracks(state, parts.overlaps, parts.grows, parts.touching, parts.startsInEquilibrium, summary);
  if (parts.grows)
    reportLigaments(state, parts.mirrors, summary);
}

/// The faces of cracks lie, and their springs are stretched, as in an equilibrium that has the same cracks.
template <int D>
void takeOver(const Parts<D>& parts, State<D>& state, const State<D>& from)
{
  CrackSet<D>& to = state.cracks;
  if (from.cracks.vertex.extent(0) != to.vertex.extent(0))
    return; // it has none
  Kokkos::deep_copy(to.vertex, from.cracks.vertex);
  Kokkos::deep_copy(to.face, from.cracks.face);
  if (from.cracks.carried.extent(0) > 0)
  {
    to.carried = View<double* [D]>("rhegma::crackDisplacement", from.cracks.carried.extent(0));
    Kokkos::deep_copy(to.carried, from.cracks.carried);
  }
  if (!parts.hasSprings)
    return;
  const std::string name = springField<D>().field.name;
  const auto theirs = onHost(from.mesh.nodalFields.template real<NodalSpring<D>::size>(name));
  const auto ours = state.mesh.nodalFields.template real<NodalSpring<D>::size>(name);
  if (theirs.extent(0) != ours.extent(0))
    throw std::invalid_argument(
        "Time > Initial State: the cells of the equilibrium differ from those at the start of the run");
  double last = 0.0;
  for (std::size_t n = 0; n < theirs.extent(0); ++n)
    last = std::max(last, theirs(n, 0));
  // The next step of the run follows the last one of the equilibrium.
  for (std::size_t n = 0; n < theirs.extent(0); ++n)
    theirs(n, 0) = theirs(n, 0) == last ? parts.surroundings.stamp : -1.0;
  Kokkos::deep_copy(ours, theirs);
  state.energy.springs = state.ranks.rank() == 0 ? from.energy.springs : 0.0; // of all ranks
}

template <int D>
Effect<D> make(const Teuchos::ParameterList& scene, const RunOptions& options)
{
  const auto parts = std::make_shared<Parts<D>>(scene, options);
  Effect<D> effect;
  effect.name = "Cracks";
  addFields(*parts, effect);
  effect.cuts = [=](const State<D>& state) { return cutsOf(*parts, state); };
  effect.atStart = [=](State<D>& state) { start(parts, state); };
  effect.judge = [=, unstable = bodiesOfFewParticles(scene, options)](State<D>& state)
  {
    state.warnings.insert(state.warnings.end(), unstable.begin(), unstable.end());
    if (!parts->meshes.empty()) // else bodies or cracks are wrong
      judgeLigaments(*parts->bodies, parts->mirrored, parts->meshes, state);
    parts->meshes.clear();
    judgeLengths(sizesOf(*parts, state).second, state); // in cells that are refined already
    if (parts->adaptive)
      refuseCloseCracks(state);
  };
  effect.memory = [=](State<D>& state, Archive& archive)
  {
    archive("steps", parts->surroundings.stamp);
    storeCracks(state, archive);
    storeOverlaps(parts->overlaps, archive);
    if (parts->grows)
      parts->growth.serialize(state.cracks, archive);
    if (parts->joins)
      parts->junctions.serialize(archive);
  };
  effect.takeOver = [=](State<D>& state, const State<D>& from) { takeOver(*parts, state, from); };
  if (parts->hasSprings)
    callSprings(parts, scene, effect);
  if (parts->grows)
    effect.call(Stage::BetweenSteps, "cracks grow", {quantity::frontAdvances},
                {quantity::crackGeometry, quantity::fractureEnergy}, {},
                [=](State<D>& s) { grow(*parts, s); });
  effect.call(stageOfFaceVelocity(scene), "cracks move",
              {projectsLast(scene) ? quantity::projection : quantity::nodalMotion}, {quantity::crackGeometry},
              {}, [=](State<D>& s) { move(*parts, s); });
  effect.call(Stage::Observe, "opening of cracks", {quantity::crackGeometry}, {}, {},
              [=](State<D>& s)
              {
                const std::vector<Opening> openings = openingsOf(s.cracks);
                addCrackColumns(s, openings, parts->grows);
                recordOverlaps(s, openings, parts->touching, parts->overlaps);
              });
  if constexpr (D == 2)
    if (parts->formulation == Formulation::CorrectedBrokenCell)
      effect.timeStepLimit = [](const State<D>& state)
      { return largestCfl(state.cracks) * state.mesh.grid.spacing / state.clock.fastestSpeed; };
  effect.report = [=](const State<D>& state, nlohmann::json& summary) { report(*parts, state, summary); };
  return effect;
}

} // namespace

EffectEntry cracksEntry()
{
  EffectEntry entry{crackSection(), checkCracks, make<2>, make<3>, true};
  entry.declare = [](const Teuchos::ParameterList& list, RunOptions& options)
  {
    const Formulation formulation = readFormulation(list);
    options.openingKnown = formulation != Formulation::BrokenCell;
    options.extrapolated = formulation == Formulation::CorrectedBrokenCell;
  };
  entry.cells.subject = "cracks with a front in material";
  entry.cells.addNeeds = reportCells;
  return entry;
}

} // namespace Rhegma::cracks
