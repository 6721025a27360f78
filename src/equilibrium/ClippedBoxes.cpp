#include "equilibrium/ClippedBoxes.hpp"

#include "equilibrium/Unknowns.hpp"
#include "state/Subdomain.hpp"
#include "transfer/ParticleViews.hpp"

#include <cmath>
#include <vector>

namespace Rhegma::equilibrium
{

namespace
{

/// Clips a box along an axis. \param at, half its centre and half width in cells \return whether it was
bool clip(double& at, double& half)
{
  const double low = at - half, high = at + half, reach = 2.0 * half * leastReach;
  const double above = std::ceil(low), below = std::floor(high);
  const bool lower = above - low < reach && above > low, upper = high - below < reach && high > below;
  const double begin = lower ? above : low, end = upper ? below : high;
  at = 0.5 * (begin + end);
  half = 0.5 * (end - begin);
  return lower || upper;
}

/// Calls use(node) for each node that a particle sees.
template <int D, class Connect, class Use>
void forNodesOf(const State<D>& state, const Connect& connect, int p, const Use& use)
{
  connect.visitStraining(p,
                         [&](int node, double weight, const auto& slopes)
                         {
                           if (counts(weight, slopes.of, slopes.size, state.mesh.grid.spacing))
                             use(node);
                         });
}

/// Clips the boxes of particles without stored stencils. \return which were
template <int D>
std::vector<char> clipAll(const State<D>& state, const ClippedBoxes<D>& boxes)
{
  const Grid<D>& grid = state.mesh.grid;
  const auto position = state.particles.template real<D>(fields::position);
  const auto box = state.particles.template real<D>(fields::box);
  const int count = state.particles.size();
  std::vector<char> clipped(count, 0);
  for (int p = 0; p < count; ++p)
    for (int d = 0; d < D; ++d)
    {
      double at = grid.inCells(position(p, d), d), half = box(p, d) * grid.inverse;
      const bool stored = state.stored.count > 0 && state.stored.row(p) >= 0;
      const bool is = !stored && clip(at, half);
      clipped[p] = is || clipped[p] != 0 ? 1 : 0;
      boxes.position(p, d) = is ? grid.origin[d] + at * grid.spacing : position(p, d);
      boxes.half(p, d) = is ? half * grid.spacing : box(p, d);
    }
  return clipped;
}

} // namespace

template <int D>
ClippedBoxes<D> clipBoxes(const State<D>& state)
{
  if (state.method.shape != ShapeKind::Gimp)
    return {};
  const int count = state.particles.size();
  const ClippedBoxes<D> boxes{View<double* [D]>("rhegma::equilibrium::clippedPosition", count),
                              View<double* [D]>("rhegma::equilibrium::clippedBox", count)};
  const std::vector<char> clipped = clipAll(state, boxes);
  const auto position = state.particles.template real<D>(fields::position);
  const auto box = state.particles.template real<D>(fields::box);
  const View<double*> seen("rhegma::equilibrium::seen", state.mesh.nodes.sums.extent(0));
  bool any = false;
  withStraining(state,
                [&](const auto& connect)
                {
                  const auto ofClipped = boxes.in(connect);
                  for (int p = 0; p < count; ++p)
                    forNodesOf(state, ofClipped, p, [&](int node) { seen(node) = 1.0; });
                  sumOverRanks(state, seen.data(), 1, 0, 1);
                  for (int p = 0; p < count; ++p)
                  {
                    bool all = true;
                    if (clipped[p] != 0)
                      forNodesOf(state, connect, p, [&](int node) { all = all && seen(node) != 0.0; });
                    any = any || (clipped[p] != 0 && all);
                    for (int d = 0; d < D && !all; ++d)
                    {
                      boxes.position(p, d) = position(p, d);
                      boxes.half(p, d) = box(p, d);
                    }
                  }
                });
  return ranksOf(state).max(any ? 1.0 : 0.0) > 0.0 ? boxes : ClippedBoxes<D>();
}

template ClippedBoxes<2> clipBoxes(const State<2>&);
template ClippedBoxes<3> clipBoxes(const State<3>&);

} // namespace Rhegma::equilibrium
