/// J where temperature strains the body and changes its moduli.

#include "HeldPlate.hpp"
#include "energy_release/DomainIntegral.hpp"

namespace Rhegma
{
namespace Test
{

namespace
{

/// A crack along half of a plate of 6 m in plane stress.
Rhegma::Run<2> heldStrip(const std::string& temperature, const std::string& young)
{
  Teuchos::ParameterList scene = heldPlate<2>(6.0, 0.0, temperature, young);
  scene.sublist("Cracks").sublist("Notch").set("Points",
                                               Teuchos::Array<double>(Teuchos::tuple(-0.1, 0.0, 3.0, 0.0)));
  scene.sublist("Energy Release").set("Crack Closure", false);
  return atRest<2>(scene, 30.0);
}

auto releaseIn(const State<2>& state)
{
  return [&state](double inner, double outer)
  {
    energy_release::InternalAcceleration<2> acceleration;
    return energy_release::integrateDomain(state, state.cracks.fronts[0],
                                           {inner * heldCell, outer * heldCell}, acceleration)
        .J;
  };
}

} // namespace

/// Cooled evenly, the strip holds E e^2 / (1 - nu) ahead of the crack and E e^2 / 2 behind it, for it can't
/// shrink along the edges there either. The tolerance is as for a strip that is pulled, 8 cells a half
/// height; the ends, 3 heights away, are in it.
TEST(HeatedCracks, CooledStripHasTheEnergyThatItLosesAlongTheCrack)
{
  const Rhegma::Run<2> run = heldStrip("290", "");
  const double expected = heldHalf * std::pow(cooledStrain(), 2) * (1.0 + heldPoisson) / (1.0 - heldPoisson);
  expectRelease(releaseIn(run.state()), expected, 0.01);
}

/// Temperature and with it the modulus change along the crack.
TEST(HeatedCracks, AnyContourGivesTheSameWhereTemperatureChanges)
{
  Rhegma::Run<2> run = heldStrip("290 + 2*(x - 3)", "280:1.5, 300:0.5");
  expectAnyRingGivesTheSame(run.state(), releaseIn(run.state()), 0.01, 0.05);
}

} // namespace Test
} // namespace Rhegma
