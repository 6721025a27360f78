#include "energy_release/FrontIntegral.hpp"

#include "energy_release/FacePressureInSpace.hpp"
#include "energy_release/ParticleHeat.hpp"
#include "energy_release/ParticleMotion.hpp"
#include "material/Materials.hpp"
#include "parallel/Subdomain.hpp"
#include "transfer/LocalSpacing.hpp"
#include "transfer/ParticleViews.hpp"
#include "transfer/Stencils.hpp"

#include <algorithm>

namespace Rhegma::energy_release
{

namespace
{

constexpr int D = 3;

/// What the tube does as a whole.
struct MeanMotion
{
  double turn[D][D] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  Vector<D> velocity{{0.0, 0.0, 0.0}}; ///< [m/s]
};

Region<D> regionAround(const FrontLine& line, double reach)
{
  Region<D> box{line.stations[0].position, line.stations[0].position};
  for (const FrontStation<D>& s : line.stations)
    for (int d = 0; d < D; ++d)
    {
      box.lower[d] = std::min(box.lower[d], s.position[d]);
      box.upper[d] = std::max(box.upper[d], s.position[d]);
    }
  for (int d = 0; d < D; ++d)
  {
    box.lower[d] -= reach;
    box.upper[d] += reach;
  }
  return box;
}

/// The rotation of a polar decomposition: the mean of a matrix and its inverse transposed, over and over
/// (Higham, SIAM J. Sci. Stat. Comput. 7 (1986) 1160).
void nearestRotation(double (&a)[D][D])
{
  for (int turns = 0; turns < 30; ++turns)
  {
    double cofactor[D][D], change = 0.0;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
      {
        const int k = (i + 1) % D, l = (i + 2) % D, m = (j + 1) % D, n = (j + 2) % D;
        cofactor[i][j] = a[k][m] * a[l][n] - a[k][n] * a[l][m];
      }
    const double determinant = a[0][0] * cofactor[0][0] + a[0][1] * cofactor[0][1] + a[0][2] * cofactor[0][2];
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
      {
        const double next = 0.5 * (a[i][j] + cofactor[i][j] / determinant);
        change = std::max(change, std::fabs(next - a[i][j]));
        a[i][j] = next;
      }
    if (change < 1e-15)
      return;
  }
}

MeanMotion meanMotion(const State<D>& state, const Region<D>& box)
{
  const auto position = state.particles.real<D>(fields::position);
  const auto velocity = state.particles.real<D>(fields::velocity);
  const auto F = state.particles.real<gradientSize<D>>(fields::deformation);
  MeanMotion mean;
  for (int i = 0; i < D; ++i)
  {
    double sums[D + 2] = {}; // of a row of the gradient, of the velocity's component, number
    Kokkos::parallel_reduce(
        "rhegma::meanMotionOfFront", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
        KOKKOS_LAMBDA(const int p, double& x, double& y, double& z, double& v, double& number) {
          if (!box.holds({position(p, 0), position(p, 1), position(p, 2)}))
            return;
          x += F(p, D * i);
          y += F(p, D * i + 1);
          z += F(p, D * i + 2);
          v += velocity(p, i);
          number += 1.0;
        },
        sums[0], sums[1], sums[2], sums[3], sums[4]);
    sumParts(state, sums, D + 2);
    const double count = sums[D + 1];
    if (count == 0.0)
      return {};
    mean.velocity[i] = sums[D] / count;
    for (int j = 0; j < D; ++j)
      mean.turn[i][j] = sums[j] / count;
  }
  nearestRotation(mean.turn);
  return mean;
}

/// Adds the configurational forces of a block of particles to the nodes.
template <class Connect>
struct ForceBlock
{
  Connect connect;
  Region<D> box;
  MeanMotion mean;
  View<double* [D]> force;
  NodalVelocity<D> motion;
  NodalAcceleration<D> acceleration;
  BorrowedView<double* [D]> position;
  BorrowedView<double*> mass, volume;
  BorrowedView<double * [gradientSize<D>]> deformation;
  BorrowedView<double * [symmetricSize<D>]> stress;
  BorrowedView<double**> history;
  BorrowedView<int*> material;
  View<Properties*> materials;
  ParticleHeat<D> heat;
  bool moving;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    for (int p = begin; p < end; ++p)
      if (box.holds({position(p, 0), position(p, 1), position(p, 2)}))
        add(p);
  }

  KOKKOS_INLINE_FUNCTION void add(int p) const
  {
    ParticleMotion<D> is;
    if (moving)
      is = particleMotion(connect, p, motion, acceleration, mean.velocity);
    const Vector<D>&v = is.v, &a = is.a;
    const auto& dv = is.dv;
    const double* F = &deformation(p, 0);
    const double* tau = &stress(p, 0);
    const double density = mass(p) / volume(p);
    const double* own = history.extent(1) > 0 ? &history(p, 0) : nullptr;
    const Properties& law = materials(material(p));
    const double energy = heat.energy(p, material(p), law, F, own) + 0.5 * density * dot(v, v);
    // The image of each axis of the turned tube, and u,k relative to it.
    double image[D][D], du[D][D];
    for (int i = 0; i < D; ++i)
      for (int k = 0; k < D; ++k)
      {
        image[i][k] = 0.0;
        for (int j = 0; j < D; ++j)
          image[i][k] += F[D * i + j] * mean.turn[k][j];
        du[i][k] = image[i][k] - (i == k ? 1.0 : 0.0);
      }
    double flux[D][D],
        inertia[D]; // of a shift along axis k: (k, slope's axis), and what goes with the weight itself
    for (int k = 0; k < D; ++k)
    {
      inertia[k] = 0.0;
      for (int j = 0; j < D; ++j)
      {
        flux[k][j] = -energy * image[j][k];
        double dvk = 0.0; // of velocity's component j along the image of the axis
        for (int i = 0; i < D; ++i)
        {
          flux[k][j] += tau[symmetricIndex<D>(i, j)] * du[i][k];
          dvk += dv[j][i] * image[i][k];
        }
        inertia[k] += density * (a[j] * du[j][k] - v[j] * dvk);
      }
      const Vector<D> along{image[0][k], image[1][k], image[2][k]};
      inertia[k] -= heat.energyAlong(p, material(p), law, F, tau, own, along);
    }
    const double V = volume(p);
    connect.visit(p,
                  [&](int node, double share, const double* slope)
                  {
                    for (int k = 0; k < D; ++k)
                      force(node, k) += V * (flux[k][0] * slope[0] + flux[k][1] * slope[1] +
                                             flux[k][2] * slope[2] + inertia[k] * share);
                  });
  }
};

View<double* [D]> configurationalForces(const State<D>& state, const Region<D>& box,
                                        const NodalAcceleration<D>& acceleration)
{
  View<double* [D]> force("rhegma::configurationalForce", state.nodes.sums.extent(0));
  const MeanMotion mean = meanMotion(state, box);
  withConnectivity(state,
                   [&](const auto& connect)
                   {
                     using Connect = std::decay_t<decltype(connect)>;
                     ForceBlock<Connect> block{connect,
                                               box,
                                               mean,
                                               force,
                                               NodalVelocity<D>(state),
                                               acceleration,
                                               state.particles.real<D>(fields::position),
                                               state.particles.scalar(fields::mass),
                                               state.particles.scalar(fields::volume),
                                               state.particles.real<gradientSize<D>>(fields::deformation),
                                               state.particles.real<symmetricSize<D>>(fields::stress),
                                               {},
                                               state.particles.integer(fields::material),
                                               state.materials,
                                               ParticleHeat<D>(state),
                                               state.step > 0}; // nodes are empty before the first step
                     if (state.particles.has(fields::history))
                       block.history = state.particles.table(fields::history);
                     forEachBlock("rhegma::configurationalForce", state.blocks, block);
                   });
  return force;
}

/// A node in the tube.
struct TubeNode
{
  double ramp;
  int line;
  double arc;
  double along; ///< its direction times its configurational force, both fields [N]
  Vector<D> direction;
};

/// The nodes in the tube on this rank.
struct TubeNodes
{
  std::vector<TubeNode> nodes;
  View<int*> number; ///< of each row of the lattice and of refined cells, in `nodes`, or -1
};

TubeNodes findNodes(const State<D>& state, const FrontSight& sight, const ContourRadii& radii,
                    const Region<D>& box, const View<double* [D]>& force)
{
  const Nodes<D> nodes = state.nodes;
  const NodePlaces<D> places = nodePlaces(state);
  const int candidates = static_cast<int>(nodes.active.extent(0));
  TubeNodes found;
  found.number = View<int*>("rhegma::tubeNode", nodes.numLattice);
  Kokkos::deep_copy(found.number, -1);
  const View<int*> number = found.number;
  const auto isNear = KOKKOS_LAMBDA(const int n, FrontFoot& foot)
  {
    const Vector<D> x = places(n);
    if (!box.holds(x))
      return false;
    foot = sight.look(x);
    return foot.distance < radii.outer;
  };
  int count = 0;
  Kokkos::parallel_scan(
      "rhegma::tubeNodes", Kokkos::RangePolicy<ExecSpace>(0, candidates),
      KOKKOS_LAMBDA(const int i, int& at, const bool final) {
        FrontFoot foot;
        if (!isNear(nodes.active(i), foot))
          return;
        if (final)
          number(nodes.active(i)) = at;
        ++at;
      },
      count);
  const View<double* [7]> values("rhegma::tubeNodes", count);
  const int rows = candidates + nodes.numSecond;
  // Both fields of a node, one after the other.
  for (const bool second : {false, true})
    Kokkos::parallel_for(
        "rhegma::tubeForces",
        Kokkos::RangePolicy<ExecSpace>(second ? candidates : 0, second ? rows : candidates),
        KOKKOS_LAMBDA(const int i) {
          const int row = activeNode(nodes, i), k = number(latticeNode(nodes, row));
          if (k < 0)
            return;
          const FrontFoot foot = sight.look(places(latticeNode(nodes, row)));
          const double ramp = (radii.outer - foot.distance) / (radii.outer - radii.inner);
          values(k, 0) = ramp > 1.0 ? 1.0 : ramp;
          values(k, 1) = foot.arc;
          for (int d = 0; d < D; ++d)
          {
            values(k, 2) += foot.direction[d] * force(row, d);
            values(k, 3 + d) = foot.direction[d];
          }
          values(k, 6) = foot.line;
        });
  const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, values);
  for (int k = 0; k < count; ++k)
    found.nodes.push_back({host(k, 0),
                           static_cast<int>(host(k, 6)),
                           host(k, 1),
                           host(k, 2),
                           {host(k, 3), host(k, 4), host(k, 5)}});
  return found;
}

/// Parts into which a cell's length of front is cut to integrate along it.
constexpr int partsOfCell = 8;

/// Adds to each station's sum the integral along the front of its weight as the cells interpolate it [m].
void addWidths(const State<D>& state, const FrontLine& line, const FrontSight& sight, const FrontTube& tube,
               const TubeNodes& tubeNodes, std::vector<double>& width)
{
  struct Part
  {
    Vector<D> place, direction;
    double length;
  };
  std::vector<Part> parts;
  for (const FrontPiece& piece : line.pieces)
  {
    const FrontStation<D>&a = line.stations[piece.from], &b = line.stations[piece.to];
    const Vector<D> along = b.position - a.position;
    const int count =
        std::max(1, static_cast<int>(std::ceil(partsOfCell * piece.length / spacingAt(state, a.position))));
    for (int i = 0; i < count; ++i)
    {
      const double at = (i + 0.5) / count;
      const Vector<D> e = (1.0 - at) * a.direction + at * b.direction;
      parts.push_back({a.position + at * along, (1.0 / norm(e)) * e, piece.length / count});
    }
  }
  ObservedPoints<D> points;
  points.onAllRanks = true;
  points.count = static_cast<int>(parts.size());
  points.position = View<double* [D]>("rhegma::frontPartPosition", points.count);
  points.half = View<double* [D]>("rhegma::frontPartHalf", points.count);
  points.side = View<int*>("rhegma::frontPartSide", points.count); // away from cracks: unbroken
  const auto position = Kokkos::create_mirror_view(points.position);
  for (int k = 0; k < points.count; ++k)
    for (int d = 0; d < D; ++d)
      position(k, d) = parts[k].place[d];
  Kokkos::deep_copy(points.position, position);
  StencilTable<D> table;
  pointStencils(state, points, table, false);
  const auto count = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, table.count);
  const auto node = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, table.node);
  const auto weight = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, table.weight);
  const auto number = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, tubeNodes.number);
  for (int k = 0; k < points.count; ++k)
    for (int i = 0; i < count(k); ++i)
    {
      const int own = number(node(k, i));
      if (own < 0)
        continue;
      const TubeNode& n = tubeNodes.nodes[own];
      const double share = parts[k].length * weight(k, i) * n.ramp * dot(n.direction, parts[k].direction);
      for (std::size_t s = 0; s < width.size(); ++s)
        width[s] += share * hatOf(sight, n.line, n.arc, static_cast<int>(s), tube.halfWidth);
    }
}

/// Particles whose functions reach a node are at most 2.5 cells from it along each axis.
double reachOf(const State<D>& state, const FrontTube& tube)
{
  return tube.radii.outer + 4.0 * state.grid.spacing;
}

/// J at every station, of the nodes' configurational forces [N].
std::vector<double> integrate(const State<D>& state, const FrontLine& line, const FrontTube& tube,
                              const View<double* [D]>& force)
{
  const std::size_t stations = line.stations.size();
  const FrontSight sight(line, reachOf(state, tube));
  const TubeNodes nodes = findNodes(state, sight, tube.radii, regionAround(line, tube.radii.outer), force);
  std::vector<double> sums(2 * stations, 0.0); // of the release, then of the width
  for (std::size_t s = 0; s < stations; ++s)
    for (const TubeNode& n : nodes.nodes)
      sums[s] += n.ramp * n.along * hatOf(sight, n.line, n.arc, static_cast<int>(s), tube.halfWidth);
  std::vector<double> width(stations, 0.0);
  addWidths(state, line, sight, tube, nodes, width);
  std::copy(width.begin(), width.end(), sums.begin() + static_cast<long>(stations));
  sumParts(state, sums.data(), static_cast<int>(sums.size()));
  std::vector<double> J(stations, 0.0);
  for (std::size_t s = 0; s < stations; ++s)
    if (sums[stations + s] > 0.0)
      J[s] = sums[s] / sums[stations + s];
  return J;
}

} // namespace

std::vector<double> integrateWithAcceleration(const State<3>& state, const FrontLine& line,
                                              const FrontTube& tube, const NodalAcceleration<3>& acceleration)
{
  if (line.empty())
    return std::vector<double>(line.stations.size(), 0.0);
  return integrate(state, line, tube,
                   configurationalForces(state, regionAround(line, reachOf(state, tube)), acceleration));
}

std::vector<double> integrateAlongFront(const State<3>& state, int crack, const FrontLine& line,
                                        const FrontTube& tube, NodalAcceleration<3>& acceleration)
{
  if (line.empty())
    return std::vector<double>(line.stations.size(), 0.0);
  // Nodes that particles in the tube touch are touched by others.
  internalAcceleration(state, regionAround(line, reachOf(state, tube) + 4.0 * state.grid.spacing),
                       acceleration);
  addAccelerationByPressure(state, acceleration);
  const View<double* [D]> force =
      configurationalForces(state, regionAround(line, reachOf(state, tube)), acceleration);
  addForceOfPressure(state, crack, line, tube, force);
  return integrate(state, line, tube, force);
}

} // namespace Rhegma::energy_release
