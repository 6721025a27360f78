#include "SmallState.hpp"
#include "output/Summary.hpp"

#include <cmath>
#include <stdexcept>

using nlohmann::json;
using Rhegma::addReferences;
using Rhegma::Folder;
using Rhegma::makeSummary;
using Rhegma::SummaryFacts;
using Teuchos::ParameterList;

namespace
{

void addReference(ParameterList& section, const std::string& name, const std::string& quantity, double value,
                  double tolerance)
{
  ParameterList& entry = section.sublist(name);
  entry.set<std::string>("Quantity", quantity);
  entry.set("Value", value);
  entry.set("Tolerance", tolerance);
  entry.set<std::string>("Source", "by hand");
}

json someSummary()
{
  return json::parse(R"({"energy": {"kinetic": 2.0, "residual": 1e-9}, "settled": true, "status": "finished",
    "empty": null, "cracks": [{"name": "Left"}, {"name": "Notch", "fronts": [{"G_J": 101.0}]}]})");
}

/// Result of one reference.
json judged(const std::string& quantity, double value, double tolerance)
{
  ParameterList section;
  addReference(section, "Only", quantity, value, tolerance);
  json summary = someSummary();
  const bool within = addReferences(section, summary);
  EXPECT_EQ(within, summary["references"][0]["within"].get<bool>());
  return summary["references"][0];
}

} // namespace

TEST(Summary, HasTheKeysThatScriptsRead)
{
  SummaryFacts facts;
  facts.scene = "dcb.xml";
  facts.steps = 10;
  facts.particles = 100;
  facts.particleSteps = 1000.0;
  facts.wallSeconds = 2.0e-3;
  facts.peakMemory = {3.0e6, 2.0e6};
  facts.stages = {{"Scatter", 1.0e-3}};
  const json summary =
      makeSummary(facts, {{"energy", {{"kinetic", 1.0}}}, {"cracks", {{{"name", "Notch"}}}}});
  for (const char* key : {"scene",
                          "version",
                          "backend",
                          "ranks",
                          "threads",
                          "effects",
                          "steps",
                          "time",
                          "wall_seconds",
                          "particles",
                          "particle_steps",
                          "ns_per_particle_step",
                          "peak_memory_bytes",
                          "peak_memory_bytes_of_ranks",
                          "bytes_per_particle",
                          "stages",
                          "energy",
                          "cracks",
                          "settled",
                          "references"})
    EXPECT_TRUE(summary.contains(key)) << key;
  EXPECT_DOUBLE_EQ(summary["ns_per_particle_step"].get<double>(), 2000.0);
  EXPECT_EQ(summary["cracks"][0]["name"], "Notch");
  EXPECT_DOUBLE_EQ(summary["stages"]["Scatter"].get<double>(), 1.0e-3);
  EXPECT_EQ(summary["peak_memory_bytes"], 5000000);
  EXPECT_EQ(summary["peak_memory_bytes_of_ranks"], json::parse("[3000000, 2000000]"));
  EXPECT_EQ(summary["bytes_per_particle"], 50000.0);
  EXPECT_GT(Rhegma::peakMemoryBytes(), 1.0e6);
}

TEST(Summary, OfARunWithoutStepsHasNoCostPerStep)
{
  EXPECT_TRUE(makeSummary(SummaryFacts(), json::object())["ns_per_particle_step"].is_null());
}

TEST(Summary, IsReplacedWhole)
{
  const Folder folder;
  const std::string path = folder.path("summary.json");
  Rhegma::writeSummary({{"status", "first"}, {"nan", std::nan("")}}, path);
  Rhegma::writeSummary({{"status", "second"}, {"scene", "\xff.xml"}}, path);
  EXPECT_EQ(json::parse(Rhegma::contents(path))["status"], "second");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
  EXPECT_THROW(Rhegma::writeSummary({}, folder.path("no/summary.json")), std::runtime_error);
}

TEST(References, FollowNamesAndPositions)
{
  const json result = judged("cracks.1.fronts.0.G_J", 100.0, 0.02);
  EXPECT_EQ(result["value"], 101.0);
  EXPECT_NEAR(result["relative_error"].get<double>(), 0.01, 1.0e-15);
  EXPECT_TRUE(result["within"].get<bool>());
  EXPECT_EQ(result["source"], "by hand");
  EXPECT_EQ(judged("cracks.Notch.fronts.0.G_J", 100.0, 0.02)["value"], 101.0);
  EXPECT_EQ(judged("settled", 1.0, 1.0e-12)["value"], 1.0);
}

TEST(References, AreRelative)
{
  EXPECT_TRUE(judged("energy.kinetic", 2.2, 0.1)["within"].get<bool>());
  EXPECT_FALSE(judged("energy.kinetic", 2.2, 0.09)["within"].get<bool>());
  EXPECT_FALSE(judged("energy.kinetic", -2.0, 1.0)["within"].get<bool>());
}

TEST(References, OfZeroAreAbsolute)
{
  EXPECT_TRUE(judged("energy.residual", 0.0, 1.0e-8)["within"].get<bool>());
  EXPECT_FALSE(judged("energy.kinetic", 0.0, 1.9)["within"].get<bool>());
  EXPECT_DOUBLE_EQ(judged("energy.kinetic", 0.0, 1.0)["relative_error"].get<double>(), 2.0);
}

TEST(References, OfWhatIsNotThereAreOutsideAndSayWhy)
{
  EXPECT_EQ(judged("energy.heat", 1.0, 1.0)["problem"],
            "energy has no \"heat\"; it has kinetic and residual");
  EXPECT_EQ(judged("cracks.2.length", 1.0, 1.0)["problem"], "cracks has no \"2\"; it is a list of 2");
  EXPECT_EQ(judged("cracks.Top.length", 1.0, 1.0)["problem"], "cracks has no \"Top\"; it is a list of 2");
  EXPECT_EQ(judged("energy.last_share", 1.0, 1.0)["problem"],
            "energy has no \"last_share\"; it is now named \"last_fraction\"");
  EXPECT_EQ(judged("settled.really", 1.0, 1.0)["problem"], "settled has no \"really\"; it is one value");
  EXPECT_EQ(judged("empty", 1.0, 1.0)["problem"], "empty is not a number");
  EXPECT_EQ(judged("status", 1.0, 1.0)["problem"], "status is not a number");
  EXPECT_EQ(judged("cracks", 1.0, 1.0)["problem"], "cracks is not a number");
  EXPECT_FALSE(judged("nothing", 0.0, 1.0)["within"].get<bool>());
  EXPECT_TRUE(judged("nothing", 0.0, 1.0)["value"].is_null());
  EXPECT_EQ(judged("", 0.0, 1.0)["problem"], " is not a number");
}

TEST(References, NotANumberIsOutside)
{
  ParameterList section;
  addReference(section, "Only", "x", 1.0, 1.0);
  json summary{{"x", std::nan("")}};
  EXPECT_FALSE(addReferences(section, summary));
  EXPECT_EQ(summary["references"][0]["problem"], "x is not a number");
}

TEST(References, AllMustBeWithin)
{
  ParameterList section;
  json summary = someSummary();
  EXPECT_TRUE(addReferences(section, summary));
  EXPECT_TRUE(summary["references"].empty());
  EXPECT_EQ(Rhegma::referencesAsText(summary), "");
  addReference(section, "Good", "energy.kinetic", 2.0, 0.01);
  addReference(section, "Bad", "cracks.1.fronts.0.G_J", 1.0, 0.01);
  EXPECT_FALSE(addReferences(section, summary));
  EXPECT_EQ(summary["references"].size(), 2u);
  EXPECT_EQ(Rhegma::referencesAsText(summary),
            "within   energy.kinetic = 2, reference 2, error 0 %, tolerance 1 % (by hand)\n"
            "OUTSIDE  cracks.1.fronts.0.G_J = 101, reference 1, error 1e+04 %, tolerance 1 % (by hand)\n");
}

/// A run without a single comparison does not pass for one that has been compared.
TEST(References, AtLeastOneIsCompared)
{
  ParameterList section;
  addReference(section, "Start", "propagation.initiated", 1.0, 0.01);
  json summary = someSummary();
  summary["propagation"] = {{"load_factor", 2.0}, {"initiated", 1.0}};
  EXPECT_FALSE(addReferences(section, summary));
  EXPECT_NE(Rhegma::referencesAsText(summary).find("none of the references could be compared"),
            std::string::npos);
  addReference(section, "Good", "energy.kinetic", 2.0, 0.01);
  EXPECT_TRUE(addReferences(section, summary));
  EXPECT_EQ(Rhegma::referencesAsText(summary).find("none of the references"), std::string::npos);
}

/// Of a run whose loads have a factor; times of growth are not compared.
TEST(References, ThatAreAllTimesAreWarnedOf)
{
  ParameterList section;
  EXPECT_EQ(Rhegma::warningOfReferences(section), "");
  addReference(section, "Start", "cracks.0.fronts.0.initiated", 1.0, 0.01);
  EXPECT_NE(Rhegma::warningOfReferences(section).find("none of the references will be compared"),
            std::string::npos);
  addReference(section, "Good", "energy.kinetic", 2.0, 0.01);
  EXPECT_EQ(Rhegma::warningOfReferences(section), "");
}
