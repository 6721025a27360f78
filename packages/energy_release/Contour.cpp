#include "energy_release/Contour.hpp"

#include "state/Subdomain.hpp"
#include "transfer/LocalSpacing.hpp"
#include "transfer/PushNodes.hpp"

#include <algorithm>

namespace Rhegma::energy_release
{

namespace
{

/// Adds the particles' volume to the nodes, without regard to cracks.
template <int D>
void sumVolume(const State<D>& state, const Vector<D>& centre, double radius, const View<double*>& volume)
{
  const TreeSight<D> sight(state.mesh.grid, state.mesh.tree);
  const auto position = state.particles.template real<D>(fields::position);
  const auto initial = state.particles.scalar(fields::volume);
  const bool boxes = state.method.shape == ShapeKind::Gimp;
  BorrowedView<double* [D]> box;
  if (boxes)
    box = state.particles.template real<D>(fields::box);
  // In a fixed order, so that the result does not depend on the number of threads.
  forEachPushing(
      "rhegma::contourVolume", state.particles.size(), KOKKOS_LAMBDA(const int p) {
        Vector<D> x, half;
        for (int d = 0; d < D; ++d)
        {
          x[d] = position(p, d);
          half[d] = boxes ? box(p, d) : 0.0;
        }
        if (dot(x - centre, x - centre) < radius * radius)
          sight.forEachNode(x, half,
                            [&](int node, double weight, const double(&)[D])
                            { Kokkos::atomic_add(&volume(node), weight * initial(p)); });
      });
}

/// The gap between the faces of a crack, which a contour may contain, unlike other surfaces.
template <int D>
struct Gap
{
  View<double* [2][D]> face;
  View<int* [D]> simplex;
  int first = 0, end = 0; ///< simplices
  double margin = 0.0;    ///< how far beyond the faces nodes are partly empty because of the gap [m]

  KOKKOS_INLINE_FUNCTION bool holds(const Vector<D>& x) const
  {
    for (int s = first; s < end; ++s)
    {
      const int v = simplex(s, 0), w = simplex(s, D - 1);
      Vector<D> a, along, halfAtA, halfAtB;
      for (int d = 0; d < D; ++d)
      {
        a[d] = 0.5 * (face(v, 0, d) + face(v, 1, d));
        along[d] = 0.5 * (face(w, 0, d) + face(w, 1, d)) - a[d];
        halfAtA[d] = 0.5 * (face(v, 1, d) - face(v, 0, d));
        halfAtB[d] = 0.5 * (face(w, 1, d) - face(w, 0, d));
      }
      const double square = dot(along, along);
      double at = square > 0.0 ? dot(x - a, along) / square : 0.0;
      at = at < 0.0 ? 0.0 : (at > 1.0 ? 1.0 : at);
      if (norm(x - a - at * along) < (1.0 - at) * norm(halfAtA) + at * norm(halfAtB) + margin)
        return true;
    }
    return false;
  }
};

/// The gap of a front's crack. Nodes reach 1.5 cells.
template <int D>
Gap<D> gapOf(const State<D>& state, const CrackFront<D>& front)
{
  Gap<D> gap;
  if (D == 3 || state.cracks.face.extent(0) == 0)
    return gap;
  const Crack<D>& crack = state.cracks.cracks[front.crack];
  gap.face = state.cracks.face;
  gap.simplex = state.cracks.simplex;
  gap.first = crack.firstSimplex;
  gap.end = crack.firstSimplex + crack.numSimplices;
  gap.margin = 1.5 * spacingAt(state, front.position);
  return gap;
}

/// clearRadius without the nodes in a gap.
template <int D>
double clearAdjacent(const State<D>& state, const Vector<D>& centre, double radius, const Gap<D>& gap)
{
  const NodePositions<D> positions = nodePositions(state);
  const View<double*> cover = coverOfNodes(state, centre, radius);
  const Nodes<D> numbers = state.mesh.nodes;
  double nearest = radius;
  Kokkos::parallel_reduce(
      "rhegma::clearRadius", Kokkos::RangePolicy<ExecSpace>(0, cover.extent(0)),
      KOKKOS_LAMBDA(const int n, double& smallest) {
        if (!isOpen(numbers, cover, n))
          return;
        const double r = norm(positions(n) - centre);
        if (r < smallest && !gap.holds(positions(n)))
          smallest = r;
      },
      Kokkos::Min<double>(nearest));
  double closeness = -nearest;
  maxParts(state, &closeness, 1);
  return std::min(-closeness, radius);
}

} // namespace

template <int D>
View<double*> coverOfNodes(const State<D>& state, const Vector<D>& centre, double radius)
{
  View<double*> cover("rhegma::coverOfNodes", state.mesh.grid.numNodes + state.mesh.tree.numFine);
  sumVolume(state, centre, radius + 3.0 * state.mesh.grid.spacing, cover);
  sumOverRanks(state, cover);
  double cell = D == 2 ? state.method.thickness : 1.0;
  for (int d = 0; d < D; ++d)
    cell *= state.mesh.grid.spacing;
  const bool refined = state.mesh.tree.refined();
  const View<double*> nodeFraction = state.mesh.tree.nodeVolume;
  Kokkos::parallel_for(
      "rhegma::coverOfNodes", Kokkos::RangePolicy<ExecSpace>(0, cover.extent(0)),
      KOKKOS_LAMBDA(const int n) { cover(n) /= cell * (refined ? nodeFraction(n) : 1.0); });
  return cover;
}

template <int D>
double clearRadius(const State<D>& state, const Vector<D>& centre, double radius)
{
  return clearAdjacent(state, centre, radius, Gap<D>{});
}

template <int D>
double largestContour(const State<D>& state, const CrackFront<D>& front, double radius)
{
  double clear = clearAdjacent(state, front.position, radius, gapOf(state, front));
  for (const CrackFront<D>& other : state.cracks.fronts)
    if (!other.ended && (other.crack != front.crack || other.number != front.number))
      clear = std::min(clear, norm(other.position - front.position));
  return clear;
}

namespace
{

constexpr double smallestOuterCells = 2.0;

} // namespace

ContourRadii usualRadii(const GivenRadii& given, double cell)
{
  ContourRadii radii;
  radii.outer = given.outer > 0.0 ? given.outer : std::max(given.outerCells * cell, 2.0 * given.inner);
  radii.inner = given.inner > 0.0 ? given.inner : std::min(given.innerCells * cell, 0.5 * radii.outer);
  return radii;
}

double smallestOuter(const GivenRadii& given, double cell)
{
  return given.inner > 0.0 ? given.inner + cell : smallestOuterCells * cell;
}

template View<double*> coverOfNodes(const State<2>&, const Vector<2>&, double);
template View<double*> coverOfNodes(const State<3>&, const Vector<3>&, double);
template double clearRadius(const State<2>&, const Vector<2>&, double);
template double clearRadius(const State<3>&, const Vector<3>&, double);
template double largestContour(const State<2>&, const CrackFront<2>&, double);
template double largestContour(const State<3>&, const CrackFront<3>&, double);

} // namespace Rhegma::energy_release
