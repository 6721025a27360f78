#include "CubeScene.hpp"

#include "cracks/CrackGeometry.hpp"
#include "cracks/Opening.hpp"
#include "state/EnergySums.hpp"
#include "transfer/Stencils.hpp"

#include <algorithm>

using namespace Rhegma;
using namespace Rhegma::cracks;
using namespace Rhegma::cracks::test;

namespace
{

/// A double cantilever beam of width w (0: 2D) between two mirrors, pulled at its ends.
Teuchos::ParameterList slab(double w)
{
  const bool flat = w == 0.0;
  // at a third of a degree to the cells: along them the springs of 2D have a law of their own
  const double end = 0.00405;
  Teuchos::ParameterList scene =
      blockScene(flat ? std::vector<double>{0.02, 0.008} : std::vector<double>{0.02, 0.008, w});
  setCrack(scene, flat ? std::vector<double>{0.0, 0.004, 0.009, end}
                       : std::vector<double>{0.0, 0.004, w, 0.009, end, w, 0.009, end, 0.0, 0.0, 0.004, 0.0});
  Teuchos::ParameterList& loads = scene.sublist("Boundaries");
  for (const double sign : {1.0, -1.0})
  {
    Teuchos::ParameterList& load = loads.sublist(sign > 0.0 ? "Up" : "Down");
    load.set("Type", std::string("Traction"));
    load.set("Body", std::string("Block"));
    const double low = sign > 0.0 ? 0.004 : 0.0, high = low + 0.004;
    if (flat)
    {
      load.set("From", numbers({0.0, high}));
      load.set("To", numbers({0.0, low}));
      load.set("Stress", numbers({0.0, sign * 1e5}));
    }
    else
    {
      load.set("Corner", numbers({0.0, low, 0.0}));
      load.set("Edge 1", numbers({0.0, 0.0, w}));
      load.set("Edge 2", numbers({0.0, 0.004, 0.0}));
      load.set("Stress", numbers({0.0, sign * 1e5, 0.0}));
    }
  }
  if (!flat)
    for (const double at : {0.0, w})
    {
      Teuchos::ParameterList& mirror = loads.sublist(at == 0.0 ? "Front" : "Back");
      mirror.set("Type", std::string("Symmetry"));
      mirror.set("Axis", std::string("z"));
      mirror.set("Position", at);
      mirror.set("Side", std::string(at == 0.0 ? "Lower" : "Upper"));
    }
  return scene;
}

template <int D>
void advance(Run<D>& run, int steps, double dt)
{
  for (int k = 1; k <= steps; ++k)
    run.step(run.state().clock.time + dt, k == steps);
  measureEnergy(run.state());
}

Teuchos::ParameterList crackedCube()
{
  Teuchos::ParameterList scene = blockScene({8e-3, 8e-3, 8e-3});
  setCrack(scene, regularPolygon({4.2e-3, 3.9e-3, 4.3e-3}, 2.4e-3, 16));
  return scene;
}

std::string refusal(const std::vector<double>& points, const std::vector<int>& fronts = {})
{
  Teuchos::ParameterList scene = crackedCube();
  setCrack(scene, points);
  if (!fronts.empty())
    scene.sublist("Cracks").sublist("Cut").set("Front Edges",
                                               Teuchos::Array<int>(fronts.begin(), fronts.end()));
  std::vector<SceneError> errors;
  validateList(scene, effectSchema(), errors);
  if (!errors.empty())
    return toString(errors.front());
  try
  {
    Run<3>(scene).initialize();
  }
  catch (const std::invalid_argument& wrong)
  {
    return wrong.what();
  }
  return "";
}

} // namespace

/// Between two mirrors a slab is in plane strain, so both dimensions compute the same numbers in a different
/// order of sums. Directions of a crack at an angle to the cells are found from other points in 3D: they
/// differ by 4e-6, and with them the stiffness of front springs.
TEST(Cracks3D, MakeASlabBehaveAsItsPlane)
{
  const double width = 2e-3;
  const auto plane = start<2>(slab(0.0));
  const auto solid = start<3>(slab(width));
  const double dt = 0.5 * solid->stableTimeStep();
  advance(*plane, 200, dt);
  advance(*solid, 200, dt);
  const State<2>& a = plane->state();
  const State<3>& b = solid->state();
  ASSERT_GT(a.energy.strain, 0.0);
  const double turned = 1e-5;
  EXPECT_NEAR(b.energy.strain / width, a.energy.strain, turned * a.energy.strain);
  EXPECT_NEAR(b.energy.kinetic / width, a.energy.kinetic, turned * a.energy.kinetic);
  EXPECT_NEAR(b.energy.externalWork / width, a.energy.externalWork, turned * a.energy.externalWork);
  const Opening line = measureOpening(a.cracks, 0), face = measureOpening(b.cracks, 0);
  ASSERT_GT(line.largest, 1e-7);
  EXPECT_NEAR(face.largest, line.largest, turned * line.largest);
  ASSERT_EQ(b.cracks.fronts.size(), 1u);
  ASSERT_EQ(a.cracks.fronts.size(), 1u);
  EXPECT_NEAR(b.cracks.fronts[0].length, width, 1e-9 * width);
  for (int d = 0; d < 2; ++d)
  {
    EXPECT_NEAR(b.cracks.fronts[0].position[d], a.cracks.fronts[0].position[d], 1e-12);
    EXPECT_NEAR(b.cracks.fronts[0].direction[d], a.cracks.fronts[0].direction[d], turned);
    EXPECT_NEAR(b.cracks.fronts[0].normal[d], a.cracks.fronts[0].normal[d], turned);
  }
}

/// Each side's functions reproduce linear fields, so a rigid turn strains no particle: of every stored
/// stencil the weights add up to 1, the positions of the nodes to the particle's, and their products with
/// slopes to 1.
TEST(Cracks3D, CutFunctionsThatReproduceLinearFields)
{
  const auto run = start<3>(crackedCube());
  advance(*run, 1, 1e-9);
  State<3>& state = run->state();
  storeStencils(state);
  const auto host = [](const auto& view) { return onHost(view); };
  const auto particle = host(state.stored.particle), count = host(state.stored.table.count);
  const auto node = host(state.stored.table.node);
  const auto weight = host(state.stored.table.weight);
  const auto slope = host(state.stored.table.slope);
  const auto parent = host(state.mesh.nodes.parent);
  const auto x = host(state.particles.real<3>(fields::position));
  int second = 0;
  ASSERT_GT(state.stored.count, 0);
  for (int r = 0; r < state.stored.count; ++r)
  {
    double sum = 0.0, mean[3] = {0.0, 0.0, 0.0}, gradient[3][3] = {};
    for (int k = 0; k < count(r); ++k)
    {
      const bool isSecond = node(r, k) >= state.mesh.nodes.numLattice;
      second += isSecond ? 1 : 0;
      const Vector<3> at = state.mesh.grid.nodePosition(
          isSecond ? parent(node(r, k) - state.mesh.nodes.numLattice) : node(r, k));
      sum += weight(r, k);
      for (int i = 0; i < 3; ++i)
      {
        mean[i] += weight(r, k) * at[i];
        for (int j = 0; j < 3; ++j)
          gradient[i][j] += at[i] * slope(r, k, j);
      }
    }
    EXPECT_NEAR(sum, 1.0, 1e-13);
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_NEAR(mean[i], x(particle(r), i), 1e-13 * cell);
      for (int j = 0; j < 3; ++j)
        EXPECT_NEAR(gradient[i][j], i == j ? 1.0 : 0.0, 1e-12);
    }
  }
  EXPECT_GT(second, 0);
}

/// A crack turns with its body. At faces the lumped projection gives nodes the velocity of the middle of
/// their particles, up to a quarter of a cell off the crack: an error of omega h / 4. It lies along the
/// crack, along which positions drift by up to that over the turn; as it begins it shakes the body by strains
/// of up to omega h / c, which over the crack's width open it by no more than that.
TEST(Cracks3D, TurnWithTheBody)
{
  const Vector<3> omega{1500.0, -2500.0, 2000.0}, centre{4e-3, 4e-3, 4e-3};
  const auto cross = [](const Vector<3>& a, const Vector<3>& b) {
    return Vector<3>{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  };
  const auto run = start<3>(crackedCube());
  State<3>& state = run->state();
  const auto positions = [&]
  {
    const auto vertex = onHost(state.cracks.vertex);
    std::vector<Vector<3>> x;
    for (std::size_t v = 0; v < vertex.extent(0); ++v)
      x.push_back({vertex(v, 0), vertex(v, 1), vertex(v, 2)});
    return x;
  };
  const std::vector<Vector<3>> before = positions();
  const Vector<3> normal = state.cracks.fronts[0].normal;
  setVelocity(state, [&](const Vector<3>& x) { return cross(omega, x - centre); });
  while (norm(omega) * state.clock.time < 0.5)
    run->step(1.0, false);
  const std::vector<Vector<3>> after = positions();
  const double speed = std::sqrt(young / (2.0 * (1.0 + poisson)) / density); // of shear waves
  const double bound = norm(omega) * cell / speed * 4.8e-3;
  EXPECT_LE(measureOpening(state.cracks, 0).largest, bound);
  ASSERT_GT(after.size(), 20u);
  for (std::size_t v = 0; v < after.size(); ++v)
    for (std::size_t w = 0; w < v; ++w)
      EXPECT_NEAR(norm(after[v] - after[w]), norm(before[v] - before[w]),
                  0.25 * cell * norm(omega) * state.clock.time)
          << v << " " << w;
  // It has turned: by 0.5 about an axis that leans from its normal.
  EXPECT_LT(dot(normal, state.cracks.fronts[0].normal), 0.95);
  // And each particle still is where its side says.
  const auto side = onHost(state.particles.integer(fields::side));
  const auto x = onHost(state.particles.real<3>(fields::position));
  int sided = 0;
  for (int p = 0; p < state.particles.size(); ++p)
    if (side(p) != 0)
    {
      ++sided;
      const Vector<3> from = Vector<3>{x(p, 0), x(p, 1), x(p, 2)} - after[0];
      EXPECT_GT(side(p) * dot(from, state.cracks.fronts[0].normal), -bound);
    }
  EXPECT_GT(sided, 100);
}

/// Forces between faces are opposite: momentum is kept to round-off of what moves.
TEST(Cracks3D, KeepMomentum)
{
  Teuchos::ParameterList scene = crackedCube();
  scene.sublist("Face Pressure").sublist("Cut").set("Pressure", std::string("1e6*sin(2e6*t)"));
  scene.sublist("Contact").set("Law", std::string("Coulomb"));
  scene.sublist("Contact").set("Friction Coefficient", 0.3);
  const auto run = start<3>(scene);
  const Vector<3> drift{1.0, 2.0, -3.0};
  setVelocity(run->state(), [&](const Vector<3>& x) { return drift + 2e3 * Vector<3>{x[2], x[0], x[1]}; });
  advance(*run, 1, 1e-9);
  const Vector<3> before = run->state().sample.momentum;
  advance(*run, 50, run->stableTimeStep());
  const double mass = density * std::pow(8e-3, 3);
  for (int d = 0; d < 3; ++d)
    EXPECT_NEAR(run->state().sample.momentum[d], before[d], 1e-12 * mass * (norm(drift) + 20.0));
  EXPECT_GT(measureOpening(run->state().cracks, 0).largest, 0.0);
}

/// Far from particles on the other side nothing is stored: marks end a stencil away from the crack.
TEST(Cracks3D, OnlyParticlesNearTheCrackPay)
{
  const auto run = start<3>(crackedCube());
  advance(*run, 1, 1e-9);
  const State<3>& state = run->state();
  const auto x = onHost(state.particles.real<3>(fields::position));
  const auto row = onHost(state.stored.row);
  int stored = 0;
  for (int p = 0; p < state.particles.size(); ++p)
    if (row(p) >= 0)
    {
      ++stored;
      EXPECT_LT(std::abs(x(p, 2) - 4.3e-3), 2.0 * cell);
      EXPECT_LT(std::hypot(x(p, 0) - 4.2e-3, x(p, 1) - 3.9e-3), 2.4e-3 + 2.0 * std::sqrt(2.0) * cell);
    }
  EXPECT_GT(stored, 0);
  EXPECT_EQ(state.stored.count, stored);
}

/// Inside the polygon a node belongs to a side, beyond the front to none; where the front meets a
/// surface-breaking end it goes straight on.
TEST(Cracks3D, FrontsDecideWhichNodesAreSplit)
{
  Teuchos::ParameterList scene = blockScene({8e-3, 8e-3, 4e-3});
  setCrack(scene, {0.0, 4.4e-3, 0.0, 0.0, 4.4e-3, 4e-3, 4.5e-3, 4.4e-3, 4e-3, 4.5e-3, 4.4e-3, 0.0});
  const auto run = start<3>(scene);
  advance(*run, 1, 1e-9);
  const State<3>& state = run->state();
  const auto side = onHost(state.cracks.nodeSide);
  const auto active = onHost(state.mesh.nodes.active);
  // From the outside of the polygon, its order seen from +y is anticlockwise, so side +1 is above.
  int seen = 0;
  for (std::size_t i = 0; i < active.extent(0); ++i)
  {
    const Vector<3> x = state.mesh.grid.nodePosition(active(i));
    if (std::abs(x[1] - 4.4e-3) > 1.5 * cell || x[0] < -1.5 * cell || x[2] < -1.5 * cell || x[2] > 5.5 * cell)
      continue;
    ++seen;
    const int expected = x[0] > 4.5e-3 ? 0 : (x[1] > 4.4e-3 ? 1 : -1);
    EXPECT_EQ(side(active(i)), expected) << x[0] << " " << x[1] << " " << x[2];
  }
  EXPECT_GT(seen, 100);
  ASSERT_EQ(state.cracks.fronts.size(), 1u);
  EXPECT_NEAR(state.cracks.fronts[0].length, 4e-3, 1e-12);
  EXPECT_NEAR(state.cracks.fronts[0].direction[0], 1.0, 1e-12);
}

/// What sticks out of the body is cut off, and the scene may say itself what is a front.
TEST(Cracks3D, AreCutOffOutsideOfBodies)
{
  Teuchos::ParameterList scene = blockScene({8e-3, 8e-3, 8e-3});
  setCrack(scene, {-3e-3, 2.1e-3, 4e-3, 3.3e-3, 2.1e-3, 4e-3, 3.3e-3, 6.3e-3, 4e-3, -3e-3, 6.3e-3, 4e-3});
  const auto run = start<3>(scene);
  const CrackSet<3>& cracks = run->state().cracks;
  // Each piece of the cut is at its position to 1e-3 of an edge.
  EXPECT_NEAR(measureOpening(cracks, 0).size, 3.3e-3 * 4.2e-3, 4.2e-3 * 2e-3 * cell);
  ASSERT_EQ(cracks.fronts.size(), 1u);
  EXPECT_NEAR(cracks.fronts[0].length, 2.0 * 3.3e-3 + 4.2e-3, 4e-3 * cell);
  scene.sublist("Cracks").sublist("Cut").set("Front Edges", Teuchos::Array<int>(1, 2));
  const auto other = start<3>(scene);
  ASSERT_EQ(other->state().cracks.fronts.size(), 1u);
  EXPECT_NEAR(other->state().cracks.fronts[0].length, 4.2e-3, 1e-12);
}

TEST(Cracks3D, RefuseWrongPolygonsWithAReason)
{
  const auto says = [](const std::string& message, const std::string& piece)
  {
    EXPECT_NE(message.find("Cracks > Cut"), std::string::npos) << message;
    EXPECT_NE(message.find(piece), std::string::npos) << message;
  };
  const double z = 4e-3;
  says(refusal({2e-3, 2e-3, z, 6e-3, 2e-3, z}), "three points");
  says(refusal({2e-3, 2e-3, z, 6e-3, 2e-3}), "Points");
  says(refusal({2e-3, 2e-3, z, 4e-3, 4e-3, z, 6e-3, 6e-3, z}), "no area");
  says(refusal({2e-3, 2e-3, z, 2e-3, 2e-3, z, 6e-3, 2e-3, z, 2e-3, 6e-3, z}), "the same");
  says(refusal({2e-3, 2e-3, z, 6e-3, 2e-3, z, 6e-3, 6e-3, z + 1e-3, 2e-3, 6e-3, z}), "off the plane");
  says(refusal({2e-3, 2e-3, z, 6e-3, 6e-3, z, 6e-3, 2e-3, z, 2e-3, 7e-3, z}), "cross");
  says(refusal({2e-2, 2e-3, z, 3e-2, 2e-3, z, 3e-2, 6e-3, z}), "outside of all bodies");
  says(refusal({2e-3, 2e-3, z, 6e-3, 2e-3, z, 6e-3, 6e-3, z}, {4}), "edges 1 to 3");
  EXPECT_EQ(refusal({2e-3, 2e-3, z, 6e-3, 2e-3, z, 6e-3, 6e-3, z}, {1, 3}), "");
  Teuchos::ParameterList scene = crackedCube();
  scene.sublist("Cracks").set("Formulation", std::string("Broken Cell"));
  std::vector<SceneError> errors;
  validateList(scene, effectSchema(), errors);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors[0].where, "Cracks > Formulation");
}
