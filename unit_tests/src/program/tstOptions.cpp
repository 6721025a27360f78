/// The command line.

#include "program/Options.hpp"
#include "program/Templates.hpp"

#include <gtest/gtest.h>

namespace Rhegma
{
namespace program
{

namespace
{

Options read(const std::vector<std::string>& arguments)
{
  std::vector<std::string> forKokkos;
  return readOptions(arguments, forKokkos);
}

std::string mistake(const std::vector<std::string>& arguments)
{
  try
  {
    read(arguments);
  }
  catch (const UsageError& error)
  {
    return error.what();
  }
  return {};
}

} // namespace

TEST(Options, KeepsAPageOnRequest)
{
  EXPECT_FALSE(read({"scene.xml"}).watch);
  EXPECT_TRUE(read({"scene.xml", "--watch"}).watch);
  EXPECT_NE(mistake({"scene.xml", "--watch", "--check"}).find("--watch keeps a page of a run"),
            std::string::npos);
}

TEST(Options, RunsASceneByDefault)
{
  const Options options = read({"dcb.xml"});
  EXPECT_EQ(options.action, Options::Action::Run);
  EXPECT_EQ(options.scene, "dcb.xml");
  EXPECT_TRUE(options.output.empty() && options.restart.empty() && options.overrides.empty());
  EXPECT_FALSE(options.quiet);
}

TEST(Options, TakeATemplate)
{
  const Options options = read({"--new", "dcb", "--output", "my.xml"});
  EXPECT_EQ(options.action, Options::Action::New);
  EXPECT_EQ(options.section, "dcb");
  EXPECT_EQ(options.output, "my.xml");
  EXPECT_EQ(read({"--new", "--output", "my.xml"}).section, "");
  EXPECT_NE(mistake({"--new", "dcb", "plate"}).find("\"plate\""), std::string::npos);
}

TEST(Templates, AreFoundByTheirNames)
{
  ASSERT_FALSE(sceneTemplates().empty());
  for (const SceneTemplate& one : sceneTemplates())
  {
    EXPECT_EQ(std::string(findTemplate(one.name).text), one.text);
    EXPECT_NE(std::string(one.text).find("<ParameterList name=\"Rhegma\">"), std::string::npos) << one.name;
    EXPECT_NE(usage().find(one.name), std::string::npos) << one.name << " is not in --help";
  }
  for (const std::string wrong : {"", "dbc", "DCB"})
    EXPECT_THROW(findTemplate(wrong), UsageError) << wrong;
}

TEST(Options, TakesValuesInAnyOrder)
{
  const Options options = read({"--set", "Time:CFL=0.2", "--output", "out", "dcb.xml", "--quiet", "--restart",
                                "checkpoint.h5", "--set", "Domain:Cell Size=1"});
  EXPECT_EQ(options.scene, "dcb.xml");
  EXPECT_EQ(options.output, "out");
  EXPECT_EQ(options.restart, "checkpoint.h5");
  EXPECT_EQ(options.overrides, (std::vector<std::string>{"Time:CFL=0.2", "Domain:Cell Size=1"}));
  EXPECT_TRUE(options.quiet);
}

TEST(Options, RunsTwiceFromTheStartOnly)
{
  EXPECT_TRUE(read({"dcb.xml", "--twice"}).twice);
  EXPECT_FALSE(read({"dcb.xml"}).twice);
  EXPECT_NE(mistake({"dcb.xml", "--twice", "--restart", "checkpoint.h5"}).find("--twice"), std::string::npos);
  EXPECT_NE(mistake({"dcb.xml", "--twice", "--check"}).find("--twice"), std::string::npos);
}

TEST(Options, JoinsTheNameOfASection)
{
  EXPECT_EQ(read({"--describe"}).section, "");
  EXPECT_EQ(read({"--describe", "Energy", "Release"}).section, "Energy Release");
  const Options options = read({"--describe", "Thermal", ">", "Sources", "--quiet"});
  EXPECT_EQ(options.action, Options::Action::Describe);
  EXPECT_EQ(options.section, "Thermal > Sources");
}

TEST(Options, NeedNoSceneWhereNothingRuns)
{
  for (const char* option : {"--describe", "--describe-markdown", "--version", "--help", "-h"})
    EXPECT_EQ(mistake({option}), "") << option;
  for (const char* option : {"--check", "--print-plan", "--quiet"})
    EXPECT_NE(mistake({option}).find("no scene"), std::string::npos) << option;
}

TEST(Options, LeaveKokkosItsOwn)
{
  std::vector<std::string> forKokkos;
  const Options options = readOptions({"--kokkos-map-device-id-by=random", "dcb.xml"}, forKokkos);
  EXPECT_EQ(options.scene, "dcb.xml");
  EXPECT_EQ(forKokkos, std::vector<std::string>{"--kokkos-map-device-id-by=random"});
}

TEST(Options, SayWhatIsWrong)
{
  EXPECT_NE(mistake({"dcb.xml", "--output"}).find("--output needs a value"), std::string::npos);
  EXPECT_NE(mistake({"dcb.xml", "--output", ""}).find("--output"), std::string::npos);
  EXPECT_NE(mistake({"dcb.xml", "--restart", ""}).find("--restart"), std::string::npos);
  EXPECT_NE(mistake({"dcb.xml", "--fast"}).find("no option --fast"), std::string::npos);
  EXPECT_NE(mistake({"one.xml", "two.xml"}).find("\"two.xml\""), std::string::npos);
}

} // namespace program
} // namespace Rhegma
