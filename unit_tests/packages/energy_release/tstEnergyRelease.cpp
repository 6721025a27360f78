#include "LatticeState.hpp"

#include "energy_release/EnergyRelease.hpp"
#include "energy_release/LoadsInRing.hpp"
#include "mass_matrix/MassMatrix.hpp"
#include "plan/EffectSchema.hpp"

#include <Teuchos_ParameterList.hpp>
#include <gtest/gtest.h>

using namespace Rhegma;
using namespace Rhegma::energy_release;
using namespace Rhegma::energy_release::test;

namespace
{

Teuchos::ParameterList sceneWith(double outer)
{
  Teuchos::ParameterList scene;
  Teuchos::ParameterList& list = scene.sublist("Energy Release");
  list.set("Inner Radius", 1e-3);
  list.set("Outer Radius", outer);
  list.set("Crack Closure", false);
  list.set("Lumped Closure", false);
  list.set("Closure Cells", 1);
  list.set("Contour Integral", true);
  list.set<std::string>("Closure Recovery", "Consistent");
  scene.sublist("Cracks");
  scene.sublist("Domain").set("Dimension", 2);
  scene.sublist("Time").set("Final Time", 1.0);
  scene.sublist("Domain").set("Cell Size", 1e-3);
  return scene;
}

} // namespace

TEST(EnergyRelease, StopsTheRunAtStartWhereItLeavesTheBody)
{
  State<2> state = makeBody(0.01, 1e-3, Plane::Strain, ShapeKind::Linear);
  addFront(state, {{0.007, 0.0}}, 0.0);
  EXPECT_NO_THROW(energyReleaseEntry().make2(sceneWith(3e-3)).atStart(state));
  try
  {
    energyReleaseEntry().make2(sceneWith(4e-3)).atStart(state);
    FAIL();
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_EQ(std::string(error.what()).find("Energy Release > Outer Radius: "), 0u);
    EXPECT_NE(std::string(error.what()).find("write at most 0.003"), std::string::npos) << error.what();
  }
}

/// Half a cell fits between 1 mm and 1.5 mm; of cells of 0.5 mm a whole one does.
TEST(EnergyRelease, IsRefusedWithLessThanACellBetweenItsRadii)
{
  for (const double cell : {1e-3, 0.5e-3})
  {
    State<2> state = makeBody(0.01, cell, Plane::Strain, ShapeKind::Linear);
    addFront(state, {{0.0, 0.0}}, 0.0);
    std::string said;
    try
    {
      energyReleaseEntry().make2(sceneWith(1.5e-3)).atStart(state);
    }
    catch (const std::invalid_argument& error)
    {
      said = error.what();
    }
    EXPECT_EQ(said, cell < 1e-3
                        ? ""
                        : "Energy Release > Outer Radius: it must exceed Inner Radius by at least one "
                          "cell of 0.001 m; write at least 0.002, or a smaller Inner Radius");
  }
}

/// With default radii, the program reduces the contour and reports it.
TEST(EnergyRelease, DrawsInAContourThatIsNotGiven)
{
  Teuchos::ParameterList scene = sceneWith(3e-3);
  scene.sublist("Energy Release").remove("Inner Radius");
  scene.sublist("Energy Release").remove("Outer Radius");
  const auto start = [&](double x)
  {
    State<2> state = makeBody(0.01, 1e-3, Plane::Strain, ShapeKind::Linear);
    addFront(state, {{x, 0.0}}, 0.0);
    const Effect<2> effect = energyReleaseEntry().make2(scene);
    effect.atStart(state);
    state.clock.observing = true;
    effect.calls[0].run(state);
    nlohmann::json summary;
    effect.report(state, summary);
    EXPECT_EQ(state.warnings.size(), x == 0.0 ? 0u : 1u);
    if (x > 0.0)
    {
      EXPECT_NE(state.warnings[0].find("reduced to radii of 2 mm to 3 mm"), std::string::npos)
          << state.warnings[0];
    }
    return summary["cracks"][0]["fronts"][0];
  };
  EXPECT_NEAR(start(0.0)["outer_radius"].get<double>(), 6e-3, 1e-12);
  EXPECT_NEAR(start(7e-3)["outer_radius"].get<double>(), 3e-3, 1e-12);
  EXPECT_NEAR(start(7e-3)["inner_radius"].get<double>(), 2e-3, 1e-12);
  EXPECT_THROW(start(8.5e-3), std::invalid_argument);
}

TEST(EnergyRelease, RefusesSectionsThatDoNotFit)
{
  const EffectEntry entry = energyReleaseEntry();
  const auto wrong = [&](const Teuchos::ParameterList& scene)
  {
    std::vector<SceneError> errors;
    checkRules(scene, effectSchema(), errors);
    entry.check(scene, errors);
    std::vector<std::string> positions;
    positions.reserve(errors.size());
    for (const SceneError& error : errors)
      positions.push_back(error.where);
    return positions;
  };
  Teuchos::ParameterList scene = sceneWith(3e-3);
  EXPECT_TRUE(wrong(scene).empty());
  EXPECT_EQ(wrong(sceneWith(1e-3)), std::vector<std::string>{"Energy Release > Outer Radius"});
  EXPECT_TRUE(wrong(sceneWith(1.5e-3)).empty()); // cells at the front decide
  scene.remove("Cracks");
  EXPECT_EQ(wrong(scene), std::vector<std::string>{"Energy Release"});
  scene = sceneWith(1.5e-3);
  scene.sublist("Energy Release").set("Contour Integral", false);
  EXPECT_EQ(wrong(scene), std::vector<std::string>{"Energy Release > Contour Integral"});
  scene.sublist("Energy Release").set("Crack Closure", true); // the radii are then of no use
  EXPECT_TRUE(wrong(scene).empty());
  scene = sceneWith(3e-3);
  scene.sublist("Domain").set("Dimension", 3);
  EXPECT_TRUE(wrong(scene).empty());
}

TEST(EnergyRelease, GivesColumnsAndASummary)
{
  State<2> state = makeBody(0.01, 1e-3, Plane::Strain, ShapeKind::Linear);
  CrackFront<2> front = addFront(state, {{0.0, 0.0}}, 0.4);
  state.cracks.fronts[0].length = 0.01;
  const Effect<2> effect = energyReleaseEntry().make2(sceneWith(5e-3));
  effect.atStart(state);
  deform(state, tipDisplacement(state, front, 2.0, 0.0));
  ASSERT_EQ(effect.calls.size(), 1u);
  EXPECT_EQ(effect.calls[0].stage, Stage::Observe);

  state.clock.observing = false;
  effect.calls[0].run(state);
  EXPECT_TRUE(state.sample.row.empty());

  state.clock.observing = true;
  effect.calls[0].run(state);
  std::vector<std::string> names;
  for (const auto& entry : state.sample.row)
    names.push_back(entry.first);
  EXPECT_EQ(names, (std::vector<std::string>{"Notch.0.G_J", "Notch.0.K_I", "Notch.0.K_II", "Notch.0.length",
                                             "Notch.0.speed", "Notch.0.x", "Notch.0.y"}));
  nlohmann::json summary;
  effect.report(state, summary);
  const nlohmann::json& reported = summary["cracks"][0]["fronts"][0];
  EXPECT_EQ(summary["cracks"][0]["name"], "Notch");
  EXPECT_EQ(reported["G_J"].get<double>(), state.sample.row[0].second);
  EXPECT_EQ(reported["K_I"].get<double>(), state.sample.row[1].second);
  EXPECT_EQ(reported["length"].get<double>(), 0.01);
  EXPECT_FALSE(reported.contains("G_closure"));
  EXPECT_EQ(reported["inner_radius"].get<double>(), 1e-3);
  EXPECT_EQ(reported["outer_radius"].get<double>(), 5e-3);
}

/// Crack closure alone works where no contour fits, here 1.5 cells before the surface.
TEST(EnergyRelease, DoesWithoutAContour)
{
  State<2> state = makeBody(0.01, 1e-3, Plane::Strain, ShapeKind::Linear);
  addFront(state, {{8.5e-3, 0.0}}, 0.0);
  Teuchos::ParameterList scene = sceneWith(3e-3);
  EXPECT_THROW(energyReleaseEntry().make2(scene).atStart(state), std::invalid_argument);
  scene.sublist("Energy Release").set("Contour Integral", false);
  scene.sublist("Energy Release").set("Crack Closure", true);
  const Effect<2> effect = energyReleaseEntry().make2(scene);
  effect.atStart(state);
  state.clock.observing = true;
  effect.calls[0].run(state);
  std::vector<std::string> names;
  for (const auto& entry : state.sample.row)
    names.push_back(entry.first);
  EXPECT_EQ(names, (std::vector<std::string>{"Notch.0.G_closure", "Notch.0.length", "Notch.0.speed",
                                             "Notch.0.x", "Notch.0.y"}));
  nlohmann::json summary;
  effect.report(state, summary);
  const nlohmann::json& reported = summary["cracks"][0]["fronts"][0];
  EXPECT_TRUE(reported.contains("G_closure"));
  for (const char* name : {"G_J", "K_I", "K_II", "kink_angle", "tip_offset", "inner_radius", "outer_radius"})
    EXPECT_FALSE(reported.contains(name)) << name;
}

TEST(EnergyRelease, KnowsHowFarLoadsAre)
{
  using Kind = BoundaryRegion::Kind;
  const Vector<3> from{{1.0, 0.0, 0.0}}, to{{4.0, 4.0, 0.0}};
  const auto at = [](double x, double y)
  {
    const Vector<2> point{{x, y}};
    return std::vector<FrontSegment<2>>{{point, point}};
  };
  const Reach line = reachOf<2>({"", Kind::Force, from, to}, at(1.0, -3.0));
  EXPECT_DOUBLE_EQ(line.nearest, 3.0);
  EXPECT_DOUBLE_EQ(line.furthest, std::hypot(3.0, 7.0));
  const Reach box = reachOf<2>({"", Kind::Held, from, to}, at(0.0, 7.0));
  EXPECT_DOUBLE_EQ(box.nearest, std::hypot(1.0, 3.0));
  EXPECT_DOUBLE_EQ(box.furthest, std::hypot(4.0, 7.0));
  EXPECT_EQ(reachOf<2>({"", Kind::Held, from, to}, at(2.0, 1.0)).nearest, 0.0);
  EXPECT_EQ(reachOf<2>({"", Kind::HeldOutside, from, to}, at(1.0, -3.0)).nearest, 0.0);
  EXPECT_DOUBLE_EQ(reachOf<2>({"", Kind::HeldOutside, from, to}, at(2.5, 1.25)).nearest, 1.25);
}

/// A front along the diagonal of x and z, one piece of which passes the edge of a box and the end of a line.
TEST(EnergyRelease, KnowsHowFarLoadsAreFromAFrontInSpace)
{
  using Kind = BoundaryRegion::Kind;
  const std::vector<FrontSegment<3>> front{{Vector<3>{{-4.0, 0.0, -4.0}}, Vector<3>{{-1.0, 0.0, -1.0}}},
                                           {Vector<3>{{-1.0, 0.0, -1.0}}, Vector<3>{{7.0, 0.0, 7.0}}}};
  const Reach box = reachOf<3>({"", Kind::Held, {{2.0, 3.0, -9.0}}, {{9.0, 5.0, 0.0}}}, front);
  EXPECT_NEAR(box.nearest, std::sqrt(9.0 + 2.0), 1e-9);          // the edge (2, 3, 0) from (1, 0, 1)
  EXPECT_NEAR(box.furthest, std::sqrt(25.0 + 2.0 * 81.0), 1e-9); // the corner (9, 5, -9) from the origin
  const Reach line = reachOf<3>({"", Kind::Force, {{3.0, 1.0, 3.0}}, {{3.0, 6.0, 3.0}}}, front);
  EXPECT_NEAR(line.nearest, 1.0, 1e-9);
  EXPECT_NEAR(line.furthest, 6.0, 1e-9);
}

/// The ring is from 2 to 3 mm round a front that runs from 6 to 2.5 mm before a load.
TEST(EnergyRelease, SaysWhenAFrontComesToALoad)
{
  State<2> state = makeBody(0.01, 1e-3, Plane::Strain, ShapeKind::Linear);
  addFront(state, {{0.0, 0.0}}, 0.0);
  Teuchos::ParameterList scene = sceneWith(3e-3);
  scene.sublist("Energy Release").set("Inner Radius", 2e-3);
  scene.sublist("Time").set("Final Time", 1.0);
  for (const char* history : {"1", "0"})
  {
    Teuchos::ParameterList& load = scene.sublist("Boundaries").sublist(history[0] == '1' ? "Pin" : "Sleeper");
    load.set("Type", "Point Load");
    load.set("Point", Teuchos::Array<double>(std::vector<double>{6e-3, 0.0}));
    load.set("History", history);
  }
  const Effect<2> effect = energyReleaseEntry().make2(scene);
  effect.atStart(state);
  state.clock.observing = true;
  effect.calls[0].run(state);
  EXPECT_TRUE(state.warnings.empty());
  state.cracks.fronts[0].position = {{3.5e-3, 0.0}};
  state.clock.time = 0.5;
  for (int sample = 0; sample < 2; ++sample)
  {
    state.sample.row.clear();
    effect.calls[0].run(state);
    ASSERT_EQ(state.warnings.size(), 1u);
    EXPECT_NE(
        state.warnings[0].find("Boundaries > Pin acts in the domain integral from 2 mm to 3 mm around crack "
                               "Notch, front 0, from t = 500 ms on"),
        std::string::npos)
        << state.warnings[0];
  }
}

/// Behind faces that are six cells apart no node has both in its reach. Warnings are not repeated.
TEST(EnergyRelease, SaysWhereThereIsNoCrackClosure)
{
  State<2> state = makeBody(0.01, 1e-3, Plane::Strain, ShapeKind::Linear);
  addFront(state, {{0.0, 0.0}}, 0.0);
  Teuchos::ParameterList scene = sceneWith(3e-3);
  scene.sublist("Energy Release").set("Contour Integral", false);
  scene.sublist("Energy Release").set("Crack Closure", true);
  const Effect<2> effect = energyReleaseEntry().make2(scene);
  effect.atStart(state);
  state.clock.observing = true;
  effect.calls[0].run(state);
  EXPECT_TRUE(std::isfinite(state.sample.row[0].second));
  EXPECT_TRUE(state.warnings.empty());
  deform(state,
         [](const Vector<2>& x)
         {
           const double apart = x[0] > 0.0 ? 0.0 : x[1] > 0.0 ? 3e-3 : -3e-3;
           return Displacement{{{0.0, apart}}, {0.0, 0.0, 0.0, 0.0}};
         });
  for (int sample = 0; sample < 2; ++sample)
  {
    state.sample.row.clear();
    effect.calls[0].run(state);
    EXPECT_EQ(state.sample.row[0].first, "Notch.0.G_closure");
    EXPECT_FALSE(std::isfinite(state.sample.row[0].second));
    ASSERT_EQ(state.warnings.size(), 1u);
    EXPECT_NE(state.warnings[0].find("G_closure of crack Notch, front 0 is not available"),
              std::string::npos);
  }
}

/// The release rates of an opened crack by each matrix that a scene can choose.
TEST(EnergyRelease, TakesTheMatrixThatTheSceneChooses)
{
  const auto release = [](const std::string& recovery, const Teuchos::ParameterList& matrix)
  {
    State<2> state = makeBody(0.016, 1e-3, Plane::Strain, ShapeKind::Linear);
    const CrackFront<2> front = addFront(state, {{0.0, 0.5e-3}}, 0.0);
    Teuchos::ParameterList scene = sceneWith(5e-3);
    scene.sublist("Energy Release").set("Crack Closure", true);
    scene.sublist("Energy Release").set("Lumped Closure", true);
    scene.sublist("Energy Release").set("Closure Recovery", recovery);
    RunOptions options;
    if (matrix.numParams() > 0)
      mass_matrix::massMatrixEntry().declare(matrix, options);
    const Effect<2> effect = energyReleaseEntry().make2(scene, options);
    effect.atStart(state);
    state.cracks.nodeSide = View<int*>("rhegma::nodeSide", state.mesh.grid.numNodes);
    for (int n = 0; n < state.mesh.grid.numNodes; ++n)
    {
      const Vector<2> from = state.mesh.grid.nodePosition(n) - front.position;
      state.cracks.nodeSide(n) = from[0] < -1e-4 && std::fabs(from[1]) < 2e-3 ? (from[1] > 0.0 ? 1 : -1) : 0;
    }
    deform(state, tipDisplacement(state, front, 1e6, 0.0));
    state.clock.observing = true;
    effect.calls[0].run(state);
    nlohmann::json summary;
    effect.report(state, summary);
    const nlohmann::json& reported = summary["cracks"][0]["fronts"][0];
    return std::make_pair(reported["G_closure"].get<double>(), reported["G_closure_lumped"].get<double>());
  };
  Teuchos::ParameterList none, row, full, partial, series;
  row.set<std::string>("Type", "Lumped");
  full.set<std::string>("Type", "Full");
  full.set("Lumped Fraction", 0.0);
  full.set("Minimum Node Mass", 0.0);
  partial = full;
  partial.set<std::string>("Type", "Partial");
  partial.set("Radius", 1e-9); // no particle
  partial.set("Transition Width", 0.0);
  series.set<std::string>("Type", "FMPM");
  series.set("Order", 1);
  const double consistent = release("Consistent", none).first, lumped = release("Lumped", none).first;
  EXPECT_GT(consistent, 1.05 * lumped);
  EXPECT_EQ(release("Consistent", row).first, consistent);
  EXPECT_EQ(release("Lumped", full).first, lumped);
  EXPECT_EQ(release("Consistent", none).second, lumped);
  EXPECT_EQ(release("Mass Matrix", none).first, lumped);
  EXPECT_EQ(release("Mass Matrix", row).first, lumped);
  EXPECT_EQ(release("Mass Matrix", full).first, consistent);
  EXPECT_NEAR(release("Mass Matrix", partial).first, lumped, 1e-9 * lumped);
  EXPECT_NEAR(release("Mass Matrix", series).first, lumped, 1e-9 * lumped);
}

/// K_I = K_II turns a front clockwise by 2 atan(1/2) = 53.13 degrees, on whichever side +1 lies; the ring of
/// a 1 mm grid gives the ratio to a per cent, and the angle to a quarter of that in radians.
TEST(EnergyRelease, ReportsTheKinkCounterClockwise)
{
  for (const double handed : {1.0, -1.0})
  {
    State<2> state = makeBody(0.01, 1e-3, Plane::Strain, ShapeKind::Linear);
    state.clock.step = 0; // nodes do not move: in the cells the exact field is not in equilibrium
    CrackFront<2> front = addFront(state, {{0.0, 0.0}}, 0.4);
    const DisplacementField field = tipDisplacement(state, front, 2.0, 2.0);
    state.cracks.fronts[0].normal = handed * front.normal;
    const Effect<2> effect = energyReleaseEntry().make2(sceneWith(5e-3));
    effect.atStart(state);
    deform(state, field);
    state.clock.observing = true;
    effect.calls[0].run(state);
    nlohmann::json summary;
    effect.report(state, summary);
    const nlohmann::json& reported = summary["cracks"][0]["fronts"][0];
    EXPECT_NEAR(reported["kink_angle"].get<double>(), -53.1301, 0.2);
    EXPECT_NEAR(reported["tip_offset"].get<double>(), 0.0, 2e-5);
  }
}

/// Crack closure has a column only where it is right.
TEST(EnergyRelease, LeavesOutClosureWhereItDoesNotHold)
{
  const auto hasClosure = [](double angle, bool openingKnown)
  {
    State<2> state = makeBody(0.01, 1e-3, Plane::Strain, ShapeKind::Linear);
    addFront(state, {{0.0, 0.0}}, angle);
    Teuchos::ParameterList scene = sceneWith(5e-3);
    scene.sublist("Energy Release").set("Crack Closure", true);
    RunOptions options;
    options.openingKnown = openingKnown;
    const Effect<2> effect = energyReleaseEntry().make2(scene, options);
    effect.atStart(state);
    state.clock.observing = true;
    effect.calls[0].run(state);
    for (const auto& entry : state.sample.row)
      if (entry.first == "Notch.0.G_closure")
        return true;
    return false;
  };
  EXPECT_TRUE(hasClosure(0.0, true));
  EXPECT_FALSE(hasClosure(0.0, false));
  EXPECT_FALSE(hasClosure(0.6, true));
}
