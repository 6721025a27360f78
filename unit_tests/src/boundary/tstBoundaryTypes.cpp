#include "archive/Archive.hpp"
#include "boundary/Boundaries.hpp"
#include "boundary/BoundaryParts.hpp"
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

TEST(BoundaryTypes, SayWhereTheyAct)
{
  using Array = Teuchos::Array<double>;
  using Kind = BoundaryRegion::Kind;
  Teuchos::ParameterList scene("Rhegma");
  EXPECT_TRUE(boundaryRegions(scene).empty());
  Teuchos::ParameterList& all = scene.sublist("Boundaries");
  all.sublist("Plane").set("Type", "Symmetry").set("Axis", "y").set("Position", 2.0);
  all.sublist("Weight").set("Type", "Gravity");
  Teuchos::ParameterList& box = all.sublist("Box").set("Type", "Velocity").set("Nodes", "Outside");
  box.set("Components", "x")
      .set("Lower Corner", Array(Teuchos::tuple(0.0, 1.0)))
      .set("Upper Corner", Array(Teuchos::tuple(3.0, 4.0)));
  Teuchos::ParameterList& load = all.sublist("Load").set("Type", "Line Load");
  load.set("From", Array(Teuchos::tuple(5.0, 6.0, 7.0))).set("To", Array(Teuchos::tuple(8.0, 9.0, 10.0)));
  const std::vector<BoundaryRegion> regions = boundaryRegions(scene);
  ASSERT_EQ(regions.size(), 3u);
  EXPECT_EQ(regions[0].name, "Plane");
  EXPECT_EQ(regions[0].kind, Kind::Mirror);
  EXPECT_EQ(regions[0].axes, "y");
  EXPECT_EQ(regions[0].from[1], 2.0);
  EXPECT_EQ(regions[1].kind, Kind::HeldOutside);
  EXPECT_EQ(regions[1].axes, "x");
  EXPECT_EQ(regions[1].from[1], 1.0);
  EXPECT_EQ(regions[1].to[0], 3.0);
  EXPECT_EQ(regions[1].to[2], 0.0);
  EXPECT_EQ(regions[2].kind, Kind::Force);
  EXPECT_EQ(regions[2].from[2], 7.0);
  EXPECT_EQ(regions[2].to[2], 10.0);
}

template <int D>
void addReporter(BoundaryParts<D>& parts, const Teuchos::ParameterList&, const std::string& name)
{
  parts.effect.report = [name](const State<D>&, nlohmann::json& summary) {
    summary["boundaries"].push_back({{"name", name}});
  };
  parts.effect.memory = [](State<D>& state, Archive&) { state.clock.step = 7; };
  parts.supports.push_back(
      [](State<D>&) {
        return TimedConstraint<D>{{}, {}, TimeFunction::parse("1"), "Reporter"};
      });
}

/// What a type reports and keeps stays when supports and loads add theirs.
TEST(BoundaryTypes, OfAnApplicationMayReportAndKeep)
{
  BoundaryType type{Section("Reporter", "A support that reports."), {}, addReporter<2>, addReporter<3>};
  addBoundaryType(type);
  Teuchos::ParameterList scene("Rhegma");
  scene.sublist("Time").set("Final Time", 1.0).set("Update Scheme", "MUSL");
  scene.sublist("Boundaries").sublist("One").set("Type", "Reporter");
  const Effect<2> effect = makeBoundaries<2>(scene, false);
  State<2> state;
  nlohmann::json summary;
  effect.report(state, summary);
  EXPECT_EQ(summary["boundaries"][0]["name"], "One");
  Record record;
  Archive archive = Archive::saving(record);
  effect.memory(state, archive);
  EXPECT_EQ(state.clock.step, 7);
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
