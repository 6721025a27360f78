/// Constants of the library of materials in lists of applications, and files of the library.

#include "plan/EffectSchema.hpp"
#include "scene/FillFromLibrary.hpp"
#include "scene/MaterialLibrary.hpp"
#include "scene/Scene.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

using namespace Rhegma;

namespace
{

Teuchos::ParameterList sceneOf(const std::string& material)
{
  Teuchos::ParameterList scene("Rhegma");
  auto& domain = scene.sublist("Domain");
  domain.set("Dimension", 2);
  domain.set("Lower Corner", Teuchos::Array<double>(Teuchos::tuple(0.0, 0.0)));
  domain.set("Upper Corner", Teuchos::Array<double>(Teuchos::tuple(1.0, 1.0)));
  domain.set("Cell Size", 0.1);
  scene.sublist("Time").set("Final Time", 1.0);
  scene.sublist("Materials").sublist("Solid").set("Material From Library", material);
  auto& body = scene.sublist("Bodies").sublist("Block");
  body.set("Material", "Solid");
  body.set("Shape", "Box");
  body.set("Lower Corner", Teuchos::Array<double>(Teuchos::tuple(0.2, 0.2)));
  body.set("Upper Corner", Teuchos::Array<double>(Teuchos::tuple(0.8, 0.8)));
  return scene;
}

std::string messageOf(const char* text)
{
  try
  {
    readMaterialLibrary({{"some.xml", text}});
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return {};
}

} // namespace

/// Simulation validates the list that readScene has validated once more.
TEST(MaterialLibrary, ListCanBeValidatedTwice)
{
  Teuchos::ParameterList scene = sceneOf("Alumina");
  scene.sublist("Materials").sublist("Solid").set("Poisson Ratio", 0.24);
  std::vector<SceneError> errors;
  validateList(scene, effectSchema(), errors);
  ASSERT_TRUE(errors.empty()) << toString(errors.front());
  const Teuchos::ParameterList once(scene);
  validateList(scene, effectSchema(), errors);
  ASSERT_TRUE(errors.empty()) << toString(errors.front());
  EXPECT_TRUE(once == scene);
  const Teuchos::ParameterList& solid = scene.sublist("Materials").sublist("Solid");
  EXPECT_EQ(solid.get<std::string>("Model"), "Linear Elastic");
  EXPECT_DOUBLE_EQ(solid.get<double>("Density"), 3890.0);
  EXPECT_DOUBLE_EQ(solid.get<double>("Young Modulus"), 373e9);
  EXPECT_DOUBLE_EQ(solid.get<double>("Poisson Ratio"), 0.24);
  const auto uses = libraryUses(scene, effectSchema());
  ASSERT_EQ(uses.size(), 1u);
  EXPECT_EQ(uses[0].taken.size(), 3u); // Model, Density, Young Modulus
  EXPECT_EQ(uses[0].written, std::vector<std::string>{"Poisson Ratio"});
}

/// A list with errors is not changed.
TEST(MaterialLibrary, UnknownMaterialIsOneError)
{
  Teuchos::ParameterList scene = sceneOf("Alumna");
  const Teuchos::ParameterList before(scene);
  std::vector<SceneError> errors;
  validateList(scene, effectSchema(), errors);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors[0].where, "Materials > Solid > Material From Library");
  EXPECT_NE(errors[0].message.find("Alumina"), std::string::npos);
  EXPECT_TRUE(before == scene);
}

TEST(MaterialLibrary, WrongFilesAreRefusedWithTheirLine)
{
  const std::string start =
      "<ParameterList name=\"Library\">\n<ParameterList name=\"A\" title=\"t\" laws=\"Linear "
      "Elastic\" temperature=\"1 to 2 K\" rate=\"r\">\n";
  EXPECT_NE(messageOf((start + "<Parameter name=\"Density\" type=\"double\" value=\"1\"/>").c_str())
                .find("some.xml, line 3: <Parameter> has no attribute source"),
            std::string::npos);
  EXPECT_NE(messageOf((start + "<Other name=\"Density\"/>").c_str()).find("<Other> is unknown"),
            std::string::npos);
  EXPECT_EQ(messageOf((start + "</ParameterList></ParameterList>").c_str()), "");
  EXPECT_NE(messageOf("<ParameterList name=\"Library\"><ParameterList name=\"A\"/></ParameterList>")
                .find("has no attribute title"),
            std::string::npos);
}

TEST(MaterialLibrary, RangesAreTwoNumbers)
{
  EXPECT_EQ(rangeOf("1.17 to 1.2"), std::make_pair(1.17, 1.2));
  EXPECT_FALSE(rangeOf("1.17"));
  EXPECT_FALSE(rangeOf("1 to many"));
}
