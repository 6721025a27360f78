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

/// Fraction of boxes that reach over rows of nodes from which a reduced stiffness is worth its assembly.
constexpr double leastSpanning = 1.0 / 3.0;

/// Part of the width of a box that may be beyond a row of nodes and is left out.
double reachOf(Clipping clipping) { return clipping == Clipping::LittleBeyondCells ? leastReach : 0.5; }

/// Part of the stiffness of a node that must be left.
double partOf(Clipping clipping) { return clipping == Clipping::LittleBeyondCells ? 0.0 : leastStiffness; }

/// Clips a box along an axis. \param at, half its centre and half width in cells \param part of its width
/// that is left out at most \return whether it was
bool clip(double& at, double& half, double part)
{
  const double low = at - half, high = at + half, reach = 2.0 * half * part;
  const double above = std::ceil(low), below = std::floor(high);
  const bool lower = above - low < reach && above > low, upper = high - below < reach && high > below;
  const double begin = lower ? above : low, end = upper ? below : high;
  at = 0.5 * (begin + end);
  half = 0.5 * (end - begin);
  return lower || upper;
}

/// Whether the stencil of a particle is stored: then it keeps its box.
template <int D>
bool isStored(const State<D>& state, int p)
{
  return state.stored.count > 0 && state.stored.row(p) >= 0;
}

/// Calls use(node, stiffness) for each node that a particle sees, with a measure of what it exerts there.
template <int D, class Connect, class Use>
void forNodesOf(const State<D>& state, const Connect& connect, int p, const Use& use)
{
  const double spacing = state.mesh.grid.spacing;
  connect.visitStraining(p,
                         [&](int node, double weight, const auto& slopes)
                         {
                           if (!counts(weight, slopes.of, slopes.size, spacing))
                             return;
                           double sum = weight * weight;
                           for (int k = 0; k < slopes.size; ++k)
                             sum += slopes.of[k] * slopes.of[k] * spacing * spacing;
                           use(node, sum);
                         });
}

/// What the particles of all ranks exert on each node, as a measure.
template <int D, class Connect>
View<double*> stiffnessOfNodes(const State<D>& state, const Connect& connect)
{
  const View<double*> sum("rhegma::equilibrium::stiffnessOfNodes", state.mesh.nodes.sums.extent(0));
  for (int p = 0; p < state.particles.size(); ++p)
    forNodesOf(state, connect, p, [&](int node, double part) { sum(node) += part; });
  sumOverRanks(state, sum.data(), 1, 0, 1);
  return sum;
}

/// Clips the boxes of particles without stored stencils. \return which were
template <int D>
std::vector<char> clipAll(const State<D>& state, Clipping clipping, const ClippedBoxes<D>& boxes)
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
      const bool is = !isStored(state, p) && clip(at, half, reachOf(clipping));
      clipped[p] = is || clipped[p] != 0 ? 1 : 0;
      boxes.position(p, d) = is ? grid.origin[d] + at * grid.spacing : position(p, d);
      boxes.half(p, d) = is ? half * grid.spacing : box(p, d);
    }
  return clipped;
}

/// Which nodes need boxes that are not clipped.
struct Weak
{
  double part; ///< of the stiffness of all particles that is left to them at most
  int axes;    ///< along which they are outside the cell of such a box
};

/// Gives boxes back their extent along axes in which they reach nodes that need them. \param clipped
/// particles \param whole stiffness of the nodes without clipping
template <int D, class Connect>
void keepWhole(const State<D>& state, const Connect& connect, const std::vector<char>& clipped,
               const Weak& weak, const View<double*>& whole, const ClippedBoxes<D>& boxes)
{
  const View<double*> left = stiffnessOfNodes(state, boxes.in(connect));
  const NodePositions<D> positions = nodePositions(state);
  const auto position = state.particles.template real<D>(fields::position);
  const auto box = state.particles.template real<D>(fields::box);
  for (int p = 0; p < state.particles.size(); ++p)
  {
    if (clipped[p] == 0)
      continue;
    bool keeps[D] = {};
    forNodesOf(state, connect, p,
               [&](int node, double)
               {
                 if (left(node) > weak.part * whole(node))
                   return;
                 const Vector<D> x = positions(latticeNode(state.mesh.nodes, node));
                 bool outside[D];
                 int count = 0;
                 for (int d = 0; d < D; ++d)
                 {
                   outside[d] = std::fabs(x[d] - boxes.position(p, d)) > state.mesh.grid.spacing;
                   count += outside[d] ? 1 : 0;
                 }
                 for (int d = 0; d < D && count == weak.axes; ++d)
                   keeps[d] = keeps[d] || outside[d];
               });
    for (int d = 0; d < D; ++d)
    {
      boxes.position(p, d) = keeps[d] ? position(p, d) : boxes.position(p, d);
      boxes.half(p, d) = keeps[d] ? box(p, d) : boxes.half(p, d);
    }
  }
}

} // namespace

template <int D>
ClippedBoxes<D> clipBoxes(const State<D>& state, Clipping clipping)
{
  if (state.method.shape != ShapeKind::Gimp)
    return {};
  const int count = state.particles.size();
  const ClippedBoxes<D> boxes{View<double* [D]>("rhegma::equilibrium::clippedPosition", count),
                              View<double* [D]>("rhegma::equilibrium::clippedBox", count)};
  const std::vector<char> clipped = clipAll(state, clipping, boxes);
  withStraining(state,
                [&](const auto& connect)
                {
                  const View<double*> whole = stiffnessOfNodes(state, connect);
                  for (int axes = 1; axes <= D; ++axes)
                    keepWhole(state, connect, clipped, {partOf(clipping), axes}, whole, boxes);
                });
  const auto box = state.particles.template real<D>(fields::box);
  double any = 0.0;
  for (int p = 0; p < count && any == 0.0; ++p)
    for (int d = 0; d < D; ++d)
      any = boxes.half(p, d) < box(p, d) ? 1.0 : any;
  return ranksOf(state).max(any) > 0.0 ? boxes : ClippedBoxes<D>();
}

template <int D>
bool spanSeveralCells(const State<D>& state)
{
  if (state.method.shape != ShapeKind::Gimp)
    return false;
  const Grid<D>& grid = state.mesh.grid;
  const auto position = state.particles.template real<D>(fields::position);
  const auto box = state.particles.template real<D>(fields::box);
  double counts[] = {0.0, static_cast<double>(state.particles.size())}; // spanning, all
  for (int p = 0; p < state.particles.size(); ++p)
  {
    bool spans = false;
    for (int d = 0; d < D && !isStored(state, p); ++d)
    {
      const double at = grid.inCells(position(p, d), d),
                   half = box(p, d) * grid.inverse * (1.0 - 2.0 * leastReach);
      spans = spans || std::floor(at + half) > std::floor(at - half);
    }
    counts[0] += spans ? 1.0 : 0.0;
  }
  ranksOf(state).sum(counts, 2);
  return counts[0] > leastSpanning * counts[1];
}

template ClippedBoxes<2> clipBoxes(const State<2>&, Clipping);
template ClippedBoxes<3> clipBoxes(const State<3>&, Clipping);
template bool spanSeveralCells(const State<2>&);
template bool spanSeveralCells(const State<3>&);

} // namespace Rhegma::equilibrium
