/// Motion that is prescribed as a function of position.

#include "SteelPlate.hpp"
#include "boundary/Boundaries.hpp"

#include <cmath>

namespace Rhegma
{
namespace Test
{

namespace
{

Teuchos::RCP<Teuchos::ParameterList> square(const std::string& field)
{
  const auto scene = steelPlate(-4.0, 4.0, 0.5, Reals(2, -2.0), Reals(2, 2.0));
  Teuchos::ParameterList& held = scene->sublist("Boundaries").sublist("Held");
  held.set<std::string>("Type", "Velocity");
  held.set<std::string>("Nodes", "Outside");
  held.set("Lower Corner", Reals(2, 0.0));
  held.set("Upper Corner", Reals(2, 0.0));
  held.set<std::string>("Field", field);
  return scene;
}

double strainEnergy(const std::string& field)
{
  Simulation simulation(Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD)), square(field));
  simulation.initialize();
  simulation.sampleEvery(1e-4, {});
  simulation.advance(1e-4);
  return simulation.report()["energy"]["strain"].get<double>();
}

} // namespace

TEST(PrescribedField, HoldsNodesInsideOrOutsideOfABox)
{
  NodeConstraint<2> constraint;
  constraint.lower = {{0.0, 0.0}};
  constraint.upper = {{1.0, 2.0}};
  EXPECT_TRUE(constraint.appliesAt({{0.5, 1.5}}));
  EXPECT_TRUE(constraint.appliesAt({{1.0, 2.0}}));
  EXPECT_FALSE(constraint.appliesAt({{1.5, 1.5}}));
  constraint.outside = true;
  EXPECT_FALSE(constraint.appliesAt({{0.5, 1.5}}));
  EXPECT_TRUE(constraint.appliesAt({{1.5, 1.5}}));
  EXPECT_TRUE(constraint.appliesAt({{0.5, -0.1}}));
}

/// All nodes stretch along x at 10 / s: after 0.1 ms the strain is e = 1e-3, and without Poisson's effect the
/// energy of the plate of 4 m by 4 m by 1 m is E e^2 / 2 times its volume, to the order of e.
TEST(PrescribedField, StrainsABodyEvenly)
{
  const double expected = 0.5 * 2.1e11 * 1e-6 * 16.0;
  EXPECT_NEAR(strainEnergy("10*x, 0"), expected, 2e-3 * expected);
}

TEST(PrescribedField, RefusesAPoleOnANode)
{
  const std::string message = refusal(square("1/(x-1), y"));
  EXPECT_NE(message.find("Boundaries > Held > Field"), std::string::npos) << message;
}

} // namespace Test
} // namespace Rhegma
