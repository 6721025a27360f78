#include "body_contact/InterfacePoints.hpp"

#include "archive/Archive.hpp"
#include "base/SmallLoops.hpp"

namespace Rhegma::body_contact
{

namespace
{

/// Gives the nodes' pairs room for springs, and clears them.
template <int D>
void clearSprings(const NodalPairs<D>& pairs, NodalSprings<D>& springs)
{
  if (springs.joins.extent(0) < pairs.gap.extent(0))
  {
    const std::size_t most = pairs.gap.extent(0);
    springs.joins = View<int*>("rhegma::pairsOfInterfaces", most);
    springs.force = View<double* [D]>("rhegma::forcesOfInterfaces", most);
    springs.normal = View<double* [D]>("rhegma::normalsOfInterfaces", most);
    springs.stiffness = View<double* [D][D]>("rhegma::stiffnessOfInterfaces", most);
    return;
  }
  Kokkos::deep_copy(springs.joins, 0);
  Kokkos::deep_copy(springs.force, 0.0);
  Kokkos::deep_copy(springs.normal, 0.0);
  Kokkos::deep_copy(springs.stiffness, 0.0);
}

/// Number of a pair of groups at a node, or -1.
template <int D>
KOKKOS_INLINE_FUNCTION int pairAt(const SharedNodes<D>& shared, const NodalPairs<D>& pairs, int node, int one,
                                  int other)
{
  const int s = shared.indexOf(node);
  for (int q = s < 0 ? 0 : pairs.first(s); s >= 0 && q < pairs.first(s + 1); ++q)
    if (pairs.group(q, 0) == one && pairs.group(q, 1) == other)
      return q;
  return -1;
}

/// Makes the stencil of a point and adds its springs to the nodes.
template <int D>
struct SumSprings
{
  Grid<D> grid;
  SharedNodes<D> shared;
  NodalPairs<D> pairs;
  InterfacePoints<D> points;

  KOKKOS_INLINE_FUNCTION void operator()(const int k) const
  {
    if (points.released(k) != 0)
      return;
    Vector<D> x, n, jump;
    for (int d = 0; d < D; ++d)
    {
      x[d] = points.position(k, d);
      n[d] = points.normal(k, d);
      jump[d] = points.jump(k, d);
    }
    points.table.count(k) = 0;
    if (grid.inside(x))
      connect(k, x);
    if (points.table.count(k) == 0)
    {
      points.released(k) = 1;
      return;
    }
    markAround(k, x);
    const double across = dot(jump, n), normal = points.stiffness(k, 0), along = points.stiffness(k, 1);
    for (int e = 0; e < points.table.count(k); ++e)
    {
      const int q = points.table.node(k, e);
      const double area = points.table.weight(k, e) * points.area(k);
      for (int i = 0; i < D; ++i)
      {
        Kokkos::atomic_add(&pairs.springs.force(q, i),
                           area * (along * jump[i] + (normal - along) * across * n[i]));
        Kokkos::atomic_add(&pairs.springs.normal(q, i), area * n[i]);
        for (int j = 0; j < D; ++j)
          Kokkos::atomic_add(&pairs.springs.stiffness(q, i, j),
                             area * ((i == j ? along : 0.0) + (normal - along) * n[i] * n[j]));
      }
    }
  }

  /// Writes the stencil: of the nodes of the cell those that both groups touch, renormalised.
  KOKKOS_INLINE_FUNCTION void connect(int k, const Vector<D>& x) const
  {
    const StencilTable<D>& table = points.table;
    writeStencil<D, ShapeKind::Linear>(grid, table, k, x, Vector<D>{});
    int kept = 0;
    double sum = 0.0;
    for (int e = 0; e < table.count(k); ++e)
    {
      const int q = pairAt(shared, pairs, table.node(k, e), points.group(k, 0), points.group(k, 1));
      const double weight = table.weight(k, e);
      if (q < 0 || !(weight > 0.0))
        continue;
      table.node(k, kept) = q;
      table.weight(k, kept) = weight;
      for (int d = 0; d < D; ++d)
        table.slope(k, kept, d) = table.slope(k, e, d);
      sum += weight;
      ++kept;
    }
    table.count(k) = kept;
    for (int e = 0; e < kept; ++e)
      table.weight(k, e) /= sum;
  }

  /// Nodes of the cells around are next to the interface: where bodies that it joins overlap, they are not in
  /// contact.
  KOKKOS_INLINE_FUNCTION void markAround(int k, const Vector<D>& x) const
  {
    int from[D], all = 1;
    for (int d = 0; d < D; ++d, all *= 4)
      from[d] = static_cast<int>(grid.inCells(x[d], d)) - 1;
    for (int e = 0; e < all; ++e)
    {
      int at[D];
      for (int d = 0, rest = e; d < D; ++d, rest /= 4)
        at[d] = from[d] + rest % 4;
      const int q = pairAt(shared, pairs, grid.nodeIndex(at), points.group(k, 0), points.group(k, 1));
      if (q >= 0)
        pairs.springs.joins(q) = 1;
    }
  }
};

/// Velocities around a point, of the stencil of its nodes.
template <int D>
struct MotionAtPoint
{
  Vector<D> mean{}, jump{};   ///< of the two groups, and of the second relative to the first [m/s]
  double gradient[D][D] = {}; ///< of the mean, derivative along j of component i at [i][j] [1/s]

  KOKKOS_INLINE_FUNCTION MotionAtPoint(const Nodes<D>& nodes, const NodalPairs<D>& pairs,
                                       const StencilTable<D>& table, int k)
  {
    for (int pass = 0; pass < 2; ++pass)
      for (int e = 0; e < table.count(k); ++e)
      {
        const int q = table.node(k, e), a = pairs.row(q, 0), b = pairs.row(q, 1);
        for (int d = 0; d < D; ++d)
        {
          const double one = nodes.projection(a, d), other = nodes.projection(b, d),
                       both = 0.5 * (one + other);
          if (pass == 0)
          {
            mean[d] += table.weight(k, e) * both;
            jump[d] += table.weight(k, e) * (other - one);
          }
          // Less the mean: slopes of some of a cell's nodes do not cancel for a uniform motion.
          for (int j = 0; j < D && pass == 1; ++j)
            gradient[d][j] += table.slope(k, e, j) * (both - mean[d]);
        }
      }
  }
};

/// Turns a vector with the faces. \param n their normal, turned as well
KOKKOS_INLINE_FUNCTION void turn(const double (&g)[2][2], double dt, Vector<2>& n, Vector<2>& jump)
{
  // The faces' tangent t turns by n . g t.
  const Vector<2> t{n[1], -n[0]};
  double rate = 0.0;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      rate += n[i] * g[i][j] * t[j];
  // From t towards n is counter-clockwise if t is n turned clockwise.
  const double c = std::cos(rate * dt), s = std::sin(rate * dt);
  n = {c * n[0] - s * n[1], s * n[0] + c * n[1]};
  jump = {c * jump[0] - s * jump[1], s * jump[0] + c * jump[1]};
}

KOKKOS_INLINE_FUNCTION void turn(const double (&g)[3][3], double dt, Vector<3>& n, Vector<3>& jump)
{
  // Of tangents t the part n . g t, as a rotation about an axis in the faces; about n the spin of the motion.
  Vector<3> change{}, axis{};
  double along = 0.0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      change[j] -= n[i] * g[i][j];
  along = dot(change, n);
  change = change - along * n;
  const Vector<3> spin{0.5 * (g[2][1] - g[1][2]), 0.5 * (g[0][2] - g[2][0]), 0.5 * (g[1][0] - g[0][1])};
  const Vector<3> across{n[1] * change[2] - n[2] * change[1], n[2] * change[0] - n[0] * change[2],
                         n[0] * change[1] - n[1] * change[0]};
  axis = dt * (across + dot(spin, n) * n);
  const double angle = norm(axis);
  if (!(angle > 0.0))
    return;
  const Vector<3> e = (1.0 / angle) * axis;
  const double c = std::cos(angle), s = std::sin(angle);
  for (Vector<3>* const v : {&n, &jump})
  {
    const Vector<3> cross{e[1] * (*v)[2] - e[2] * (*v)[1], e[2] * (*v)[0] - e[0] * (*v)[2],
                          e[0] * (*v)[1] - e[1] * (*v)[0]};
    *v = c * *v + s * cross + ((1.0 - c) * dot(e, *v)) * e;
  }
}

} // namespace

template <int D>
void sumSprings(const State<D>& state, const SharedNodes<D>& shared, NodalPairs<D>& pairs,
                const InterfacePoints<D>& points)
{
  clearSprings(pairs, pairs.springs);
  const SumSprings<D> sum{state.mesh.grid, shared, pairs, points};
  parallelForSmall("rhegma::sumInterfaceSprings", points.count, sum);
}

template <int D>
void releaseInterfaces(const InterfacePoints<D>& points)
{
  if (points.count > 0)
    Kokkos::deep_copy(points.released, 1);
}

template <int D>
void moveInterfaces(const State<D>& state, const NodalPairs<D>& pairs, const InterfacePoints<D>& points)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const InterfacePoints<D> at = points;
  const double dt = state.clock.dt;
  parallelForSmall(
      "rhegma::moveInterfaces", points.count, KOKKOS_LAMBDA(const int k) {
        if (at.released(k) != 0)
          return;
        const MotionAtPoint<D> motion(nodes, pairs, at.table, k);
        Vector<D> n, jump;
        for (int d = 0; d < D; ++d)
        {
          at.position(k, d) += dt * motion.mean[d];
          n[d] = at.normal(k, d);
          jump[d] = at.jump(k, d) + dt * motion.jump[d];
        }
        turn(motion.gradient, dt, n, jump);
        for (int d = 0; d < D; ++d)
        {
          at.normal(k, d) = n[d];
          at.jump(k, d) = jump[d];
        }
      });
}

template <int D>
double energyOfInterfaces(const InterfacePoints<D>& points, int one, int other)
{
  const InterfacePoints<D> at = points;
  return parallelSumSmall<double>(
      "rhegma::energyOfInterfaces", points.count, KOKKOS_LAMBDA(const int k, double& sum) {
        if (at.released(k) != 0 || (one >= 0 && (at.group(k, 0) != one || at.group(k, 1) != other)))
          return;
        double across = 0.0, square = 0.0;
        for (int d = 0; d < D; ++d)
        {
          across += at.jump(k, d) * at.normal(k, d);
          square += at.jump(k, d) * at.jump(k, d);
        }
        sum += 0.5 * at.area(k) *
               (at.stiffness(k, 1) * square + (at.stiffness(k, 0) - at.stiffness(k, 1)) * across * across);
      });
}

template <int D>
void serialize(InterfacePoints<D>& points, Archive& archive)
{
  archive("position", points.position);
  archive("normal", points.normal);
  archive("jump", points.jump);
  archive("released", points.released);
}

template void sumSprings(const State<2>&, const SharedNodes<2>&, NodalPairs<2>&, const InterfacePoints<2>&);
template void sumSprings(const State<3>&, const SharedNodes<3>&, NodalPairs<3>&, const InterfacePoints<3>&);
template void releaseInterfaces(const InterfacePoints<2>&);
template void releaseInterfaces(const InterfacePoints<3>&);
template void moveInterfaces(const State<2>&, const NodalPairs<2>&, const InterfacePoints<2>&);
template void moveInterfaces(const State<3>&, const NodalPairs<3>&, const InterfacePoints<3>&);
template double energyOfInterfaces(const InterfacePoints<2>&, int, int);
template double energyOfInterfaces(const InterfacePoints<3>&, int, int);
template void serialize(InterfacePoints<2>&, Archive&);
template void serialize(InterfacePoints<3>&, Archive&);

} // namespace Rhegma::body_contact
