#include "Scenes.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_XMLParameterListCoreHelpers.hpp>

#include <sstream>

using namespace Rhegma;
using namespace Rhegma::SceneTests;
using Reals = Teuchos::Array<double>;

TEST(SceneDefaults, GoodSceneHasNoMistakes)
{
  const auto result = read(goodScene());
  EXPECT_TRUE(result.errors.empty()) << all(result.errors);
  ASSERT_FALSE(result.list.is_null());
}

TEST(SceneDefaults, AreFilledIn)
{
  const auto result = read(goodScene());
  auto& scene = *result.list;
  EXPECT_EQ(scene.sublist("Domain").get<std::string>("Plane"), "Strain");
  EXPECT_EQ(scene.sublist("Domain").get<double>("Thickness"), 1.0);
  EXPECT_EQ(scene.sublist("Domain").get<std::string>("Shape Functions"), "GIMP");
  EXPECT_EQ(scene.sublist("Time").get<double>("CFL"), 0.4);
  EXPECT_EQ(scene.sublist("Time").get<int>("Maximum Steps"), 2000000000);
  const auto& plate = scene.sublist("Bodies").sublist("Plate");
  EXPECT_EQ(plate.get<Reals>("Velocity"), Reals(2, 0.0));
  EXPECT_EQ(plate.get<Reals>("Angular Velocity"), Reals(1, 0.0));
  EXPECT_EQ(plate.get<int>("Particles Per Cell"), 2);
  EXPECT_FALSE(plate.isParameter("Rotation Centre"));
  EXPECT_FALSE(plate.isParameter("Rotation Axis")); // 3D only
  EXPECT_FALSE(plate.isSublist("Operations"));
  EXPECT_EQ(scene.sublist("Boundaries").sublist("Pull").get<std::string>("History"), "1");
}

TEST(SceneDefaults, OutputIsMadeAndFollowsTheFinalTime)
{
  const auto result = read(goodScene());
  ASSERT_TRUE(result.list->isSublist("Output"));
  EXPECT_EQ(result.list->sublist("Output").get<double>("History Interval"), 1e-3 / 200.0);
  EXPECT_TRUE(result.list->sublist("Output").get<bool>("Fields"));
  EXPECT_FALSE(result.list->sublist("Output").isParameter("Field Interval"));
}

TEST(SceneDefaults, OptionalSectionsStayAbsent)
{
  EXPECT_FALSE(read(goodScene()).list->isSublist("Reference"));
}

TEST(SceneDefaults, ThreeDimensionsHaveTheirOwn)
{
  const std::string scene = R"xml(<ParameterList name="Rhegma">
  <ParameterList name="Domain">
    <Parameter name="Dimension" type="int" value="3"/>
    <Parameter name="Lower Corner" type="Array(double)" value="{0, 0, 0}"/>
    <Parameter name="Upper Corner" type="Array(double)" value="{4, 4, 4}"/>
    <Parameter name="Cell Size" type="double" value="0.5"/>
  </ParameterList>
  <ParameterList name="Time"><Parameter name="Final Time" type="double" value="1"/></ParameterList>
  <ParameterList name="Materials"><ParameterList name="Rubber">
    <Parameter name="Model" type="string" value="Mooney-Rivlin"/>
    <Parameter name="Density" type="double" value="1000"/>
    <Parameter name="C10" type="double" value="1e5"/>
    <Parameter name="C01" type="double" value="0"/>
    <Parameter name="Bulk Modulus" type="double" value="1e7"/>
  </ParameterList></ParameterList>
  <ParameterList name="Bodies"><ParameterList name="Rod">
    <Parameter name="Material" type="string" value="Rubber"/>
    <Parameter name="Shape" type="string" value="Cylinder"/>
    <Parameter name="From" type="Array(double)" value="{1, 2, 2}"/>
    <Parameter name="To" type="Array(double)" value="{3, 2, 2}"/>
    <Parameter name="Radius" type="double" value="0.5"/>
  </ParameterList></ParameterList>
  <ParameterList name="Boundaries"><ParameterList name="Held">
    <Parameter name="Type" type="string" value="Velocity"/>
    <Parameter name="Lower Corner" type="Array(double)" value="{0, 0, 0}"/>
    <Parameter name="Upper Corner" type="Array(double)" value="{1, 4, 4}"/>
    <Parameter name="Value" type="Array(double)" value="{0, 0, 0}"/>
  </ParameterList></ParameterList>
</ParameterList>)xml";
  const auto result = read(scene);
  ASSERT_TRUE(result.errors.empty()) << all(result.errors);
  const auto& rod = result.list->sublist("Bodies").sublist("Rod");
  EXPECT_EQ(rod.get<Reals>("Velocity"), Reals(3, 0.0));
  EXPECT_EQ(rod.get<Reals>("Angular Velocity"), Reals(3, 0.0));
  EXPECT_EQ(rod.get<Reals>("Rotation Axis"), Reals(Teuchos::tuple(0.0, 0.0, 1.0)));
  EXPECT_EQ(result.list->sublist("Boundaries").sublist("Held").get<std::string>("Components"), "xyz");
  EXPECT_FALSE(result.list->sublist("Domain").isParameter("Plane"));
}

TEST(SceneTypes, AreNormalised)
{
  auto scene = changed("type=\"double\" value=\"0.5\"", "type=\"int\" value=\"1\"");          // Cell Size
  scene.replace(scene.find("type=\"int\" value=\"2\""), 20, "type=\"double\" value=\"2.0\""); // Dimension
  scene.replace(scene.find("type=\"Array(double)\" value=\"{4.0, 4.0}\""), 39,
                "type=\"Array(int)\" value=\"{4, 4}\"");
  const auto result = read(scene);
  ASSERT_TRUE(result.errors.empty()) << all(result.errors);
  const auto& domain = result.list->sublist("Domain");
  EXPECT_EQ(domain.get<double>("Cell Size"), 1.0);
  EXPECT_EQ(domain.get<int>("Dimension"), 2);
  EXPECT_EQ(domain.get<Reals>("Upper Corner"), Reals(2, 4.0));
}

TEST(SceneTypes, OneNumberIsAnArrayOfOne)
{
  const auto result = read(with("Plate", parameter("Angular Velocity", "double", "3")));
  ASSERT_TRUE(result.errors.empty()) << all(result.errors);
  EXPECT_EQ(result.list->sublist("Bodies").sublist("Plate").get<Reals>("Angular Velocity"), Reals(1, 3.0));
}

TEST(SceneTypes, ANumberIsAConstantHistory)
{
  const auto result = read(with("Pull", parameter("History", "double", "0.5")));
  ASSERT_TRUE(result.errors.empty()) << all(result.errors);
  EXPECT_EQ(result.list->sublist("Boundaries").sublist("Pull").get<std::string>("History"), "0.5");
}

TEST(SceneTypes, DigitsSurviveReading)
{
  const auto result = read(changed("value=\"0.3\"", "value=\"0.12345678901234567\""));
  ASSERT_TRUE(result.errors.empty()) << all(result.errors);
  EXPECT_EQ(result.list->sublist("Materials").sublist("Steel").get<double>("Poisson Ratio"),
            0.12345678901234567);
}

TEST(SceneList, KeepsTheOrderOfOperations)
{
  std::string operations = "<ParameterList name=\"Operations\">";
  for (const std::string name : {"Z", "A", "M"})
    operations += "<ParameterList name=\"" + name + "\">" + parameter("Operation", "string", "Cut") +
                  parameter("Shape", "string", "Ball") + parameter("Centre", "Array(double)", "{2, 2}") +
                  parameter("Radius", "double", "0.1") + "</ParameterList>";
  const auto result = read(with("Plate", operations + "</ParameterList>"));
  ASSERT_TRUE(result.errors.empty()) << all(result.errors);
  std::string order;
  for (const auto& entry : result.list->sublist("Bodies").sublist("Plate").sublist("Operations"))
    order += entry.first;
  EXPECT_EQ(order, "ZAM");
}

TEST(SceneList, SublistsKnowTheirPath)
{
  EXPECT_EQ(read(goodScene()).list->sublist("Bodies").sublist("Plate").name(), "Rhegma->Bodies->Plate");
}

TEST(SceneList, ValidatesAgainUnchanged)
{
  const auto result = read(goodScene());
  Teuchos::ParameterList again(*result.list);
  std::vector<SceneError> errors;
  validateList(again, coreSchema(), errors);
  EXPECT_TRUE(errors.empty()) << all(errors);
  EXPECT_TRUE(Teuchos::haveSameValues(again, *result.list));
}

TEST(SceneList, CanBeWrittenAndReadAgain)
{
  const auto result = read(goodScene());
  std::ostringstream xml;
  Teuchos::writeParameterListToXmlOStream(*result.list, xml);
  const auto again = read(xml.str());
  ASSERT_TRUE(again.errors.empty()) << all(again.errors);
  EXPECT_TRUE(Teuchos::haveSameValues(*again.list, *result.list));
}

TEST(SceneList, OfAnApplicationIsValidated)
{
  Teuchos::ParameterList list;
  list.sublist("Domain").set("Dimension", 2);
  list.sublist("Domain").set("Lower Corner", Teuchos::Array<double>(2, 0.0));
  list.sublist("Domain").set("Upper Corner", Teuchos::Array<int>(2, 1));
  list.sublist("Domain").set("Cell Size", 0.25f);
  list.sublist("Time").set("Final Time", 1);
  list.sublist("Time").set("Maximum Steps", 1000L);
  auto& steel = list.sublist("Materials").sublist("Steel");
  steel.set("Model", "Neo-Hookean").set("Density", 1.0).set("Young Modulus", 1.0).set("Poisson Ratio", 0.3);
  auto& ball = list.sublist("Bodies").sublist("Ball");
  ball.set("Material", "Steel")
      .set("Shape", "Ball")
      .set("Radius", 0.25)
      .set("Centre", Teuchos::Array<double>(2, 0.5));
  std::vector<SceneError> errors;
  validateList(list, coreSchema(), errors);
  ASSERT_TRUE(errors.empty()) << all(errors);
  EXPECT_EQ(list.sublist("Domain").get<double>("Cell Size"), 0.25);
  EXPECT_EQ(list.sublist("Time").get<double>("Final Time"), 1.0);
  EXPECT_EQ(list.sublist("Time").get<int>("Maximum Steps"), 1000);
  EXPECT_TRUE(list.isSublist("Output"));
}

TEST(SceneList, WithMistakesIsLeftAsItWas)
{
  Teuchos::ParameterList list;
  list.sublist("Domain").set("Dimension", 4);
  list.sublist("Tiem").set("Final Time", 1);
  const Teuchos::ParameterList before(list);
  std::vector<SceneError> errors;
  validateList(list, coreSchema(), errors);
  EXPECT_GT(errors.size(), 4u);
  EXPECT_TRUE(Teuchos::haveSameValues(list, before));
}
