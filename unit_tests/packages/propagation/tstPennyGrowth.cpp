/// A penny crack that grows, driven by what is prescribed.

#include "Pi.hpp"
#include "cracks/Opening.hpp"
#include "material/RayleighSpeed.hpp"
#include "output/CoreRow.hpp"
#include "packages/propagation/DrivenFronts.hpp"
#include "src/step/ElasticBox.hpp"
#include "state/EnergySums.hpp"
#include "transfer/FacePoints.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

using namespace Rhegma;
using namespace Rhegma::Test;

namespace
{

using Reals = Teuchos::Array<double>;

Reals reals(const std::vector<double>& values) { return Reals(values.begin(), values.end()); }

using Rhegma::Test::pi;
constexpr double cell = 1e-3, radius = 3e-3, half = 8e-3, stress = 2e6;
const ElasticSolid solid;

/// A quarter of a penny crack in a block that is stretched across it from the start, and held.
Teuchos::ParameterList quarter(const std::string& toughness)
{
  Teuchos::ParameterList scene = elasticBox<3>(Vector<3>{0.0, 0.0, -4.0 * cell},
                                               Vector<3>{half, half, 4.0 * cell}, cell, 2.0, solid, "Block");
  for (const char* axis : {"x", "y"})
  {
    Teuchos::ParameterList& mirror = scene.sublist("Boundaries").sublist(axis);
    mirror.set("Type", std::string("Symmetry"));
    mirror.set("Axis", std::string(axis));
    mirror.set("Position", 0.0);
  }
  Teuchos::ParameterList& crack = scene.sublist("Cracks").sublist("Penny");
  crack.set("Centre", reals({0.0, 0.0, 0.3 * cell}));
  crack.set("Normal", reals({0.0, 0.0, 1.0}));
  crack.set("Radius", radius);
  scene = validated(scene);
  // Nothing measures what drives the front: the test says it.
  Teuchos::ParameterList& propagation = scene.sublist("Propagation");
  propagation.set("Toughness", toughness);
  propagation.set("Direction", std::string("Straight"));
  propagation.set("Increment", 1.0);
  propagation.set("Start Time", 0.0);
  return scene;
}

/// Pulls the particles apart evenly.
void stretch(State<3>& state, double rate)
{
  const auto x = onHost(state.particles.real<3>(fields::position));
  const auto v = state.particles.real<3>(fields::velocity);
  const auto host = onHost(v);
  for (int p = 0; p < state.particles.size(); ++p)
    host(p, 2) = rate * x(p, 2);
  Kokkos::deep_copy(v, host);
}

/// Drives the front so that it runs at `speed` by a toughness of 100 (1 + v / 100) J/m2 until it has a
/// radius.
void drive(State<3>& state, double speed, double until, double fromAngle = -1.0)
{
  for (FrontNode<3>& frontNode : state.cracks.fronts[0].nodes)
  {
    const double at = std::hypot(frontNode.position[0], frontNode.position[1]);
    const bool driven = at < until && std::atan2(frontNode.position[1], frontNode.position[0]) > fromAngle;
    frontNode.driving.release = driven ? 100.0 * (1.0 + speed / 100.0) : 0.0;
  }
}

nlohmann::json report(const Rhegma::Run<3>& run)
{
  nlohmann::json summary;
  for (const Effect<3>& effect : run.plan().effects)
    if (effect.report)
      effect.report(run.state(), summary);
  return summary;
}

/// A column of the last sample.
double sampled(const State<3>& state, const std::string& name)
{
  for (const auto& [column, value] : state.sample.row)
    if (column == name)
      return value;
  ADD_FAILURE() << "no column " << name;
  return -1.0;
}

/// How far the faces overlap at the worst of their vertices, along the crack's normal [m].
double overlap(const State<3>& state)
{
  const auto face = onHost(state.cracks.face);
  double worst = 0.0;
  for (std::size_t v = 0; v < face.extent(0); ++v)
    worst = std::max(worst, face(v, 0, 2) - face(v, 1, 2));
  return worst;
}

/// Overlap of a crack that has grown by two cells and is squeezed then.
double overlapWhenSqueezed(bool touching, double rate)
{
  Teuchos::ParameterList scene = quarter("100*(1 + v/100)");
  if (touching)
  {
    Teuchos::ParameterList& contact = scene.sublist("Contact");
    contact.set("Law", std::string("Frictionless"));
    contact.set("Penalty", 2.0);
  }
  Rhegma::Run<3> run(scene, drivenByTest<3>());
  run.initialize();
  State<3>& state = run.state();
  stretch(state, 200.0);
  for (int k = 0; k < 80; ++k)
  {
    drive(state, 400.0, 5e-3);
    run.step(1.0, false);
  }
  EXPECT_GT(
      std::hypot(state.cracks.fronts[0].nodes[0].position[0], state.cracks.fronts[0].nodes[0].position[1]),
      4.5e-3);
  stretch(state, -rate);
  double worst = 0.0;
  for (const double begin = state.clock.time; state.clock.time < begin + 1e-5;)
  {
    run.step(1.0, false);
    worst = std::max(worst, overlap(state));
  }
  return worst;
}

} // namespace

/// A front whose driving force is prescribed runs at the speed at which the toughness is as large; it stays
/// round and flat, and the nodes that it has passed take the energy of its new faces: what their forces have
/// spent and what these still hold is what was recorded, which is area times toughness.
TEST(PennyGrowth, RunsAsItsToughnessSaysAndPaysForItsArea)
{
  const double speed = 400.0, until = 6e-3;
  Rhegma::Run<3> run(quarter("100*(1 + v/100)"), drivenByTest<3>());
  run.initialize();
  State<3>& state = run.state();
  ASSERT_EQ(state.cracks.fronts.size(), 1u);
  const double before = cracks::measureOpening(state.cracks, 0).size;
  stretch(state, 1e3);
  measureEnergy(state);
  double begin = -1.0, end = -1.0;
  FacePoints<3> points;
  for (int k = 0; k < 150; ++k)
  {
    drive(state, speed, until);
    run.step(1.0, false);
    points.update(state);
    const FrontNode<3>& middle = state.cracks.fronts[0].nodes[state.cracks.fronts[0].nodes.size() / 2];
    const double at = std::hypot(middle.position[0], middle.position[1]);
    if (begin < 0.0 && at > radius + 0.5 * cell)
      begin = state.clock.time;
    if (end < 0.0 && at > until - 0.5 * cell)
      end = state.clock.time;
  }
  ASSERT_GT(end, begin);
  // Increments are a quarter of a cell, so begin and end are late by up to one and the path is 2 cells.
  EXPECT_NEAR((until - radius - cell) / (end - begin), speed, 0.13 * speed);
  const CrackFront<3>& front = state.cracks.fronts[0];
  const double area = cracks::measureOpening(state.cracks, 0).size - before;
  EXPECT_NEAR(area, 0.25 * pi * (until * until - radius * radius), 0.1 * area);
  // The first increment of each front node is that of a front at rest.
  const double first = 0.25 * pi * (std::pow(radius + 0.25 * cell, 2) - radius * radius);
  EXPECT_NEAR(front.budget.required, 100.0 * ((1.0 + speed / 100.0) * area - speed / 100.0 * first),
              0.02 * front.budget.required);
  for (const FrontNode<3>& s : front.nodes)
  {
    EXPECT_NEAR(s.position[2], 0.3 * cell, 0.1 * cell);
    EXPECT_NEAR(std::hypot(s.position[0], s.position[1]), until, 0.05 * until + 0.25 * cell);
  }
  // Points on the faces stand for the new ones too, as large as those have become by stretching; the last row
  // of triangles alone is a third of the area. Since they were placed the body has strained by 2e-3.
  const auto size = onHost(points.size);
  double all = 0.0;
  for (int k = 0; k < points.count(); ++k)
    all += size(k);
  EXPECT_NEAR(all, before + area, 0.01 * area);
  const double inFlight = report(run)["energy_in_flight"];
  EXPECT_GT(state.energy.fracture, 0.0);
  EXPECT_NEAR(state.energy.fracture + inFlight, front.budget.required, 0.01 * front.budget.required);
}

/// A front of which one half is initiated and the other never does: nodes that it opens next to front nodes
/// that have made no face resist as those next to the others do. What was recorded is spent or in flight. The
/// pending energy depends on where the front stands between them, here at five positions within a cell: up to
/// half a row of cells along the stretch that runs, since a node opens with all its area as the front passes
/// its middle.
TEST(PennyGrowth, PaysForItsAreaWhereHalfOfItSetsOut)
{
  for (const double until : {4.6e-3, 4.8e-3, 5.0e-3, 5.2e-3, 5.4e-3})
  {
    Rhegma::Run<3> run(quarter("100*(1 + v/100)"), drivenByTest<3>());
    run.initialize();
    State<3>& state = run.state();
    stretch(state, 1e3);
    measureEnergy(state);
    for (int k = 0; k < 110; ++k)
    {
      drive(state, 400.0, until, 0.25 * pi);
      run.step(1.0, false);
    }
    const CrackFront<3>& front = state.cracks.fronts[0];
    EXPECT_FALSE(front.ended);
    ASSERT_GT(front.budget.required, 0.0);
    const double inFlight = report(run)["energy_in_flight"];
    EXPECT_NEAR(state.energy.fracture + inFlight, front.budget.required, 0.01 * front.budget.required);
    const double row = 500.0 * cell * 0.25 * pi * until;
    std::cout << "until " << until / cell << " cells: pending "
              << front.budget.pending / front.budget.required << " of what was required, "
              << front.budget.pending / row << " of a row\n";
    EXPECT_LT(std::fabs(front.budget.pending), 0.5 * row);
  }
}

/// A front that runs to the surface and ends there: the nodes that its last faces open have a traction too,
/// and release the pending energy, to the hundredth to which the energies agree.
TEST(PennyGrowth, PaysForItsAreaToTheEnd)
{
  Rhegma::Run<3> run(quarter("100*(1 + v/100)"), drivenByTest<3>());
  run.initialize();
  State<3>& state = run.state();
  stretch(state, 1e3);
  measureEnergy(state);
  const double before = cracks::measureOpening(state.cracks, 0).size;
  for (int k = 0; k < 400 && !state.cracks.fronts[0].ended; ++k)
  {
    drive(state, 400.0, 1.0);
    run.step(1.0, false);
  }
  ASSERT_TRUE(state.cracks.fronts[0].ended);
  const nlohmann::json ended = report(run)["cracks"][0]["fronts"][0];
  for (int k = 0; k < 5; ++k)
    run.step(1.0, false);
  const CrackFront<3>& front = state.cracks.fronts[0];
  const nlohmann::json summary = report(run);
  const double inFlight = summary["energy_in_flight"], area = half * half - before;
  EXPECT_NEAR(front.budget.required, 500.0 * area, 0.1 * front.budget.required);
  EXPECT_NEAR(state.energy.fracture + inFlight, front.budget.required, 0.01 * front.budget.required);
  std::cout << "pending " << front.budget.pending / front.budget.required << " of what was required, all "
            << (state.energy.fracture + inFlight) / front.budget.required << "\n";
  EXPECT_LT(std::fabs(front.budget.pending), 0.01 * front.budget.required);
  // What it has done is known after its front nodes are no more.
  const nlohmann::json& entry = summary["cracks"][0]["fronts"][0];
  EXPECT_GT(entry["increments"].get<long>(), 0);
  EXPECT_GT(entry["last_advance"].get<double>(), entry["initiated"].get<double>());
  for (const char* name : {"increments", "initiated", "last_advance", "settled_speed", "speed_limit"})
    EXPECT_EQ(entry[name], ended[name]) << name;
  EXPECT_NEAR(entry["speed_limit"].get<double>(), rayleighSpeed(state.materials.properties[0]), 1e-9);
}

/// A crack like a C, whose arms grow towards each other: a front that meets itself. It stops before they are
/// three cells apart, which is reported once, and no energy is lost.
TEST(PennyGrowth, StopsBeforeItsOwnFaces)
{
  const double wide = 12.0 * cell, z = 0.3 * cell, arm = 2.2 * cell, other = wide - arm;
  Teuchos::ParameterList scene = quarter("100*(1 + v/100)");
  scene.sublist("Domain").set("Upper Corner", reals({wide + 2.0 * cell, wide + 2.0 * cell, 6.0 * cell}));
  scene.sublist("Bodies").sublist("Block").set("Upper Corner", reals({wide, wide, 4.0 * cell}));
  Teuchos::ParameterList& crack = scene.sublist("Cracks").sublist("Penny");
  for (const char* name : {"Centre", "Normal", "Radius"})
    crack.remove(name);
  const double low = -cell, high = wide + cell, spine = 1.2 * cell;
  crack.set("Points", reals({low,   low,   z, high, low,   z, high, arm,  z, spine, arm,  z,
                             spine, other, z, high, other, z, high, high, z, low,   high, z}));
  Rhegma::Run<3> run(scene, drivenByTest<3>());
  run.initialize();
  State<3>& state = run.state();
  ASSERT_EQ(state.cracks.fronts.size(), 1u);
  stretch(state, 1e3);
  const double before = cracks::measureOpening(state.cracks, 0).size;
  for (int k = 0; k < 80; ++k)
  {
    for (FrontNode<3>& frontNode : state.cracks.fronts[0].nodes) // the spine stays where it is
      frontNode.driving.release = std::fabs(frontNode.direction[1]) > 0.9 ? 500.0 : 0.0;
    run.step(1.0, false);
  }
  const CrackFront<3>& front = state.cracks.fronts[0];
  int reported = 0, arms = 0;
  for (const std::string& warning : state.warnings)
    reported +=
        warning.find("stopped less than three cells from faces of its own crack") != std::string::npos;
  EXPECT_EQ(reported, 1);
  double below = 0.0, above = wide;
  for (const FrontNode<3>& frontNode : front.nodes)
    if (frontNode.position[0] > 0.5 * wide)
    {
      ++arms;
      EXPECT_TRUE(frontNode.stopped);
      const bool upper = frontNode.position[1] > 0.5 * wide;
      below = upper ? below : std::max(below, frontNode.position[1]);
      above = upper ? std::min(above, frontNode.position[1]) : above;
    }
  EXPECT_GE(arms, 8);
  // Both have gone at least a cell of the 2.3 that they may, a quarter at a time.
  EXPECT_GT(below, arm + cell);
  EXPECT_LT(above, other - cell);
  EXPECT_GT(above - below, 2.5 * cell);
  EXPECT_GT(cracks::measureOpening(state.cracks, 0).size, before + wide * cell);
  EXPECT_TRUE(std::isfinite(front.budget.required) && front.budget.required > 0.0);
  // A part of the front has stopped: what is said of it has both numbers, and is not "arrested".
  const nlohmann::json summary = report(run), entry = summary["cracks"][0]["fronts"][0];
  ASSERT_LT(front.numStopped(), static_cast<int>(front.nodes.size()));
  const std::string part =
      std::to_string(front.numStopped()) + " of " + std::to_string(front.nodes.size()) + " front nodes";
  EXPECT_EQ(entry["status"],
            "stopped in part, " + part + ": less than three cells from faces of its own crack");
  EXPECT_TRUE(entry["stopped"].get<bool>());
  EXPECT_EQ(entry["stop"]["nodes"], front.numStopped());
  EXPECT_EQ(entry["stop"]["of_nodes"], front.nodes.size());
  EXPECT_EQ(entry["stop"]["node_positions"].size(), static_cast<std::size_t>(front.numStopped()));
  EXPECT_GE(entry["stop"]["G"].get<double>(), entry["stop"]["toughness"].get<double>());
  const std::string line = summary["answers"][0], ended = summary["ended_by"];
  for (const std::string& text : {line, ended})
  {
    EXPECT_NE(text.find(part + " stopped less than three cells"), std::string::npos) << text;
    EXPECT_NE(text.find("G = 500 J/m2 for Gc = "), std::string::npos) << text;
    EXPECT_EQ(text.find(" arrested at"), std::string::npos) << text;
  }
  EXPECT_NE(ended.find("On Stop = Continue"), std::string::npos) << ended;
  // The history has the fraction of nodes, and the run ends with that sample.
  EXPECT_FALSE(state.clock.ended());
  run.step(1.0, true);
  EXPECT_TRUE(state.clock.ended());
  EXPECT_DOUBLE_EQ(sampled(state, "Penny.0.stopped"),
                   double(state.cracks.fronts[0].numStopped()) / double(state.cracks.fronts[0].nodes.size()));
}

/// With On Stop = Continue the run goes on beyond the sample with the first stopped node. Nodes of which J
/// can't be computed stop, as it is not known whether they advance.
TEST(PennyGrowth, StopsNodesWithoutAContour)
{
  Teuchos::ParameterList scene = quarter("100*(1 + v/100)");
  scene.sublist("Propagation").set("On Stop", std::string("Continue"));
  Rhegma::Run<3> run(scene, drivenByTest<3>());
  run.initialize();
  State<3>& state = run.state();
  stretch(state, 1e3);
  for (int k = 0; k < 20; ++k)
  {
    drive(state, 400.0, 5e-3);
    if (k == 10)
      for (FrontNode<3>& node : state.cracks.fronts[0].nodes)
        node.driving.lost = node.position[1] > node.position[0];
    run.step(1.0, k == 19);
  }
  const CrackFront<3>& front = state.cracks.fronts[0];
  EXPECT_GT(front.numStopped(), 2);
  EXPECT_LT(front.numStopped(), static_cast<int>(front.nodes.size()));
  int reported = 0;
  for (const std::string& warning : state.warnings)
    reported += warning.find("a front node stopped with no material left in the domain of its J integral, "
                             "G is not known, it was last 500 J/m2") != std::string::npos;
  EXPECT_EQ(reported, 1);
  const nlohmann::json summary = report(run), entry = summary["cracks"][0]["fronts"][0];
  EXPECT_EQ(entry["status"].get<std::string>().rfind("stopped in part, ", 0), 0u) << entry["status"];
  EXPECT_FALSE(summary.contains("ended_by"));
  EXPECT_FALSE(state.clock.ended());
  EXPECT_GT(sampled(state, "Penny.0.stopped"), 0.0);
  EXPECT_LT(sampled(state, "Penny.0.stopped"), 1.0);
}

/// A front is arrested only where G is below the toughness everywhere along it. How far it went is said: of
/// the node that advanced most, in the mean, and its new area.
TEST(PennyGrowth, IsArrestedOnlyWhereGIsBelowTheToughnessEverywhere)
{
  Rhegma::Run<3> run(quarter("100*(1 + v/100)"), drivenByTest<3>());
  run.initialize();
  State<3>& state = run.state();
  stretch(state, 1e3);
  const double before = cracks::measureOpening(state.cracks, 0).size;
  for (int k = 0; k < 110; ++k)
  {
    drive(state, 400.0, 4.5e-3, 0.25 * pi);
    run.step(1.0, false);
  }
  CrackFront<3>& front = state.cracks.fronts[0];
  const nlohmann::json summary = report(run), entry = summary["cracks"][0]["fronts"][0];
  EXPECT_EQ(entry["status"], "arrested");
  const std::string line = summary["answers"][0];
  EXPECT_NE(line.find("arrested at t = "), std::string::npos) << line;
  EXPECT_NE(line.find(" at most, "), std::string::npos) << line;
  EXPECT_NE(line.find(" on average, new area "), std::string::npos) << line;
  const double area = cracks::measureOpening(state.cracks, 0).size - before;
  EXPECT_NEAR(entry["new_area"].get<double>(), area,
              0.01 * area); // the body strains the faces that are there
  const double largest = entry["largest_advance"], mean = entry["mean_advance"];
  EXPECT_NEAR(largest, 1.5e-3, 0.3 * cell);
  EXPECT_NEAR(mean, 0.5 * largest, 0.15 * largest); // half of the front never ran
  front.nodes[0].driving.release = 1000.0;
  const nlohmann::json other = report(run);
  EXPECT_EQ(other["cracks"][0]["fronts"][0]["status"], "at rest");
  EXPECT_EQ(other["answers"][0].get<std::string>().find("arrested"), std::string::npos);
}

/// With Contact new faces that are pressed together hold against each other: the layer between them gives by
/// the pressure over its stiffness, penalty times M / cell, so by the strain times half a cell; the pressure
/// of the squeeze is at most twice that of the strain, where waves meet. Without, they pass through each
/// other.
TEST(PennyGrowth, NewFacesTouchWithContact)
{
  const double rate = 2000.0, with = overlapWhenSqueezed(true, rate),
               without = overlapWhenSqueezed(false, rate);
  std::cout << "overlap " << with / cell << " cells with contact, " << without / cell << " without\n";
  EXPECT_LT(with, 2.0 * rate * 1e-5 * 0.5 * cell);
  EXPECT_GT(without, 2.0 * with);
}
