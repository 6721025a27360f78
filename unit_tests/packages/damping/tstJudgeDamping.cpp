/// Damping that leaves no motion, or never brings a body to rest.

#include "damping/JudgeDamping.hpp"
#include "src/plausibility/Warnings.hpp"

#include <cmath>

namespace Rhegma
{
namespace Test
{
namespace
{

/// A plate that is pulled for 0.1 s. \param rate [1/s]
Teuchos::RCP<Teuchos::ParameterList> dampedPlate(double rate, bool stops)
{
  const auto scene = freePlate();
  scene->sublist("Time").set("Final Time", 0.1);
  hold(*scene, "Grip", pair(-0.1, -0.1), pair(0.05, 1.1));
  pull(*scene, 1e6);
  scene->sublist("Damping").set("Mass Rate", rate);
  scene->sublist("Damping").set("Stop When Settled", stops);
  return scene;
}

const std::string never = "so the run ends before it has settled";

/// The number after a text in one of some warnings; 0: it is in none.
double numberAfter(const std::string& text, const Warnings& warnings)
{
  for (const std::string& warning : warnings)
    if (const std::size_t at = warning.find(text); at != std::string::npos)
      return std::stod(warning.substr(at + text.size()));
  return 0.0;
}

} // namespace

/// exp(-4 / s 0.1 s / 2) = 0.8187, and 0.01 % take 2 ln(1e4) / 0.1 s.
TEST(Settling, ThatIsNeverReachedIsSaid)
{
  const Warnings said = warningsOf(dampedPlate(4.0, true));
  EXPECT_TRUE(say(
      said,
      "Damping > Mass Rate is 4 1/s: when damping ends, 81.87 % of an oscillation is left (after 100 ms)"));
  EXPECT_TRUE(say(said, never));
  EXPECT_TRUE(say(said, "write at least 184.2 1/s"));
}

TEST(Settling, IsNotSaidOfARunThatGoesOnOrIsDampedWell)
{
  EXPECT_FALSE(say(warningsOf(dampedPlate(4.0, false)), never));
  EXPECT_FALSE(say(warningsOf(dampedPlate(2000.0, true)), never));
  const auto viscous = dampedPlate(0.0, true);
  viscous->sublist("Damping").set("Bulk Viscosity", 1e6); // 1e6 / M w^2 / 2 = 630 / s
  EXPECT_FALSE(say(warningsOf(viscous), never));
  const auto ended = dampedPlate(2000.0, true);
  ended->sublist("Damping").set("End Time", 1e-4);
  EXPECT_TRUE(say(warningsOf(ended), never));
}

/// With ten times critical damping the slow rate is w (10 - sqrt(99)) = 0.0501 w. Its wave speed and length
/// are those of the plate.
TEST(Settling, ThatCreepsIsSaid)
{
  EXPECT_DOUBLE_EQ(damping::slowRate(3.0, 7.0), 1.5);
  EXPECT_DOUBLE_EQ(damping::slowRate(14.0, 7.0), 7.0);
  EXPECT_NEAR(damping::slowRate(140.0, 7.0), 7.0 * (10.0 - std::sqrt(99.0)), 1e-12);
  EXPECT_NEAR(damping::slowRate(1e12, 7.0), 49e-12, 1e-20); // w^2 / r
  const Warnings mild = warningsOf(dampedPlate(2000.0, true)), strong = warningsOf(dampedPlate(2e7, true));
  EXPECT_FALSE(say(mild, "creeps to equilibrium"));
  EXPECT_TRUE(say(strong, "creeps to equilibrium"));
}

/// Arms of 50 mm thickness and 500 mm length, whose roots give way as if they were longer by 0.64 h (Kanninen
/// 1973): w = 3.52 / sqrt(12) c h / (a + 0.64 h)^2 = 931 / s, 6 % of the wave along the plate (16,300 / s).
/// At critical damping of the wave, exp(-w^2 / r 0.05 s), a quarter, is left of the motion. The opening of
/// the crack with stiff arms, 13,000 / s, and the wave add 1 % to 1 / w^2.
TEST(Settling, OfArmsNextToACrackIsThatOfTheirBending)
{
  for (const bool cracked : {true, false})
  {
    const auto scene = steelPlate(-0.4, 1.4, 0.025, pair(0.0, 0.0), pair(1.0, 0.1));
    scene->sublist("Time").set("Final Time", 0.05);
    pull(*scene, 1e6).set("To", pair(1.0, 0.1));
    if (cracked)
      scene->sublist("Cracks").sublist("Notch").set("Points",
                                                    Reals(std::vector<double>{-0.01, 0.05, 0.5, 0.05}));
    scene->sublist("Damping").set("Mass Rate", 2.0 * 16300.0).set("Stop When Settled", true);
    const Warnings said = warningsOf(scene);
    EXPECT_EQ(
        say(said, "times the critical damping of the bending of arms of Plate, 50 mm thick and 500 mm long"),
        cracked);
    EXPECT_NEAR(numberAfter("write about ", said), cracked ? 2.0 * 931.0 : 0.0, 40.0);
  }
}

/// A square plate of the side W, half cracked, opens with w = 0.657 c / W, c = sqrt(E / rho): measured by the
/// decay of the kinetic energy under strong damping (unit_tests/program/test_cracked_plates.py). That is a
/// fifth of the wave.
TEST(Settling, OfAnEdgeCrackIsThatOfItsOpening)
{
  const double w = 0.657 * std::sqrt(2.1e11 / 7800.0);
  for (const bool cracked : {true, false})
  {
    const auto scene = freePlate(0.05);
    scene->sublist("Time").set("Final Time", 0.01);
    pull(*scene, 1e6);
    if (cracked)
      scene->sublist("Cracks").sublist("Notch").set("Points",
                                                    Reals(std::vector<double>{0.0, 0.51, 0.5, 0.51}));
    scene->sublist("Damping").set("Mass Rate", 14.0 * w).set("Stop When Settled", true);
    const Warnings said = warningsOf(scene);
    EXPECT_EQ(
        say(said, "times the critical damping of the opening of the crack of 500 mm in Plate, 1 m wide"),
        cracked);
    EXPECT_NEAR(numberAfter("write about ", said), cracked ? 2.0 * w : 0.0, 0.1 * w);
  }
}

/// Supports keep a crack from opening: no critical rate is named, and the longest wave is a bound.
TEST(Settling, OfACrackBetweenSupportsIsNotKnown)
{
  for (const double rate : {5e4, 1e6})
  {
    const auto scene = freePlate(0.05);
    scene->sublist("Time").set("Final Time", 0.01);
    pull(*scene, 1e6);
    hold(*scene, "Grip", pair(-0.1, -0.1), pair(0.05, 1.1));
    scene->sublist("Cracks").sublist("Notch").set("Points", Reals(std::vector<double>{0.5, 0.0, 0.5, 0.5}));
    scene->sublist("Damping").set("Mass Rate", rate).set("Stop When Settled", true);
    const Warnings said = warningsOf(scene);
    EXPECT_EQ(say(said, "times the critical damping of the longest wave of Plate, which creeps"),
              rate == 1e6);
    EXPECT_EQ(say(said, "is left, so results are not static; write less than "), rate == 1e6);
    EXPECT_FALSE(say(said, "critically damped at"));
  }
}

/// Rotation by a moment: 4 sigma / E' V(x) with sigma = 6 M / W^2 and the fit V of Tada, Paris and Irwin
/// (2.13). It and the integral of their K, which counts squared, differ by up to 3.3 %. A shallow edge crack
/// opens by pi 1.122^2 x^2 under tension, and a middle crack by pi / 2 x^2.
TEST(SectionCompliance, IsThatOfTheHandbook)
{
  for (const double x : {0.25, 0.5, 0.7})
  {
    const double V = std::pow(x / (1.0 - x), 2) *
                     (5.93 - 19.69 * x + 37.14 * x * x - 35.84 * std::pow(x, 3) + 13.12 * std::pow(x, 4));
    const damping::SectionCompliance c = damping::edgeCrack(x, 0.04, 3e9);
    EXPECT_NEAR(c.rotation * 3e9 * 0.04 * 0.04 / (24.0 * V), 1.0, 0.04) << x;
    EXPECT_LT(c.coupling * c.coupling, c.opening * c.rotation);
  }
  constexpr double pi = 3.14159265358979, shallow = 0.01;
  EXPECT_NEAR(damping::edgeCrack(shallow, 0.04, 1.0).opening / (pi * 1.122 * 1.122 * shallow * shallow), 1.0,
              0.03);
  EXPECT_NEAR(damping::middleCrack(shallow, 1.0).opening / (0.5 * pi * shallow * shallow), 1.0, 0.01);
}

/// What a run that has not settled is to change follows from the measured frequency if there is one.
TEST(Settling, ThatIsMissedSaysWhichWay)
{
  damping::Unsettled run{100.0, std::nullopt, {10.0, "the opening", true}, false};
  const auto said = [&](const std::string& text)
  { return damping::unsettledWarning(run).find(text) != std::string::npos; };
  EXPECT_TRUE(
      said("or lower Damping > Mass Rate, 100 1/s, to about 20 1/s (the opening is critically damped"));
  EXPECT_FALSE(said("Static"));
  run.measured = 5.0;
  EXPECT_TRUE(said("; lower Damping > Mass Rate, 100 1/s, to about 10 1/s: the motion creeps"));
  run = {4.0, std::nullopt, {10.0, "the opening", true}, true};
  EXPECT_TRUE(said("raise Time > Final Time, or Damping > Mass Rate, 4 1/s, to at most about 20 1/s"));
  EXPECT_TRUE(said("; Time > Analysis = Static, without Damping, solves"));
  run.rate = 0.0;
  EXPECT_TRUE(said("or damp by a Mass Rate of about 20 1/s instead of a viscosity"));
}

/// It is called not static only where more than a thousandth may still change, or that is not known.
TEST(Settling, ThatIsMissedSaysByHowMuch)
{
  damping::Unsettled run{100.0, std::nullopt, {10.0, "the opening", true}, false};
  run.drift = 1e-5;
  const auto said = [&](const std::string& text)
  { return damping::unsettledWarning(run).find(text) != std::string::npos; };
  EXPECT_TRUE(said("so its results are not static; "));
  run.change = 0.07;
  EXPECT_TRUE(said("so its results are not static: energy release rates"));
  EXPECT_TRUE(said("may still change by up to 7 %"));
  run.change = 5e-5;
  EXPECT_FALSE(said("not static"));
  EXPECT_TRUE(said("to within Settled Drift = 1e-05"));
  EXPECT_TRUE(said("by up to 0.005 %"));
}

/// Five samples are compared, which take four intervals.
TEST(Settling, InSamplesThatAreNotTakenIsSaid)
{
  for (const double interval : {1.0, 0.026, 0.024, 1e-3})
    for (const bool stops : {true, false})
    {
      const auto scene = dampedPlate(2000.0, stops);
      scene->sublist("Output").set("History Interval", interval);
      const Warnings said = warningsOf(scene);
      EXPECT_EQ(say(said, "Output > History Interval is "), stops && interval > 0.025) << interval;
      EXPECT_EQ(say(said, "there are 0 samples: Damping > Stop When Settled compares the last 5"),
                stops && interval == 1.0);
    }
}

TEST(Damping, ThatHoldsABodyIsSaid)
{
  EXPECT_TRUE(say(warningsOf(dampedPlate(1e9, false)), "so it hardly moves"));
  EXPECT_TRUE(say(warningsOf(dampedPlate(1e9, false)), "times 1 / (stable time step)"));
}

} // namespace Test
} // namespace Rhegma
