#include "equilibrium/ClippedBoxes.hpp"

#include "equilibrium/Unknowns.hpp"
#include "state/Subdomain.hpp"
#include "transfer/ParticleViews.hpp"

#include <cmath>

namespace Rhegma::equilibrium
{

namespace
{

/// Fraction of boxes that reach over rows of nodes from which a reduced stiffness is worth its assembly.
constexpr double leastSpanning = 1.0 / 3.0;

using ParticleRange = Kokkos::RangePolicy<ExecSpace>;

/// Part of the width of a box that may be beyond a row of nodes and is left out.
double reachOf(Clipping clipping) { return clipping == Clipping::LittleBeyondCells ? leastReach : 0.5; }

/// Part of the stiffness of a node that must be left.
double partOf(Clipping clipping) { return clipping == Clipping::LittleBeyondCells ? 0.0 : leastStiffness; }

/// Clips a box along an axis. \param at, half its centre and half width in cells \param part of its width
/// that is left out at most \return whether it was
KOKKOS_INLINE_FUNCTION bool clip(double& at, double& half, double part)
{
  const double low = at - half, high = at + half, reach = 2.0 * half * part;
  const double above = std::ceil(low), below = std::floor(high);
  const bool lower = above - low < reach && above > low, upper = high - below < reach && high > below;
  const double begin = lower ? above : low, end = upper ? below : high;
  at = 0.5 * (begin + end);
  half = 0.5 * (end - begin);
  return lower || upper;
}

/// Particles whose stencils are stored: they keep their boxes.
struct KeepsBox
{
  View<int*> row; ///< empty where none are stored

  template <int D>
  explicit KeepsBox(const State<D>& state)
  {
    if (state.stored.count > 0)
      row = state.stored.row;
  }
  KOKKOS_INLINE_FUNCTION bool operator()(int p) const { return row.extent(0) > 0 && row(p) >= 0; }
};

/// Calls use(node, stiffness) for each node that a particle sees, with a measure of what it exerts there.
template <class Connect, class Use>
KOKKOS_INLINE_FUNCTION void forNodesOf(const Connect& connect, double spacing, int p, const Use& use)
{
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

template <class Connect>
struct StiffnessOfNodes
{
  Connect connect;
  double spacing;
  View<double*> sum;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    for (int p = begin; p < end; ++p)
      forNodesOf(connect, spacing, p, [&](int node, double part) { sum(node) += part; });
  }
};

/// What the particles of all ranks exert on each node, as a measure.
template <int D, class Connect>
View<double*> stiffnessOfNodes(const State<D>& state, const Connect& connect)
{
  const View<double*> sum("rhegma::equilibrium::stiffnessOfNodes", state.mesh.nodes.sums.extent(0));
  forEachBlock("rhegma::equilibrium::stiffnessOfNodes", state.mesh.blocks,
               StiffnessOfNodes<Connect>{connect, state.mesh.grid.spacing, sum});
  sumOverRanks(state, sum.data(), 1, 0, 1);
  return sum;
}

/// Clips the boxes of particles without stored stencils. \return not 0 where they were
template <int D>
View<char*> clipAll(const State<D>& state, Clipping clipping, const ClippedBoxes<D>& boxes)
{
  const Grid<D> grid = state.mesh.grid;
  const auto position = state.particles.template real<D>(fields::position);
  const auto box = state.particles.template real<D>(fields::box);
  const KeepsBox stored(state);
  const double reach = reachOf(clipping);
  const View<char*> clipped("rhegma::equilibrium::clipped", state.particles.size());
  Kokkos::parallel_for(
      "rhegma::equilibrium::clip", ParticleRange(0, state.particles.size()), KOKKOS_LAMBDA(const int p) {
        for (int d = 0; d < D; ++d)
        {
          double at = grid.inCells(position(p, d), d), half = box(p, d) * grid.inverse;
          const bool is = !stored(p) && clip(at, half, reach);
          clipped(p) = is || clipped(p) != 0 ? 1 : 0;
          boxes.position(p, d) = is ? grid.origin[d] + at * grid.spacing : position(p, d);
          boxes.half(p, d) = is ? half * grid.spacing : box(p, d);
        }
      });
  return clipped;
}

/// Gives boxes back their extent along axes in which they reach nodes that need them.
template <int D, class Connect>
struct KeepWhole
{
  Connect connect;
  View<char*> clipped;       ///< not 0 where a particle's box is
  View<double*> left, whole; ///< stiffness of the nodes with clipping and without
  double part;               ///< of the stiffness of all particles that is left to weak nodes at most
  int axes;                  ///< along which these are outside the cell of a box that stays whole
  Nodes<D> nodes;
  NodePositions<D> positions;
  double spacing;
  BorrowedView<double*[D]> position, box;
  ClippedBoxes<D> boxes;

  KOKKOS_INLINE_FUNCTION void operator()(int p) const
  {
    if (clipped(p) == 0)
      return;
    bool keeps[D] = {};
    forNodesOf(connect, spacing, p,
               [&](int node, double)
               {
                 if (left(node) > part * whole(node))
                   return;
                 const Vector<D> x = positions(latticeNode(nodes, node));
                 bool outside[D];
                 int count = 0;
                 for (int d = 0; d < D; ++d)
                 {
                   outside[d] = std::fabs(x[d] - boxes.position(p, d)) > spacing;
                   count += outside[d] ? 1 : 0;
                 }
                 for (int d = 0; d < D && count == axes; ++d)
                   keeps[d] = keeps[d] || outside[d];
               });
    for (int d = 0; d < D; ++d)
    {
      boxes.position(p, d) = keeps[d] ? position(p, d) : boxes.position(p, d);
      boxes.half(p, d) = keeps[d] ? box(p, d) : boxes.half(p, d);
    }
  }
};

} // namespace

template <int D>
ClippedBoxes<D> clipBoxes(const State<D>& state, Clipping clipping)
{
  if (state.method.shape != ShapeKind::Gimp)
    return {};
  const int count = state.particles.size();
  const ClippedBoxes<D> boxes{View<double* [D]>("rhegma::equilibrium::clippedPosition", count),
                              View<double* [D]>("rhegma::equilibrium::clippedBox", count)};
  const View<char*> clipped = clipAll(state, clipping, boxes);
  const auto position = state.particles.template real<D>(fields::position);
  const auto box = state.particles.template real<D>(fields::box);
  withStraining(state,
                [&](const auto& connect)
                {
                  using Connect = std::decay_t<decltype(connect)>;
                  const View<double*> whole = stiffnessOfNodes(state, connect);
                  for (int axes = 1; axes <= D; ++axes)
                    Kokkos::parallel_for(
                        "rhegma::equilibrium::keepWhole", ParticleRange(0, count),
                        KeepWhole<D, Connect>{connect, clipped, stiffnessOfNodes(state, boxes.in(connect)),
                                              whole, partOf(clipping), axes, state.mesh.nodes,
                                              nodePositions(state), state.mesh.grid.spacing, position, box,
                                              boxes});
                });
  int any = 0;
  Kokkos::parallel_reduce(
      "rhegma::equilibrium::anyClipped", ParticleRange(0, count),
      KOKKOS_LAMBDA(const int p, int& found) {
        for (int d = 0; d < D; ++d)
          found = boxes.half(p, d) < box(p, d) ? 1 : found;
      },
      Kokkos::Max<int>(any));
  return ranksOf(state).max(any > 0 ? 1.0 : 0.0) > 0.0 ? boxes : ClippedBoxes<D>();
}

template <int D>
bool spanSeveralCells(const State<D>& state)
{
  if (state.method.shape != ShapeKind::Gimp)
    return false;
  const Grid<D> grid = state.mesh.grid;
  const auto position = state.particles.template real<D>(fields::position);
  const auto box = state.particles.template real<D>(fields::box);
  const KeepsBox stored(state);
  long spanning = 0;
  Kokkos::parallel_reduce(
      "rhegma::equilibrium::spanSeveralCells", ParticleRange(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, long& sum) {
        bool spans = false;
        for (int d = 0; d < D && !stored(p); ++d)
        {
          const double at = grid.inCells(position(p, d), d),
                       half = box(p, d) * grid.inverse * (1.0 - 2.0 * leastReach);
          spans = spans || std::floor(at + half) > std::floor(at - half);
        }
        sum += spans ? 1 : 0;
      },
      spanning);
  double counts[] = {static_cast<double>(spanning), static_cast<double>(state.particles.size())};
  ranksOf(state).sum(counts, 2);
  return counts[0] > leastSpanning * counts[1];
}

template ClippedBoxes<2> clipBoxes(const State<2>&, Clipping);
template ClippedBoxes<3> clipBoxes(const State<3>&, Clipping);
template bool spanSeveralCells(const State<2>&);
template bool spanSeveralCells(const State<3>&);

} // namespace Rhegma::equilibrium
