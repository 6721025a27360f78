/// Normals and gaps of pairs of groups at shared nodes.

#include "base/SmallLoops.hpp"
#include "body_contact/LineThroughDomain.hpp"
#include "body_contact/LogisticNormal.hpp"
#include "body_contact/NearestHulls.hpp"
#include "body_contact/NodalContact.hpp"
#include "transfer/ParticleDomains.hpp"
#include "transfer/PressedNodes.hpp"

namespace Rhegma::body_contact
{

namespace
{

/// The particles of two fields at a shared node, which `one` and `other` are below: their rows.
template <int D>
struct ParticlesOfPair
{
  Grid<D> grid;
  SharedNodes<D> shared;
  ParticleDomains<D> domains;
  BorrowedView<double* [D]> position;

  /// Calls visit(p, label) for the particles of both fields, label -1 for the first and 1 for the second.
  template <class Visit>
  KOKKOS_INLINE_FUNCTION void forEach(int s, int one, int other, const Visit& visit) const
  {
    const int last = shared.firstParticle(s + 1);
    for (int k = shared.firstParticle(s); k < last; ++k)
    {
      const int field = shared.field(k);
      if (field == one || field == other)
        visit(shared.particle(k), field == one ? -1.0 : 1.0);
    }
  }
};

/// A domain around a particle that is smaller than its own, so that those of two bodies which press on each
/// other do not overlap.
constexpr double coreSize = 0.5;

/// Distance of hulls below which they count as overlapping [cells]: rounding of their shortest line.
constexpr double apart = 1e-6;

/// Distance from a node of the lines along which gaps are measured [cells]: a quarter of a domain, so that
/// the mean of two lines is that of the two domains where the node lies between them.
constexpr double fromNode = 0.125;

/// Size of domains that a line meets, so that strain leaves no way between neighbours.
constexpr double closedSize = 1.1;

/// Most by which the gap at a node is larger than the least one within half a cell [cells]: by so much may
/// corners between nodes overlap.
constexpr double mostSlope = 0.1;

template <int D>
struct FindGap
{
  ParticlesOfPair<D> particles;
  NodalPairs<D> pairs;

  KOKKOS_INLINE_FUNCTION void operator()(const int s) const
  {
    for (int q = pairs.first(s); q < pairs.first(s + 1); ++q)
      if (!pairs.springs.join(q))
        find(s, q);
  }

  KOKKOS_INLINE_FUNCTION void find(int s, int q) const
  {
    const int one = pairs.row(q, 0), other = pairs.row(q, 1);
    const Vector<D> node = particles.grid.nodePosition(particles.shared.node(s));
    const Vector<D> first = normalOf(s, one, other, node);
    Separation best{first, dot(first, first) > 0.0 ? gapAlong(s, one, other, node, first) : 1e300};
    if (best.gap <= 0.0)
      separate(s, one, other, node, best);
    if (best.gap <= 0.0 && particles.shared.second(s) >= 0)
      slideAlongFaces(s, one, other, node, best);
    for (int d = 0; d < D; ++d)
      pairs.normal(q, d) = best.normal[d];
    pairs.gap(q) = best.gap;
  }

  /// A direction from the first group to the second, and the gap between them along it [m].
  struct Separation
  {
    Vector<D> normal;
    double gap;
  };

  /// Where corners pass each other, the direction between cores runs across, and along it the domains overlap
  /// before they touch. The hulls of the whole domains are then apart; their distance is the gap.
  KOKKOS_INLINE_FUNCTION void separate(int s, int one, int other, const Vector<D>& node,
                                       Separation& best) const
  {
    const Vector<D> between = shortestBetweenHulls<D>(best.normal, [&](const Vector<D>& v)
                                                      { return nearest(s, one, other, node, v, 1.0); });
    const double distance = norm(between);
    if (distance > apart * particles.grid.spacing)
      best = {(1.0 / distance) * between, distance};
  }

  /// A body that moves in along one face of a crack touches the other face at a corner, and the direction
  /// between cores runs across that corner. Where the gap along the normal of the faces is larger, it slides
  /// along them.
  KOKKOS_INLINE_FUNCTION void slideAlongFaces(int s, int one, int other, const Vector<D>& node,
                                              Separation& best) const
  {
    const int own = particles.shared.node(s), second = particles.shared.second(s);
    if (one != own && one != second && other != own && other != second)
      return;
    const Vector<D> across = normalOf(s, own, second, node);
    for (const double sign : {-1.0, 1.0})
      if (const double gap =
              dot(across, across) > 0.0 ? gapAlong(s, one, other, node, sign * across) : best.gap;
          gap > best.gap)
        best = {sign * across, gap};
  }

  /// Gap between the two groups at a node along a direction [m]. Where faces slope away from each other, as
  /// those of round bodies, the least gap within half a cell is that of half a cell nearer to where they
  /// touch, so that a contact became too wide by a part of a cell. Then the gap is that at the node.
  KOKKOS_INLINE_FUNCTION double gapAlong(int s, int one, int other, const Vector<D>& node,
                                         const Vector<D>& n) const
  {
    const double h = particles.grid.spacing, least = leastGap(s, one, other, node, n);
    if (least > stillClosed * h) // they do not touch
      return least;
    return std::fmax(least, std::fmin(gapAtNode(s, one, other, node, n), least + mostSlope * h));
  }

  /// Mean gap on lines next to the node along n [m]; -1e300 if none meets both groups.
  KOKKOS_INLINE_FUNCTION double gapAtNode(int s, int one, int other, const Vector<D>& node,
                                          const Vector<D>& n) const
  {
    Vector<D> aside[2];
    tangents(n, aside);
    double sum = 0.0;
    int lines = 0;
    for (int line = 0; line < (1 << (D - 1)); ++line)
    {
      Vector<D> start = node;
      for (int d = 0; d < D - 1; ++d)
        start = start + ((line >> d & 1) != 0 ? 1.0 : -1.0) * fromNode * particles.grid.spacing * aside[d];
      const double gap = gapOnLine(s, one, other, start, n);
      if (gap < 1e200)
      {
        sum += gap;
        ++lines;
      }
    }
    return lines > 0 ? sum / lines : -1e300;
  }

  /// Unit vectors normal to n and to each other: one in 2D, two in 3D.
  KOKKOS_INLINE_FUNCTION void tangents(const Vector<D>& n, Vector<D> (&aside)[2]) const
  {
    if constexpr (D == 2)
      aside[0] = {-n[1], n[0]};
    else
    {
      int least = 0;
      for (int d = 1; d < D; ++d)
        least = std::fabs(n[d]) < std::fabs(n[least]) ? d : least;
      Vector<D> axis{};
      axis[least] = 1.0;
      const Vector<D> first = axis - n[least] * n;
      aside[0] = (1.0 / norm(first)) * first;
      for (int d = 0; d < D; ++d)
      {
        const int i = (d + 1) % 3, j = (d + 2) % 3;
        aside[1][d] = n[i] * aside[0][j] - n[j] * aside[0][i];
      }
    }
  }

  /// Gap on a line along n [m]; above 1e200 if it does not meet both groups.
  KOKKOS_INLINE_FUNCTION double gapOnLine(int s, int one, int other, const Vector<D>& start,
                                          const Vector<D>& n) const
  {
    double end = -1e300, begin = 1e300; // of the first group, and of the second
    particles.forEach(s, one, other,
                      [&](int p, double label)
                      {
                        Vector<D> edges[D];
                        particles.domains.edgesOf(p, edges);
                        const PartOfLine part = partOfLine<D>(edges, -1.0 * offset(p, start), n, closedSize);
                        if (!part.any())
                          return;
                        const double at = along(p, label, n, start, 1.0);
                        if (label < 0.0)
                          end = std::fmax(end, std::fmin(at, part.last));
                        else
                          begin = std::fmin(begin, std::fmax(at, part.first));
                      });
    return end > -1e200 && begin < 1e200 ? begin - end : 1e300;
  }

  /// The least gap near a node along a direction [m].
  KOKKOS_INLINE_FUNCTION double leastGap(int s, int one, int other, const Vector<D>& node,
                                         const Vector<D>& n) const
  {
    const double window = windowAround(s, one, other, node, n);
    double end = -1e300, begin = 1e300; // of the first group, and of the second, along the normal
    particles.forEach(s, one, other,
                      [&](int p, double label)
                      {
                        if (distanceFromLine(p, n, node) > window)
                          return;
                        const double at = along(p, label, n, node, 1.0);
                        if (label < 0.0)
                          end = std::fmax(end, at);
                        else
                          begin = std::fmin(begin, at);
                      });
    return begin - end;
  }

  /// Distance of a particle from the line through the node along the normal [m].
  KOKKOS_INLINE_FUNCTION double distanceFromLine(int p, const Vector<D>& n, const Vector<D>& node) const
  {
    const Vector<D> x = offset(p, node);
    return norm(x - dot(x, n) * n);
  }

  /// The gap of a node is that of the particles up to this distance from that line: half a cell, or as far as
  /// there is one of each group. Were it that of all particles at the node, a disk that rolls would press on
  /// the nodes a cell ahead of where it touches.
  KOKKOS_INLINE_FUNCTION double windowAround(int s, int one, int other, const Vector<D>& node,
                                             const Vector<D>& n) const
  {
    double nearest[2] = {1e300, 1e300};
    particles.forEach(s, one, other,
                      [&](int p, double label)
                      {
                        double& least = nearest[label < 0.0 ? 0 : 1];
                        least = std::fmin(least, distanceFromLine(p, n, node));
                      });
    return (1.0 + 1e-6) * std::fmax(0.5 * particles.grid.spacing, std::fmax(nearest[0], nearest[1]));
  }

  KOKKOS_INLINE_FUNCTION Vector<D> offset(int p, const Vector<D>& node) const
  {
    Vector<D> x;
    for (int d = 0; d < D; ++d)
      x[d] = particles.position(p, d) - node[d];
    return x;
  }

  /// Coordinate along a direction of the point of a particle's domain that is nearest to the other group [m].
  /// \param size of the domain, 1: its own
  KOKKOS_INLINE_FUNCTION double along(int p, double label, const Vector<D>& direction, const Vector<D>& node,
                                      double size) const
  {
    Vector<D> edges[D];
    particles.domains.edgesOf(p, edges);
    double reach = 0.0;
    for (int e = 0; e < D; ++e)
      reach += 0.5 * size * std::fabs(dot(edges[e], direction));
    return dot(offset(p, node), direction) - label * reach;
  }

  /// Unit vector from the first group to the second: along the shortest way between the hulls of their cores,
  /// or, where these overlap, across the plane that separates their particles best.
  KOKKOS_INLINE_FUNCTION Vector<D> normalOf(int s, int one, int other, const Vector<D>& node) const
  {
    Vector<D> first{}, second{};
    int numbers[2] = {0, 0};
    particles.forEach(s, one, other,
                      [&](int p, double label)
                      {
                        (label < 0.0 ? first : second) = offset(p, node);
                        ++numbers[label < 0.0 ? 0 : 1];
                      });
    if (numbers[0] == 0 || numbers[1] == 0)
      return Vector<D>{};
    const Vector<D> shortest = shortestBetweenHulls<D>(second - first, [&](const Vector<D>& v)
                                                       { return nearest(s, one, other, node, v, coreSize); });
    const double length = norm(shortest);
    if (length > 1e-3 * particles.grid.spacing)
      return (1.0 / length) * shortest;
    return logisticNormal<D>(
        [&](const auto& visit)
        {
          particles.forEach(s, one, other,
                            [&](int p, double label)
                            { visit(label, particles.grid.inverse * offset(p, node)); });
        });
  }

  /// The vector between points of the two groups' domains whose product with v is smallest. \param size of
  /// the domains, 1: their own
  KOKKOS_INLINE_FUNCTION Vector<D> nearest(int s, int one, int other, const Vector<D>& node,
                                           const Vector<D>& v, double size) const
  {
    double most[2] = {-1e300, -1e300};
    int best[2] = {0, 0};
    particles.forEach(s, one, other,
                      [&](int p, double label)
                      {
                        const int k = label < 0.0 ? 0 : 1;
                        const double at = -label * along(p, label, v, node, size);
                        if (at > most[k])
                        {
                          most[k] = at;
                          best[k] = p;
                        }
                      });
    return corner(best[1], 1.0, v, node, size) - corner(best[0], -1.0, v, node, size);
  }

  KOKKOS_INLINE_FUNCTION Vector<D> corner(int p, double label, const Vector<D>& v, const Vector<D>& node,
                                          double size) const
  {
    Vector<D> edges[D], x = offset(p, node);
    particles.domains.edgesOf(p, edges);
    for (int e = 0; e < D; ++e)
      x = x - (label * 0.5 * size * (dot(edges[e], v) > 0.0 ? 1.0 : -1.0)) * edges[e];
    return x;
  }
};

} // namespace

template <int D>
void findGaps(const State<D>& state, const SharedNodes<D>& shared, const NodalPairs<D>& pairs)
{
  ParticlesOfPair<D> particles;
  particles.grid = state.mesh.grid;
  particles.shared = shared;
  particles.domains = particleDomains(state);
  particles.position = state.particles.template real<D>(fields::position);
  const FindGap<D> find{particles, pairs};
  Kokkos::parallel_for("rhegma::findGaps",
                       Kokkos::RangePolicy<ExecSpace, Kokkos::Schedule<Kokkos::Dynamic>>(0, shared.count),
                       find);
}

template void findGaps(const State<2>&, const SharedNodes<2>&, const NodalPairs<2>&);
template void findGaps(const State<3>&, const SharedNodes<3>&, const NodalPairs<3>&);

} // namespace Rhegma::body_contact
