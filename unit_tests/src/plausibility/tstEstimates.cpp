/// Estimates by which scenes are judged: histories, forces, plastic zones.

#include "plausibility/CrackExtent.hpp"
#include "plausibility/LoadEstimate.hpp"

#include <Teuchos_Array.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <sstream>

namespace Rhegma
{
namespace
{

using Reals = Teuchos::Array<double>;

/// On a line of 2 m whose outward normal is x.
Teuchos::ParameterList traction2()
{
  Teuchos::ParameterList list;
  list.set<std::string>("Type", "Traction");
  list.set("From", Reals(Teuchos::tuple(1.0, 0.0)));
  list.set("To", Reals(Teuchos::tuple(1.0, 2.0)));
  return list;
}

TEST(RangeOf, IsThatOfAHistoryAndItsIntegrals)
{
  const HistoryRange constant = rangeOf("1", 2.0);
  EXPECT_DOUBLE_EQ(constant.largest, 1.0);
  EXPECT_NEAR(constant.integral, 2.0, 1e-12);
  EXPECT_NEAR(constant.twice, 2.0, 1e-12); // T^2 / 2
  const HistoryRange ramp = rangeOf("-3*t", 2.0);
  EXPECT_DOUBLE_EQ(ramp.largest, 6.0);
  EXPECT_NEAR(ramp.integral, 6.0, 1e-12);
  EXPECT_NEAR(ramp.twice, -4.0, 1e-4); // -3 T^3 / 6
  EXPECT_NEAR(rangeOf("0:1, 1:1, 1.0000001:-1", 2.0).twice, 1.0, 0.01);
}

/// A pulse of 10 ms in 10 s, as an expression and as a table: its corners are looked at wherever they are.
TEST(RangeOf, SeesShortPulses)
{
  EXPECT_EQ(rangeOf("t > 5 && t < 5.01 ? 1 : 0", 10.0).largest, 1.0);
  EXPECT_NEAR(rangeOf("t > 5 && t < 5.01 ? 1 : 0", 10.0).integral, 0.01, 0.0025);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> between(0.0, 9.0);
  for (int k = 0; k < 20; ++k)
  {
    const double at = between(random);
    std::ostringstream table;
    table.precision(17);
    table << "0:0, " << at + 1e-6 << ":0, " << at + 2e-6 << ":-4, " << at + 3e-6 << ":0";
    const HistoryRange range = rangeOf(table.str(), 10.0);
    EXPECT_NEAR(range.largest, 4.0, 1e-12) << table.str();
    EXPECT_NEAR(range.integral, 4e-6, 1e-12) << table.str();
  }
}

/// Load steps see the ends of steps only, and supports their displacement there.
TEST(RangeOf, KnowsTheTimesThatCount)
{
  const HistoryRange alias = rangeOf("sin(2*pi*10*t)", ActingTimes{1.0, 20});
  EXPECT_NEAR(alias.largest, 1.0, 1e-4);
  EXPECT_LT(alias.acting, 1e-14);
  EXPECT_NEAR(alias.integral, 1.0 / (10.0 * std::acos(-1.0)), 1e-6); // 2 / w
  EXPECT_NEAR(alias.actingIntegral, alias.integral, 1e-6);           // at every second end
  const HistoryRange back = rangeOf("t < 0.5 ? 1 : -1", ActingTimes{1.0, 1});
  EXPECT_EQ(back.acting, 1.0);
  EXPECT_NEAR(back.integral, 0.5, 1e-3);
  EXPECT_LT(back.actingIntegral, 5e-4);
  const HistoryRange all = rangeOf("t", 3.0);
  EXPECT_EQ(all.acting, all.largest);
  EXPECT_EQ(all.actingIntegral, all.integral);
}

TEST(ForceOf, IsThatOfTheLoads)
{
  Teuchos::ParameterList stress = traction2(), pressure = traction2(), point, scene;
  scene.sublist("Domain").set("Thickness", 0.5);
  stress.set("Stress", Reals(Teuchos::tuple(3.0, -4.0)));
  EXPECT_DOUBLE_EQ(forceOf<2>(scene, stress)[0], 3.0);
  EXPECT_DOUBLE_EQ(forceOf<2>(scene, stress)[1], -4.0);
  pressure.set("Pressure", 5.0); // on a surface whose outward normal is x
  EXPECT_DOUBLE_EQ(forceOf<2>(scene, pressure)[0], -5.0);
  EXPECT_DOUBLE_EQ(forceOf<2>(scene, pressure)[1], 0.0);
  point.set<std::string>("Type", "Point Load");
  point.set("Force", Reals(Teuchos::tuple(1.0, 2.0, 3.0)));
  EXPECT_DOUBLE_EQ(forceOf<3>(scene, point)[2], 3.0);
  Teuchos::ParameterList face;
  face.set<std::string>("Type", "Traction");
  face.set("Edge 1", Reals(Teuchos::tuple(2.0, 0.0, 0.0)));
  face.set("Edge 2", Reals(Teuchos::tuple(0.0, 3.0, 0.0)));
  face.set("Pressure", 7.0);
  EXPECT_DOUBLE_EQ(forceOf<3>(scene, face)[2], -42.0);
  Teuchos::ParameterList gravity;
  gravity.set<std::string>("Type", "Gravity");
  EXPECT_DOUBLE_EQ(norm(forceOf<2>(scene, gravity)), 0.0);
}

TEST(LargestStrain, IsAFiniteNumber)
{
  const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(largestStrain({}), nullptr);
  EXPECT_EQ(largestStrain({{"one", inf, inf, inf}, {"other", nan, nan, nan}}), nullptr);
  const std::vector<LoadEstimate> loads{
      {"one", inf, inf, inf}, {"two", 1e-3, 1e6, 1e6}, {"three", 1e-2, 1e7, 1e7}};
  ASSERT_NE(largestStrain(loads), nullptr);
  EXPECT_EQ(largestStrain(loads)->where, "three");
}

/// Irwin: (K / yield stress)^2 / (2 pi) in plane stress, a third of it elsewhere.
TEST(PlasticZone, IsThatOfIrwin)
{
  BodyMeasure<2> body;
  body.yield = 4e8;
  EXPECT_NEAR(plasticZone(5e7, body, Plane::Stress), 0.0156250 / (2.0 * 3.14159265), 1e-9);
  EXPECT_NEAR(plasticZone(5e7, body, Plane::Strain), 0.0156250 / (6.0 * 3.14159265), 1e-9);
  EXPECT_NEAR(plasticZone(5e7, body, Plane::Solid), 0.0156250 / (6.0 * 3.14159265), 1e-9);
}

} // namespace
} // namespace Rhegma
