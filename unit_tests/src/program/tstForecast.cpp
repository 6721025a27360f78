/// Cost of a run from the rates of its steps, and the rates that are kept.

#include "program/Checkpoints.hpp"
#include "program/Forecast.hpp"
#include "program/RateCache.hpp"
#include "program/Twice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <unistd.h>

namespace Rhegma::program
{
namespace Test
{

namespace
{

Teuchos::ParameterList scene()
{
  Teuchos::ParameterList list;
  list.sublist("Domain").set("Cell Size", 0.5).set("Accuracy", std::string("3 %"));
  list.sublist("Time").set("Final Time", 1.0).set("Maximum Steps", 2000000000);
  list.sublist("Output").set("Fields", true).set("History Interval", 0.1).set("Field Interval", 0.25);
  return list;
}

/// Ten steps of 1 ms, for which 0.1 s are simulated.
StepRates rates()
{
  StepRates r;
  r.setup = 0.5;
  r.spent = 0.01;
  r.step = 1e-3;
  r.sample = 2e-3;
  r.frame = 5e-3;
  r.frameBytes = 1000.0;
  r.memory = 1e8;
  r.timeStep = 0.01;
  r.time = 0.1;
  r.particles = 64;
  r.steps = 10;
  return r;
}

class Folder
{
public:
  Folder() : path_("rates_of_test_" + std::to_string(getpid())) {}
  ~Folder()
  {
    std::error_code none;
    std::filesystem::remove_all(path_, none);
  }
  const std::string& path() const { return path_; }

private:
  std::string path_;
};

std::string textOf(const std::string& path)
{
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

} // namespace

constexpr double copies = 1.0 + costOfCopies;

/// 100 steps of 1 ms, 10 samples of 2 ms and 4 snapshots of 5 ms; copies of the state take costOfCopies of
/// the steps.
TEST(Forecast, AddsWhatStepsSamplesAndSnapshotsCost)
{
  const Forecast f = forecastOf(rates(), scene(), 0.0);
  EXPECT_NEAR(f.steps, 100.0, 1.0);
  EXPECT_NEAR(f.seconds, 0.5 + copies * (0.1 + 0.02) + 0.02, 2e-3);
  EXPECT_EQ(f.bytes, 4000.0);
  EXPECT_EQ(f.secondsToRest, 0.0);
}

TEST(Forecast, EndsAtMaximumSteps)
{
  Teuchos::ParameterList few = scene();
  few.sublist("Time").set("Maximum Steps", 50);
  const Forecast f = forecastOf(rates(), few, 0.0);
  EXPECT_EQ(f.steps, 50.0);
  EXPECT_NEAR(f.seconds, 0.5 + copies * (0.05 + 0.01) + 0.01, 2e-3);
}

/// Each takes 50 ms: ten in a run of 1 s with one every 0.1 s; four with 0.3 s, whose last one is at the end.
TEST(Forecast, AddsWhatCheckpointsCost)
{
  StepRates r = rates();
  r.checkpoint = 0.05;
  r.checkpointBytes = 2e6;
  const auto with = [](const char* name, double value, bool wanted = true)
  {
    Teuchos::ParameterList list = scene();
    list.sublist("Output").set("Checkpoints", wanted).set(name, value);
    return list;
  };
  const double without = forecastOf(r, scene(), 0.0).seconds;
  const auto more = [&](const Teuchos::ParameterList& list)
  { return forecastOf(r, list, 0.0).seconds - without; };
  EXPECT_NEAR(more(with("Checkpoint Interval", 0.1)), 0.5, 1e-9);
  EXPECT_NEAR(more(with("Checkpoint Interval", 0.3)), 0.2, 1e-9);
  EXPECT_NEAR(more(with("Checkpoint Interval", 5.0)), 0.05, 1e-9);
  EXPECT_NEAR(more(with("Checkpoint Interval", 1e-9)), 0.05 * 100, 1e-9); // at most one a step
  EXPECT_EQ(more(with("Checkpoint Interval", 0.1, false)), 0.0);
  // 0.642 s in parts of 0.12 s.
  EXPECT_NEAR(more(with("Checkpoint Minutes", 0.002)), 5 * 0.05, 1e-9);
  EXPECT_EQ(more(with("Checkpoint Minutes", 1.0)), 0.0);
  Teuchos::ParameterList half = with("Checkpoint Interval", 0.1);
  half.sublist("Time").set("Maximum Steps", 50);
  EXPECT_EQ(forecastOf(r, half, 0.0).checkpoints, 5.0);
  EXPECT_EQ(forecastOf(r, with("Checkpoint Interval", 0.2), 0.5).checkpoints, 3.0); // 0.6, 0.8 and 1 s
  const std::string text = asText(forecastOf(r, with("Checkpoint Interval", 0.1), 0.0));
  EXPECT_NE(text.find(", 10 checkpoints of 2 MB (0.5 s)"), std::string::npos) << text;
}

/// A run that goes on at half of its time has half of its steps before it.
TEST(Forecast, OfARunThatGoesOn) { EXPECT_NEAR(forecastOf(rates(), scene(), 0.5).steps, 50.0, 1.0); }

/// exp(-40 t / 2) is 1e-4 at 0.4605 s.
TEST(Forecast, ToWhereDampingHasItSettle)
{
  Teuchos::ParameterList damped = scene();
  damped.sublist("Damping").set("Stop When Settled", true).set("Mass Rate", 40.0).set("Settled Drift", 1e-4);
  damped.sublist("Damping").set("Settled Energy Ratio", 1e-4);
  constexpr double critical = 20.0; // of the slowest motion
  const Forecast f = forecastOf(rates(), damped, 0.0, critical);
  EXPECT_NEAR(f.secondsToRest, 0.5 + 0.4605 * copies * 0.12 + 0.005, 2e-3);
  EXPECT_LT(f.secondsToRest, f.seconds);
  Teuchos::ParameterList rare = damped; // rest is seen in a sample
  rare.sublist("Output").set("History Interval", 0.6);
  EXPECT_NEAR(forecastOf(rates(), rare, 0.0, critical).secondsToRest, 0.5 + 0.6 * copies * 0.1033 + 0.005,
              2e-3);
  rare.sublist("Output").set("History Interval", 2.0);
  EXPECT_EQ(forecastOf(rates(), rare, 0.0, critical).secondsToRest, 0.0);
  // It creeps, and is not known.
  EXPECT_EQ(forecastOf(rates(), damped, 0.0, 0.99 * critical).secondsToRest, 0.0);
  EXPECT_EQ(forecastOf(rates(), damped, 0.0).secondsToRest, 0.0);
  damped.sublist("Damping").set("Mass Rate", 0.0);
  EXPECT_EQ(forecastOf(rates(), damped, 0.0, critical).secondsToRest, 0.0);
}

/// The first steps were the dear ones: what they took is known, and the rest is as the last of them.
TEST(Forecast, KnowsWhatTheFirstStepsTook)
{
  StepRates slowFirst = rates();
  slowFirst.spent = 0.3;
  const Forecast f = forecastOf(slowFirst, scene(), 0.0);
  EXPECT_NEAR(f.seconds, 0.5 + copies * (0.3 + 0.09 + 0.02) + 0.02, 2e-3);
}

/// A run that has come to its end in its first steps takes what these took, however they differ.
TEST(Forecast, OfARunThatIsOver)
{
  StepRates whole = rates();
  whole.time = 1.0;
  whole.spent = 0.7;
  const Forecast f = forecastOf(whole, scene(), 0.0);
  EXPECT_EQ(f.steps, 10.0);
  EXPECT_NEAR(f.seconds, 0.5 + copies * (0.7 + 10 * 0.002) + 0.02, 1e-9);
}

/// Cells that are refined later: twice the steps for a time, of three times as many particles in the mean.
TEST(Forecast, OfCellsThatChange)
{
  StepRates changing = rates();
  changing.growth = {2.0, 6.0};
  const Forecast f = forecastOf(changing, scene(), 0.0);
  EXPECT_EQ(f.steps, 190.0);
  EXPECT_NEAR(f.seconds, 0.5 + copies * (0.01 + 0.54 + 0.02) + 0.02, 1e-9);
  EXPECT_NE(asText(f).find("from its first 10 steps and a run with cells of twice the size"),
            std::string::npos)
      << asText(f);
}

/// Growth that is within what a forecast is off anyway is not used.
TEST(Forecast, OfCellsThatHardlyChange)
{
  EXPECT_FALSE(isNoticeable({}));
  EXPECT_FALSE(isNoticeable({1.1, 0.9}));
  EXPECT_TRUE(isNoticeable({1.0, 1.5}));
  EXPECT_TRUE(isNoticeable({0.5, 1.0}));
}

/// Two of twenty load steps were taken, with three linear systems each.
TEST(Forecast, CountsLoadStepsAndLinearSystems)
{
  StepRates r;
  r.setup = 0.5;
  r.steps = 2;
  r.time = 0.1;
  r.timeStep = 0.05;
  r.spent = 0.6;
  r.step = 0.3;
  r.unknowns = 4443;
  r.solves = 3.0;
  r.solve = 0.1;
  r.memory = 1e8;
  const Forecast f = forecastOf(r, scene(), 0.0);
  EXPECT_EQ(f.steps, 20.0);
  EXPECT_EQ(f.solves, 60.0);
  EXPECT_NEAR(f.seconds, 0.5 + copies * 20 * 0.3, 1e-9);
  const std::string text = asText(f);
  for (const char* part : {"6.5 s (20 load steps, 60 linear systems of 4443 unknowns, 100 ms each, ",
                           "from its first 2 load steps"})
    EXPECT_NE(text.find(part), std::string::npos) << text;
}

/// A load step that takes long is not taken for a forecast.
TEST(Forecast, OfOneLinearSystem)
{
  StepRates r;
  r.timeStep = 1.0;
  r.step = 40.0;
  r.unknowns = 250000;
  r.solves = 4.0;
  r.solve = 10.0;
  const Forecast f = forecastOf(r, scene(), 0.0);
  EXPECT_EQ(f.steps, 1.0);
  EXPECT_NEAR(f.seconds, copies * 40.0, 1e-9);
  const std::string text = asText(f);
  for (const char* part : {"1 load step, 4 linear systems of 250000 unknowns, 1e+04 ms each",
                           "from the time of one linear system"})
    EXPECT_NE(text.find(part), std::string::npos) << text;
}

/// 10 steps of 100 particles in the first second, then 20 of 300 in each.
TEST(WorkCurve, ComparesTheRestWithAPart)
{
  WorkCurve curve;
  for (int k = 1; k <= 10; ++k)
    curve.add(0.1 * k, k, 100.0 * k);
  for (int k = 1; k <= 40; ++k)
    curve.add(1.0 + 0.05 * k, 10.0 + k, 1000.0 + 300.0 * k);
  EXPECT_EQ(curve.end(), 3.0);
  const auto rest = curve.growth({0.25, 0.55}, 3.0);
  ASSERT_TRUE(rest);
  EXPECT_NEAR(rest->steps, (44.5 / 2.45) / 10.0, 1e-9);
  EXPECT_NEAR(rest->work, (12450.0 / 2.45) / 1000.0, 1e-9);
  // Where it ends before the run, it goes on as in its last third.
  const auto longer = curve.growth({0.25, 0.55}, 4.0);
  ASSERT_TRUE(longer);
  EXPECT_NEAR(longer->steps, (64.5 / 3.45) / 10.0, 1e-9);
  EXPECT_NEAR(longer->work, (18450.0 / 3.45) / 1000.0, 1e-9);
}

TEST(WorkCurve, OfTooFewStepsSaysNothing)
{
  WorkCurve curve;
  for (int k = 1; k <= 6; ++k)
    curve.add(0.1 * k, k, 100.0 * k);
  EXPECT_FALSE(curve.growth({0.1, 0.2}, 0.6));
}

TEST(Forecast, SaysWhatItIsOf)
{
  const std::string text = asText(forecastOf(rates(), scene(), 0.0));
  for (const char* part : {"0.64 s", "1 ms a step", "100 MB of memory", "from its first 10 steps"})
    EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST(RateCache, KeepsRatesOfAScene)
{
  const Folder folder;
  const RateCache cache(folder.path(), "this machine", "a build");
  EXPECT_FALSE(cache.find(scene()));
  StepRates kept = rates();
  kept.growth = {2.0, 6.0};
  kept.unknowns = 12;
  cache.keep(scene(), kept);
  const auto found = cache.find(scene());
  ASSERT_TRUE(found);
  EXPECT_EQ(found->step, 1e-3);
  EXPECT_EQ(found->timeStep, 0.01);
  EXPECT_EQ(found->particles, 64);
  EXPECT_EQ(found->spent, 0.01);
  EXPECT_EQ(found->growth.work, 6.0);
  EXPECT_EQ(found->unknowns, 12);
  Teuchos::ParameterList other = scene();
  other.sublist("Domain").set("Cell Size", 0.25);
  EXPECT_FALSE(cache.find(other));
  StepRates slower = rates();
  slower.step = 2e-3;
  cache.keep(other, slower);
  EXPECT_EQ(cache.find(scene())->step, 1e-3);
  EXPECT_EQ(cache.find(other)->step, 2e-3);
}

/// The file of another machine, under whatever name, and one that is damaged.
TEST(RateCache, RefusesOthersFiles)
{
  const Folder folder;
  const RateCache mine(folder.path(), "this machine", "a build"),
      other(folder.path(), "another machine", "a build");
  mine.keep(scene(), rates());
  EXPECT_FALSE(other.find(scene()));
  std::filesystem::copy_file(mine.path(), other.path());
  EXPECT_FALSE(other.find(scene()));
  other.keep(scene(), rates());
  EXPECT_TRUE(other.find(scene()));
  std::ofstream(mine.path()) << textOf(other.path()).substr(0, 100);
  EXPECT_FALSE(mine.find(scene()));
  std::ofstream(mine.path()) << R"({"machine": "this machine", "scenes": [{"scene": 3}]})";
  EXPECT_FALSE(mine.find(scene()));
}

/// Another compiler or other flags give other rates. Those of one build do not replace those of another.
TEST(RateCache, KeepsRatesOfEachBuild)
{
  const Folder folder;
  const RateCache one(folder.path(), "this machine", "a build"),
      other(folder.path(), "this machine", "debug");
  one.keep(scene(), rates());
  EXPECT_FALSE(other.find(scene()));
  StepRates slower = rates();
  slower.step = 1.0;
  other.keep(scene(), slower);
  EXPECT_EQ(one.find(scene())->step, 1e-3);
  EXPECT_EQ(other.find(scene())->step, 1.0);
}

/// The unfinished file of another process is neither renamed nor overwritten.
TEST(RateCache, LeavesTheTemporaryFileOfAnotherProcess)
{
  const Folder folder;
  const RateCache cache(folder.path(), "this machine", "a build");
  std::filesystem::create_directories(folder.path());
  std::ofstream(cache.path() + ".part") << "half of it";
  cache.keep(scene(), rates());
  EXPECT_TRUE(cache.find(scene()));
  EXPECT_EQ(textOf(cache.path() + ".part"), "half of it");
}

/// 1.7e9 s after 1970 began.
TEST(RateCache, KeepsTheDateThatAForecastPrints)
{
  const Folder folder;
  const RateCache cache(folder.path(), "this machine", "a build");
  StepRates dated = rates();
  dated.measured = 1700000000;
  cache.keep(scene(), dated);
  Forecast f = forecastOf(*cache.find(scene()), scene(), 0.0);
  f.kept = true;
  EXPECT_NE(asText(f).find("kept from an earlier measurement, 2023-11-14 22:13:20 UTC"), std::string::npos)
      << asText(f);
}

/// The file that runs: its size is known, and a build has another date.
TEST(RateCache, KnowsTheBuild)
{
  const std::string size = std::to_string(std::filesystem::file_size("/proc/self/exe"));
  EXPECT_NE(buildIdentity().find("; " + size + " bytes of "), std::string::npos) << buildIdentity();
  EXPECT_EQ(machineIdentity(1).find(size + " bytes"), std::string::npos);
}

/// Nothing is kept of a scene that fails, nor where there is no folder.
TEST(RateCache, KeepsNothingOfAFailure)
{
  const Folder folder;
  const RateCache cache(folder.path(), "this machine", "a build");
  StepRates failed = rates();
  failed.failure = "the body left the domain";
  cache.keep(scene(), failed);
  EXPECT_FALSE(std::filesystem::exists(cache.path()));
  const RateCache nowhere("", "this machine", "a build");
  nowhere.keep(scene(), rates());
  EXPECT_FALSE(nowhere.find(scene()));
}

TEST(Twice, HalvesCellsAndKeepsWhatAccuracyChose)
{
  Teuchos::ParameterList list = scene();
  list.sublist("Time").set("Maximum Steps", 30);
  halveCells(list);
  EXPECT_EQ(list.sublist("Domain").get<double>("Cell Size"), 0.25);
  EXPECT_FALSE(list.sublist("Domain").isParameter("Accuracy"));
  EXPECT_EQ(list.sublist("Time").get<int>("Maximum Steps"), 60);
  list.sublist("Time").set("Maximum Steps", 2000000000);
  halveCells(list);
  EXPECT_EQ(list.sublist("Time").get<int>("Maximum Steps"), 2000000000);
}

} // namespace Test
} // namespace Rhegma::program
