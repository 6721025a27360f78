#include "step/LevelsOfCells.hpp"

#include "state/Ancestry.hpp"
#include "state/Subdomain.hpp"

#include <cmath>

namespace Rhegma
{

namespace
{

/// Whether any cell of a level in a range is refined. \param low, high in cells of the lattice
template <int D>
bool anyRefined(const Branches<D>& refined, int level, const double (&low)[D], const double (&high)[D])
{
  int first[D], count[D], all = 1;
  for (int d = 0; d < D; ++d)
  {
    first[d] = static_cast<int>(std::floor(std::ldexp(low[d], level)));
    count[d] = static_cast<int>(std::floor(std::ldexp(high[d], level))) - first[d] + 1;
    all *= count[d];
  }
  for (int k = 0; k < all; ++k)
  {
    typename Branches<D>::Cell cell;
    for (int d = 0, rest = k; d < D; rest /= count[d], ++d)
      cell[d] = first[d] + rest % count[d];
    if (refined.isInside(level, cell) && refined.isRefined(level, cell))
      return true;
  }
  return false;
}

} // namespace

template <int D>
bool haveCutParticles(const State<D>& state)
{
  const auto body = onHost(state.particles.integer(fields::body));
  const auto edge = onHost(state.particles.template real<D>(fields::edge));
  for (int p = 0; p < state.particles.size(); ++p)
    for (int d = 0; d < D; ++d)
      if (edge(p, d) != state.bodies.info[body(p)].edge[d])
        return true;
  return false;
}

template <int D>
IsDivided<D> dividedByCells(const State<D>& state)
{
  const Branches<D> refined = refinedCells(state);
  const bool boxes = state.method.shape == ShapeKind::Gimp;
  return [refined, boxes](const Geometry::OrientedBox<D>& box, int level)
  {
    const Grid<D>& grid = refined.grid();
    const double slack = std::ldexp(mayReach, -level - 1);
    double low[D], high[D];
    for (int d = 0; d < D; ++d)
    {
      double half = boxes ? -slack : 0.0;
      for (int e = 0; e < D && boxes; ++e)
        half += 0.5 * std::fabs(box.axes[e][d]) * box.edge[e] * grid.inverse;
      const double at = grid.inCells(box.centre[d], d);
      low[d] = at - half;
      high[d] = at + half;
    }
    return level < refined.depth() && anyRefined(refined, level, low, high);
  };
}

template bool haveCutParticles(const State<2>&);
template bool haveCutParticles(const State<3>&);
template IsDivided<2> dividedByCells(const State<2>&);
template IsDivided<3> dividedByCells(const State<3>&);

} // namespace Rhegma
