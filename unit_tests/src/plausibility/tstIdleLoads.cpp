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
  return idleMessages(pressure, "Pressure", function, "Pa", end);
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
  const Warnings said = idleMessages({"Thermal > Sources > Torch", "source"}, list, {"Power", "Force"}, 1e-3);
  ASSERT_EQ(said.size(), 3u);
  EXPECT_EQ(said[0], "Thermal > Sources > Torch > Power is zero, so this source does nothing");
  EXPECT_TRUE(say(said, "Torch > Force is zero"));
  EXPECT_TRUE(say(said, "its factor is at most 1e-05, so this source does next to nothing"));
  list.set("Power", 1.0);
  list.set("Force", pair(0.0, 1.0));
  list.set<std::string>("History", "0:0, 1e-2:2");
  EXPECT_TRUE(
      say(idleMessages({"Thermal > Sources > Torch", "source"}, list, {"Power"}, 1e-3),
          "Torch > History: up to Time > Final Time = 1 ms its factor is at most 0.2, and it reaches 2 "
          "later: does the run end too early?"));
  EXPECT_TRUE(idleMessages({"Thermal > Sources > Torch", "source"}, list, {"Power"}, 3e-3).empty());
  list.set<std::string>("History", "1");
  EXPECT_TRUE(idleMessages({"Thermal > Sources > Torch", "source"}, list, {"Power", "Force"}, 1e-3).empty());
}

} // namespace Test
} // namespace Rhegma
