#include "LatticeState.hpp"

#include "energy_release/Disagreement.hpp"
#include "material/MaterialTable.hpp"

#include <gtest/gtest.h>

using namespace Rhegma;
using namespace Rhegma::energy_release;
using namespace Rhegma::energy_release::test;

namespace
{

/// What is said of fronts whose K_I and K_II, equal ones, give a fraction of their J of 10 J/m2.
std::vector<std::string> saidOf(const std::vector<double>& fractions, double speed = 0.0,
                                const std::vector<double>& release = {10.0, 10.0}, double energy = 0.0)
{
  State<2> state = makeBody(0.01, 1e-3, Plane::Strain, ShapeKind::Gimp);
  state.energy.strain = energy;
  CrackFront<2> front = addFront(state, {{0.0, 0.0}}, 0.0);
  state.cracks.cracks[0].numVertices = 2;
  state.cracks.vertex = View<double* [2]>("rhegma::vertex", 2);
  state.cracks.vertex(1, 0) = 4e-3;
  front.nodes[0].speed = speed;
  const double modulus = elasticity(state.materials.properties[0]).effectiveModulus;
  std::vector<FrontSample<2>> samples;
  for (std::size_t k = 0; k < fractions.size(); ++k)
  {
    front.number = static_cast<int>(k);
    samples.emplace_back(front, 0.0);
    samples.back().J = {release[k]};
    samples.back().modeI = samples.back().modeII = {std::sqrt(0.5 * fractions[k] * modulus * release[k])};
    samples.back().tube.radii = {3e-3, 6e-3};
  }
  return warningsOfDisagreement(state, samples, 2e-3);
}

} // namespace

/// K^2 / E' is J.
TEST(Disagreement, OfGAndKIsSaidWithItsSize)
{
  const std::vector<std::string> said = saidOf({0.75, 1.2});
  ASSERT_EQ(said.size(), 2u);
  EXPECT_NE(said[0].find(", front 0 at t = 2 ms give G = K^2 / E' = 7.5 J/m2, 25 % less than the 10 J/m2"),
            std::string::npos)
      << said[0];
  EXPECT_NE(said[1].find("12 J/m2, 20 % more than the 10 J/m2"), std::string::npos) << said[1];
}

/// Up to 10 %; of running fronts, of which another formula holds; where nothing was computed; of a front
/// whose G is noise next to that of another.
TEST(Disagreement, IsNotSaidOfWhatMayDiffer)
{
  EXPECT_TRUE(saidOf({0.901, 1.099}).empty());
  EXPECT_EQ(saidOf({0.899, 1.101}).size(), 2u);
  EXPECT_TRUE(saidOf({0.5, 0.5}, 100.0).empty());
  EXPECT_TRUE(saidOf({FrontSample<2>::notYet, 1.0}).empty());
  EXPECT_TRUE(saidOf({0.5, 1.0}, 0.0, {0.49, 10.0}).empty());
  EXPECT_EQ(saidOf({0.5, 1.0}, 0.0, {0.51, 10.0}).size(), 1u);
  const double usual = 100.0 * 4e-4 * thickness / (2.0 * 3.14159265358979 * 4e-3); // energy for 100 J/m2
  EXPECT_TRUE(saidOf({0.5}, 0.0, {4.9}, usual).empty());
  EXPECT_EQ(saidOf({0.5}, 0.0, {5.1}, usual).size(), 1u);
}
