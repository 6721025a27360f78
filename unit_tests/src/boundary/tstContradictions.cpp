/// Two supports of the same nodes: those that want one velocity pass, round-off or not, and others do not.

#include "SteelPlate.hpp"

namespace Rhegma
{
namespace Test
{

namespace
{

/// A plate from y = 0.3 on, on a lattice whose nodes there lie next to 0.3 by a rounding.
Teuchos::RCP<Teuchos::ParameterList> plate()
{
  return steelPlate(-0.4, 1.4, 0.1, pair(0.0, 0.3), Reals(2, 1.0));
}

/// The same as heat alone, at 300 K.
Teuchos::RCP<Teuchos::ParameterList> warmPlate()
{
  const auto scene = plate();
  Teuchos::ParameterList& steel = scene->sublist("Materials").sublist("Steel");
  steel = Teuchos::ParameterList("Steel");
  steel.set<std::string>("Model", "Rigid");
  steel.set("Density", 7800.0);
  steel.set("Specific Heat", 460.0);
  steel.set("Conductivity", 50.0);
  scene->sublist("Thermal").set("Initial Temperature", 300.0);
  scene->sublist("Thermal").set("Mechanics", false);
  return scene;
}

/// Cells of half the edge at the plate's left side.
void refine(Teuchos::ParameterList& scene)
{
  Teuchos::ParameterList& adaptivity = scene.sublist("Adaptivity");
  adaptivity.set("Maximum Level", 1);
  Teuchos::ParameterList& box = adaptivity.sublist("Box");
  box.set("Lower Corner", pair(-0.1, 0.2));
  box.set("Upper Corner", pair(0.2, 1.1));
  box.set("Level", 1);
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

/// Holds them at a temperature.
void warm(Teuchos::ParameterList& scene, const std::string& name, double from, double to, double temperature,
          const std::string& history = "1")
{
  Teuchos::ParameterList& list = grip(scene, name, from, to);
  list.set<std::string>("Type", "Temperature");
  list.set("Temperature", temperature);
  list.set("History", history);
}

/// Of two grips of the same nodes.
std::string refusalOfTwo(const std::string& one, const std::string& two)
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

/// A field that is zero on the plane, but for the rounding of its nodes' positions.
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
  EXPECT_EQ(refusalOfTwo("sin(6283.185307179586*t)", "2*sin(3141.592653589793*t)*cos(3141.592653589793*t)"),
            "");
  EXPECT_EQ(refusalOfTwo("1e3*t - 0.3", "1e3*(t - 3e-4)"), "");
}

TEST(Contradictions, RefuseWhatDiffersByMoreThanRounding)
{
  EXPECT_NE(refusalOfTwo("sin(6283.185307179586*t)", "sin(6283.185307179586*t) + 1e-6")
                .find("both prescribe the node"),
            std::string::npos);
  const auto scene = plate();
  grip(*scene, "Grip", 0.25, 1.05).set<std::string>("Field", "0, y-0.3001");
  mirror(*scene);
  const std::string message = refusal(scene);
  EXPECT_NE(message.find("both prescribe the node"), std::string::npos) << message;
  EXPECT_NE(message.find("along y"), std::string::npos) << message;
}

/// Between nodes of the lattice only nodes of smaller cells belong to two supports.
TEST(Contradictions, RefuseTwoVelocitiesOfANodeOfARefinedCell)
{
  for (const bool refined : {false, true})
  {
    const auto scene = plate();
    grip(*scene, "Below", 0.25, 0.56).set("Value", pair(0.0, 0.0));
    grip(*scene, "Above", 0.54, 1.05).set("Value", pair(0.0, 0.1));
    if (refined)
      refine(*scene);
    const std::string message = refusal(scene);
    EXPECT_EQ(message.find("Boundaries > Below: this and Boundaries > Above both prescribe the node") !=
                  std::string::npos,
              refined)
        << message;
    EXPECT_EQ(message.empty(), !refined) << message;
  }
}

TEST(Contradictions, RefuseTwoTemperaturesOfANode)
{
  const auto scene = warmPlate();
  warm(*scene, "Cold", 0.25, 0.65, 300.0);
  warm(*scene, "Hot", 0.55, 1.05, 400.0);
  const std::string message = refusal(scene);
  EXPECT_NE(message.find("Boundaries > Cold: this and Boundaries > Hot both prescribe the node"),
            std::string::npos)
      << message;
  EXPECT_NE(message.find("at 300 and 400 K"), std::string::npos) << message;
  EXPECT_NE(message.find("one temperature"), std::string::npos) << message;
}

TEST(Contradictions, PassOneTemperatureInTwoSpellings)
{
  const auto scene = warmPlate();
  warm(*scene, "Cold", 0.25, 0.65, 300.0, "1 + 100*t");
  warm(*scene, "Hot", 0.55, 1.05, 600.0, "0.5 + 50*t");
  EXPECT_EQ(refusal(scene), "");
}

TEST(Contradictions, RefuseTwoTemperaturesOfANodeOfARefinedCell)
{
  for (const bool refined : {false, true})
  {
    const auto scene = warmPlate();
    warm(*scene, "Cold", 0.25, 0.56, 300.0);
    warm(*scene, "Hot", 0.54, 1.05, 400.0);
    if (refined)
      refine(*scene);
    const std::string message = refusal(scene);
    EXPECT_EQ(message.find("both prescribe the node") != std::string::npos, refined) << message;
    EXPECT_EQ(message.empty(), !refined) << message;
  }
}

} // namespace Test
} // namespace Rhegma
