/// The same bodies as they fly through the lattice (tstStability.cpp).

#include "RandomBodies.hpp"

#include <algorithm>
#include <iostream>
#include <vector>

namespace Rhegma
{
namespace Test
{

/// Bodies that fly through the lattice, a cell in 20,000 steps, two hundred times as fast as they are shaken.
/// What they keep of the energy of the shaking must not depend on the solver: it works on what is not flight.
/// Particles reach other cells here, which gives and takes energy with any mass matrix; what Lumped makes of
/// the same flight is printed next to it.
class MassFlight : public testing::TestWithParam<std::string>
{
};

TEST_P(MassFlight, IsSolvedAsWellAsRest)
{
  constexpr int steps = 20000;
  const Motion motion{1e-6, Vector<2>{{2e-4, 0.0}}};
  for (const std::vector<Pose>& bodies : poses(everything() ? 20 : 2))
  {
    const auto kept = [&](const std::string& type, double tolerance)
    {
      Settings settings;
      settings.tolerance = tolerance;
      return ends(follow(bodiesScene(type, GetParam(), bodies, settings), bodies.size(), steps, motion));
    };
    const std::vector<double> full = kept("Full", Settings{}.tolerance), exact = kept("Full", 1e-11);
    for (std::size_t b = 0; b < bodies.size(); ++b)
      EXPECT_NEAR(full[b], exact[b], steps * Settings{}.tolerance) << bodies[b];
    std::cout << GetParam() << ", " << bodies.size() << " bodies in flight, the last " << bodies.back()
              << ": energy of the last tenth of " << steps << " steps over the first with Full "
              << range(full) << ", with Lumped " << range(kept("Lumped", 0.0)) << std::endl;
  }
}

/// A body with a crack in flight, of which a particle gives mass to a field behind the front that had none:
/// what the springs there are stretched by is no flight. (Where it was, the energy of the shaking grew a
/// thousandfold.)
TEST(MassFlightWithACrack, GainsNothingFromSprings)
{
  const Pose pose{Vector<2>{{0.474, 0.062}}, 11.0};
  const Motion motion{1e-6, Vector<2>{{2e-4, 0.0}}};
  const History history = follow(bodiesScene("Partial", "Linear", {pose}, Settings{}), 1, 8000, motion);
  EXPECT_LT(*std::max_element(history[0].begin(), history[0].end()), 2.0);
}

INSTANTIATE_TEST_SUITE_P(Bodies, MassFlight, testing::Values("Linear", "GIMP"));

} // namespace Test
} // namespace Rhegma
