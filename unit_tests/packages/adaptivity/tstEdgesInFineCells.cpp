/// Edges of bodies in cells that are refined at the start.

#include "Refined.hpp"

#include "geometry/Shape.hpp"
#include "state/Ancestry.hpp"

#include <cstdlib>
#include <iostream>
#include <map>

namespace Rhegma
{
namespace Test
{

namespace
{

/// Mass in each refined cell that lies in the body, over that of a full cell, is 1; also next to the edge of
/// a hole that is smaller than a coarse cell. The hole, the cells and the box of fine cells are anywhere.
template <int D>
void expectFullCells(const std::string& shape)
{
  const char* const given = std::getenv("RHEGMA_SEED");
  const unsigned seed = given != nullptr ? std::strtoul(given, nullptr, 10) : std::random_device{}();
  std::cout << "seed " << seed << '\n';
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> some(0.0, 1.0);
  // Cells looked at: where the hole takes most of the box of fine cells there are few, and trials go on.
  constexpr int enough = 100, mostTrials = 12;
  int full = 0;
  for (int trial = 0; trial < mostTrials && (trial < (D == 2 ? 6 : 2) || full <= enough); ++trial)
  {
    Vector<D> centre{}, lower{}, upper{};
    const double radius = 0.3 + 0.5 * some(engine);
    for (int d = 0; d < D; ++d)
    {
      centre[d] = 2.0 + some(engine);
      lower[d] = centre[d] + 0.3 * (some(engine) - 0.5);
      upper[d] = lower[d] + 0.8 + 0.4 * some(engine);
    }
    const int levels = D == 2 ? 4 : 3;
    Teuchos::ParameterList scene = refinedScene<D>(shape, 5.0, lower, upper, levels);
    Teuchos::ParameterList& hole =
        scene.sublist("Bodies").sublist("Cube").sublist("Operations").sublist("Bore");
    hole.set("Operation", "Cut").set("Shape", "Ball").set("Radius", radius).set("Centre", array(centre));
    Run<D> run(validated(scene));
    run.initialize();
    const HostParticles<D> particles(run.state());
    const auto level = onHost(run.state().particles.integer(fields::level));
    const auto volumes = onHost(run.state().particles.scalar(fields::volume));
    using Cell = std::array<int, D>;
    std::map<Cell, double> mass; // of cells of the deepest level
    const double edge = std::ldexp(1.0, -levels);
    double all = 0.0, density = 0.0, volume = 0.0;
    for (int p = 0; p < particles.size; ++p)
    {
      all += particles.mass(p);
      density = particles.mass(p) / volumes(p);
      volume += volumes(p);
      if (level(p) != levels)
        continue;
      Cell cell;
      for (int d = 0; d < D; ++d)
        cell[d] = static_cast<int>(std::floor(particles.position(p, d) / edge));
      mass[cell] += particles.mass(p);
    }
    const double round = D == 2 ? M_PI * radius * radius : 4.0 / 3.0 * M_PI * radius * radius * radius;
    EXPECT_NEAR(volume, std::pow(5.0, D) - round, 2e-3 * round);
    EXPECT_NEAR(all, density * volume, 1e-9 * all);
    for (const auto& [cell, m] : mass)
    {
      Vector<D> middle;
      bool inBox = true;
      for (int d = 0; d < D; ++d)
      {
        middle[d] = (cell[d] + 0.5) * edge;
        inBox = inBox && middle[d] > lower[d] && middle[d] < upper[d];
      }
      // Farther from the hole than a particle that has taken a part of its neighbour.
      if (!inBox || norm(middle - centre) < radius + 2.0 * edge * std::sqrt(double(D)))
        continue;
      ++full;
      EXPECT_NEAR(m, density * std::pow(edge, D), 1e-9 * density * std::pow(edge, D))
          << "cell at " << middle[0] << ", " << middle[1] << ", hole of radius " << radius << " at "
          << centre[0] << ", " << centre[1];
    }
  }
  EXPECT_GT(full, enough);
}

} // namespace

TEST(EdgesInFineCells, CellsAreFull2D)
{
  expectFullCells<2>("GIMP");
  expectFullCells<2>("Linear");
}

TEST(EdgesInFineCells, CellsAreFull3D) { expectFullCells<3>("GIMP"); }

} // namespace Test
} // namespace Rhegma
