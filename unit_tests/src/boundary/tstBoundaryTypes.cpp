#include "plan/BoundaryType.hpp"
#include "plan/EffectSchema.hpp"
#include "scene/Scene.hpp"

#include <gtest/gtest.h>

#include <set>

namespace Rhegma
{
namespace
{

std::vector<SceneError> errorsOf(const Teuchos::ParameterList& boundary)
{
  Teuchos::ParameterList scene("Rhegma");
  scene.sublist("Domain").set("Dimension", 2);
  scene.sublist("Bodies").sublist("Plate");
  scene.sublist("Boundaries").sublist("One").setParameters(boundary);
  std::vector<SceneError> errors;
  checkBoundaries(scene, errors);
  return errors;
}

TEST(BoundaryTypes, HaveNamesOfTheirOwnAndAct)
{
  std::set<std::string> names;
  for (const BoundaryType& type : boundaryTypes())
  {
    EXPECT_TRUE(names.insert(type.section.name).second) << type.section.name;
    EXPECT_EQ(type.capability.empty(), static_cast<bool>(type.add2)) << type.section.name;
    EXPECT_EQ(type.capability.empty(), static_cast<bool>(type.add3)) << type.section.name;
  }
  EXPECT_EQ(names.count("Velocity"), 1u);
}

TEST(BoundaryTypes, AreWhatTheSchemaOffers)
{
  const SceneSchema schema = schemaOf({});
  const Section* section = schema.root().findSection("Boundaries");
  ASSERT_NE(section, nullptr);
  ASSERT_TRUE(section->userNamed());
  EXPECT_EQ(section->entry[0].variants.size(), boundaryTypes().size());
}

TEST(BoundaryTypes, AreFoundByName)
{
  EXPECT_EQ(boundaryType("Traction").section.name, "Traction");
  EXPECT_THROW(boundaryType("Magnet"), std::invalid_argument);
}

TEST(BoundaryTypes, OfAnApplicationNeedANameAndWhatTheyDo)
{
  BoundaryType type{Section("Gravity", "There is one already.")};
  EXPECT_THROW(addBoundaryType(type), std::invalid_argument);
  type.section.name = "Magnet";
  EXPECT_THROW(addBoundaryType(type), std::invalid_argument);
  EXPECT_THROW(boundaryType("Magnet"), std::invalid_argument);
}

TEST(BoundaryTypes, OfAnEffectNameWhatItProvides)
{
  EXPECT_FALSE(boundaryType("Heat Flux").capability.empty());
  EXPECT_TRUE(boundaryType("Gravity").capability.empty());
}

TEST(BoundaryTypes, CheckBodiesForAllTypes)
{
  Teuchos::ParameterList list;
  list.set("Type", "Point Load");
  list.set("Body", "Plaet");
  const auto errors = errorsOf(list);
  ASSERT_EQ(errors.size(), 1u);
  EXPECT_EQ(errors[0].where, "Boundaries > One > Body");
}

} // namespace
} // namespace Rhegma
