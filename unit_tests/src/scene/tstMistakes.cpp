#include "Scenes.hpp"

#include <algorithm>
#include <limits>
#include <set>

using namespace Rhegma;
using namespace Rhegma::SceneTests;

namespace
{

void expectMistake(const std::string& xml, const std::string& where, const std::vector<std::string>& pieces)
{
  expectOnly(read(xml).errors, where, pieces);
}

/// The right scene without one of its sections.
std::string without(const std::string& section)
{
  std::string scene = goodScene();
  const std::string indent = "\n  ", end = indent + "</ParameterList>";
  const auto from = scene.find(indent + "<ParameterList name=\"" + section + "\">");
  return scene.erase(from, scene.find(end, from) + end.size() - from);
}

} // namespace

TEST(SceneMistakes, MisspeltParameterNamesTheNearestAndIsNotAlsoMissing)
{
  expectMistake(changed("Young Modulus", "Youngs Modulus"), "Materials > Steel > Youngs Modulus",
                {"Young Modulus"});
}

TEST(SceneMistakes, UnlikeNameListsThePossibleOnes)
{
  expectMistake(with("Time", parameter("Colour", "string", "red")), "Time > Colour",
                {"no such parameter", "Final Time", "CFL", "Update Scheme"});
}

TEST(SceneMistakes, FormerNameOfAParameterNamesTheNewOne)
{
  Section oven("Oven", "A section with parameters that had other names.");
  oven.real("Power").formerly("Strength");
  oven.chosenBy("Type");
  Section gas("Gas", "One variant.");
  gas.real("Gas Flow").formerly("Stream").byDefault(1.0);
  oven.variant(gas);
  oven.variant(Section("Electric", "The other variant."));
  const SceneSchema schema = schemaOf({EffectEntry{oven, {}, {}, {}}});
  const auto errorsOf =
      [&](const std::string& type, const std::string& more, const std::vector<std::string>& overrides = {})
  {
    return readSceneText(with("Rhegma", "<ParameterList name=\"Oven\">" + parameter("Type", "string", type) +
                                            more + "</ParameterList>"),
                         overrides, schema)
        .errors;
  };
  const std::string power = parameter("Power", "double", "1"), stream = parameter("Stream", "double", "2");
  expectOnly(errorsOf("Gas", parameter("Strength", "double", "1")), "Oven > Strength",
             {"now named \"Power\""});
  for (const std::string type : {"Gas", "Electric"})
    expectOnly(errorsOf(type, power + stream), "Oven > Stream", {"now named \"Gas Flow\""});
  expectOnly(errorsOf("Gas", power, {"Oven:Stream=3"}), "Oven > Stream", {"now named \"Gas Flow\""});
}

TEST(SceneMistakes, CaseMatters)
{
  expectMistake(changed("Final Time", "final time"), "Time > final time", {"Final Time"});
}

TEST(SceneMistakes, MisspeltSection)
{
  expectMistake(changed("\"Bodies\"", "\"Bodys\""), "Bodys", {"Bodies"});
}

TEST(SceneMistakes, UnknownSectionInABody)
{
  expectMistake(with("Plate", "<ParameterList name=\"Operation\"/>"), "Bodies > Plate > Operation",
                {"Operations"});
}

TEST(SceneMistakes, SectionGivenAsParameter)
{
  expectMistake(with("Rhegma", parameter("Output", "string", "x")), "Output",
                {"<ParameterList name=\"Output\">"});
}

TEST(SceneMistakes, ParameterGivenAsSection)
{
  expectMistake(with("Time", "<ParameterList name=\"CFL\"/>"), "Time > CFL", {"<Parameter name=\"CFL\""});
}

TEST(SceneMistakes, ParameterWhereOnlySectionsStand)
{
  expectMistake(with("Materials", parameter("Density", "double", "1")), "Materials > Density",
                {"only sections"});
}

TEST(SceneMistakes, TextForARealNumber)
{
  expectMistake(changed("type=\"double\" value=\"0.5\"", "type=\"string\" value=\"half\""),
                "Domain > Cell Size", {"the text \"half\"", "real number", "type=\"double\""});
}

TEST(SceneMistakes, BrokenNumberForAnInteger)
{
  expectMistake(with("Plate", parameter("Particles Per Cell", "double", "2.5")),
                "Bodies > Plate > Particles Per Cell", {"2.5", "whole number"});
}

TEST(SceneMistakes, NumberForABoolean)
{
  expectMistake(with("Rhegma", "<ParameterList name=\"Output\">" + parameter("Fields", "int", "1") +
                                   "</ParameterList>"),
                "Output > Fields", {"the number 1", "true or false"});
}

TEST(SceneMistakes, NumberForAChoice)
{
  expectMistake(with("Time", parameter("Update Scheme", "int", "1")), "Time > Update Scheme",
                {"the number 1", "string"});
}

TEST(SceneMistakes, ArrayForAText)
{
  expectMistake(changed("type=\"string\" value=\"Steel\"", "type=\"Array(int)\" value=\"{1, 2}\""),
                "Bodies > Plate > Material", {"the array {1, 2}", "a text"});
}

TEST(SceneMistakes, TextForAnArray)
{
  expectMistake(changed("type=\"Array(double)\" value=\"{1.0, 1.0}\"", "type=\"string\" value=\"1 1\""),
                "Bodies > Plate > Lower Corner", {"the text", "Array(double)"});
}

TEST(SceneMistakes, ValuesThatAreNotOfTheirOwnType)
{
  const std::string real = "type=\"double\" value=\"0.5\"";
  expectMistake(changed(real, "type=\"double\" value=\"0.5 m\""), "Domain > Cell Size",
                {"0.5 m", "not a number"});
  expectMistake(changed(real, "type=\"double\" value=\"\""), "Domain > Cell Size", {"not a number"});
  expectMistake(changed(real, "type=\"double\" value=\"1d-3\""), "Domain > Cell Size", {"not a number"});
  expectMistake(changed(real, "type=\"double\" value=\"0x10\""), "Domain > Cell Size", {"not a number"});
  expectMistake(with("Time", parameter("Maximum Steps", "int", "3000000000")), "Time > Maximum Steps",
                {"whole number"});
  expectMistake(with("Time", parameter("Maximum Steps", "int", "ten")), "Time > Maximum Steps", {"\"ten\""});
  expectMistake(changed("{1.0, 1.0}", "{1.0, x}"), "Bodies > Plate > Lower Corner",
                {"{1.0, x}", "list of numbers"});
  expectMistake(changed("{1.0, 1.0}", "{1.0, 1.0"), "Bodies > Plate > Lower Corner", {"list of numbers"});
  expectMistake(with("Rhegma", "<ParameterList name=\"Output\">" + parameter("Fields", "bool", "yes") +
                                   "</ParameterList>"),
                "Output > Fields", {"\"yes\"", "true"});
}

TEST(SceneMistakes, NotFinite)
{
  for (const std::string value : {"nan", "NaN", "inf", "-inf", "1e999", "infinity"})
  {
    expectMistake(changed("value=\"7800\"", "value=\"" + value + "\""), "Materials > Steel > Density",
                  {"not finite"});
    expectMistake(changed("{1e6, 0.0}", "{" + value + ", 0}"), "Boundaries > Pull > Stress", {"not finite"});
  }
}

TEST(SceneMistakes, NotFiniteFromAnApplication)
{
  const auto result = read(goodScene());
  result.list->sublist("Materials").sublist("Steel").set("Density", std::numeric_limits<double>::quiet_NaN());
  std::vector<SceneError> errors;
  validateList(*result.list, coreSchema(), errors);
  expectOnly(errors, "Materials > Steel > Density", {"not finite"});
}

TEST(SceneMistakes, OutOfRangeSaysRangeAndUnit)
{
  expectMistake(changed("value=\"7800\"", "value=\"-7800\""), "Materials > Steel > Density",
                {"-7800 kg/m3", "above 0 kg/m3"});
  expectMistake(changed("value=\"2.1e11\"", "value=\"0\""), "Materials > Steel > Young Modulus",
                {"above 0 Pa"});
  expectMistake(changed("value=\"1e-3\"", "value=\"0\""), "Time > Final Time", {"is 0 s", "above 0 s"});
  expectMistake(with("Plate", parameter("Particles Per Cell", "int", "9")),
                "Bodies > Plate > Particles Per Cell", {"is 9", "from 1 to 8"});
  expectMistake(with("Time", parameter("PIC Fraction", "double", "1.01")), "Time > PIC Fraction",
                {"from 0 to 1"});
  expectMistake(with("Time", parameter("Maximum Steps", "int", "0")), "Time > Maximum Steps", {"at least 1"});
}

TEST(SceneMistakes, OpenBoundsAreOpenAndClosedOnesClosed)
{
  for (const std::string value : {"0.5", "-1", "0.7"})
    expectMistake(changed("value=\"0.3\"", "value=\"" + value + "\""), "Materials > Steel > Poisson Ratio",
                  {"above -1 and below 0.5"});
  EXPECT_TRUE(read(changed("value=\"0.3\"", "value=\"0.49999999999999994\"")).errors.empty());
  expectMistake(with("Time", parameter("CFL", "double", "0")), "Time > CFL", {"above 0 and at most 1"});
  EXPECT_TRUE(read(with("Time", parameter("CFL", "double", "1"))).errors.empty());
  EXPECT_TRUE(read(with("Time", parameter("PIC Fraction", "double", "1"))).errors.empty());
}

TEST(SceneMistakes, UnknownChoiceListsAllAndTheNearest)
{
  expectMistake(with("Time", parameter("Update Scheme", "string", "MUSSL")), "Time > Update Scheme",
                {"\"MUSSL\"", "MUSL, USF, USL or USAVG", "did you mean \"MUSL\""});
  expectMistake(changed("value=\"Linear Elastic\"", "value=\"Linear elastic\""), "Materials > Steel > Model",
                {"did you mean \"Linear Elastic\""});
}

TEST(SceneMistakes, MissingParameterAndSection)
{
  expectMistake(changed(parameter("Cell Size", "double", "0.5"), ""), "Domain > Cell Size",
                {"missing", "a real number [m]"});
  expectMistake(changed(parameter("Model", "string", "Linear Elastic"), ""), "Materials > Steel > Model",
                {"missing", "J2 Plastic"});
  expectMistake(without("Time"), "Time", {"missing", "<ParameterList name=\"Time\">"});
}

TEST(SceneMistakes, EmptySceneLacksTheFourRequiredSections)
{
  const auto errors = read("<ParameterList name=\"Rhegma\"/>").errors;
  ASSERT_EQ(errors.size(), 4u) << all(errors);
  const std::vector<std::string> required = {"Domain", "Time", "Materials", "Bodies"};
  for (std::size_t i = 0; i < required.size(); ++i)
  {
    EXPECT_EQ(errors[i].where, required[i]);
    EXPECT_NE(errors[i].message.find("missing"), std::string::npos);
  }
}

TEST(SceneMistakes, EmptyMaterialsAndBodies)
{
  for (const std::string section : {"Materials", "Bodies"})
  {
    std::string scene = without(section);
    scene.insert(scene.rfind("</ParameterList>"), "<ParameterList name=\"" + section + "\"/>");
    const auto errors = read(scene).errors;
    const auto empty = std::find_if(errors.begin(), errors.end(),
                                    [&](const SceneError& error) { return error.where == section; });
    ASSERT_NE(empty, errors.end()) << section << ":\n" << all(errors);
    EXPECT_NE(empty->message.find("empty"), std::string::npos) << empty->message;
  }
}

TEST(SceneMistakes, WrongArrayLength)
{
  expectMistake(changed("{1.0, 1.0}", "{1.0, 1.0, 1.0}"), "Bodies > Plate > Lower Corner",
                {"has 3 numbers", "2 numbers", "2D"});
  expectMistake(with("Plate", parameter("Velocity", "Array(double)", "{1}")), "Bodies > Plate > Velocity",
                {"has 1 number;"});
  expectMistake(with("Plate", parameter("Angular Velocity", "Array(double)", "{0, 0, 1}")),
                "Bodies > Plate > Angular Velocity", {"has 3 numbers", "write 1 number"});
  expectMistake(with("Plate", parameter("Velocity", "Array(double)", "{}")), "Bodies > Plate > Velocity",
                {"has 0 numbers"});
}

TEST(SceneMistakes, ParameterOfAnotherVariant)
{
  expectMistake(with("Steel", parameter("Hardening Modulus", "double", "1e8")),
                "Materials > Steel > Hardening Modulus", {"belongs to the Model J2 Plastic"});
}

TEST(SceneMistakes, ParameterOfAnotherDimension)
{
  expectMistake(with("Plate", parameter("Rotation Axis", "Array(double)", "{0, 0, 1}")),
                "Bodies > Plate > Rotation Axis", {"only a 3D scene", "this one is 2D"});
}

TEST(SceneMistakes, OneOfTwo)
{
  expectMistake(with("Pull", parameter("Pressure", "double", "1")), "Boundaries > Pull",
                {"Stress and Pressure", "only one"});
  expectMistake(changed(parameter("Stress", "Array(double)", "{1e6, 0.0}"), ""), "Boundaries > Pull",
                {"needs one of Stress, Pressure or Force"});
}

TEST(SceneMistakes, AllOrNone)
{
  auto scene = changed("Linear Elastic", "J2 Plastic");
  const std::string opening = "<ParameterList name=\"Steel\">";
  scene.insert(scene.find(opening) + opening.size(),
               parameter("Yield Stress", "double", "1e8") + parameter("Saturation Rate", "double", "10"));
  expectMistake(scene, "Materials > Steel", {"Saturation Rate alone", "Saturation Stress"});
}

TEST(SceneMistakes, EmptyText)
{
  const std::string reference = "<ParameterList name=\"Reference\"><ParameterList name=\"G\">" +
                                parameter("Quantity", "string", "energy.kinetic") +
                                parameter("Value", "double", "1") + parameter("Tolerance", "double", "0.01") +
                                parameter("Source", "string", " ") + "</ParameterList></ParameterList>";
  expectMistake(with("Rhegma", reference), "Reference > G > Source", {"empty"});
}

TEST(SceneMistakes, BadHistory)
{
  expectMistake(with("Pull", parameter("History", "string", "sin(x)")), "Boundaries > Pull > History",
                {"\"sin(x)\"", "\"x\"", "expression of t"});
  expectMistake(with("Pull", parameter("History", "string", "0:0, 0:1")), "Boundaries > Pull > History",
                {"increase"});
  expectMistake(with("Pull", parameter("History", "string", "1/t")), "Boundaries > Pull > History",
                {"not finite at t = 0 s"});
  expectMistake(with("Pull", parameter("History", "string", "sqrt(0.5e-3 - t)")),
                "Boundaries > Pull > History", {"not finite at t = 0.0005"});
}

TEST(SceneMistakes, AllAreCollected)
{
  auto scene = changed("Young Modulus", "Youngs Modulus");
  for (const auto& [piece, by] : std::vector<std::pair<std::string, std::string>>{
           {"value=\"7800\"", "value=\"nan\""},
           {"value=\"0.3\"", "value=\"0.5\""},
           {"value=\"1e-3\"", "value=\"0\""},
           {"{1.0, 1.0}", "{1.0}"},
           {"type=\"string\" value=\"Steel\"", "type=\"string\" value=\"Stel\""},
           {"type=\"string\" value=\"Plate\"", "type=\"string\" value=\"Plato\""},
           {"name=\"Cell Size\"", "name=\"Cell Sise\""}})
    scene.replace(scene.find(piece), piece.size(), by);
  const auto errors = read(scene, {"Output:Field=1"}).errors;
  std::set<std::string> positions;
  for (const auto& error : errors)
    positions.insert(error.where);
  EXPECT_EQ(positions,
            (std::set<std::string>{"Materials > Steel > Youngs Modulus", "Materials > Steel > Density",
                                   "Materials > Steel > Poisson Ratio", "Time > Final Time",
                                   "Bodies > Plate > Lower Corner", "Bodies > Plate > Material",
                                   "Boundaries > Pull > Body", "Domain > Cell Sise", "Output > Field"}));
  EXPECT_EQ(errors.size(), positions.size()) << all(errors);
}
