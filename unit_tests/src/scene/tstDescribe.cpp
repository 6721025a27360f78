#include "Scenes.hpp"

#include "base/Numbers.hpp"
#include "scene/NearestName.hpp"
#include "scene/NormaliseValue.hpp"
#include "scene/Validators.hpp"

#include <Teuchos_ParameterListExceptions.hpp>

#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>

using namespace Rhegma;
using namespace Rhegma::SceneTests;

namespace
{

void forEachSection(const Section& section, const std::function<void(const Section&)>& visit)
{
  visit(section);
  for (const auto* below : {&section.sections, &section.variants, &section.entry})
    for (const auto& sub : *below)
      forEachSection(sub, visit);
}

bool contains(const std::string& text, const std::string& piece)
{
  return text.find(piece) != std::string::npos;
}

} // namespace

TEST(Describe, HoldsEveryParameterWithItsMeaning)
{
  const auto schema = coreSchema();
  const std::string plain = describe(schema, "");
  const std::string markdown = describeMarkdown(schema);
  int parameters = 0;
  forEachSection(schema.root(),
                 [&](const Section& section)
                 {
                   for (const auto& p : section.parameters)
                   {
                     ++parameters;
                     EXPECT_TRUE(contains(plain, "  " + p.name + "  ")) << p.name;
                     EXPECT_TRUE(contains(plain, p.meaning)) << p.name;
                     EXPECT_TRUE(contains(markdown, "| " + p.name + " |")) << p.name;
                     EXPECT_TRUE(contains(markdown, p.meaning)) << p.name;
                   }
                 });
  EXPECT_GT(parameters, 60);
}

TEST(Describe, OneParameterInFull)
{
  const std::string text = describe(coreSchema(), "Time");
  EXPECT_TRUE(contains(text, "Time  (required)"));
  EXPECT_TRUE(contains(text, "Final Time  double [s]; required; above 0"));
  EXPECT_TRUE(contains(text, "CFL  double; default 0.4; above 0 and at most 1"));
  EXPECT_TRUE(contains(text, "Update Scheme  string; default MUSL; one of MUSL, USF, USL or USAVG"));
  EXPECT_FALSE(contains(text, "Materials"));
}

TEST(Describe, VariantsEntriesAndRules)
{
  const std::string text = describe(coreSchema(), "");
  EXPECT_TRUE(contains(text, "Materials > <material>  (Model = J2 Plastic)"));
  EXPECT_TRUE(contains(text, "Bodies > <body> > Operations > <operation>  (Shape = Cylinder, 3D only)"));
  EXPECT_TRUE(contains(text, "Exactly one of Stress, Pressure or Force is given."));
  EXPECT_TRUE(contains(text, "default {0, 0} in 2D, {0, 0, 0} in 3D"));
}

TEST(Describe, UnknownSectionNamesTheNearest)
{
  try
  {
    describe(coreSchema(), "Bodys");
    ADD_FAILURE();
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_TRUE(contains(error.what(), "\"Bodies\"")) << error.what();
  }
}

TEST(Describe, PartsOfASection)
{
  const auto schema = coreSchema();
  // A section in a section, under a user-defined name, in both notations of a path.
  const std::string operations = describe(schema, "Bodies > Plate > Operations");
  EXPECT_TRUE(contains(operations, "Bodies > Plate > Operations  (optional)"));
  EXPECT_TRUE(contains(operations, "Bodies > Plate > Operations > <operation>"));
  EXPECT_FALSE(contains(operations, "Angular Velocity"));
  EXPECT_EQ(describe(schema, "Bodies:Plate:Operations"), operations);
  EXPECT_TRUE(contains(describe(schema, "Bodies > <body>"), "Angular Velocity"));
  // A common parameter of variants appears once.
  const std::string step = describe(schema, "Time > CFL");
  EXPECT_TRUE(contains(step, "CFL  double; default 0.4"));
  EXPECT_FALSE(contains(step, "Final Time"));
  const std::string history = describe(schema, "Boundaries:Pull:History");
  EXPECT_EQ(history.find("  History  string"), history.rfind("  History  string"));
  EXPECT_TRUE(contains(history, "  History  string"));
}

TEST(Describe, AWrongPartNamesTheNearest)
{
  for (const auto& [path, nearest] :
       std::map<std::string, std::string>{{"Domain > Cell Syze", "\"Cell Size\""},
                                          {"Bodies > Plate > Operation", "\"Operations\""},
                                          {"Time > CFL > Limit", "Time > CFL is a parameter"}})
    try
    {
      describe(coreSchema(), path);
      ADD_FAILURE() << path;
    }
    catch (const std::invalid_argument& error)
    {
      EXPECT_TRUE(contains(error.what(), nearest)) << error.what();
    }
}

TEST(Schema, EveryParameterAndSectionSaysWhatItMeans)
{
  forEachSection(coreSchema().root(),
                 [](const Section& section)
                 {
                   EXPECT_FALSE(section.meaning.empty()) << section.name;
                   for (const auto& p : section.parameters)
                     EXPECT_FALSE(p.meaning.empty()) << section.name << " > " << p.name;
                 });
}

TEST(Schema, EveryDefaultIsValid)
{
  forEachSection(coreSchema().root(),
                 [](const Section& section)
                 {
                   for (const auto& p : section.parameters)
                     for (const int dimension : {2, 3})
                       if (const auto* value = p.defaultIn(dimension); value && p.existsIn(dimension))
                       {
                         Teuchos::ParameterList list;
                         setValue(list, p, *value);
                         EXPECT_EQ(normaliseValue(list, p, dimension).value_or(""), "")
                             << section.name << " > " << p.name;
                       }
                 });
}

TEST(ValidParameters, CarryDocumentationAndValidators)
{
  const auto schema = coreSchema();
  const auto list = validParameters(*schema.root().findSection("Time"));
  EXPECT_EQ(list->get<double>("CFL"), 0.4);
  EXPECT_TRUE(contains(list->getEntry("Final Time").docString(), "[s]; above 0; required"));
  Teuchos::ParameterList given;
  given.set("Final Time", 1.0).set("CFL", 0.5);
  EXPECT_NO_THROW(given.validateParametersAndSetDefaults(*list));
  EXPECT_EQ(given.get<std::string>("Update Scheme"), "MUSL");
  for (const double wrong : {0.0, -1.0, 1.0000000000000002, std::nan("")})
  {
    Teuchos::ParameterList bad;
    bad.set("CFL", wrong);
    EXPECT_THROW(bad.validateParameters(*list), Teuchos::Exceptions::InvalidParameterValue) << wrong;
  }
  Teuchos::ParameterList bad;
  bad.set("Update Scheme", "MUSSL");
  EXPECT_THROW(bad.validateParameters(*list), Teuchos::Exceptions::InvalidParameterValue);
}

TEST(ValidParameters, CanBeMadeOfEverySection)
{
  forEachSection(coreSchema().root(),
                 [](const Section& section)
                 {
                   const auto list = validParameters(section);
                   for (const auto& p : section.parameters)
                     EXPECT_TRUE(list->isParameter(p.name)) << section.name << " > " << p.name;
                 });
}

TEST(NearestName, CountsInsertionsDeletionsChangesAndSwaps)
{
  EXPECT_EQ(editDistance("Time", "time"), 0);
  EXPECT_EQ(editDistance("Tiem", "Time"), 1);
  EXPECT_EQ(editDistance("Tim", "Time"), 1);
  EXPECT_EQ(editDistance("Youngs Modulus", "Young Modulus"), 1);
  EXPECT_EQ(editDistance("kitten", "sitting"), 3);
  EXPECT_EQ(editDistance("", "abc"), 3);
}

TEST(NearestName, IsNearOrNone)
{
  EXPECT_EQ(nearestName("Bodys", {"Domain", "Bodies", "Time"}), "Bodies");
  EXPECT_EQ(nearestName("Colour", {"Domain", "Bodies", "Time"}), "");
  EXPECT_EQ(nearestName("q", {"x", "y"}), "");
  EXPECT_EQ(nearestName("x", {}), "");
}

TEST(Numbers, AreReadStrictly)
{
  EXPECT_EQ(parseReal(" +1.5e-3 "), 1.5e-3);
  EXPECT_EQ(parseReal("-0.25"), -0.25);
  EXPECT_EQ(parseReal("1e-999"), 0.0);
  EXPECT_TRUE(std::isinf(parseReal("1e999").value_or(0.0)));
  for (const std::string wrong : {"", " ", "1.5Pa", "1,5", "1 2", "0x1", "1d3", "+-1", "--1", "e5", "."})
    EXPECT_FALSE(parseReal(wrong)) << wrong;
  EXPECT_EQ(parseInteger("1e3"), 1000);
  EXPECT_FALSE(parseInteger("2.5"));
  EXPECT_FALSE(parseInteger("2147483648"));
  EXPECT_FALSE(parseInteger("nan"));
}

TEST(Numbers, ArraysInThreeWritings)
{
  const std::vector<double> expected = {1.0, -2.0, 3.5};
  for (const std::string text : {"{1, -2, 3.5}", "1,-2,3.5", " 1  -2\t3.5 "})
    EXPECT_EQ(parseReals(text), expected) << text;
  EXPECT_EQ(parseReals("{}"), std::vector<double>());
  for (const std::string wrong : {"{1, 2", "1, 2}", "{1,,2}", "{1, 2,}", "{1 a}"})
    EXPECT_FALSE(parseReals(wrong)) << wrong;
  const std::vector<double> digits = {0.1, 1.0 / 3.0, 1e-300};
  EXPECT_EQ(parseReals(formatReals(digits)), digits);
}
