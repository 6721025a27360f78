#include "energy_release/Contour.hpp"

#include "state/BodyGroup.hpp"
#include "state/Subdomain.hpp"
#include "transfer/LocalSpacing.hpp"
#include "transfer/PushNodes.hpp"

#include <algorithm>
#include <limits>
#include <type_traits>

namespace Rhegma::energy_release
{

namespace
{

/// Adds to a sum that forEachPushing visits: on a host one after the other.
KOKKOS_INLINE_FUNCTION void addTo(double& sum, double more)
{
  if constexpr (std::is_same_v<ExecSpace, Kokkos::DefaultHostExecutionSpace>)
    sum += more;
  else
    Kokkos::atomic_add(&sum, more);
}

/// Adds the particles' volume to the nodes, without regard to cracks: calls add(node, volume).
template <int D, class Add>
void sumVolume(const State<D>& state, int crack, const Vector<D>& centre, double radius, const Add& add)
{
  const ParticlesOfGroup own = particlesOfCrack(state, crack);
  const TreeSight<D> sight(state.mesh.grid, state.mesh.tree);
  const auto position = state.particles.template real<D>(fields::position);
  const auto initial = state.particles.scalar(fields::volume);
  const bool boxes = state.method.shape == ShapeKind::Gimp;
  BorrowedView<double* [D]> box;
  if (boxes)
    box = state.particles.template real<D>(fields::box);
  BlocksInReach<D> blocks;
  blocks.find(state, {boxAround(centre, radius)});
  const View<int* [2]> range = blocks.ranges();
  // In a fixed order, so that the result does not depend on the number of threads.
  forEachPushing(
      "rhegma::contourVolume", blocks.count(), KOKKOS_LAMBDA(const int b) {
        for (int p = range(b, 0); p < range(b, 1); ++p)
        {
          Vector<D> x, half;
          for (int d = 0; d < D; ++d)
          {
            x[d] = position(p, d);
            half[d] = boxes ? box(p, d) : 0.0;
          }
          if (own.hold(p) && dot(x - centre, x - centre) < radius * radius)
            sight.forEachNode(x, half,
                              [&](int node, double weight, const double(&)[D])
                              { add(node, weight * initial(p)); });
        }
      });
}

/// The volume of particles at the nodes of a box, of all ranks [m3].
template <int D>
View<double*> volumeOfNodes(const State<D>& state, int crack, const Vector<D>& centre, double radius,
                            const BoxNodes<D>& box)
{
  View<double*> volume("rhegma::volumeOfNodes", box.count());
  if (!state.mesh.subdomain)
  {
    sumVolume(
        state, crack, centre, radius, KOKKOS_LAMBDA(const int node, const double more) {
          if (const int k = box.find(node); k >= 0)
            addTo(volume(k), more);
        });
    return volume;
  }
  const View<double*> all("rhegma::volumeOfAllNodes", state.mesh.grid.numNodes + state.mesh.tree.numFine);
  sumVolume(
      state, crack, centre, radius,
      KOKKOS_LAMBDA(const int node, const double more) { addTo(all(node), more); });
  sumOverRanks(state, all);
  Kokkos::parallel_for(
      "rhegma::volumeOfNodes", Kokkos::RangePolicy<ExecSpace>(0, box.count()),
      KOKKOS_LAMBDA(const int k) { volume(k) = all(box.node(k)); });
  return volume;
}

/// The gap between the faces of a front's crack, which a contour may contain, unlike other surfaces.
class Gap
{
public:
  Gap(const State<2>& state, const CrackFront<2>& front)
  {
    if (state.cracks.face.extent(0) == 0)
      return;
    const Crack<2>& crack = state.cracks.cracks[front.crack];
    face_ = state.cracks.face;
    simplex_ = state.cracks.simplex;
    first_ = crack.firstSimplex;
    end_ = crack.firstSimplex + crack.numSimplices;
    margin_ = 1.5 * spacingAt(state, front.position); // nodes reach that far
  }

  KOKKOS_INLINE_FUNCTION bool holds(const Vector<2>& x) const
  {
    for (int s = first_; s < end_; ++s)
    {
      const int v = simplex_(s, 0), w = simplex_(s, 1);
      Vector<2> a, along, halfAtA, halfAtB;
      for (int d = 0; d < 2; ++d)
      {
        a[d] = 0.5 * (face_(v, 0, d) + face_(v, 1, d));
        along[d] = 0.5 * (face_(w, 0, d) + face_(w, 1, d)) - a[d];
        halfAtA[d] = 0.5 * (face_(v, 1, d) - face_(v, 0, d));
        halfAtB[d] = 0.5 * (face_(w, 1, d) - face_(w, 0, d));
      }
      const double square = dot(along, along);
      double at = square > 0.0 ? dot(x - a, along) / square : 0.0;
      at = at < 0.0 ? 0.0 : (at > 1.0 ? 1.0 : at);
      if (norm(x - a - at * along) < (1.0 - at) * norm(halfAtA) + at * norm(halfAtB) + margin_)
        return true;
    }
    return false;
  }

private:
  View<double* [2][2]> face_;
  View<int* [2]> simplex_;
  int first_ = 0, end_ = 0; ///< simplices
  double margin_ = 0.0;     ///< how far beyond the faces nodes are partly empty because of the gap [m]
};

/// Distance from a front to the other end of its crack, where this crack meets the surface of the body or has
/// another front [m]. On the surface the weight must be zero: its normal is not that of the faces.
double distanceToOtherEnd(const State<2>& state, const CrackFront<2>& front)
{
  if (state.cracks.vertex.extent(0) == 0) // a front by itself
    return std::numeric_limits<double>::infinity();
  const Crack<2>& crack = state.cracks.cracks[front.crack];
  const auto vertex = onHost(state.cracks.vertex);
  double furthest = 0.0;
  // Vertices of a crack follow each other.
  for (const int v : {crack.firstVertex, crack.firstVertex + crack.numVertices - 1})
    furthest = std::max(furthest, norm(Vector<2>{{vertex(v, 0), vertex(v, 1)}} - front.position));
  return furthest;
}

constexpr double smallestOuterCells = 2.0;

} // namespace

template <int D>
NodeCover<D> coverOfNodes(const State<D>& state, const Vector<D>& centre, double radius, int crack)
{
  const BoxNodes<D> box(state, boxAround(centre, radius));
  const View<double*> cover =
      volumeOfNodes(state, crack, centre, radius + 3.0 * state.mesh.grid.spacing, box);
  double cell = 1.0;
  for (int d = 0; d < D; ++d)
    cell *= state.mesh.grid.spacing;
  const Depth depth = state.method.depth();
  const double onAxis = 0.25 * state.mesh.grid.spacing; // mean radius of the part of a node there
  const bool refined = state.mesh.tree.refined();
  const View<double*> nodeFraction = state.mesh.tree.nodeVolume;
  Kokkos::parallel_for(
      "rhegma::coverOfNodes", Kokkos::RangePolicy<ExecSpace>(0, box.count()), KOKKOS_LAMBDA(const int k) {
        double whole = cell * (refined ? nodeFraction(box.node(k)) : 1.0);
        if constexpr (D == 2)
        {
          const double x = box.position(k)[0];
          whole *= depth.around && x < onAxis ? 0.5 * depth.at(onAxis) : depth.at(x);
        }
        cover(k) /= whole;
      });
  return {box, cover, state.mesh.nodes};
}

double largestContour(const State<2>& state, const CrackFront<2>& front, double radius)
{
  const NodeCover<2> cover = coverOfNodes(state, front.position, radius, front.crack);
  const Gap gap(state, front);
  const Vector<2> centre = front.position;
  double nearest = radius;
  Kokkos::parallel_reduce(
      "rhegma::largestContour", Kokkos::RangePolicy<ExecSpace>(0, cover.box.count()),
      KOKKOS_LAMBDA(const int k, double& smallest) {
        const Vector<2> x = cover.box.position(k);
        const double r = norm(x - centre);
        if (r < smallest && cover.isOpen(k) && !gap.holds(x))
          smallest = r;
      },
      Kokkos::Min<double>(nearest));
  double closeness = -nearest;
  maxParts(state, &closeness, 1);
  double clear = std::min({-closeness, radius, distanceToOtherEnd(state, front)});
  for (const CrackFront<2>& other : state.cracks.fronts)
    if (!other.ended && (other.crack != front.crack || other.number != front.number))
      clear = std::min(clear, norm(other.position - front.position));
  return clear;
}

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

template NodeCover<2> coverOfNodes(const State<2>&, const Vector<2>&, double, int);
template NodeCover<3> coverOfNodes(const State<3>&, const Vector<3>&, double, int);

} // namespace Rhegma::energy_release
