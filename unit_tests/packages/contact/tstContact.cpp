#include "JointScene.hpp"

#include "contact/ClosedVisibility.hpp"
#include "contact/Contact.hpp"
#include "transfer/Stencils.hpp"

#include <algorithm>

using namespace Rhegma;
using namespace Rhegma::contact;
using namespace Rhegma::contact::test;

namespace
{

std::vector<std::string> pathsOfErrors(const std::vector<std::string>& overrides)
{
  const SceneResult scene =
      readScene(std::string(RHEGMA_SOURCE_DIR) + "/xml_inputs/verification/contact_pulse_compressive.xml",
                overrides, effectSchema());
  std::vector<std::string> positions;
  for (const SceneError& error : scene.errors)
    positions.push_back(error.where);
  return positions;
}

using Paths = std::vector<std::string>;

} // namespace

TEST(Contact, RefusesWhatDoesNotFit)
{
  EXPECT_EQ(pathsOfErrors({}), Paths{});
  EXPECT_EQ(pathsOfErrors({"Contact:Law=Coulomb"}), Paths{"Contact > Friction Coefficient"});
  EXPECT_EQ(pathsOfErrors({"Contact:Law=Coulomb", "Contact:Friction Coefficient=0.3"}), Paths{});
  EXPECT_EQ(pathsOfErrors({"Contact:Friction Coefficient=0.3"}), Paths{"Contact > Friction Coefficient"});
  EXPECT_EQ(pathsOfErrors({"Contact:Law=Visibility"}), Paths{"Contact > Law"});
  EXPECT_EQ(pathsOfErrors({"Contact:Law=Visibility", "Cracks:Formulation=Broken Cell"}), Paths{});
  EXPECT_EQ(pathsOfErrors({"Contact:Penalty=0"}), Paths{"Contact > Penalty"});
  Teuchos::ParameterList scene;
  scene.sublist("Contact");
  std::vector<SceneError> errors;
  checkRules(scene, effectSchema(), errors);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors[0].where, "Contact");
}

TEST(Contact, IsAbsentUnlessAskedFor)
{
  const SceneResult scene =
      readScene(std::string(RHEGMA_SOURCE_DIR) + "/xml_inputs/examples/dcb.xml", {}, effectSchema());
  Rhegma::Run<2> run(*scene.list);
  run.initialize();
  for (const Effect<2>& effect : run.plan().effects)
    EXPECT_NE(effect.name, "Contact");
  EXPECT_EQ(printPlan(run.plan(), run.state()).find("contact"), std::string::npos);
}

TEST(Contact, TakesNoTimeUpToThePenaltyThatStepsCanBear)
{
  const auto limit = [](const std::string& penalty)
  { return barAtRest({"Contact:Penalty=" + penalty})->stableTimeStep(); };
  const double free = limit("1e-6");
  EXPECT_DOUBLE_EQ(limit("3"), free);
  // 0.9 h / (c sqrt(2 + alpha)), c the speed of a dilatational wave
  EXPECT_NEAR(limit("98"), 0.9 * cell / (std::sqrt(modulus / 1200.0) * 10.0), 1e-12 * free);
}

/// Where faces come closer, a position below the joint sees the nodes above it; where they part, it doesn't.
TEST(ClosedVisibility, MendsCutsWhereFacesAreClosed)
{
  const auto run = barAtRest({"Contact:Law=Visibility", "Cracks:Formulation=Broken Cell"});
  State<2>& state = run->state();
  ObservedPoints<2> points;
  points.count = 1;
  points.position = View<double* [2]>("position", 1);
  points.half = View<double* [2]>("half", 1);
  points.side = View<int*>("side", 1);
  Kokkos::deep_copy(Kokkos::subview(points.position, 0, 0), 0.5 * width);
  Kokkos::deep_copy(Kokkos::subview(points.position, 0, 1), height - 0.25 * cell);
  Kokkos::deep_copy(points.side, -1);
  // Nodes on the joint count as above it; from just below, unbroken functions give them 3/4.
  const auto seenAbove = [&]()
  {
    StencilTable<2> table;
    pointStencils(state, points, table, false);
    const auto count = onHost(table.count);
    const auto node = onHost(table.node);
    const auto weight = onHost(table.weight);
    double sum = 0.0;
    for (int e = 0; e < count(0); ++e)
      sum += state.mesh.grid.nodePosition(node(0, e))[1] > height - 0.5 * cell ? weight(0, e) : 0.0;
    return sum;
  };
  ClosedVisibility visibility;
  visibility.install(state);
  state.clock.dt = 1e-7;
  const auto move = [&](double velocity)
  {
    visibility.prepare(state);
    moveSides(state, {0.0, velocity}, {0.0, 0.0});
    visibility.advance(state, state.mesh.nodes.projection);
  };
  move(1.0);
  EXPECT_EQ(visibility.closedPoints(0), 0);
  EXPECT_EQ(seenAbove(), 0.0);
  move(-2.0);
  EXPECT_GT(visibility.closedPoints(0), 0);
  EXPECT_NEAR(seenAbove(), 0.75, 1e-12);
}
