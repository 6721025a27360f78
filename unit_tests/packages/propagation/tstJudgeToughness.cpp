/// A toughness against the bonds, the law and the loads of a scene.

#include "src/plausibility/Warnings.hpp"

#include <cmath>

namespace Rhegma
{
namespace Test
{
namespace
{

/// A plate that is pulled, with a crack of 0.5 m along its middle. \param young [Pa] \param stress [Pa]
Teuchos::RCP<Teuchos::ParameterList> crackedPlate(double young, double stress, const std::string& toughness)
{
  const auto scene = freePlate(0.05);
  scene->sublist("Materials").sublist("Steel").set("Young Modulus", young);
  for (const bool top : {false, true})
  {
    Teuchos::ParameterList& list = boundary(*scene, top ? "Top" : "Bottom", "Traction");
    list.set<std::string>("Body", "Plate");
    list.set("From", pair(top ? 1.0 : 0.0, top ? 1.0 : 0.0));
    list.set("To", pair(top ? 0.0 : 1.0, top ? 1.0 : 0.0));
    list.set("Stress", pair(0.0, top ? stress : -stress));
  }
  scene->sublist("Cracks").sublist("Notch").set("Points", Reals(std::vector<double>{-0.025, 0.5, 0.5, 0.5}));
  scene->sublist("Energy Release");
  scene->sublist("Propagation").set("Toughness", toughness);
  return scene;
}

/// The same of the plastic law.
Teuchos::RCP<Teuchos::ParameterList> yieldingPlate(double stress, double yield, const std::string& toughness)
{
  const auto scene = crackedPlate(2.1e11, stress, toughness);
  scene->sublist("Materials").sublist("Steel").set<std::string>("Model", "J2 Plastic");
  scene->sublist("Materials").sublist("Steel").set("Yield Stress", yield);
  return scene;
}

const std::string asK = "if it is a K_Ic of ";

} // namespace

/// Acrylic: 350 J/m2 are 1.02 MPa m^0.5. Written as 1.02, it is less than of ice.
TEST(ToughnessOfBonds, AsStressIntensityOfAPolymerIsSaid)
{
  EXPECT_FALSE(say(warningsOf(crackedPlate(3e9, 1e5, "350")), "Propagation"));
  const Warnings said = warningsOf(crackedPlate(3e9, 1e5, "1.02"));
  EXPECT_TRUE(
      say(said, "Propagation > Toughness is 1.02 J/m2: with the E' of Steel that is a K_Ic of 0.05532 MPa"));
  EXPECT_TRUE(say(said, asK + "1.02 MPa m^0.5, write 346.8 J/m2"));
}

/// A crack of 0.5 m in it that 0.1 MPa press open runs at 1 MPa m^0.5 or 1 MPa of remote stress; with a K_Ic
/// in Pa m^0.5 as toughness it needs 60 times the stress.
TEST(ToughnessOfBonds, AsStressIntensityUnderPressureIsSaid)
{
  for (const bool right : {true, false})
  {
    const auto scene = crackedPlate(3e9, 0.0, right ? "350" : "1.02e6");
    scene->remove("Boundaries");
    scene->sublist("Cracks").sublist("Notch").set("Points", Reals(std::vector<double>{0.25, 0.5, 0.75, 0.5}));
    scene->sublist("Face Pressure").sublist("Notch").set<std::string>("Pressure", "1e5 + 1e5*t/1e-3");
    EXPECT_EQ(say(warningsOf(scene), "times the highest stress of the loads"), !right);
  }
}

/// A lead weight on the plate yields at less than the plate's crack needs, which counts if the crack is in
/// it.
TEST(ToughnessOfYield, IsJudgedInBodiesWithCracks)
{
  for (const bool inWeight : {false, true})
  {
    const auto scene = crackedPlate(2.1e11, 1e6, "1000");
    Teuchos::ParameterList& lead = scene->sublist("Materials").sublist("Lead");
    lead = scene->sublist("Materials").sublist("Steel");
    lead.set<std::string>("Model", "J2 Plastic").set("Young Modulus", 1.6e10).set("Yield Stress", 2e6);
    Teuchos::ParameterList& weight = scene->sublist("Bodies").sublist("Weight");
    weight = scene->sublist("Bodies").sublist("Plate");
    weight.set<std::string>("Material", "Lead").set<std::string>("Bonded To", "Plate");
    weight.set("Lower Corner", inWeight ? pair(1.0, 0.4) : pair(0.4, 1.0));
    weight.set("Upper Corner", inWeight ? pair(1.2, 0.6) : pair(0.6, 1.2));
    if (inWeight)
      scene->sublist("Cracks").sublist("Notch").set("Points", Reals(std::vector<double>{0.5, 0.5, 1.1, 0.5}));
    EXPECT_EQ(say(warningsOf(scene), "ahead of it yield (twice Irwin's radius) at Materials > Lead"),
              inWeight);
  }
}

/// Glass: 8 J/m2 are 0.75 MPa m^0.5. Written as 0.75, bonds break within less than an atom's distance.
TEST(ToughnessOfBonds, AsStressIntensityOfGlassIsSaid)
{
  EXPECT_FALSE(say(warningsOf(crackedPlate(7e10, 5e5, "8")), "Propagation"));
  EXPECT_TRUE(
      say(warningsOf(crackedPlate(7e10, 1e5, "0.75")), "less than an atom's distance; " + asK + "0.75"));
}

/// Acrylic 1 m long weighs 12 kPa and a crack of 0.5 m runs at 0.9 MPa; of 1 J/m2 at 45 kPa.
TEST(ToughnessAndWeight, OfABodyInMillimetresIsSaid)
{
  const auto scene = [](double scale)
  {
    const auto plate = crackedPlate(3e9, 1e6, "350");
    plate->sublist("Materials").sublist("Steel").set("Density", 1200.0 * scale);
    return plate;
  };
  EXPECT_FALSE(say(warningsOf(scene(1.0)), "would stress it with"));
  const auto large = scene(100.0); // as if 100 times as long
  EXPECT_TRUE(
      say(warningsOf(large), "but the weight of Bodies > Plate, which is 1 m long, would stress it with"));
  boundary(*large, "Weight", "Gravity").set("Acceleration", pair(0.0, -9.81));
  EXPECT_FALSE(say(warningsOf(large), "would stress it with"));
}

/// One that rises with speed is judged by its largest value, and soft solids are not.
TEST(ToughnessOfBonds, OfARunningCrackOrASoftSolidIsRight)
{
  EXPECT_FALSE(say(warningsOf(crackedPlate(3e9, 1e5, "0:1, 100:1, 200:100")), asK));
  EXPECT_FALSE(say(warningsOf(crackedPlate(1e6, 10.0, "1")), asK));
}

/// Speeds in km/s: 440 m/s, half of the speed of Rayleigh waves, would need 2.6e5 J/m2.
TEST(ToughnessOfSpeed, InKilometresIsSaid)
{
  const std::string rises = "J/m2: it rises to ", speeds = "speeds are in m/s";
  EXPECT_TRUE(
      say(warningsOf(crackedPlate(3e9, 1e5, "300*(1 + v/0.5)")), "Propagation > Toughness is 300 " + rises));
  EXPECT_TRUE(say(warningsOf(crackedPlate(3e9, 1e5, "10*(1 + v/0.5)")), "faster than in any stiff solid"));
  for (const char* right : {"300*(1 + v/100)", "0:1, 100:1, 200:1000", "300/(1 - v/2000)"})
    EXPECT_FALSE(say(warningsOf(crackedPlate(3e9, 1e5, right)), speeds)) << right;
  EXPECT_FALSE(say(warningsOf(crackedPlate(1e6, 10.0, "1*(1 + v/0.1)")), speeds));
}

/// Without contraction the Rayleigh speed is 0.874 of sqrt(mu / rho).
TEST(SpeedLimit, AboveRayleighWavesIsSaid)
{
  const double rayleigh = 0.8740 * std::sqrt(1.5e9 / 7800.0);
  for (const double part : {0.5, 0.99, 1.01, 1e6})
  {
    const auto scene = crackedPlate(3e9, 1e5, "300");
    scene->sublist("Propagation").set("Speed Limit", part * rayleigh);
    EXPECT_EQ(say(warningsOf(scene), "times the speed of Rayleigh waves (383.3 m/s)"), part > 1.0) << part;
  }
}

TEST(PlasticZoneOfToughness, IsSmallNextToTheCrack)
{
  const std::string zone = "ahead of it yield (twice Irwin's radius) at Materials > Steel > Yield Stress = ";
  EXPECT_TRUE(say(warningsOf(yieldingPlate(1e7, 5e7, "20000")), zone + "50000000 Pa, more than a fifth"));
  EXPECT_FALSE(say(warningsOf(yieldingPlate(1e7, 1e9, "20000")), zone));
}

TEST(YieldStress, BelowTheLoadsIsSaid)
{
  const std::string place = "Materials > Steel > Yield Stress is ";
  EXPECT_TRUE(say(warningsOf(yieldingPlate(1e7, 250.0, "20000")),
                  place + "250 Pa, and Boundaries > Bottom stresses the body with about 1e+07 Pa"));
  EXPECT_TRUE(
      say(warningsOf(yieldingPlate(1e8, 1.1e8, "20000")), place + "110000000 Pa, and under the 1e+08 Pa"));
  EXPECT_FALSE(say(warningsOf(yieldingPlate(1e7, 1e9, "20000")), place));
}

} // namespace Test
} // namespace Rhegma
