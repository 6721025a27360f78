/// Two supports of the same nodes: those that want one velocity pass, round-off or not, and others do not.

#include "Simulation.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_DefaultMpiComm.hpp>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

using namespace Rhegma;

namespace
{

using Reals = Teuchos::Array<double>;

Reals pair(double x, double y) { return Reals(std::vector<double>{x, y}); }

/// A plate from y = 0.3 on, on a lattice whose nodes there lie beside 0.3 by a rounding.
Teuchos::RCP<Teuchos::ParameterList> plate()
{
  const auto scene = Teuchos::rcp(new Teuchos::ParameterList("Rhegma"));
  Teuchos::ParameterList& domain = scene->sublist("Domain");
  domain.set("Dimension", 2);
  domain.set("Lower Corner", Reals(2, -0.4));
  domain.set("Upper Corner", Reals(2, 1.4));
  domain.set("Cell Size", 0.1);
  scene->sublist("Time").set("Final Time", 1e-3);
  Teuchos::ParameterList& steel = scene->sublist("Materials").sublist("Steel");
  steel.set<std::string>("Model", "Linear Elastic");
  steel.set("Density", 7800.0);
  steel.set("Young Modulus", 2.1e11);
  steel.set("Poisson Ratio", 0.0);
  Teuchos::ParameterList& body = scene->sublist("Bodies").sublist("Plate");
  body.set<std::string>("Material", "Steel");
  body.set<std::string>("Shape", "Box");
  body.set("Lower Corner", pair(0.0, 0.3));
  body.set("Upper Corner", Reals(2, 1.0));
  return scene;
}

/// Holds the nodes of the plate's left side from one height to another.
Teuchos::ParameterList& grip(Teuchos::ParameterList& scene, const std::string& name, double from, double to)
{
  Teuchos::ParameterList& list = scene.sublist("Boundaries").sublist(name);
  list.set<std::string>("Type", "Velocity");
  list.set("Lower Corner", pair(-0.35, from));
  list.set("Upper Corner", pair(0.05, to));
  return list;
}

void mirror(Teuchos::ParameterList& scene)
{
  Teuchos::ParameterList& list = scene.sublist("Boundaries").sublist("Mirror");
  list.set<std::string>("Type", "Symmetry");
  list.set<std::string>("Axis", "y");
  list.set("Position", 0.3);
  list.set<std::string>("Side", "Lower");
}

/// What the program says of a scene; empty if it takes it.
std::string refusal(const Teuchos::RCP<Teuchos::ParameterList>& scene)
{
  try
  {
    Simulation simulation(Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD)), scene);
    simulation.initialize();
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "";
}

/// Of two grips of the same nodes.
std::string refusal(const std::string& one, const std::string& two)
{
  const auto scene = plate();
  int number = 0;
  for (const std::string& history : {one, two})
  {
    Teuchos::ParameterList& list = grip(*scene, "Grip " + std::to_string(++number), 0.25, 1.05);
    list.set("Value", pair(0.0, 0.1));
    list.set("History", history);
  }
  return refusal(scene);
}

} // namespace

/// A field that is zero on the plane, but for the rounding of its nodes' places.
TEST(Contradictions, PassAFieldThatVanishesOnAPlaneOfSymmetry)
{
  for (const double top : {1.05, 0.35}) // all along the side, and on the plane alone
  {
    const auto scene = plate();
    grip(*scene, "Grip", 0.25, top).set<std::string>("Field", "0, 1e3*(y-0.3)");
    mirror(*scene);
    EXPECT_EQ(refusal(scene), "");
  }
}

/// Where they cross zero their rounding is all that there is.
TEST(Contradictions, PassTwoSpellingsOfAHistory)
{
  EXPECT_EQ(refusal("sin(6283.185307179586*t)", "2*sin(3141.592653589793*t)*cos(3141.592653589793*t)"), "");
  EXPECT_EQ(refusal("1e3*t - 0.3", "1e3*(t - 3e-4)"), "");
}

TEST(Contradictions, RefuseWhatDiffersByMoreThanRounding)
{
  EXPECT_NE(refusal("sin(6283.185307179586*t)", "sin(6283.185307179586*t) + 1e-6").find("both hold the node"),
            std::string::npos);
  const auto scene = plate();
  grip(*scene, "Grip", 0.25, 1.05).set<std::string>("Field", "0, y-0.3001");
  mirror(*scene);
  const std::string words = refusal(scene);
  EXPECT_NE(words.find("both hold the node"), std::string::npos) << words;
  EXPECT_NE(words.find("along y"), std::string::npos) << words;
}
