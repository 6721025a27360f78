#include "CubeScene.hpp"
#include "Pi.hpp"

#include "energy_release/FrontLine.hpp"

using namespace Rhegma;
using namespace Rhegma::cracks::test;

namespace
{

using Rhegma::Test::pi;

double frontLength(const Teuchos::ParameterList& scene)
{
  const auto run = start<3>(scene);
  const std::vector<CrackFront<3>>& fronts = run->state().cracks.fronts;
  EXPECT_EQ(fronts.size(), 1u);
  return energy_release::lineOf(fronts.at(0)).length;
}

} // namespace

/// Straight fronts that cross a body at an angle do so from surface to surface, wherever their vertices fall:
/// straight ahead of a last piece is no material for a cell.
TEST(Border, FrontsThatLeanReachTheSurface)
{
  const double wide = 5.0 * cell;
  for (const double degrees : {10.0, 20.0, 30.0, 45.0})
    for (const double shift : {0.0, 0.3, 0.7})
    {
      const double slope = std::tan(degrees * pi / 180.0), from = -(1.0 + shift) * cell, to = wide + cell;
      const auto x = [&](double y) { return 8.0 * cell + (y - 0.5 * wide) * slope; };
      Teuchos::ParameterList scene = blockScene({16.0 * cell, wide, 10.0 * cell});
      setCrack(scene, {-cell, from, 5.2 * cell, x(from), from, 5.2 * cell, x(to), to, 5.2 * cell, -cell, to,
                       5.2 * cell});
      // An end lies on the surface to a thousandth of an edge, by halving.
      EXPECT_NEAR(frontLength(scene), wide / std::cos(degrees * pi / 180.0), 0.01 * cell)
          << degrees << " " << shift;
    }
}

/// A disk of which a surface cuts off less and less: its front is all of the arc inside, which the chords of
/// its corners, of the same area, exceed by at most a fraction of (pi / 25)^2 / 6; a corner that was moved on
/// to the surface cuts its chord short by less than a tenth of a cell.
TEST(Border, DisksKeepTheirFrontUpToTheSurface)
{
  const double radius = 4.0 * cell;
  for (const double depth : {0.0, 0.5, 1.0, 1.5, 2.0, 3.0})
  {
    Teuchos::ParameterList scene = blockScene({12.0 * cell, 12.0 * cell, 10.0 * cell});
    Teuchos::ParameterList& crack = scene.sublist("Cracks").sublist("Cut");
    crack.set("Centre", numbers({6.0 * cell, depth * cell, 5.2 * cell}));
    crack.set("Normal", numbers({0.0, 0.0, 1.0}));
    crack.set("Radius", radius);
    const double arc = radius * (pi + 2.0 * std::asin(depth * cell / radius));
    EXPECT_NEAR(frontLength(scene), arc, std::pow(pi / 25.0, 2) / 6.0 * arc + 0.2 * cell) << depth;
  }
}
