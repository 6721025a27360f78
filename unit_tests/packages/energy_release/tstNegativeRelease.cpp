#include "LatticeState.hpp"

#include "energy_release/NegativeRelease.hpp"

#include <gtest/gtest.h>

using namespace Rhegma;
using namespace Rhegma::energy_release;
using namespace Rhegma::energy_release::test;

namespace
{

/// 2 pi a U / V is 100 J/m2 with this density [J/m3].
constexpr double usualEnergy = 100.0 / (2.0 * 3.14159265358979 * 4e-3);

/// What is said of fronts of one crack of 4 mm in a body of 20 mm, whose mean density of energy is that.
std::vector<std::string> saidOf(const std::vector<double>& release, double energyDensity,
                                double largestEver = 0.0)
{
  State<2> state = makeBody(0.01, 1e-3, Plane::Strain, ShapeKind::Gimp);
  state.energy.strain = energyDensity * 4e-4 * thickness;
  CrackFront<2> front = addFront(state, {{0.0, 0.0}}, 0.0);
  state.cracks.fronts.clear();
  state.cracks.cracks[0].numVertices = 2;
  state.cracks.vertex = View<double* [2]>("rhegma::vertex", 2);
  state.cracks.vertex(1, 0) = 4e-3;
  std::vector<FrontSample<2>> samples;
  for (const double G : release)
  {
    front.number = static_cast<int>(samples.size());
    state.cracks.fronts.push_back(front);
    samples.emplace_back(front, 0.0);
    samples.back().J = {G};
    samples.back().tube.radii = {3e-3, 6e-3};
  }
  return warningsOfNegativeRelease(state, samples, 2e-3, largestEver);
}

} // namespace

TEST(NegativeRelease, IsSaidWithItsNumber)
{
  const std::vector<std::string> said = saidOf({-99.0}, usualEnergy);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(said[0].rfind("Energy Release: G_J of crack ", 0), 0u) << said[0];
  EXPECT_NE(said[0].find(", front 0 is -99 J/m2 at t = 2 ms"), std::string::npos) << said[0];
  EXPECT_NE(said[0].find("from 3 mm to 6 mm"), std::string::npos) << said[0];
}

/// A twentieth of what a crack of that extent has, or of the largest G.
TEST(NegativeRelease, IsNoiseBelowATwentieth)
{
  EXPECT_TRUE(saidOf({-4.9}, usualEnergy).empty());
  EXPECT_EQ(saidOf({-5.1}, usualEnergy).size(), 1u);
  EXPECT_TRUE(saidOf({-9.9, 200.0}, usualEnergy).empty());
  EXPECT_EQ(saidOf({-10.1, 200.0}, usualEnergy).size(), 1u);
  EXPECT_TRUE(saidOf({0.0, 3.0}, usualEnergy).empty());
  EXPECT_TRUE(saidOf({FrontSample<2>::notYet}, usualEnergy).empty());
}

/// After unloading, G is noise next to what it was before.
TEST(NegativeRelease, IsNoiseNextToTheLargestOfTheRun)
{
  EXPECT_TRUE(saidOf({-0.9}, 1e-6 * usualEnergy, 20.0).empty());
  EXPECT_EQ(saidOf({-1.1}, 1e-6 * usualEnergy, 20.0).size(), 1u);
}
