/// Full and Partial over 100,000 steps, for bodies at random positions and at angles to the lattice.
///
/// Every day two bodies are tried. RHEGMA_STABILITY=all in the environment makes it twenty positions at each
/// of five angles, one angle after the other (RHEGMA_STABILITY=11 those at 11 degrees alone); what each has
/// kept is printed as soon as it is known. Bodies are no larger than is needed for cells that the boundary
/// cuts on all four sides at any position, and for the edge of the zone that Partial unlumps to lie within
/// them.

#include "RandomBodies.hpp"

#include <algorithm>
#include <array>
#include <iostream>
#include <vector>

namespace Rhegma
{
namespace Test
{

namespace
{

class MassStability : public testing::TestWithParam<std::tuple<std::string, std::string>>
{
protected:
  std::string type() const { return std::get<0>(GetParam()); }
  std::string shape() const { return std::get<1>(GetParam()); }
};

} // namespace

/// Nothing gives these bodies energy or takes it, and their nodes stay what they are: a step changes the
/// energy by what is left of its solves, of which each may leave the tolerance.
TEST_P(MassStability, KeepsEnergy)
{
  for (const std::vector<Pose>& bodies : poses(everything() ? 20 : 1, type() == "Partial"))
  {
    const History history = follow(bodiesScene(type(), shape(), bodies, Settings{}), bodies.size(), allSteps);
    for (std::size_t b = 0; b < bodies.size(); ++b)
      for (int part = 1; part < parts; ++part)
        EXPECT_NEAR(history[b][part], 1.0, allSteps * Settings{}.tolerance)
            << bodies[b] << ", tenth " << part + 1;
    std::cout << type() << ", " << shape() << ": " << bodies.size() << " bodies, the last " << bodies.back()
              << ": energy of the last tenth of " << allSteps << " steps over the first "
              << range(ends(history)) << std::endl;
  }
}

/// Bodies with neither a lumped fraction nor a smallest node, one by one; every day until one grows.
TEST_P(MassStability, GrowsWithoutTheCures)
{
  Settings none;
  none.lumpedFraction = none.smallestNode = 0.0;
  int grown = 0, tried = 0;
  for (const std::vector<Pose>& bodies : poses(everything() ? 20 : 10))
    for (const Pose& pose : bodies)
    {
      if (grown > 0 && !everything())
        break;
      ++tried;
      grown += follow(bodiesScene(type(), shape(), {pose}, none), 1, 2000)[0].back() > 10.0 ? 1 : 0;
    }
  EXPECT_GT(grown, 0);
  std::cout << type() << ", " << shape() << ": without the cures " << grown << " of " << tried
            << " bodies grow tenfold in 2,000 steps" << std::endl;
}

/// Without the cures a crack may be flung farther than all cells before a particle is: the run stops with a
/// message.
TEST(MassWithoutCures, StopsWhereACrackIsFlungAway)
{
  Settings none;
  none.lumpedFraction = none.smallestNode = 0.0;
  const Pose pose{Vector<2>{{0.21497922217155768, 0.15703111183739796}}, 11.0};
  Rhegma::Run<2> run(validated(bodiesScene("Partial", "Linear", {pose}, none)));
  run.initialize();
  shake(run.state(), 1, Motion{});
  const auto manySteps = [&run]
  {
    for (int k = 0; k < 2000; ++k)
      run.step(1e30, false);
  };
  EXPECT_THROW(manySteps(), RunError);
}

INSTANTIATE_TEST_SUITE_P(Bodies, MassStability,
                         testing::Combine(testing::Values("Full", "Partial"),
                                          testing::Values("Linear", "GIMP")),
                         CaseName());

} // namespace Test
} // namespace Rhegma
