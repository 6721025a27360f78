#include "cracks/Cracks.hpp"

#include "archive/Archive.hpp"
#include "base/ReadList.hpp"
#include "cracks/AdvectedFronts.hpp"
#include "cracks/CellsForCracks.hpp"
#include "cracks/CrackFrames.hpp"
#include "cracks/CrackMotion.hpp"
#include "cracks/CrackSetup.hpp"
#include "cracks/FrontSprings.hpp"
#include "cracks/Growth.hpp"
#include "cracks/HeldFaces.hpp"
#include "cracks/IdleCracks.hpp"
#include "cracks/Junctions.hpp"
#include "cracks/Normals.hpp"
#include "cracks/Opening.hpp"
#include "cracks/Overlap.hpp"
#include "cracks/Sides.hpp"
#include "cracks/SurfaceGrowth.hpp"
#include "cracks/Visibility.hpp"
#include "plan/LastStage.hpp"

#include <memory>
#include <vector>

namespace Rhegma::cracks
{

namespace
{

Section section()
{
  Section s("Cracks",
            "Explicit cracks: polylines (2D) or surfaces (3D) that cut bodies independently of the grid.");
  s.choice("Formulation", {"Dual Field", "Broken Cell", "Corrected Broken Cell"})
      .byDefault("Dual Field")
      .meaning("How cracked cells are treated. Dual Field: one velocity field on each side of the crack. "
               "Broken Cell: shape functions truncated by visibility. Corrected Broken Cell: the same, made "
               "linearly complete by extrapolation.");
  s.boolean("Front Springs")
      .formerly("Front Ties")
      .byDefault(true)
      .meaning("Penalty springs between the two fields of nodes less than a cell behind a front, so that the "
               "crack on the grid ends at its front and not at the next column of nodes. Dual Field only.");
  Section crack("crack", "A crack. You choose its name.");
  crack.realArray("Points")
      .unit("m")
      .perPoint(2)
      .optional("in 3D Radius or Surface File")
      .meaning("2D: points of a polyline. 3D: at least three corners of a plane polygon, convex or not, in "
               "order around it. Parts outside the bodies are cut off.");
  crack.realArray("Centre").unit("m").perAxis().optional().onlyIn(3).meaning(
      "Centre of a disk-shaped or elliptical crack.");
  crack.realArray("Normal").perAxis().optional().onlyIn(3).meaning(
      "Normal of the disk, of any non-zero length, from side -1 to side +1 of the crack.");
  crack.real("Radius")
      .unit("m")
      .positive()
      .optional("Points or Surface File")
      .onlyIn(3)
      .meaning("Radius of the disk, or one semi-axis of an ellipse.");
  crack.real("Second Radius")
      .unit("m")
      .positive()
      .optional("Radius")
      .onlyIn(3)
      .meaning("Other semi-axis of the ellipse, normal to Radius Direction.");
  crack.realArray("Radius Direction")
      .perAxis()
      .optional("the coordinate axis farthest from Normal")
      .onlyIn(3)
      .meaning("Direction of Radius. Its component normal to the crack plane is ignored.");
  crack.text("Surface File")
      .notEmpty()
      .optional("Points or Radius")
      .onlyIn(3)
      .meaning("Path (relative to the scene) of an STL or OBJ file with the crack as a triangulated surface "
               "in metres. Its edges inside material are crack fronts.");
  crack.choice("Fronts", {"Automatic", "First", "Last", "Both", "None"})
      .byDefault("Automatic")
      .onlyIn(2)
      .meaning("Which ends of the polyline are crack fronts. Automatic: every end inside material.");
  crack.integerArray("Front Edges")
      .optional("edges inside material")
      .onlyIn(3)
      .meaning("Edges of the polygon that are crack fronts; the others are free edges. Edge k goes from "
               "point k to the next, counted from 1.");
  s.namedByUser(crack);
  return s;
}

/// A crack has one shape, and all that belongs to it.
void checkShape(const Teuchos::ParameterList& crack, const std::string& where, bool flat,
                std::vector<SceneError>& errors)
{
  const auto has = [&](const char* name) { return crack.isParameter(name); };
  const int shapes = (has("Points") ? 1 : 0) + (has("Radius") ? 1 : 0) + (has("Surface File") ? 1 : 0);
  if (shapes == 0 && flat)
    errors.push_back({where + " > Points", "is missing; write the crack as a polyline, point after point"});
  else if (shapes == 0)
    errors.push_back({where + " > Points",
                      "is missing; write the corners of a polygon, or Centre, Normal and Radius of a disk, "
                      "or a Surface File"});
  else if (shapes > 1)
    errors.push_back({where, "it has more than one shape; keep one of Points, Radius and Surface File"});
  if (shapes == 0)
    return;
  for (const char* name : {"Centre", "Normal"})
    if (has("Radius") && !has(name))
      errors.push_back({where + " > " + name, "is missing; a disk has Centre, Normal and Radius"});
  for (const char* name : {"Centre", "Normal", "Second Radius", "Radius Direction"})
    if (!has("Radius") && has(name))
      errors.push_back({where + " > " + name, "belongs to a disk; write its Radius too, or leave this out"});
  if (has("Front Edges") && !has("Points"))
    errors.push_back({where + " > Front Edges", "is for polygons, which have Points; leave it out"});
}

void checkShapes(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors)
{
  if (!scene.isSublist("Domain") || !scene.sublist("Domain").isType<int>("Dimension"))
    return;
  const bool flat = scene.sublist("Domain").get<int>("Dimension") == 2;
  for (const std::string& name : sublistNames(scene.sublist("Cracks")))
  {
    const std::string where = "Cracks > " + name;
    bool wrong = false; // then what follows from it says nothing
    for (const SceneError& error : errors)
      wrong = wrong || error.where.rfind(where + " > ", 0) == 0;
    if (!wrong)
      checkShape(scene.sublist("Cracks").sublist(name), where, flat, errors);
  }
}

void check(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors)
{
  if (sublistNames(scene.sublist("Cracks")).empty())
    errors.push_back({"Cracks",
                      "the section holds no crack; write one as <ParameterList name=\"...\"> or leave "
                      "the section out"});
  checkShapes(scene, errors);
  if (!scene.isSublist("Domain") || !scene.sublist("Domain").isType<int>("Dimension") ||
      scene.sublist("Domain").get<int>("Dimension") != 3)
    return;
  const Teuchos::ParameterList& cracks = scene.sublist("Cracks");
  if (cracks.isType<std::string>("Formulation") && cracks.get<std::string>("Formulation") != "Dual Field")
    errors.push_back({"Cracks > Formulation",
                      cracks.get<std::string>("Formulation") + " is for 2D scenes as yet; write Dual Field"});
}

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

template <int D>
Effect<D> make(const Teuchos::ParameterList& scene, const RunOptions& options)
{
  const Teuchos::ParameterList section = scene.sublist("Cracks");
  const Formulation formulation = readFormulation(section);
  const bool hasSprings = formulation == Formulation::DualField && section.get<bool>("Front Springs");
  const auto surroundings = std::make_shared<Surroundings>();
  const auto ghosts = std::make_shared<Ghosts>();
  const auto motion = std::make_shared<CrackMotion<D>>();
  const auto advected = std::make_shared<AdvectedFronts<D>>();
  const bool grows = options.growth;
  const int pieces = piecesOfACell(options);
  const auto springs = std::make_shared<FrontSprings<D>>(grows);
  const bool join = D == 2 && grows && sublistNames(section).size() > 1;
  const auto junctions = std::make_shared<Junctions>();
  Effect<D> effect;
  effect.name = "Cracks";
  effect.adds.push_back(
      {fields::side, 1, "", "side of the nearest crack: its number + 1, negative on side -1", true});
  if (formulation == Formulation::BrokenCell)
    effect.adds.push_back(
        {crackNormal, 2, "", "unit normal of the face near the particle, out of its material"});
  if (join)
    effect.adds.push_back({otherSide, 1, "", "the same of another crack that has joined it, or 0", true});
  effect.atStart = [=](State<D>& state)
  {
    state.cracks.dualField = formulation == Formulation::DualField;
    state.cracks.frontSprings = hasSprings;
    if (hasSprings)
      state.motion.followingForces.push_back(springs->following());
    readCracks(section, state, state.mesh.grid.spacing / pieces);
    if (hasSprings)
      advected->start(state);
    state.stored.editor.prepare = [=](State<D>& s, const View<int*>& row)
    {
      if constexpr (D == 2)
      {
        findSides(s, *surroundings, row, [&] { junctions->claimNodes(s, *surroundings); });
        junctions->markParticles(s, row);
      }
      else
        findSides(s, *surroundings, row);
      if (surroundings->stamp == 1)
        warnOfIdleCracks(s);
      if constexpr (D == 2) // a 3D scene with another formulation is refused
      {
        if (formulation == Formulation::CorrectedBrokenCell)
          findGhosts(s, row, *ghosts);
        if (formulation == Formulation::BrokenCell)
          carryNormals(s, row);
      }
    };
    state.stored.editor.edit =
        [=](const State<D>& s, const ObservedPoints<D>& points, const StencilTable<D>& table)
    {
      if constexpr (D == 2)
        junctions->hideNodes(s, points, table);
      editStencils(s, formulation, *ghosts, points, table);
    };
  };
  const auto surface = std::make_shared<SurfaceGrowth>(mirrorPlanes(scene));
  effect.memory = [=](State<D>& state, Archive& archive)
  {
    archive("steps", surroundings->stamp);
    if constexpr (D == 3)
      if (grows)
        surface->keep(state, archive);
    keepCracks(state, archive);
    if (join)
      junctions->keep(archive);
  };
  if (hasSprings)
  {
    effect.addsNodal.push_back(springField<D>());
    // USF stretches springs before forces are summed.
    effect.call({Stage::Scatter,
                 "stiffness of springs behind crack fronts",
                 {quantity::nodalMass, quantity::enrichedFields},
                 {quantity::springStiffness},
                 {},
                 [=](State<D>& s) { springs->prepare(s, *surroundings); }});
    effect.call({Stage::BeforeSolve,
                 "springs behind crack fronts",
                 {quantity::springStiffness, quantity::springStretch},
                 {quantity::springForce},
                 {quantity::internalForce},
                 [=](State<D>& s) { springs->addForces(s); }});
    if (grows)
      effect.call({Stage::Solve,
                   "cohesion of new crack faces",
                   {quantity::springForce},
                   {quantity::fractureEnergy},
                   {quantity::nodalForce},
                   [=](State<D>& s)
                   {
                     springs->release(s, *surroundings,
                                      [&](const CrackSet<D>& set, int front) -> std::vector<double>
                                      {
                                        if constexpr (D == 3)
                                          return surface->toughnessAlong(set, front);
                                        else
                                          return {set.fronts[front].budget.toughness};
                                      });
                   }});
    effect.call({Stage::AfterProjection,
                 "stretch of springs behind crack fronts",
                 {quantity::nodalMotion, ifWritten(quantity::projection)},
                 {quantity::springStretch},
                 {},
                 [=](State<D>& s) { springs->advance(s); },
                 true});
  }
  if (grows)
    effect.call({Stage::BetweenSteps,
                 "cracks grow",
                 {quantity::frontAdvances},
                 {quantity::crackGeometry, quantity::fractureEnergy},
                 {},
                 [surface, junctions](State<D>& s)
                 {
                   if constexpr (D == 2)
                   {
                     // Faces that the motion of a body opens later require the same energy.
                     for (const FrontAdvance<D>& advance : s.cracks.advances)
                       s.cracks.fronts[advance.front].budget.toughness = advance.nodes[0].toughness;
                     growCracks(s, *junctions);
                   }
                   else
                     surface->grow(s);
                 }});
  effect.call({stageOfWays(scene),
               "cracks move",
               {projectsLast(scene) ? quantity::projection : quantity::nodalMotion},
               {quantity::crackGeometry},
               {},
               [=](State<D>& s)
               {
                 if (s.clock.step == 0 && s.cracks.dualField)
                   warnOfHeldFaces(s, *surroundings);
                 motion->move(s);
                 if (hasSprings)
                   advected->update(s);
               }});
  effect.call({Stage::Observe,
               "opening of cracks",
               {quantity::crackGeometry},
               {},
               {},
               [](State<D>& s)
               {
                 for (std::size_t c = 0; c < s.cracks.cracks.size(); ++c)
                 {
                   const Opening opening = measureOpening(s.cracks, static_cast<int>(c));
                   const std::string& name = s.cracks.cracks[c].name;
                   s.sample.row.emplace_back(name + ".opening", opening.largest);
                   if constexpr (D == 3)
                     s.sample.row.emplace_back(name + ".area", opening.size);
                 }
               }});
  if constexpr (D == 2)
    if (formulation == Formulation::CorrectedBrokenCell)
      effect.timeStepLimit = [](const State<D>& state)
      { return largestCfl(state.cracks) * state.mesh.grid.spacing / state.clock.fastestSpeed; };
  const bool touching = options.contact;
  effect.report = [=](const State<D>& state, nlohmann::json& summary)
  {
    if (hasSprings)
      advected->report(state, summary);
    for (std::size_t c = 0; c < state.cracks.cracks.size(); ++c)
    {
      summary["cracks"][c]["name"] = state.cracks.cracks[c].name;
      if (!summary["cracks"][c].contains("fronts"))
        summary["cracks"][c]["fronts"] = nlohmann::json::array();
      const Opening opening = measureOpening(state.cracks, static_cast<int>(c));
      const std::string complaint = touching ? "" : complaintOfOverlap(state, static_cast<int>(c));
      if (!complaint.empty())
        summary["warnings"].push_back(complaint);
      summary["cracks"][c]["opening"] = opening.largest;
      summary["cracks"][c][D == 2 ? "opening_area" : "opening_volume"] = opening.volume;
      summary["cracks"][c][D == 2 ? "length" : "area"] = opening.size;
    }
    if (grows)
      summary["energy_in_flight"] = springs->pendingEnergy(state, surroundings->stamp);
    for (const CrackFront<D>& front : state.cracks.fronts)
    {
      nlohmann::json& entry = summary["cracks"][front.crack]["fronts"][front.number];
      entry["position"] = std::vector<double>(front.position.c, front.position.c + D);
      entry["length"] = front.length;
      entry["speed"] = front.speed();
    }
  };
  return effect;
}

} // namespace

EffectEntry cracksEntry()
{
  EffectEntry entry{section(), check, make<2>, make<3>, true};
  entry.declare = [](const Teuchos::ParameterList& list, RunOptions& options)
  {
    const Formulation formulation = readFormulation(list);
    options.openingKnown = formulation != Formulation::BrokenCell;
    options.extrapolated = formulation == Formulation::CorrectedBrokenCell;
  };
  entry.cells.knows = "cracks with a front in material";
  entry.cells.tell = tellCells;
  return entry;
}

} // namespace Rhegma::cracks
