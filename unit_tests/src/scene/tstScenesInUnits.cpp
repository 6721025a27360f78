#include "Scenes.hpp"
#include "base/Numbers.hpp"
#include "checkpoint/SceneText.hpp"
#include "plan/EffectSchema.hpp"
#include "scene/ValueWithUnit.hpp"

#include <Teuchos_Array.hpp>

#include <iostream>
#include <random>
#include <sstream>

using namespace Rhegma;
using namespace Rhegma::SceneTests;
using Reals = Teuchos::Array<double>;

namespace
{

const std::string cell = "type=\"double\" value=\"0.5\"";
const std::string modulus = "type=\"double\" value=\"2.1e11\"";

std::string inUnit(const std::string& type, const std::string& value, const std::string& unit)
{
  return "type=\"" + type + "\" value=\"" + value + "\" unit=\"" + unit + "\"";
}

/// A parameter with a unit.
std::string withUnit(const std::string& name, const std::string& type, const std::string& value,
                     const std::string& unit)
{
  return "<Parameter name=\"" + name + "\" " + inUnit(type, value, unit) + "/>";
}

void expectMistake(const std::string& scene, const std::string& where, const std::vector<std::string>& pieces)
{
  expectOnly(read(scene).errors, where, pieces);
}

/// A scene of all effects whose crack burns or is under pressure, with one section more.
SceneResult readAll(const std::string& more, const std::vector<std::string>& overrides = {})
{
  std::string scene = goodScene();
  return readSceneText(scene.insert(scene.rfind("</ParameterList>"), more), overrides, effectSchema());
}

std::string section(const std::string& name, const std::string& content)
{
  return "<ParameterList name=\"" + name + "\">" + content + "</ParameterList>";
}

/// A crack with faces under this pressure, without other errors.
std::string pressed(const std::string& pressure)
{
  const std::string points = parameter("Points", "Array(double)", "{1.5, 2.0, 2.5, 2.0}");
  return section("Cracks", section("Notch", points)) + section("Face Pressure", section("Notch", pressure));
}

} // namespace

TEST(ScenesInUnits, TakeTheAttribute)
{
  for (const auto& [value, unit] :
       std::vector<std::pair<std::string, std::string>>{{inUnit("double", "500", "mm"), "mm"},
                                                        {inUnit("double", "50", "cm"), "cm"},
                                                        {inUnit("int", "500", "mm"), "whole"},
                                                        {inUnit("string", "500", "mm"), "text"},
                                                        {"type=\"string\" value=\"500 mm\"", "in the text"},
                                                        {"type=\"string\" value=\"0.5m\"", "without blank"}})
  {
    const auto result = read(changed(cell, value));
    ASSERT_TRUE(result.errors.empty()) << all(result.errors);
    EXPECT_EQ(result.list->sublist("Domain").get<double>("Cell Size"), 0.5) << unit;
  }
}

TEST(ScenesInUnits, ConvertEveryEntryOfAnArray)
{
  for (const std::string& stress :
       {inUnit("Array(double)", "{1.1, -2}", "MPa"), inUnit("string", "{1.1, -2}", "MPa"),
        inUnit("Array(int)", "{2, -2}", "MPa"), std::string("type=\"string\" value=\"{1.1, -2} MPa\"")})
  {
    const auto result = read(changed("type=\"Array(double)\" value=\"{1e6, 0.0}\"", stress));
    ASSERT_TRUE(result.errors.empty()) << all(result.errors);
    const auto& got = result.list->sublist("Boundaries").sublist("Pull").get<Reals>("Stress");
    EXPECT_EQ(got, Reals(Teuchos::tuple(stress.find("int") == std::string::npos ? 1.1e6 : 2e6, -2e6)))
        << stress;
  }
}

TEST(ScenesInUnits, HoldNumbersOnlyAfterwards)
{
  const auto result = read(changed(modulus, inUnit("double", "210", "GPa")));
  ASSERT_TRUE(result.errors.empty()) << all(result.errors);
  EXPECT_EQ(result.list->sublist("Materials").sublist("Steel").get<double>("Young Modulus"), 2.1e11);
  std::ostringstream printed;
  result.list->print(printed);
  EXPECT_EQ(printed.str().find("GPa"), std::string::npos);
}

TEST(ScenesInUnits, AreThoseOfCheckpointsInSi)
{
  const auto si = read(goodScene());
  std::string other = changed(modulus, inUnit("double", "210", "GPa"));
  const std::string density = "type=\"double\" value=\"7800\"";
  other.replace(other.find(density), density.size(), inUnit("double", "7.8", "g/cm3"));
  const auto result = read(other, {"Domain:Cell Size=500 mm", "Bodies:Plate:Lower Corner={1000, 1000} mm"});
  ASSERT_TRUE(si.errors.empty() && result.errors.empty()) << all(result.errors);
  EXPECT_EQ(differenceOfScenes(sceneLines(*result.list, coreSchema()), sceneLines(*si.list, coreSchema())),
            "");
}

TEST(ScenesInUnits, OfAnotherDimensionAreRefused)
{
  expectMistake(changed(cell, inUnit("double", "2", "MPa")), "Domain > Cell Size",
                {"MPa, a pressure", "a length", "m, mm or um"});
  expectMistake(changed(modulus, "type=\"string\" value=\"210 mm\""), "Materials > Steel > Young Modulus",
                {"mm, a length", "a pressure", "GPa"});
  expectMistake(changed(cell, inUnit("double", "2", "mn")), "Domain > Cell Size",
                {"\"mn\"", "no known unit"});
  expectMistake(changed(cell, inUnit("double", "2", "")), "Domain > Cell Size", {"empty unit"});
  expectMistake(changed(cell, inUnit("string", "2 mm", "mm")), "Domain > Cell Size", {"2 mm", "another one"});
  expectMistake(changed(cell, inUnit("string", "two", "mm")), "Domain > Cell Size",
                {"\"two\"", "write a number"});
  expectMistake(changed(cell, inUnit("bool", "true", "mm")), "Domain > Cell Size", {"no number"});
}

TEST(ScenesInUnits, WhereThereAreNoneAreRefused)
{
  const std::string ratio = "type=\"double\" value=\"0.3\"";
  expectMistake(changed(ratio, inUnit("double", "0.3", "mm")), "Materials > Steel > Poisson Ratio",
                {"in mm", "a number without a unit", "leave the unit out"});
  expectMistake(changed(ratio, "type=\"string\" value=\"30 %\""), "Materials > Steel > Poisson Ratio",
                {"in %", "a number without a unit"});
  expectMistake(with("Domain", withUnit("Plane", "string", "Stress", "mm")), "Domain > Plane",
                {"one of the allowed values", "leave the unit out"});
  expectMistake(changed("type=\"string\" value=\"Steel\"", inUnit("string", "Steel", "kg")),
                "Bodies > Plate > Material", {"a text", "leave the unit out"});
  expectMistake(with("Plate", withUnit("Particles Per Cell", "int", "2", "m")),
                "Bodies > Plate > Particles Per Cell", {"a whole number", "leave the unit out"});
  expectMistake(changed("<ParameterList name=\"Domain\">", "<ParameterList name=\"Domain\" unit=\"mm\">"),
                "Domain", {"no attribute \"unit\""});
  expectMistake(with("Domain", withUnit("Cell Sise", "double", "2", "mm")), "Domain > Cell Sise",
                {"no such parameter", "\"Cell Size\""});
}

TEST(ScenesInUnits, AdviseWhoWritesTheUnitIntoANumber)
{
  expectMistake(changed(cell, "type=\"double\" value=\"500 mm\""), "Domain > Cell Size",
                {"\"500 mm\" is not a number", "value=\"500\" unit=\"mm\""});
}

TEST(ScenesInUnits, OfTheCommandLine)
{
  const auto result =
      read(changed(cell, inUnit("double", "3", "mm")),
           {"Domain:Cell Size=500 mm", "Bodies:Plate:Velocity={1, -2} mm/s", "Time:Final Time=7ms"});
  ASSERT_TRUE(result.errors.empty()) << all(result.errors);
  EXPECT_EQ(result.list->sublist("Domain").get<double>("Cell Size"), 0.5);
  EXPECT_EQ(result.list->sublist("Time").get<double>("Final Time"), 0.007);
  EXPECT_EQ(result.list->sublist("Bodies").sublist("Plate").get<Reals>("Velocity"),
            Reals(Teuchos::tuple(1e-3, -2e-3)));
  // Without a unit it is in SI units, also where the scene has another one.
  const auto plain = read(changed(cell, inUnit("double", "3", "mm")), {"Domain:Cell Size=0.5"});
  EXPECT_EQ(plain.list->sublist("Domain").get<double>("Cell Size"), 0.5);
  expectOnly(read(goodScene(), {"Domain:Cell Size=2 MPa"}).errors, "Domain > Cell Size", {"MPa, a pressure"});
  expectOnly(read(goodScene(), {"Time:CFL=0.3 s"}).errors, "Time > CFL", {"a number without a unit"});
  expectOnly(read(goodScene(), {"Bodies:Plate:Velocity=1, 2 mm/s"}).errors, "Bodies > Plate > Velocity",
             {"{1, 2} m/s"});
}

TEST(ScenesInUnits, OfFunctionsOfTime)
{
  const auto pressure = [](const std::string& value, const std::string& unit)
  {
    const auto result = readAll(pressed(withUnit("Pressure", "string", value, unit)));
    EXPECT_TRUE(result.errors.empty()) << all(result.errors);
    if (!result.errors.empty())
      return std::string();
    return result.list->sublist("Face Pressure").sublist("Notch").get<std::string>("Pressure");
  };
  EXPECT_EQ(pressure("2.2", "MPa"), "2200000");
  EXPECT_EQ(pressure("0:0, 1e-5 : 1.1,2:3", "MPa"), "0:0, 1e-5 :1100000,2:3000000");
  EXPECT_EQ(pressure("t &lt; 1 ? t : 2", "MPa"), "1000000*(t < 1 ? t : 2)");
  const auto wrong = readAll(pressed(withUnit("Pressure", "string", "2 +", "MPa")));
  expectOnly(wrong.errors, "Face Pressure > Notch > Pressure", {"\"2 +\" is not a function of time"});
  const auto inText = readAll(pressed(parameter("Pressure", "string", "2 MPa")));
  ASSERT_TRUE(inText.errors.empty()) << all(inText.errors);
  EXPECT_EQ(inText.list->sublist("Face Pressure").sublist("Notch").get<std::string>("Pressure"), "2000000");
}

TEST(ScenesInUnits, OfTemperaturesAndTheirTables)
{
  const std::string thermal = section("Thermal", withUnit("Initial Temperature", "double", "20", "degC"));
  auto result = readAll(
      thermal, {"Materials:Steel:Conductivity=50 W/(m K)", "Materials:Steel:Specific Heat=0.5 kJ/(kg K)"});
  ASSERT_TRUE(result.errors.empty()) << all(result.errors);
  EXPECT_EQ(result.list->sublist("Thermal").get<double>("Initial Temperature"), 293.15);
  EXPECT_EQ(result.list->sublist("Materials").sublist("Steel").get<double>("Specific Heat"), 500.0);

  std::string scene = changed(modulus, inUnit("string", "293:210, 600:180.5", "GPa"));
  scene.insert(scene.rfind("</ParameterList>"), thermal);
  result = readSceneText(scene, {"Materials:Steel:Conductivity=50", "Materials:Steel:Specific Heat=500"},
                         effectSchema());
  ASSERT_TRUE(result.errors.empty()) << all(result.errors);
  EXPECT_EQ(result.list->sublist("Materials").sublist("Steel").get<std::string>("Young Modulus"),
            "293:210000000000, 600:180500000000");
}

TEST(ScenesInUnits, OfExpressions)
{
  const std::string field = "Temperature Field";
  const auto number =
      readSceneText(with("Plate", withUnit(field, "string", "20", "degC")), {}, effectSchema());
  EXPECT_EQ(number.list->sublist("Bodies").sublist("Plate").get<std::string>(field), "293.15");
  const auto errors =
      readSceneText(with("Plate", withUnit(field, "string", "20 + x", "degC")), {}, effectSchema()).errors;
  ASSERT_FALSE(errors.empty());
  EXPECT_NE(all(errors).find("an expression or a table"), std::string::npos) << all(errors);
}

TEST(ScenesInUnits, AtRandomAreThoseInSi)
{
  const unsigned seed = std::random_device()();
  std::cout << "seed " << seed << "\n";
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> digits(1, 999999);
  for (int trial = 0; trial < 200; ++trial)
  {
    const std::string n = std::to_string(digits(random));
    const auto given =
        read(goodScene(), {"Materials:Steel:Young Modulus=" + n + " GPa", "Time:Final Time=" + n + " us",
                           "Bodies:Plate:Velocity={" + n + ", -" + n + "} mm/s",
                           "Materials:Steel:Density=" + n + " g/cm3"});
    const auto si =
        read(goodScene(),
             {"Materials:Steel:Young Modulus=" + n + "e9", "Time:Final Time=" + n + "e-6",
              "Bodies:Plate:Velocity={" + n + "e-3, -" + n + "e-3}", "Materials:Steel:Density=" + n + "e3"});
    ASSERT_TRUE(given.errors.empty() && si.errors.empty()) << all(given.errors) << all(si.errors);
    ASSERT_EQ(differenceOfScenes(sceneLines(*given.list, coreSchema()), sceneLines(*si.list, coreSchema())),
              "")
        << n;
  }
}

TEST(ScenesInUnits, CompareAndPrintTheirValues)
{
  const ValueWithUnit one{Teuchos::ParameterEntry(2.0), "mm"}, same = one,
                                                               other{Teuchos::ParameterEntry(2.0), "m"};
  EXPECT_TRUE(one == same);
  EXPECT_FALSE(one == other);
  std::ostringstream printed;
  printed << one;
  EXPECT_NE(printed.str().find("mm"), std::string::npos);
}
