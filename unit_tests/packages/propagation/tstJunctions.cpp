/// A crack that runs into the face of another.

#include "packages/propagation/JunctionScenes.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

using namespace Rhegma;
using namespace Rhegma::Test;

namespace
{

/// Beam runs to the left until it joins Roof, which rises at 35 degrees to the path of Wall. Wall then has
/// Beam 4.2 cells ahead and behind that Roof, to which it comes nearer than three cells first.
constexpr double tip = 15.3e-3, beam = tip + 4.2 * cell;
void cutBelowABeam(Teuchos::ParameterList& scene)
{
  addLoad(scene, "Left", {0.0, 20.0 * cell}, {0.0, 0.0}, {-pull, 0.0});
  addLoad(scene, "Right", {size, 0.0}, {size, 20.0 * cell}, {pull, 0.0});
  const double wall = 20.3e-3, slope = std::tan(35.0 * M_PI / 180.0), crossing = tip + 5.9 * cell;
  const auto roofAt = [&](double y) { return wall + slope * (y - crossing); };
  Teuchos::ParameterList& cracks = scene.sublist("Cracks");
  cracks.sublist("Roof").set("Points", reals({roofAt(3e-3), 3e-3, roofAt(30e-3), 30e-3}));
  cracks.sublist("Beam").set("Points", reals({size, beam, wall + 2.6 * cell, beam}));
  cracks.sublist("Wall").set("Points", reals({wall, 0.0, wall, tip}));
}

/// Wall is about to advance by four cells; an earlier part of it lies across its path, and Roof behind that.
constexpr double earlier = 16.8e-3;
void cutBelowItself(Teuchos::ParameterList& scene)
{
  cutACorner(scene);
  scene.sublist("Cracks").sublist("Wall").set(
      "Points", reals({8e-3, earlier, 24e-3, earlier, 24e-3, 7e-3, wall, 7e-3, wall, tip}));
}

/// The same as the first, but Roof is in a body of its own, a cell above the one in which Wall runs.
void cutBelowAGap(Teuchos::ParameterList& scene)
{
  addLoad(scene, "Left", {0.0, 18.0 * cell}, {0.0, 0.0}, {-pull, 0.0});
  addLoad(scene, "Right", {size, 0.0}, {size, 18.0 * cell}, {pull, 0.0});
  Teuchos::ParameterList& bodies = scene.sublist("Bodies");
  Teuchos::ParameterList& cover = bodies.sublist("Cover");
  cover = bodies.sublist("Plate");
  bodies.sublist("Plate").set("Upper Corner", reals({size, 18.0 * cell}));
  cover.set("Lower Corner", reals({0.0, 19.0 * cell}));
  Teuchos::ParameterList& cracks = scene.sublist("Cracks");
  cracks.sublist("Roof").set("Points", reals({0.0, roof, 30e-3, roof}));
  cracks.sublist("Wall").set("Points", reals({wall, 0.0, wall, 10e-3}));
}

/// Momentum along an axis of what was in a part of the plate [kg m/s].
template <class Part>
double momentum(const State<2>& state, int axis, const Part& part)
{
  const auto host = [](const auto& view) { return onHost(view); };
  const auto x = host(state.particles.real<2>(fields::reference));
  const auto v = host(state.particles.real<2>(fields::velocity));
  const auto m = host(state.particles.scalar(fields::mass));
  double sum = 0.0;
  for (int p = 0; p < state.particles.size(); ++p)
    if (part(x(p, 0), x(p, 1)))
      sum += m(p) * v(p, axis);
  return sum;
}

/// Force on such a part over 20 us, from when its faces are open [N]. \param open how long that takes [s]
template <class Part>
double forceOn(Rhegma::Run<2>& run, int axis, double open, const Part& part)
{
  const State<2>& state = run.state();
  for (const double joined = state.clock.time; state.clock.time < joined + open;)
    run.step(1.0, false);
  const double begin = state.clock.time, before = momentum(state, axis, part);
  while (state.clock.time < begin + 2e-5)
    run.step(1.0, false);
  return (momentum(state, axis, part) - before) / (state.clock.time - begin);
}

} // namespace

/// The crack ends on the face of the other, and its new faces require its toughness times the whole path.
TEST(Junctions, CrackEndsOnTheFaceOfTheOther)
{
  Piece piece = runWall(cutACorner);
  State<2>& state = piece.run.state();
  ASSERT_GE(piece.front, 0);
  const CrackFront<2>& front = state.cracks.fronts[piece.front];
  ASSERT_TRUE(front.ended);
  EXPECT_FALSE(front.stopped());
  EXPECT_EQ(front.speed(), 0.0);
  EXPECT_NEAR(front.position[0], wall, 0.1 * cell);
  EXPECT_NEAR(front.position[1], roof, 0.1 * cell);
  ASSERT_FALSE(state.warnings.empty());
  EXPECT_NE(state.warnings.back().find("joined crack Roof"), std::string::npos) << state.warnings.back();
  // The first increment is that of a front at rest.
  const double length = roof - 10e-3;
  EXPECT_NEAR(front.budget.required, 5.0 * (length - cell) + 1.0 * cell, 0.02 * front.budget.required);
  while (state.clock.time < piece.joined + 1e-5)
    piece.run.step(1.0, false);
  nlohmann::json summary;
  for (const Effect<2>& effect : piece.run.plan().effects)
    if (effect.report)
      effect.report(piece.run.state(), summary);
  const double inFlight = summary["energy_in_flight"];
  std::cout << "spent " << state.energy.fracture / front.budget.required << ", in flight "
            << inFlight / front.budget.required << "\n";
  EXPECT_NEAR(state.energy.fracture + inFlight, front.budget.required, 0.02 * front.budget.required);
}

/// No crack joins another through the gap between two bodies: it ends at the surface of its own.
TEST(Junctions, NoneAcrossAGap)
{
  Piece piece = runWall(cutBelowAGap);
  const State<2>& state = piece.run.state();
  ASSERT_GE(piece.joined, 0.0);
  EXPECT_NEAR(state.cracks.fronts[piece.front].position[1], 18.0 * cell, 0.5 * cell);
  ASSERT_FALSE(state.warnings.empty());
  EXPECT_NE(state.warnings.back().find("reached the surface"), std::string::npos) << state.warnings.back();
}

/// The piece that the two cracks cut out is free: once the faces are open it is pulled by the load on its
/// edge alone, force times time, and nothing holds it at the junction.
TEST(Junctions, PieceThatIsCutOutIsFree)
{
  Piece piece = runWall(cutACorner);
  ASSERT_GE(piece.joined, 0.0);
  const double load = -pull * 20.0 * cell,
               force = forceOn(piece.run, 0, 1.5e-5, [](double x, double y) { return x < wall && y < roof; });
  std::cout << "force on the piece " << force / load << " of the load on its edge\n";
  // A cell of material at the junction would transmit up to a twentieth.
  EXPECT_NEAR(force / load, 1.0, 0.02);
}

/// Round a junction stencils are not linearly complete. Heat that flows there, from a piece of one
/// temperature to those next to it, is all kept even so.
TEST(Junctions, KeepHeat)
{
  const double density = 1200.0, capacity = 1000.0, diffusivity = 0.5;
  Piece piece = runWall(
      [&](Teuchos::ParameterList& scene)
      {
        cutACorner(scene);
        Teuchos::ParameterList& material = scene.sublist("Materials").sublist("Solid");
        material.set("Specific Heat", capacity);
        material.set("Conductivity", diffusivity * density * capacity);
        scene.sublist("Thermal").set("Initial Temperature", 300.0);
      });
  ASSERT_GE(piece.joined, 0.0);
  const State<2>& state = piece.run.state();
  const auto x = state.particles.real<2>(fields::position);
  const auto T = state.particles.scalar(fields::temperature),
             e = state.particles.scalar(fields::internalEnergy);
  const auto volume = state.particles.scalar(fields::volume);
  const auto host = [](const auto& view) { return onHost(view); };
  const auto wall = host(x);
  const auto warm = host(T), energy = host(e);
  for (int p = 0; p < state.particles.size(); ++p)
  {
    // Rises towards the junction, so that gradients are there too.
    const double rise = 1e3 * (wall(p, 0) + wall(p, 1)) * (wall(p, 1) < roof ? 1.0 : 0.2);
    warm(p) += rise;
    energy(p) += density * capacity * rise;
  }
  Kokkos::deep_copy(T, warm);
  Kokkos::deep_copy(e, energy);
  // Modulus and expansion do not depend on the temperature: conduction alone.
  const auto heat = [&](const auto& temperature)
  {
    const auto now = host(temperature), V = host(volume);
    double sum = 0.0;
    for (int p = 0; p < state.particles.size(); ++p)
      sum += density * capacity * V(p) * (now(p) - 300.0);
    return sum;
  };
  const double before = heat(T);
  for (int s = 0; s < 50; ++s)
    piece.run.step(1.0, false);
  const double after = heat(T), made = after - before;
  std::cout << "heat made at a junction over that which is there: " << made / before << "\n";
  EXPECT_NEAR(made, 0.0, 1e-11 * before);
}

/// Two fronts that meet end at one position, and their cracks part the plate as one would.
TEST(Junctions, FrontsThatMeetPartThePlate)
{
  Piece piece = runWall(cutInTwo);
  ASSERT_GE(piece.joined, 0.0);
  const State<2>& state = piece.run.state();
  ASSERT_EQ(state.cracks.fronts.size(), 2u);
  for (const CrackFront<2>& front : state.cracks.fronts)
  {
    EXPECT_TRUE(front.ended);
    EXPECT_NEAR(front.position[0], 15e-3, 0.1 * cell);
  }
  // The halves part along the whole plate, and waves come and go: up to 100 us the force swings by up to a
  // tenth. A cell of material would hold them for good.
  const double load = pull * size,
               force = forceOn(piece.run, 1, 1e-4, [](double, double y) { return y > roof; });
  std::cout << "force on the upper half " << force / load << " of the load on its edge\n";
  EXPECT_NEAR(force / load, 1.0, 1e-3);
}

/// A crack ends on the first of two cracks in its path, though the second is nearer.
TEST(Junctions, CrackEndsOnTheFirstCrackInItsPath)
{
  Rhegma::Run<2> run(plate(cutBelowABeam), drivenByTest<2>());
  run.initialize();
  State<2>& state = run.state();
  const auto runs = [&](const std::string& name) -> const CrackFront<2>&
  {
    auto& fronts = state.cracks.fronts;
    const auto front =
        std::find_if(fronts.begin(), fronts.end(),
                     [&](const CrackFront<2>& one) { return state.cracks.cracks[one.crack].name == name; });
    for (const double begin = state.clock.time;
         state.clock.time < begin + 5e-5 && !front->ended && !front->stopped();)
    {
      front->nodes[0].driving.release = 1.0 + speed / 100.0;
      run.step(1.0, false);
    }
    return *front;
  };
  ASSERT_TRUE(runs("Beam").ended);
  const CrackFront<2>& front = runs("Wall");
  EXPECT_TRUE(front.ended);
  EXPECT_NEAR(front.position[1], beam, 0.1 * cell);
  EXPECT_TRUE(std::any_of(state.warnings.begin(), state.warnings.end(),
                          [](const std::string& warning)
                          { return warning.find("joined crack Beam") != std::string::npos; }));
}

/// An earlier part of its own, before another crack, stops it.
TEST(Junctions, CrackDoesNotCrossItself)
{
  Piece piece = runWall(cutBelowItself, 4.0);
  const CrackFront<2>& front = piece.run.state().cracks.fronts[piece.front];
  EXPECT_TRUE(front.stopped());
  EXPECT_LT(front.position[1], earlier);
}
