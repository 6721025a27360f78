#include "Scenes.hpp"

#include "scene/Compatibility.hpp"

using namespace Rhegma;

namespace
{

/// A schema with a furnace that provides heat, pipes, and wells named after the pipes.
SceneSchema schema()
{
  Section furnace("Furnace", "Burns."), pipes("Pipes", "Carry."), wells("Wells", "Deep.");
  furnace.real("Power").byDefault(1.0).meaning("Of it.");
  furnace.provide(capability::heat);
  furnace.refuse({when::above("Furnace", "Power", 5.0), when::present("Pipes > *"), when::absent("Wells")},
                 "the pipes boil; add Wells");
  furnace.refuse({when::is("Furnace", "Open", {"true"}), when::isNot("Pipes", "Kind", {"Steel", "Copper"})},
                 "they melt", 1, 3);
  Section pipe("pipe", "One."), well("pipe", "One.");
  pipes.namedByUser(pipe);
  pipes.refuse({when::given("Pipes > *", "Temperature"), when::unprovided(capability::heat)},
               "nothing heats");
  wells.namedByUser(well);
  wells.namedAfter("Pipes", "there are no pipes");
  wells.refuse(
      {when::present("Wells > *"),
       when::satisfies("Pipes > *", "that leak", [](const auto& list) { return list.isParameter("Leak"); })},
      "it floods");
  return SceneSchema({furnace, pipes, wells});
}

std::vector<std::string> errorsOf(const Teuchos::ParameterList& scene)
{
  std::vector<SceneError> errors;
  checkRules(scene, schema(), errors);
  std::vector<std::string> texts;
  for (const SceneError& error : errors)
    texts.push_back(error.where + ": " + error.message);
  return texts;
}

using Texts = std::vector<std::string>;

} // namespace

TEST(Compatibility, HoldsWhereAllConditionsDo)
{
  Teuchos::ParameterList scene;
  scene.sublist("Furnace").set("Power", 6.0);
  EXPECT_EQ(errorsOf(scene), Texts{});
  scene.sublist("Pipes").sublist("A");
  scene.sublist("Pipes").sublist("B");
  EXPECT_EQ(errorsOf(scene), Texts{"Furnace > Power: the pipes boil; add Wells"});
  scene.sublist("Wells").sublist("B");
  EXPECT_EQ(errorsOf(scene), Texts{});
}

TEST(Compatibility, NamesTheListsOfTheSameName)
{
  Teuchos::ParameterList scene;
  scene.sublist("Pipes").sublist("A").set("Leak", true);
  scene.sublist("Pipes").sublist("B");
  scene.sublist("Wells").sublist("B");
  EXPECT_EQ(errorsOf(scene), Texts{});
  scene.sublist("Wells").sublist("A");
  EXPECT_EQ(errorsOf(scene), Texts{"Wells > A: it floods"});
}

TEST(Compatibility, KnowsWhatIsProvided)
{
  Teuchos::ParameterList scene;
  scene.sublist("Pipes").sublist("A").set("Temperature", 300.0);
  EXPECT_EQ(errorsOf(scene), Texts{"Pipes > A > Temperature: nothing heats"});
  scene.sublist("Furnace");
  EXPECT_EQ(errorsOf(scene), Texts{});
}

TEST(Compatibility, ListsMustHaveNamesOfAnotherSections)
{
  Teuchos::ParameterList scene;
  scene.sublist("Wells").sublist("C");
  EXPECT_EQ(errorsOf(scene), Texts{"Wells: there are no pipes"});
  scene.sublist("Pipes").sublist("A");
  scene.sublist("Pipes").sublist("B");
  EXPECT_EQ(errorsOf(scene), Texts{"Wells > C: there is no pipe of this name; Pipes has A, B"});
}

TEST(Compatibility, MayBeForOneDimension)
{
  Teuchos::ParameterList scene;
  scene.sublist("Furnace").set("Open", true);
  scene.sublist("Pipes").set<std::string>("Kind", "Lead");
  scene.sublist("Domain").set("Dimension", 2);
  EXPECT_EQ(errorsOf(scene), Texts{});
  scene.sublist("Domain").set("Dimension", 3);
  EXPECT_EQ(errorsOf(scene), Texts{"Pipes > Kind: they melt"});
  scene.sublist("Pipes").set<std::string>("Kind", "Copper");
  EXPECT_EQ(errorsOf(scene), Texts{});
}

TEST(Compatibility, IsInTheReference)
{
  const std::string text = describe(schema(), "");
  EXPECT_NE(text.find("Furnace > Power above 5, Pipes > *, without section Wells"), std::string::npos)
      << text;
  EXPECT_NE(text.find("Furnace > Open = true, Pipes > Kind other than Steel or Copper (3D)"),
            std::string::npos);
  EXPECT_NE(text.find("Pipes > * > Temperature, without section Furnace"), std::string::npos);
  EXPECT_NE(
      describeMarkdown(schema()).find("| Pipes > * > Temperature, without section Furnace | nothing heats |"),
      std::string::npos);
}
