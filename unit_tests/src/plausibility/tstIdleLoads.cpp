/// Loads of zero, and loads in other units of time.

#include "Warnings.hpp"
#include "plausibility/IdleLoads.hpp"

#include <cmath>
#include <random>

namespace Rhegma
{
namespace Test
{

namespace
{

const GivenLoad pressure{"Face Pressure > Notch", "pressure"};

std::vector<std::string> ofPressure(const std::string& function, double end)
{
  return idleMessages(pressure, "Pressure", function, "Pa", {end});
}

} // namespace

TEST(IdleFunction, OfZeroIsSaid)
{
  const Warnings said = ofPressure("0", 1e-3);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(said[0],
            "Face Pressure > Notch > Pressure is zero up to Time > Final Time = 1 ms, so this pressure "
            "does nothing");
  EXPECT_TRUE(say(ofPressure("0:0, 1:0, 2:5e6", 1e-3), "it reaches 5e+06 Pa later"));
}

/// 5 MPa in 50 s are 20 Pa in 200 us.
TEST(IdleFunction, InOtherUnitsOfTimeIsSaid)
{
  const std::string most = "it is 20 Pa at most, 4e-06 of the 5e+06 Pa that it reaches later";
  EXPECT_TRUE(say(ofPressure("0:0, 50:5e6", 2e-4), most));
  EXPECT_TRUE(say(ofPressure("5e6*min(1, t/50)", 2e-4), most));
}

/// One that rises without end has no units of time, and a pulse ends.
TEST(IdleFunction, IsNotSaidOfWhatActs)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> exponent(-9.0, 9.0);
  for (int k = 0; k < 20; ++k)
  {
    const double end = std::pow(10.0, exponent(random));
    const std::string T = std::to_string(std::log10(end));
    for (const std::string& function : std::vector<std::string>{
             "5e10*t", "t*t", "1e6", "1e6*exp(-t/10^" + T + ")", "1e6*min(1, t/10^" + T + ")",
             "sin(t/10^" + T + ")", "t < 10^" + T + "/2 ? -3 : 0"})
      EXPECT_TRUE(ofPressure(function, end).empty()) << function << " up to " << end;
  }
}

TEST(LargestEver, IsZeroWhereAFunctionStillRises)
{
  EXPECT_NEAR(largestEver("0:0, 10:-7, 20:5", 1.0), 7.0, 1e-9); // a time that is looked at
  EXPECT_EQ(largestEver("t", 1.0), 0.0);
  EXPECT_NEAR(largestEver("5*min(1, t/50)", 1e-3), 5.0, 1e-12);
  EXPECT_NEAR(largestEver("-2", 1.0), 2.0, 0.0);
}

TEST(IdleLoad, OfZeroOrALateHistoryIsSaid)
{
  Teuchos::ParameterList list;
  list.set("Power", 0.0);
  list.set("Other", 0.0);
  list.set("Force", pair(0.0, 0.0));
  list.set<std::string>("History", "0:0, 100:1");
  const Warnings said =
      idleMessages({"Thermal > Sources > Torch", "source"}, list, {"Power", "Force"}, {1e-3});
  ASSERT_EQ(said.size(), 3u);
  EXPECT_EQ(said[0], "Thermal > Sources > Torch > Power is zero, so this source does nothing");
  EXPECT_TRUE(say(said, "Torch > Force is zero"));
  EXPECT_TRUE(say(said, "its factor is at most 1e-05, so this source does next to nothing"));
  list.set("Power", 1.0);
  list.set("Force", pair(0.0, 1.0));
  list.set<std::string>("History", "0:0, 1e-2:2");
  EXPECT_TRUE(
      say(idleMessages({"Thermal > Sources > Torch", "source"}, list, {"Power"}, {1e-3}),
          "Torch > History: up to Time > Final Time = 1 ms its factor is at most 0.2, and it reaches 2 "
          "later: does the run end too early?"));
  EXPECT_TRUE(idleMessages({"Thermal > Sources > Torch", "source"}, list, {"Power"}, {3e-3}).empty());
  list.set<std::string>("History", "1");
  EXPECT_TRUE(
      idleMessages({"Thermal > Sources > Torch", "source"}, list, {"Power", "Force"}, {1e-3}).empty());
}

/// Static looks at the end only, Quasi-Static at the ends of its load steps.
TEST(IdleLoad, ThatCountsAtNoTimeOfEquilibriumIsSaid)
{
  Teuchos::ParameterList list;
  list.set("Force", pair(0.0, 1.0));
  const GivenLoad top{"Boundaries > Top", "boundary"};
  const auto of = [&](const std::string& history, const ActingTimes& times)
  {
    list.set<std::string>("History", history);
    return idleMessages(top, list, {"Force"}, times);
  };
  for (const char* history : {"0:0, 1e-4:1, 2e-4:0", "sin(pi*t/1e-3)", "0:0, 2e-4:1, 1e-3:0"})
  {
    EXPECT_TRUE(say(of(history, {1e-3, 1}), "Boundaries > Top > History: its factor reaches 1, and is "))
        << history;
    EXPECT_TRUE(of(history, {1e-3}).empty()) << history;
  }
  // A half and more of it may be what the scene is about; a factor is found, whatever the load is.
  const char* const most = "0:0, 1e-4:1, 1e-3:0.01";
  EXPECT_TRUE(say(of(most, {1e-3, 1}), "so this boundary acts with only that; choose a Final Time"));
  EXPECT_TRUE(of("0:0, 1e-4:1, 1e-3:0.51", {1e-3, 1}).empty());
  EXPECT_TRUE(of(most, {1e-3, 1, true}).empty());
  EXPECT_TRUE(say(of("0:0, 0.501:0, 0.52:1, 0.549:0", {1.0, 20}),
                  "its factor reaches 1 between load steps, and at most 0 at the ends of load steps, where "
                  "equilibrium is found: use more Time > Load Steps than 20"));
  EXPECT_TRUE(say(of("sin(2*pi*10*t)", {1.0, 20}), "between load steps"));
  EXPECT_TRUE(of("0:0, 0.501:0, 0.52:1, 0.549:0", {1.0, 100}).empty());
  EXPECT_TRUE(of("sin(2*pi*t)", {1.0, 20}).empty());
  EXPECT_TRUE(say(idleMessages(pressure, "Pressure", "0:0, 2e-4:1e6, 4e-4:0", "Pa", {1e-3, 1}),
                  "Face Pressure > Notch > Pressure: it reaches 1e+06 Pa, and is 0 Pa at Time > Final Time"));
}

/// A static analysis takes the factor at the end, which is that of all load steps.
TEST(IdleLoad, ThatIsSmallAtTheEndOfAStaticAnalysisIsSaid)
{
  Teuchos::ParameterList list;
  list.set("Force", pair(0.0, 1.0));
  const auto of = [&](const std::string& history, const ActingTimes& times)
  {
    list.set<std::string>("History", history);
    return idleMessages({"Boundaries > Top", "boundary"}, list, {"Force"}, times);
  };
  EXPECT_TRUE(
      say(of("t/1000", {1.0, 1}),
          "Boundaries > Top > History: its factor is 0.001 at Time > Final Time = 1 s, the only time"));
  EXPECT_TRUE(say(of("0.49*t", {1.0, 1}), "acts with 0.49 of its value"));
  EXPECT_TRUE(of("0.51*t", {1.0, 1}).empty());
  EXPECT_TRUE(of("0.01", {1.0, 1}).empty()); // written as a number, it is meant
  EXPECT_TRUE(of("t/1000", {1.0, 1, true}).empty());
  EXPECT_TRUE(of("t/1000", {1.0, 20}).empty());
  EXPECT_TRUE(of("t/1000", {1.0}).empty());
}

TEST(IdleSupport, ThatComesBackIsSaid)
{
  const GivenLoad grip{"Boundaries > Grip", "support"};
  const std::string back = "t < 5e-4 ? 1 : -1";
  EXPECT_TRUE(say(idleSupportMessages(grip, back, {1e-3, 1}),
                  "Boundaries > Grip > History: the integral of its factor reaches 0.000"));
  EXPECT_TRUE(idleSupportMessages(grip, back, {1e-3, 4}).empty()); // half the way is an end of a step
  EXPECT_TRUE(idleSupportMessages(grip, back, {1e-3}).empty());
  EXPECT_TRUE(idleSupportMessages(grip, "1", {1e-3, 1}).empty());
  EXPECT_TRUE(say(idleSupportMessages(grip, "sin(2*pi*10*t)", {1.0, 10}), "between load steps"));
}

} // namespace Test
} // namespace Rhegma
