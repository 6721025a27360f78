/// How far answers move from one run to another, on made-up results.

#include "program/CompareRuns.hpp"
#include "program/RunEnd.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <limits>
#include <unistd.h>

namespace Rhegma::program
{
namespace Test
{

namespace
{

using nlohmann::json;

RunResults ended()
{
  RunResults run;
  writeEnd(RunEnd::Finished, "", run.summary);
  return run;
}

RunResults atRest(double release)
{
  RunResults run = ended();
  run.summary["cells"]["smallest"] = 0.01;
  json crack = {{"name", "Notch"}, {"length", 0.1}};
  crack["fronts"].push_back({{"G_J", release}, {"K_I", 2.0}, {"K_II", 1e-6}});
  run.summary["cracks"].push_back(crack);
  return run;
}

/// A front that runs along y = rise * x, and is arrested at x = end.
RunResults running(double rise, double end)
{
  RunResults run = atRest(3.0);
  json& front = run.summary["cracks"][0]["fronts"][0];
  front["initiated"] = 1e-5;
  front["status"] = "arrested";
  front["settled_speed"] = 500.0;
  front["position"] = std::vector<double>{end, rise * end};
  for (int k = 0; k <= 10; ++k)
  {
    run.history["Notch.0.x"].push_back(0.1 * k * end);
    run.history["Notch.0.y"].push_back(rise * 0.1 * k * end);
  }
  return run;
}

json answer(const json& comparison, const std::string& name)
{
  for (const json& one : comparison["answers"])
    if (one["name"] == name)
      return one;
  ADD_FAILURE() << "no " << name << " in " << comparison.dump(1);
  return {};
}

} // namespace

/// An error of the first order: 10 + 0.4, 10 + 0.2, so 10. K_II is as good as zero and is not compared.
TEST(CompareRuns, ExtrapolatesARateAtRest)
{
  const json comparison = compareRuns(atRest(10.4), atRest(10.2));
  const json release = answer(comparison, "G_J of Notch.0");
  EXPECT_NEAR(release["extrapolated"].get<double>(), 10.0, 1e-12);
  EXPECT_EQ(release["order"], 1);
  // An error of the second order: 10.2 - 0.2 / 3.
  EXPECT_NEAR(release["extrapolated_order_2"].get<double>(), 10.2 - 0.2 / 3.0, 1e-12);
  EXPECT_NE(comparisonAsText(comparison).find(" 10.13 to 10 "), std::string::npos);
  EXPECT_NEAR(release["change"].get<double>(), -0.2 / 10.2, 1e-12);
  EXPECT_TRUE(comparison["resolved"].get<bool>());
  EXPECT_EQ(comparison.dump().find("K_II"), std::string::npos);
  EXPECT_NE(comparisonAsText(comparison).find("Verdict: resolved"), std::string::npos);
}

/// A third is too much for an order to hold.
TEST(CompareRuns, DoesNotExtrapolateFromCellsThatAreTooLarge)
{
  const json comparison = compareRuns(atRest(10.0), atRest(15.0));
  EXPECT_FALSE(answer(comparison, "G_J of Notch.0").contains("extrapolated"));
  EXPECT_FALSE(comparison["resolved"].get<bool>());
  EXPECT_NE(comparisonAsText(comparison)
                .find("Verdict: not resolved: G_J of Notch.0 (moves by 33.33 %); use smaller cells\n"),
            std::string::npos);
}

/// A run of few increments has no speed, and rows of its history may have no position: neither is printed as
/// a number.
TEST(CompareRuns, AnswersThatARunDoesNotHaveAreNoNumbers)
{
  for (const bool isFirst : {true, false})
  {
    RunResults few = running(0.0, 0.1);
    few.summary["cracks"][0]["fronts"][0]["settled_speed"] = nullptr;
    for (const char* column : {"Notch.0.x", "Notch.0.y"})
      few.history[column][3] = std::numeric_limits<double>::quiet_NaN();
    const RunResults usual = running(0.0, 0.1);
    const json comparison = isFirst ? compareRuns(few, usual) : compareRuns(usual, few);
    const std::string text = comparisonAsText(comparison);
    EXPECT_EQ(text.find("nan"), std::string::npos) << text;
    EXPECT_EQ(text.find("inf"), std::string::npos) << text;
    EXPECT_NEAR(answer(comparison, "path of Notch.0")["cells"].get<double>(), 0.0, 1e-9);
    EXPECT_FALSE(answer(comparison, "speed of Notch.0")["resolved"].get<bool>());
  }
}

/// Over 0.1 m a path that rises by 0.32 of x ends 0.0305 m from the axis's direction, 3.05 cells; the axis
/// goes on beyond it. Of paths alike only the ends differ.
TEST(CompareRuns, MeasuresPathsInCells)
{
  const json apart = compareRuns(running(0.32, 0.1), running(0.0, 0.2));
  EXPECT_NEAR(answer(apart, "path of Notch.0")["cells"].get<double>(), 3.2, 1e-9);
  EXPECT_NE(comparisonAsText(apart).find("path of Notch.0 (differs by 3.2 cells)"), std::string::npos);
  const json alike = compareRuns(running(0.0, 0.1), running(0.0, 0.2));
  EXPECT_TRUE(answer(alike, "path of Notch.0")["resolved"].get<bool>());
  EXPECT_NEAR(answer(alike, "last position of Notch.0")["cells"].get<double>(), 10.0, 1e-9);
  EXPECT_FALSE(alike["resolved"].get<bool>());
  EXPECT_FALSE(answer(alike, "speed of Notch.0").contains("extrapolated"));
}

/// A front that starts at once does so in the first of 100 steps of 1 us, at times whose ratio says nothing;
/// one that starts two steps later does differ.
TEST(CompareRuns, TimesWithinAStepAreTheSame)
{
  const auto starting = [](double time, int steps)
  {
    RunResults run = running(0.0, 0.1);
    run.summary["cracks"][0]["fronts"][0]["initiated"] = time;
    run.summary["time"] = 1e-4;
    run.summary["steps"] = steps;
    return run;
  };
  const json atOnce = answer(compareRuns(starting(9e-7, 100), starting(4e-7, 200)), "initiation of Notch.0");
  EXPECT_EQ(atOnce["verdict"], "differs by less than a time step: resolved");
  EXPECT_NEAR(atOnce["change"].get<double>(), -1.25, 1e-12);
  const json later = answer(compareRuns(starting(9e-7, 100), starting(29e-7, 200)), "initiation of Notch.0");
  EXPECT_FALSE(later["resolved"].get<bool>());
}

/// In equilibrium under a factor a front starts in the first load step whatever the cells; the factor moves.
TEST(CompareRuns, ComparesTheLoadOfInitiationAndNotItsLoadStep)
{
  const auto growing = [](double factor, double displacement)
  {
    RunResults run = running(0.0, 0.1);
    run.summary["cracks"][0]["fronts"][0]["status"] = "growing";
    run.summary["propagation"] = {{"load_factor", 1.4},
                                  {"initiation", {{"load_factor", factor}, {"time", 0.5}}}};
    run.history["time"] = {0.25, 0.5, 1.0};
    run.history["Top.displacement"] = {0.0, displacement, 9.0 * displacement};
    return run;
  };
  const json apart = compareRuns(growing(4.3, 2e-5), growing(2.755, 2.01e-5));
  EXPECT_NEAR(answer(apart, "load factor at initiation")["change"].get<double>(), 2.755 / 2.755 - 4.3 / 2.755,
              1e-12);
  EXPECT_FALSE(answer(apart, "load factor at initiation")["resolved"].get<bool>());
  EXPECT_EQ(answer(apart, "Top, displacement at initiation")["half"].get<double>(), 2.01e-5);
  EXPECT_TRUE(answer(apart, "Top, displacement at initiation")["resolved"].get<bool>());
  EXPECT_FALSE(apart["resolved"].get<bool>());
  EXPECT_EQ(apart.dump().find("initiation of Notch.0"), std::string::npos);
  EXPECT_EQ(answer(apart, "end of Notch.0")["as_is"], "growing");
  EXPECT_TRUE(compareRuns(growing(2.8, 2e-5), growing(2.755, 2.01e-5))["resolved"].get<bool>());
  EXPECT_FALSE(
      answer(compareRuns(growing(2.8, 2e-5), running(0.0, 0.1)), "load factor at initiation")["resolved"]
          .get<bool>());
}

/// Increments are measured in cells, so that with half the cells the same number of load steps leads to half
/// the growth: loads are compared at a growth that both have, 1 mm, where the first run is half between two
/// rows. In 3D the growth is that of the area, since the length is that of the front.
TEST(CompareRuns, ComparesLoadsAtTheSameGrowth)
{
  const auto growing = [](double increment, double first, double last, const std::string& column)
  {
    RunResults run = running(0.0, 0.1);
    run.summary["cracks"][0]["fronts"][0]["status"] = "growing";
    run.summary["cracks"][0]["fronts"][0]["position"] = {100.0 * increment, 0.0};
    run.summary["propagation"]["initiation"] = {{"load_factor", first}, {"time", 0.5}};
    run.history["Notch.0.length"] = {0.05, 0.07};
    run.history[column] = {0.1, 0.1 + increment};
    run.history["load_factor"] = {first, last};
    return run;
  };
  const std::string column = "Notch.0.length", area = "Notch.area";
  const json same = compareRuns(growing(2e-3, 2.0, 1.0, column), growing(1e-3, 2.0, 1.5, column));
  EXPECT_NEAR(answer(same, "load factor at the same growth")["as_is"].get<double>(), 1.5, 1e-12);
  EXPECT_NEAR(answer(same, "load factor at the same growth")["growth"].get<double>(), 1e-3, 1e-12);
  EXPECT_EQ(answer(same, "load factor at the same growth")["unit_of_growth"], "m");
  EXPECT_TRUE(same["resolved"].get<bool>()) << same.dump(1);
  EXPECT_EQ(same.dump().find("last position"), std::string::npos);
  const json apart = compareRuns(growing(2e-3, 2.0, 1.0, column), growing(1e-3, 2.0, 1.2, column));
  EXPECT_FALSE(answer(apart, "load factor at the same growth")["resolved"].get<bool>());
  const json in3D = compareRuns(growing(2e-3, 2.0, 1.0, area), growing(1e-3, 2.0, 1.5, area));
  EXPECT_TRUE(answer(in3D, "load factor at the same growth")["resolved"].get<bool>());
  EXPECT_EQ(answer(in3D, "load factor at the same growth")["unit_of_growth"], "m2");
}

/// Names whose characters have several bytes take the width of their characters.
TEST(CompareRuns, ColumnsStandBelowEachOtherWithAnyName)
{
  std::size_t width = 0;
  for (const std::string name : {"Kerbe", "K\xC3\xA4rbe", "\xE5\x88\x87\xE5\x8F\xA3"})
  {
    RunResults one = atRest(10.4), other = atRest(10.2);
    one.summary["cracks"][0]["name"] = other.summary["cracks"][0]["name"] = name;
    const std::string text = comparisonAsText(compareRuns(one, other));
    const std::size_t begin = text.find("G_J of " + name), number = text.find("10.4", begin);
    ASSERT_NE(number, std::string::npos) << text;
    std::size_t characters = 0;
    for (std::size_t k = begin; k < number; ++k)
      characters += (static_cast<unsigned char>(text[k]) & 0xC0) != 0x80 ? 1 : 0;
    EXPECT_EQ(characters, width == 0 ? characters : width) << text;
    width = characters;
  }
}

/// Under given loads all fronts start at the end of a load step; the time within it is compared.
TEST(CompareRuns, ComparesTheTimeWithinTheLoadStepUnderGivenLoads)
{
  const auto growing = [](double time)
  {
    RunResults run = running(0.0, 0.1);
    run.summary["cracks"][0]["fronts"][0]["initiated"] = 1.0;
    run.summary["propagation"] = {{"initiation", {{"time", time}, {"from", 0.5}, {"to", 1.0}}}};
    return run;
  };
  const json apart = compareRuns(growing(0.6), growing(0.9));
  EXPECT_NEAR(answer(apart, "time at which cracks start")["change"].get<double>(), 0.3 / 0.9, 1e-12);
  EXPECT_FALSE(apart["resolved"].get<bool>());
  EXPECT_EQ(apart.dump().find("initiation of Notch.0"), std::string::npos);
  EXPECT_TRUE(compareRuns(growing(0.88), growing(0.9))["resolved"].get<bool>());
}

/// An arrest on one of the meshes and none on the other.
TEST(CompareRuns, SaysThatEndsDiffer)
{
  RunResults other = running(0.0, 0.1);
  other.summary["cracks"][0]["fronts"][0]["status"] = "ended";
  const json comparison = compareRuns(running(0.0, 0.1), other);
  EXPECT_EQ(answer(comparison, "end of Notch.0")["as_is"], "arrested");
  EXPECT_EQ(answer(comparison, "end of Notch.0")["half"], "ended");
  EXPECT_FALSE(comparison["resolved"].get<bool>());
}

/// A status may have a reason after it, and is that of the front and not of its flags: a front that moved and
/// is now at rest with G not below its toughness is not arrested.
TEST(CompareRuns, TakesTheStatusOfAFront)
{
  RunResults one = running(0.0, 0.1), other = running(0.0, 0.1);
  one.summary["cracks"][0]["fronts"][0]["status"] = "stopped: less than three cells from crack A";
  other.summary["cracks"][0]["fronts"][0]["status"] = "at rest";
  const json end = answer(compareRuns(one, other), "end of Notch.0");
  EXPECT_EQ(end["as_is"], "stopped");
  EXPECT_EQ(end["half"], "at rest");
}

/// Runs that were cut off, or that were still moving when the scene asked for rest, say nothing of its end.
TEST(CompareRuns, NothingIsResolvedBeforeTheEnd)
{
  RunResults one = atRest(10.4), other = atRest(10.2);
  for (RunResults* run : {&one, &other})
    writeEnd(RunEnd::Finished, "", run->summary);
  EXPECT_TRUE(compareRuns(one, other)["resolved"].get<bool>());
  writeEnd(RunEnd::NotAtRest, "", one.summary);
  const json moving = compareRuns(one, other);
  EXPECT_FALSE(moving["resolved"].get<bool>());
  EXPECT_FALSE(answer(moving, "G_J of Notch.0").contains("extrapolated"));
  EXPECT_EQ(answer(moving, "end of the run")["as_is"], "not at rest");
  EXPECT_NE(comparisonAsText(moving).find("As it is: finished before the bodies were at rest"),
            std::string::npos);
  writeEnd(RunEnd::Finished, "", one.summary);
  writeEnd(RunEnd::CutOff, "", other.summary);
  const json cut = compareRuns(one, other);
  EXPECT_FALSE(cut["resolved"].get<bool>());
  EXPECT_NE(cut["verdict"].get<std::string>().find("raise Time > Maximum Steps"), std::string::npos);
}

/// The worse end decides what is advised: what stops a run comes before what cuts the other off.
TEST(CompareRuns, AdvisesByTheWorseEnd)
{
  RunResults stopped = atRest(10.4), cut = atRest(10.2);
  writeEnd(RunEnd::Stopped, "the run stopped at t = 1 ms, step 7: a particle left the domain",
           stopped.summary);
  writeEnd(RunEnd::CutOff, "", cut.summary);
  const auto verdict = [](const RunResults& asIs, const RunResults& half)
  { return compareRuns(asIs, half)["verdict"].get<std::string>(); };
  EXPECT_NE(verdict(stopped, cut).find("see why the run stops with the cells of the scene"),
            std::string::npos);
  EXPECT_NE(verdict(cut, stopped).find("see why the run stops with half the cell size"), std::string::npos);
  EXPECT_NE(verdict(stopped, stopped).find("see why the runs stopped"), std::string::npos);
  EXPECT_NE(verdict(cut, cut).find("raise Time > Maximum Steps"), std::string::npos);
}

/// A front that the cells stop in both runs, which both go on to their end: what it has then is no answer.
TEST(CompareRuns, NothingIsResolvedWhereTheCellsStopAFront)
{
  RunResults one = running(0.0, 0.1), other = running(0.0, 0.1);
  EXPECT_TRUE(compareRuns(one, other)["resolved"].get<bool>());
  for (RunResults* run : {&one, &other})
    run->summary["cracks"][0]["fronts"][0]["stopped"] = true;
  const json both = compareRuns(one, other);
  EXPECT_FALSE(both["resolved"].get<bool>());
  EXPECT_EQ(answer(both, "fronts stopped by the cells")["half"], "stopped");
  for (const json& each : both["answers"]) // when cracks start is of an earlier time
    EXPECT_EQ(each["resolved"].get<bool>(), each["name"] == "initiation of Notch.0") << each;
  EXPECT_FALSE(compareRuns(running(0.0, 0.1), other)["resolved"].get<bool>());
}

/// Where a run stops, what both have at one time is compared all the same, nothing is extrapolated, and the
/// reason is said. What they have at different times is not compared.
TEST(CompareRuns, ComparesRunsThatStop)
{
  RunResults stopped = atRest(10.4), finished = atRest(10.2);
  writeEnd(RunEnd::Stopped, "the run stopped at t = 1 ms, step 7: crack Notch, front 0 stopped",
           stopped.summary);
  stopped.summary["time"] = 1e-3;
  writeEnd(RunEnd::Finished, "", finished.summary);
  finished.summary["time"] = 2e-3;
  const json better = compareRuns(stopped, finished);
  EXPECT_EQ(answer(better, "end of the run")["as_is"], "stopped");
  EXPECT_EQ(answer(better, "end of the run")["half"], "finished");
  EXPECT_EQ(answer(better, "time reached")["change"].get<double>(), 0.5);
  for (const json& each : better["answers"])
    EXPECT_NE(each["name"], "G_J of Notch.0");
  RunResults asLate = finished;
  asLate.summary["time"] = 1e-3;
  const json together = compareRuns(stopped, asLate);
  EXPECT_FALSE(answer(together, "G_J of Notch.0").contains("extrapolated"));
  EXPECT_EQ(answer(together, "G_J of Notch.0")["verdict"], "moves by -1.961 %: not judged, as a run stopped");
  EXPECT_FALSE(better["resolved"].get<bool>());
  EXPECT_EQ(better["runs"]["as_is"]["status"], stopped.summary["status"]);
  const std::string text = comparisonAsText(better);
  EXPECT_NE(text.find("As it is: the run stopped at t = 1 ms"), std::string::npos) << text;
  EXPECT_NE(text.find("the run finishes with half the cell size"), std::string::npos) << text;
  const json worse = compareRuns(finished, stopped);
  EXPECT_NE(comparisonAsText(worse).find("With half: the run stopped"), std::string::npos);
  EXPECT_FALSE(compareRuns(stopped, stopped)["resolved"].get<bool>());
  EXPECT_FALSE(answer(compareRuns(stopped, stopped), "end of the run")["resolved"].get<bool>());
}

/// An error of the second order: 100 - 4, 100 - 1.
TEST(CompareRuns, ExtrapolatesAPeakOfTemperature)
{
  RunResults one = ended(), other = ended();
  one.summary["temperature"]["peak_rise"] = 96.0;
  other.summary["temperature"]["peak_rise"] = 99.0;
  const json comparison = compareRuns(one, other);
  EXPECT_NEAR(answer(comparison, "peak rise of temperature")["extrapolated"].get<double>(), 100.0, 1e-12);
}

/// Bodies that are only cooled: their fall, with an error of the first order: 200 - 8, 200 - 4.
TEST(CompareRuns, JudgesTheFallOfBodiesThatAreCooled)
{
  RunResults one = ended(), other = ended();
  one.summary["temperature"] = {{"peak_rise", -3.0}, {"largest_fall", 192.0}};
  other.summary["temperature"] = {{"peak_rise", 0.1}, {"largest_fall", 196.0}};
  const json cooled = compareRuns(one, other);
  EXPECT_NEAR(answer(cooled, "largest fall of temperature")["extrapolated"].get<double>(), 200.0, 1e-12);
  for (const json& each : cooled["answers"])
    EXPECT_NE(each["name"], "peak rise of temperature");
  other.summary["temperature"]["peak_rise"] = 50.0;
  EXPECT_EQ(answer(compareRuns(one, other), "peak rise of temperature")["half"], 50.0);
}

/// A front that only one of them has, and runs with nothing to compare.
TEST(CompareRuns, MissesNothing)
{
  RunResults branched = atRest(10.0);
  branched.summary["cracks"][0]["fronts"].push_back(json::object());
  EXPECT_FALSE(answer(compareRuns(atRest(10.0), branched), "fronts of Notch")["resolved"].get<bool>());
  RunResults lost = atRest(10.0);
  lost.summary["cracks"][0]["fronts"][0]["G_J"] = nullptr;
  EXPECT_FALSE(answer(compareRuns(atRest(10.0), lost), "G_J of Notch.0")["resolved"].get<bool>());
  EXPECT_FALSE(compareRuns(ended(), ended())["resolved"].get<bool>());
}

/// Nothing is resolved by runs in which nothing happens; a zero next to other answers says nothing of them.
TEST(CompareRuns, DoesNotResolveZeros)
{
  const auto still = []
  {
    RunResults run = atRest(0.0);
    for (const char* mode : {"K_I", "K_II"})
      run.summary["cracks"][0]["fronts"][0][mode] = 0.0;
    return run;
  };
  const json comparison = compareRuns(still(), still());
  EXPECT_FALSE(comparison["resolved"].get<bool>());
  EXPECT_NE(
      comparisonAsText(comparison).find("Verdict: nothing to compare: all results are zero in both runs"),
      std::string::npos);
  EXPECT_EQ(answer(comparison, "G_J of Notch.0")["verdict"], "zero in both: not compared");
  EXPECT_FALSE(compareRuns(still(), atRest(1.0))["resolved"].get<bool>());
  RunResults heated = still(), other = still();
  heated.summary["temperature"]["peak_rise"] = other.summary["temperature"]["peak_rise"] = 9.0;
  EXPECT_TRUE(compareRuns(heated, other)["resolved"].get<bool>());
}

TEST(CompareRuns, ReadsAHistory)
{
  const std::string path = "history_of_test_" + std::to_string(getpid()) + ".csv";
  std::ofstream(path) << "time,\"A, \"\"B\"\".0.x\",Notch.0.x\n0,2.5,1.5\n1,2.5,nan\n";
  const HistoryColumns columns = readHistory(path);
  std::remove(path.c_str());
  EXPECT_EQ(columns.at("time"), (std::vector<double>{0.0, 1.0}));
  EXPECT_EQ(columns.at("Notch.0.x").front(), 1.5);
  EXPECT_EQ(columns.at("A, \"B\".0.x").back(), 2.5);
  EXPECT_TRUE(readHistory(path).empty());
}

} // namespace Test
} // namespace Rhegma::program
