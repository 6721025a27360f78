/// Temperatures, sources and probes of wrong units or at wrong positions.

#include "HeatedBars.hpp"
#include "Simulation.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <gtest/gtest.h>

#include <algorithm>

namespace Rhegma
{
namespace Test
{

namespace
{

using Warnings = std::vector<std::string>;

Warnings warningsOf(const Teuchos::ParameterList& scene)
{
  Simulation simulation(Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD)),
                        Teuchos::rcp(new Teuchos::ParameterList(scene)));
  simulation.initialize();
  return simulation.report()["warnings"].get<Warnings>();
}

bool say(const Warnings& warnings, const std::string& text)
{
  return std::any_of(warnings.begin(), warnings.end(),
                     [&](const std::string& warning) { return warning.find(text) != std::string::npos; });
}

/// The bar with stress, of steel at 293 K.
Teuchos::ParameterList elasticBar()
{
  Teuchos::ParameterList scene = bar<2>();
  Teuchos::ParameterList& material = scene.sublist("Materials").sublist("Solid");
  material.set("Model", "Linear Elastic");
  material.set("Density", 7800.0);
  material.set("Young Modulus", 2e11);
  material.set("Poisson Ratio", 0.3);
  material.set("Specific Heat", 500.0);
  material.set("Conductivity", 40.0);
  material.set("Thermal Expansion", 1.2e-5);
  scene.sublist("Thermal").set("Mechanics", true);
  scene.sublist("Thermal").set("Initial Temperature", 293.0);
  scene.sublist("Time").set("Final Time", 1e-2);
  return scene;
}

Teuchos::ParameterList& steel(Teuchos::ParameterList& scene)
{
  return scene.sublist("Materials").sublist("Solid");
}

/// A disk at the middle of the bar, of radius 0.5 m.
Teuchos::ParameterList& torch(Teuchos::ParameterList& scene, double power)
{
  Teuchos::ParameterList& list = scene.sublist("Thermal").sublist("Sources").sublist("Torch");
  list.set("Type", "Ball");
  list.set("Centre", array(Vector<2>{3.0, 1.0}));
  list.set("Radius", 0.5);
  list.set("Power", power);
  return list;
}

} // namespace

TEST(ReferenceTemperature, InCelsiusIsSaid)
{
  Teuchos::ParameterList scene = elasticBar();
  steel(scene).set("Reference Temperature", 20.0);
  EXPECT_TRUE(say(warningsOf(scene), "Materials > Solid > Reference Temperature: it is 20 K, which is -253.1 "
                                     "degrees Celsius"));
  EXPECT_FALSE(say(warningsOf(scene), "with a thermal strain of")); // 0.33 %
  steel(scene).set("Thermal Expansion", 7e-5);
  EXPECT_TRUE(say(warningsOf(scene),
                  "Materials > Solid > Reference Temperature: bodies start at 293 K with a "
                  "thermal strain of 1.911 %, for they have none at 20 K"));
  steel(scene).set("Reference Temperature", 293.0);
  EXPECT_FALSE(say(warningsOf(scene), "Reference Temperature"));
}

TEST(ThermalExpansion, OfNoSolidIsSaid)
{
  Teuchos::ParameterList scene = elasticBar();
  steel(scene).set("Thermal Expansion", 1.2e-2);
  EXPECT_TRUE(
      say(warningsOf(scene), "Materials > Solid > Thermal Expansion is 0.012 1/K, more than of any solid"));
  EXPECT_FALSE(say(warningsOf(elasticBar()), "Thermal Expansion"));
}

TEST(Tables, ThatDoNotCoverTheStartAreSaid)
{
  Teuchos::ParameterList scene = elasticBar();
  steel(scene).set("Young Modulus", std::string("20:2e11, 100:1e11"));
  EXPECT_TRUE(say(warningsOf(scene),
                  "Materials > Solid > Young Modulus: bodies start at 293 K, and its table "
                  "covers 20 to 100 K"));
  for (const char* right : {"293:2e11, 600:1e11", "300:2e11, 600:1e11", "100:2e11, 300:1e11"})
  {
    steel(scene).set("Young Modulus", std::string(right));
    EXPECT_FALSE(say(warningsOf(scene), "its table covers")) << right;
  }
}

/// A bar of 300 K that is heated to 373 K.
TEST(Tables, ThatDoNotCoverTheEndAreSaidThere)
{
  for (const bool covers : {true, false})
  {
    Teuchos::ParameterList scene = bar<2>();
    steel(scene).set("Specific Heat", std::string(covers ? "200:2, 400:2.2" : "280:2, 310:2.2"));
    hold<2>(scene, "Hot", -9.0, 9.0, 373.0);
    scene.sublist("Time").set("Final Time", 1.0);
    Simulation simulation(Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD)),
                          Teuchos::rcp(new Teuchos::ParameterList(scene)));
    simulation.initialize();
    EXPECT_FALSE(say(simulation.report()["warnings"].get<Warnings>(), "its table covers"));
    simulation.advance(1.0);
    EXPECT_EQ(
        say(simulation.report()["warnings"].get<Warnings>(),
            "Materials > Solid > Specific Heat: bodies came to 373 K, and its table covers 280 to 310 K"),
        !covers);
  }
}

TEST(Sources, OfNoPowerAreSaid)
{
  Teuchos::ParameterList scene = elasticBar();
  torch(scene, 1.0).set("History", std::string("0"));
  EXPECT_TRUE(say(warningsOf(scene),
                  "Thermal > Sources > Torch > History: up to Time > Final Time = 10 ms its "
                  "factor is at most 0, so this source does next to nothing"));
  torch(scene, 1.0).set("History", std::string("1"));
  EXPECT_FALSE(say(warningsOf(scene), "Torch"));
}

/// Within a disk of 1 m (no less than a cell), 10 ms at 1e15 W give 1e13 J / (pi 3.9e6 J/K) = 8e5 K; with
/// 1e12 W 800 K.
TEST(Sources, ThatEvaporateTheirBodyAreSaid)
{
  for (const double power : {1e15, 1e12, -1e15})
  {
    Teuchos::ParameterList scene = elasticBar();
    torch(scene, power);
    EXPECT_EQ(say(warningsOf(scene), "Thermal > Sources > Torch > Power: its heat changes the temperature"),
              std::fabs(power) > 1e13)
        << power;
  }
}

/// A disk that crosses the bar between two of any number of samples of the run, or passes beside it.
TEST(Sources, ThatPassABodyFastHeatIt)
{
  for (const double x : {3.0, 12.0})
  {
    Teuchos::ParameterList scene = elasticBar();
    torch(scene, 1.0).set("Centre", array(Vector<2>{x, -7777.0})).set("Velocity", array(Vector<2>{0.0, 2e6}));
    EXPECT_EQ(say(warningsOf(scene), "Thermal > Sources > Torch: no body comes closer than"), x > 6.0) << x;
  }
}

/// Steps of heat alone are a hundredth of the run, or shorter.
TEST(Sources, WhosePulseStepsDoNotSeeAreSaid)
{
  for (const std::string history : {"t > 5e-3 && t < 5.01e-3 ? 1 : 0", "0:0, 5e-3:0, 5.01e-3:1, 5.02e-3:0",
                                    "t > 2e-3 && t < 5e-3 ? 1 : 0", "sin(600*t)"})
  {
    Teuchos::ParameterList scene = bar<2>();
    scene.sublist("Time").set("Final Time", 1e-2);
    torch(scene, 1.0).set("History", history);
    EXPECT_EQ(say(warningsOf(scene), "Thermal > Sources > Torch > History: it changes within time steps of "
                                     "100 us"),
              history == "t > 5e-3 && t < 5.01e-3 ? 1 : 0")
        << history;
  }
}

/// 3 W over half of 20 us, of a table that steps of 100 us do not end at: all of it is supplied.
TEST(Sources, OfATableGiveAllTheirHeat)
{
  Teuchos::ParameterList scene = bar<2>();
  scene.sublist("Time").set("Final Time", 1e-2);
  torch(scene, 3.0).set("History", std::string("0:0, 5.03e-3:0, 5.04e-3:1, 5.05e-3:0"));
  Simulation simulation(Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD)),
                        Teuchos::rcp(new Teuchos::ParameterList(scene)));
  simulation.initialize();
  simulation.advance(1e-2);
  EXPECT_NEAR(simulation.report()["energy"]["heat"].get<double>(), 3e-5, 1e-14);
}

/// A wall of 400 K between load steps, and of 300 K at their ends.
TEST(HeldTemperatures, BetweenLoadStepsAreSaid)
{
  for (const int count : {10, 50})
  {
    Teuchos::ParameterList scene = elasticBar();
    scene.sublist("Time").set("Final Time", 10.0);
    scene.sublist("Time").set("Analysis", std::string("Quasi-Static"));
    scene.sublist("Time").set("Rigid Modes", std::string("Remove"));
    scene.sublist("Time").set("Load Steps", count);
    scene.sublist("Thermal").set("Initial Temperature", 300.0);
    scene.sublist("Thermal").set("Conduction", std::string("Implicit"));
    hold<2>(scene, "Hot", -9.0, 0.1, 400.0);
    scene.sublist("Boundaries").sublist("Hot").set("History", std::string("t > 4.1 && t < 4.9 ? 1 : 0.75"));
    EXPECT_EQ(say(warningsOf(scene),
                  "Boundaries > Hot > History: the temperature is up to 100 K from Thermal "
                  "> Initial Temperature between load steps, and at most 0 K"),
              count == 10)
        << count;
  }
}

TEST(Probes, OffTheBodiesAreSaid)
{
  for (const double x : {5.0, 5.9, 7.0, 9.0})
  {
    Teuchos::ParameterList scene = elasticBar();
    scene.sublist("Thermal").sublist("Probes").sublist("P").set("Point", array(Vector<2>{x, 1.0}));
    EXPECT_EQ(say(warningsOf(scene), "Thermal > Probes > P > Point: no body is closer than"), x > 6.5) << x;
  }
}

} // namespace Test
} // namespace Rhegma
