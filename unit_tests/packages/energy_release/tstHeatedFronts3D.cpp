/// J along a straight front in 3D where temperature strains the body and changes its moduli.

#include "HeldPlate.hpp"
#include "energy_release/FrontIntegral.hpp"

namespace Rhegma
{
namespace Test
{

namespace
{

using namespace energy_release;

/// A crack along half of a plate of 7 m between two planes of symmetry: plane strain.
Rhegma::Run<3> heldBlock(const std::string& temperature, const std::string& young)
{
  const double length = 7.0, depth = 0.25, tip = 0.5 * length;
  Teuchos::ParameterList scene = heldPlate<3>(length, depth, temperature, young);
  for (const double position : {0.0, depth})
  {
    Teuchos::ParameterList& mirror = scene.sublist("Boundaries").sublist(position > 0.0 ? "Far" : "Near");
    mirror.set("Type", "Symmetry");
    mirror.set("Axis", "z");
    mirror.set("Position", position);
  }
  scene.sublist("Cracks").sublist("Notch").set(
      "Points",
      Teuchos::Array<double>(Teuchos::tuple(0.0, 0.0, 0.0, tip, 0.0, 0.0, tip, 0.0, depth, 0.0, 0.0, depth)));
  scene.sublist("Energy Release");
  return atRest<3>(scene, 25.0);
}

/// At the front node in the middle of the front.
auto releaseIn(const State<3>& state)
{
  return [&state](double inner, double outer)
  {
    const FrontLine line = lineOf(state.cracks.fronts.at(0));
    InternalAcceleration<3> acceleration;
    const std::vector<std::optional<double>> all = integrateAlongFront(
        state, 0, line, {{inner * heldCell, outer * heldCell}, 2.0 * heldCell}, acceleration);
    return all.at(all.size() / 2).value();
  };
}

} // namespace

/// Cooled evenly, the plate holds 3 E e^2 / (2 (1 - 2 nu)) ahead of the crack, where it can shrink nowhere,
/// and E e^2 / (1 - nu) behind it. The tolerance is as for a strip that is pulled, 8 cells a half height; the
/// ends, 3.5 heights away, are in it.
TEST(HeatedFronts3D, CooledPlateHasTheEnergyThatItLosesAlongTheCrack)
{
  const Rhegma::Run<3> run = heldBlock("290", "");
  const double expected = 2.0 * heldHalf * std::pow(cooledStrain(), 2) *
                          (1.5 / (1.0 - 2.0 * heldPoisson) - 1.0 / (1.0 - heldPoisson));
  expectRelease(releaseIn(run.state()), expected, 0.02);
}

/// Temperature and with it the modulus change along the crack.
TEST(HeatedFronts3D, AnyTubeGivesTheSameWhereTemperatureChanges)
{
  Rhegma::Run<3> run = heldBlock("290 + 2*(x - 3.5)", "280:1.5, 300:0.5");
  expectAnyRingGivesTheSame(run.state(), releaseIn(run.state()), 0.015, 0.04);
}

} // namespace Test
} // namespace Rhegma
