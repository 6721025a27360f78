#include "energy_release/FacePressureInSpace.hpp"

#include "energy_release/SharedNodes.hpp"
#include "geometry/Cross.hpp"
#include "parallel/Subdomain.hpp"
#include "transfer/FacePoints.hpp"
#include "transfer/LocalSpacing.hpp"
#include "transfer/PushNodes.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::energy_release
{

namespace
{

/// Cells ahead of the front in which nodes may have two fields, pieces into which each is cut, and the parts
/// of a cell's length of front.
constexpr int cells = 2, pieces = 8, partsOfCell = 2;

/// Mean of sqrt(h / r) over the hat of a node, r the distance behind the front: 4/3 for one at the
/// front, 1.37 and 1.33 for one a quarter and half a cell behind it.
constexpr double atNodes = 4.0 / 3.0;

/// A short part of a front.
struct Part
{
  int line;
  double arc, length, pressure, cell;
};

/// Mean pressure on the triangles at each station [Pa].
std::vector<double> pressureAt(const CrackSet<3>& cracks, const FrontLine& line)
{
  const auto pressure = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, cracks.pressure);
  const auto begin = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, cracks.starBegin);
  const auto star = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, cracks.star);
  std::vector<double> mean;
  for (const FrontStation<3>& station : line.stations)
  {
    const int v = station.vertex, first = begin(v), last = begin(v + 1);
    double sum = 0.0;
    for (int k = first; k < last; ++k)
      sum += pressure(star(k));
    mean.push_back(sum / std::max(1, last - first));
  }
  return mean;
}

/// Intensity that is lost at every station [Pa m^0.5].
std::vector<double> lostAlong(const State<3>& state, const CrackFront<3>& front, const FrontLine& line,
                              double halfWidth)
{
  const std::vector<double> pressure = pressureAt(state.cracks, line);
  std::vector<Part> parts;
  std::vector<Vector<3>> places;
  for (const FrontPiece& piece : line.pieces)
  {
    const FrontStation<3>&a = line.stations[piece.from], &b = line.stations[piece.to];
    const double cell = spacingAt(state, a.position);
    const int count = std::max(1, static_cast<int>(std::ceil(partsOfCell * piece.length / cell)));
    for (int i = 0; i < count; ++i)
    {
      const double at = (i + 0.5) / count;
      parts.push_back({line.line[piece.from], line.arc[piece.from] + at * piece.length, piece.length / count,
                       (1.0 - at) * pressure[piece.from] + at * pressure[piece.to], cell});
      const Vector<3> x = (1.0 - at) * a.position + at * b.position,
                      e = (1.0 - at) * a.direction + at * b.direction;
      for (int k = 0; k < cells * pieces; ++k)
        places.push_back(x + ((k + 0.5) * cell / pieces / norm(e)) * e);
    }
  }
  const std::vector<double> split = shareOfNodes(state, front.crack, places, NodesOfFaces::Split);
  const FrontSight sight(line, 0.0);
  std::vector<double> lost(line.stations.size(), 0.0), weights(line.stations.size(), 0.0);
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    const Part& part = parts[p];
    double length = 0.0; // ahead of the front over which the nodes behind it would be pushed
    for (int k = 0; k < cells * pieces; ++k)
      length += split[cells * pieces * p + k] * part.cell / pieces;
    const double intensity =
        std::sqrt(2.0 / std::acos(-1.0)) * part.pressure * length * atNodes / std::sqrt(part.cell);
    for (std::size_t s = 0; s < lost.size(); ++s)
    {
      const double weight = part.length * hatOf(sight, part.line, part.arc, static_cast<int>(s), halfWidth);
      lost[s] += weight * intensity;
      weights[s] += weight;
    }
  }
  for (std::size_t s = 0; s < lost.size(); ++s)
    lost[s] = weights[s] > 0.0 ? lost[s] / weights[s] : 0.0;
  return lost;
}

/// Parts of a triangle's edge into which it is cut.
constexpr int partsOfEdge = 4;

/// Middles of the equal triangles into which a triangle is cut, by weights of its corners.
std::vector<Vector<3>> middles()
{
  std::vector<Vector<3>> all;
  for (int i = 0; i < partsOfEdge; ++i)
    for (int j = 0; i + j < partsOfEdge; ++j)
      for (const double third : {1.0 / 3.0, 2.0 / 3.0})
        if (third < 0.5 || i + j + 1 < partsOfEdge)
        {
          const double a = (i + third) / partsOfEdge, b = (j + third) / partsOfEdge;
          all.push_back({a, b, 1.0 - a - b});
        }
  return all;
}

/// Divergence on the crack's surface of the direction that the front has at its point nearest to x [1/m].
/// Where a front ends at the body's surface or a plane of symmetry there is a direction on one side only.
/// \param sight of a front that goes on beyond its ends by more than `step`
double spread(const FrontSight& sight, const FrontFoot& foot, const Vector<3>& x, double step)
{
  const Vector<3> along = cross(foot.direction, foot.normal);
  const FrontFoot ahead = sight.look(x + step * along), back = sight.look(x - step * along);
  const bool hasAhead = ahead.inside >= 0.0, hasBack = back.inside >= 0.0;
  if (!hasAhead && !hasBack)
    return 0.0;
  const Vector<3> turn =
      (hasAhead ? ahead.direction : foot.direction) - (hasBack ? back.direction : foot.direction);
  return dot(turn, along) / ((hasAhead && hasBack ? 2.0 : 1.0) * step);
}

} // namespace

bool isPressed(const State<3>& state)
{
  return state.step > 0 && state.cracks.pressure.extent(0) > 0 &&
         state.cracks.pressure.extent(0) == state.cracks.simplex.extent(0);
}

void addAccelerationByPressure(const State<3>& state, const NodalAcceleration<3>& acceleration)
{
  if (!isPressed(state))
    return;
  FacePoints<3> points;
  points.update(state);
  const View<double* [3]> force("rhegma::forceOfFacePressure", acceleration.extent(0));
  const View<double*> pressure = state.cracks.pressure;
  const View<int*> simplex = points.simplex();
  const FacePoints<3> p = points;
  forEachPushing(
      "rhegma::forceOfFacePressure", points.count(), KOKKOS_LAMBDA(const int k) {
        const double size = pressure(simplex(k)) * p.currentSize(k);
        for (int d = 0; d < 3; ++d)
        {
          for (int e = 0; e < p.above.count(k); ++e)
            Kokkos::atomic_add(&force(p.above.node(k, e), d), p.above.weight(k, e) * size * p.normal(k, d));
          for (int e = 0; e < p.below.count(k); ++e)
            Kokkos::atomic_add(&force(p.below.node(k, e), d), -p.below.weight(k, e) * size * p.normal(k, d));
        }
      });
  sumOverRanks(state, force.data(), 3, 0, 3);
  const Nodes<3> nodes = state.nodes;
  Kokkos::parallel_for(
      "rhegma::accelerationByFacePressure", Kokkos::RangePolicy<ExecSpace>(0, acceleration.extent(0)),
      KOKKOS_LAMBDA(const int n) {
        const double mass = nodes.sums(n, Nodes<3>::massAt);
        for (int d = 0; d < 3; ++d)
          acceleration(n, d) += mass > 0.0 ? force(n, d) / mass : 0.0;
      });
}

std::vector<double> releaseByPressure(const State<3>& state, int crack, const FrontLine& line,
                                      const FrontTube& tube)
{
  const CrackSet<3>& cracks = state.cracks;
  std::vector<double> release(line.stations.size(), 0.0), width(line.stations.size(), 0.0);
  if (!isPressed(state) || line.empty())
    return release;
  const FrontSight sight(line, 0.0), goingOn(line, tube.radii.outer);
  const auto vertex = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, cracks.vertex);
  const auto face = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, cracks.face);
  const auto simplex = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, cracks.simplex);
  const auto pressure = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, cracks.pressure);
  const std::vector<Vector<3>> parts = middles();
  const double step = 0.25 * (tube.radii.outer - tube.radii.inner);
  const Crack<3>& own = cracks.cracks[crack];
  for (int s = own.firstSimplex; s < own.firstSimplex + own.numSimplices; ++s)
  {
    Vector<3> corner[3], opening[3];
    for (int i = 0; i < 3; ++i)
      for (int d = 0; d < 3; ++d)
      {
        corner[i][d] = vertex(simplex(s, i), d);
        opening[i][d] = face(simplex(s, i), 1, d) - face(simplex(s, i), 0, d);
      }
    double nearest = 1e300;
    Vector<3> square; // of the opening along the normal, with its sign
    for (int i = 0; i < 3; ++i)
    {
      const FrontFoot foot = sight.look(corner[i]);
      nearest = std::min(nearest, foot.distance);
      const double open = dot(opening[i], foot.normal);
      square[i] = open * std::fabs(open);
    }
    if (nearest >= tube.radii.outer)
      continue;
    const double area =
        0.5 * norm(cross(corner[1] - corner[0], corner[2] - corner[0])) / double(parts.size());
    for (const Vector<3>& w : parts)
    {
      const Vector<3> x = w[0] * corner[0] + w[1] * corner[1] + w[2] * corner[2];
      const FrontFoot foot = sight.look(x);
      if (foot.distance >= tube.radii.outer)
        continue;
      const double fall = 1.0 / (tube.radii.outer - tube.radii.inner);
      const double ramp = std::min(1.0, fall * (tube.radii.outer - foot.distance));
      // Near a front the opening is no line but a root, and that of an ellipse is nowhere one: its square is
      // smooth, so that is interpolated.
      const double mean = dot(w, square), open = std::copysign(std::sqrt(std::fabs(mean)), mean);
      const double work =
          area * pressure(s) * open * ((ramp < 1.0 ? fall : 0.0) + ramp * spread(goingOn, foot, x, step));
      for (std::size_t k = 0; k < release.size(); ++k)
        release[k] += work * hatOf(sight, foot.line, foot.arc, static_cast<int>(k), tube.halfWidth);
    }
  }
  for (const FrontPiece& piece : line.pieces)
    for (int i = 0; i < pieces; ++i)
    {
      const double arc = line.arc[piece.from] + (i + 0.5) / pieces * piece.length;
      for (std::size_t k = 0; k < width.size(); ++k)
        width[k] += piece.length / pieces *
                    hatOf(sight, line.line[piece.from], arc, static_cast<int>(k), tube.halfWidth);
    }
  for (std::size_t k = 0; k < release.size(); ++k)
    release[k] = width[k] > 0.0 ? release[k] / width[k] : 0.0;
  return release;
}

void addLostPressure(const State<3>& state, const CrackFront<3>& front, const FrontLine& line,
                     const FrontTube& tube, const Elasticity& e, const std::vector<Intensities>& openings,
                     std::vector<double>& J)
{
  if (!isPressed(state) || line.empty())
    return;
  const std::vector<double> lost = lostAlong(state, front, line, tube.halfWidth);
  for (std::size_t s = 0; s < J.size(); ++s)
  {
    const double modeI = scaleTo(openings[s], J[s], e).modeI;
    J[s] += lost[s] * (2.0 * modeI + lost[s]) / e.effectiveModulus;
  }
}

} // namespace Rhegma::energy_release
