#include "Scenes.hpp"

using namespace Rhegma;
using namespace Rhegma::SceneTests;

namespace
{

void expectMistake(const std::string& xml, const std::string& where, const std::vector<std::string>& pieces)
{
  expectOnly(read(xml).errors, where, pieces);
}

/// The right scene with another shape for its body.
std::string withShape(const std::string& shape)
{
  return changed(R"xml(<Parameter name="Shape" type="string" value="Box"/>
      <Parameter name="Lower Corner" type="Array(double)" value="{1.0, 1.0}"/>
      <Parameter name="Upper Corner" type="Array(double)" value="{3.0, 3.0}"/>)xml",
                 shape);
}

std::string boundary(const std::string& content)
{
  return with("Boundaries", "<ParameterList name=\"Edge\">" + content + "</ParameterList>");
}

} // namespace

TEST(SceneCrossChecks, CornersInOrder)
{
  expectMistake(changed("{4.0, 4.0}", "{4.0, 0.0}"), "Domain > Upper Corner", {"y = 0 m", "Lower Corner"});
  expectMistake(changed("{3.0, 3.0}", "{0.5, 3.0}"), "Bodies > Plate > Upper Corner",
                {"Lower Corner along x"});
}

TEST(SceneCrossChecks, DomainHoldsACell)
{
  expectMistake(changed("value=\"0.5\"", "value=\"4.5\""), "Domain > Cell Size", {"4.5 m", "4 m along x"});
  EXPECT_TRUE(read(changed("value=\"0.5\"", "value=\"4\"")).errors.empty());
}

TEST(SceneCrossChecks, NamesThatOthersGive)
{
  expectMistake(changed("value=\"Steel\"", "value=\"Steal\""), "Bodies > Plate > Material",
                {"\"Steal\"", "did you mean \"Steel\""});
  expectMistake(changed("value=\"Plate\"", "value=\"Beam\""), "Boundaries > Pull > Body",
                {"\"Beam\"", "Plate"});
}

TEST(SceneCrossChecks, BodyOutsideOfTheDomain)
{
  expectMistake(changed("{3.0, 3.0}", "{4.5, 3.0}"), "Bodies > Plate", {"1 to 4.5 m along x", "0 to 4 m"});
  EXPECT_TRUE(read(changed("{1.0, 1.0}", "{0.0, 0.0}")).errors.empty()); // it may touch
}

TEST(SceneCrossChecks, TurnedBodyOutsideOfTheDomain)
{
  // A square of 2 m turned by 45 degrees about its middle reaches sqrt(2) m to each side: 2 - 1.41 > 0.
  EXPECT_TRUE(read(with("Plate", parameter("Rotation", "double", "45"))).errors.empty());
  auto scene = with("Plate", parameter("Rotation", "double", "45"));
  scene.replace(scene.find("{1.0, 1.0}"), 10, "{0.5, 1.0}");
  scene.replace(scene.find("{3.0, 3.0}"), 10, "{2.5, 3.0}"); // 1.5 - 1.41 > 0 still
  EXPECT_TRUE(read(scene).errors.empty());
  scene.replace(scene.find("{0.5, 1.0}"), 10, "{0.4, 1.0}");
  scene.replace(scene.find("{2.5, 3.0}"), 10, "{2.4, 3.0}"); // 1.4 - 1.41 < 0
  expectMistake(scene, "Bodies > Plate", {"along x", "outside"});
}

TEST(SceneCrossChecks, PolygonsNeedThreePointsAndAnArea)
{
  const std::string polygon = parameter("Shape", "string", "Polygon");
  expectMistake(withShape(polygon + parameter("Points", "Array(double)", "{1, 1, 2, 2}")),
                "Bodies > Plate > Points", {"has 4 numbers", "multiple of 2 numbers", "at least 6"});
  expectMistake(withShape(polygon + parameter("Points", "Array(double)", "{1, 1, 2, 2, 3, 1, 2}")),
                "Bodies > Plate > Points", {"has 7 numbers"});
  expectMistake(withShape(polygon + parameter("Points", "Array(double)", "{1, 1, 2, 2, 3, 3}")),
                "Bodies > Plate > Points", {"no area"});
  EXPECT_TRUE(
      read(withShape(polygon + parameter("Points", "Array(double)", "{1, 1, 3, 1, 3, 3}"))).errors.empty());
}

TEST(SceneCrossChecks, ShapesOfTheWrongDimension)
{
  const auto errors =
      read(withShape(parameter("Shape", "string", "Cylinder") +
                     parameter("From", "Array(double)", "{1, 1, 1}") +
                     parameter("To", "Array(double)", "{2, 2, 2}") + parameter("Radius", "double", "1")))
          .errors;
  expectOnly(errors, "Bodies > Plate > Shape",
             {"is Cylinder, which only a 3D scene has", "write Box, Ball, Polygon, File or Voxels"});
}

TEST(SceneCrossChecks, ThreeDimensionsHaveNoPlane)
{
  auto scene = with("Domain", parameter("Plane", "string", "Strain"));
  scene.replace(scene.find("type=\"int\" value=\"2\""), 20, "type=\"int\" value=\"3\"");
  bool found = false;
  for (const auto& error : read(scene).errors)
    found = found ||
            (error.where == "Domain > Plane" && error.message.find("only a 2D scene") != std::string::npos);
  EXPECT_TRUE(found);
}

TEST(SceneCrossChecks, SymmetryAlongZInAPlane)
{
  expectMistake(boundary(parameter("Type", "string", "Symmetry") + parameter("Axis", "string", "z") +
                         parameter("Position", "double", "0")),
                "Boundaries > Edge > Axis", {"z", "write x or y"});
}

TEST(SceneCrossChecks, ComponentsAreAxesOnce)
{
  const auto velocity = [](const std::string& components)
  {
    return boundary(
        parameter("Type", "string", "Velocity") + parameter("Lower Corner", "Array(double)", "{0, 0}") +
        parameter("Upper Corner", "Array(double)", "{0, 4}") + parameter("Value", "Array(double)", "{0, 0}") +
        parameter("Components", "string", components));
  };
  for (const std::string wrong : {"z", "xx", "", "x y", "yz"})
    expectMistake(velocity(wrong), "Boundaries > Edge > Components", {"\"" + wrong + "\"", "\"xy\""});
  for (const std::string right : {"x", "y", "xy", "yx"})
    EXPECT_TRUE(read(velocity(right)).errors.empty()) << right;
}

TEST(SceneCrossChecks, FieldOfVelocity)
{
  const auto velocity = [](const std::string& field)
  {
    return boundary(parameter("Type", "string", "Velocity") +
                    parameter("Lower Corner", "Array(double)", "{0, 0}") +
                    parameter("Upper Corner", "Array(double)", "{0, 4}") + field);
  };
  EXPECT_TRUE(read(velocity(parameter("Field", "string", "r = x + y; 2*r, -r"))).errors.empty());
  expectMistake(velocity(parameter("Field", "string", "2*x")), "Boundaries > Edge > Field",
                {"gives 1 value instead of 2"});
  expectMistake(velocity(parameter("Field", "string", "2*t, y")), "Boundaries > Edge > Field", {"\"t\""});
  expectMistake(velocity(""), "Boundaries > Edge", {"needs one of", "Value", "Field"});
  expectMistake(
      velocity(parameter("Field", "string", "x, y") + parameter("Value", "Array(double)", "{0, 0}")),
      "Boundaries > Edge", {"Value", "Field", "only one"});
}

TEST(SceneCrossChecks, LineOfNoLength)
{
  expectMistake(
      changed("{3.0, 3.0}\"/>\n      <Parameter name=\"Stress\"", "{3.0, 1.0}\"/><Parameter name=\"Stress\""),
      "Boundaries > Pull > To", {"same point"});
}

TEST(SceneCrossChecks, TooManyRowsOfHistory)
{
  expectMistake(with("Rhegma", "<ParameterList name=\"Output\">" +
                                   parameter("History Interval", "double", "1e-12") + "</ParameterList>"),
                "Output > History Interval", {"ten million", "1e-10 s"});
}

TEST(SceneCrossChecks, HardeningThatSoftens)
{
  auto scene = changed("Linear Elastic", "J2 Plastic");
  const std::string opening = "<ParameterList name=\"Steel\">";
  scene.insert(scene.find(opening) + opening.size(), parameter("Yield Stress", "double", "2e8") +
                                                         parameter("Saturation Rate", "double", "10") +
                                                         parameter("Saturation Stress", "double", "1e8"));
  expectMistake(scene, "Materials > Steel > Saturation Stress", {"1e+08", "2e+08"});
}

TEST(SceneCrossChecks, RubberThatIsTooCompressible)
{
  const std::string elastic = R"xml(<Parameter name="Model" type="string" value="Linear Elastic"/>
      <Parameter name="Density" type="double" value="7800"/>
      <Parameter name="Young Modulus" type="double" value="2.1e11"/>
      <Parameter name="Poisson Ratio" type="double" value="0.3"/>)xml";
  const auto rubber = [&](const std::string& bulk)
  {
    return changed(elastic, parameter("Model", "string", "Mooney-Rivlin") +
                                parameter("Density", "double", "1000") + parameter("C10", "double", "3") +
                                parameter("C01", "double", "3") + parameter("Bulk Modulus", "double", bulk));
  };
  EXPECT_TRUE(read(rubber("8.1")).errors.empty()); // Lame's first parameter: K - 4/3 (C10 + C01) = 0.1
  expectMistake(rubber("7.9"), "Materials > Steel > Bulk Modulus", {"7.9", "8"});
}

/// Its tolerance is absolute (References.OfZeroAreAbsolute).
TEST(SceneCrossChecks, ReferenceOfZeroIsAllowed)
{
  const SceneResult result =
      read(with("Rhegma", "<ParameterList name=\"Reference\"><ParameterList name=\"E\">" +
                              parameter("Quantity", "string", "energy.kinetic") +
                              parameter("Value", "double", "0") + parameter("Tolerance", "double", "0.01") +
                              parameter("Source", "string", "by hand") + "</ParameterList></ParameterList>"));
  EXPECT_TRUE(result.errors.empty());
}

TEST(SceneCrossChecks, OfAnEffectSeeDefaultsAndAddErrors)
{
  SceneSchema schema = coreSchema();
  schema.addCheck(
      [](const Teuchos::ParameterList& scene, std::vector<SceneError>& errors)
      {
        if (scene.sublist("Time").get<double>("CFL") == 0.4)
          errors.push_back({"Time > CFL", "is the default."});
      });
  expectOnly(readSceneText(goodScene(), {}, schema).errors, "Time > CFL", {"is the default."});
}
