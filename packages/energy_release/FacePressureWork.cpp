#include "energy_release/FacePressureWork.hpp"

#include "geometry/Cross.hpp"
#include "state/Subdomain.hpp"
#include "transfer/FacePoints.hpp"
#include "transfer/PushNodes.hpp"
#include "transfer/Stencils.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace Rhegma::energy_release
{

namespace
{

/// Parts of a triangle's edge into which it is cut: the shape functions are not linear within it.
constexpr int partsOfEdge = 4;

/// A force at a position [N], to be multiplied by the gradients of the nodal weights there.
struct PointForce
{
  Vector<3> position, force;
};

/// The triangles of a crack with their openings, on the host.
class PressedTriangles
{
public:
  PressedTriangles(const CrackSet<3>& cracks, const FrontLine& line, double reach)
      : vertex_(onHost(cracks.vertex)),
        face_(onHost(cracks.face)),
        simplex_(onHost(cracks.simplex)),
        pressure_(onHost(cracks.pressure)),
        sight_(line, 0.0),
        reach_(reach)
  {
  }

  /// Adds the forces of triangle s, unless it is further from the front than `reach`.
  void add(int s, std::vector<PointForce>& forces) const
  {
    Vector<3> corner[3];
    double square[3], nearest = 1e300; // of the opening along the normal, with its sign
    for (int i = 0; i < 3; ++i)
    {
      Vector<3> opening;
      for (int d = 0; d < 3; ++d)
      {
        corner[i][d] = vertex_(simplex_(s, i), d);
        opening[d] = face_(simplex_(s, i), 1, d) - face_(simplex_(s, i), 0, d);
      }
      const FrontFoot foot = sight_.locate(corner[i]);
      nearest = std::min(nearest, foot.distance);
      const double open = dot(opening, foot.normal);
      square[i] = open * std::fabs(open);
    }
    if (nearest >= reach_)
      return;
    const Vector<3> area = cross(corner[1] - corner[0], corner[2] - corner[0]);
    const Vector<3> normal = (1.0 / norm(area)) * area;
    const int first = static_cast<int>(forces.size());
    const auto number = [&](int i, int j) { return first + i * (partsOfEdge + 1) - i * (i - 1) / 2 + j; };
    for (int i = 0; i <= partsOfEdge; ++i)
      for (int j = 0; i + j <= partsOfEdge; ++j)
      {
        const double a = double(i) / partsOfEdge, b = double(j) / partsOfEdge;
        forces.push_back({(1.0 - a - b) * corner[0] + a * corner[1] + b * corner[2], {0.0, 0.0, 0.0}});
      }
    // Near a front the opening is proportional to the root of the distance, and its square is smooth also for
    // an ellipse: the square is interpolated.
    const auto addPart = [&](const std::array<int, 3>& part, double a, double b)
    {
      const double mean = (1.0 - a - b) * square[0] + a * square[1] + b * square[2];
      const double force = 0.5 * pressure_(s) * std::copysign(std::sqrt(std::fabs(mean)), mean);
      for (int i = 0; i < 3; ++i)
      {
        const Vector<3> opposite = forces[part[(i + 2) % 3]].position - forces[part[(i + 1) % 3]].position;
        forces[part[i]].force = forces[part[i]].force + force * cross(normal, opposite);
      }
    };
    constexpr double third = 1.0 / (3.0 * partsOfEdge);
    for (int i = 0; i < partsOfEdge; ++i)
      for (int j = 0; i + j < partsOfEdge; ++j)
      {
        const double a = double(i) / partsOfEdge, b = double(j) / partsOfEdge;
        addPart({number(i, j), number(i + 1, j), number(i, j + 1)}, a + third, b + third);
        if (i + j + 1 < partsOfEdge)
          addPart({number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)}, a + 2.0 * third,
                  b + 2.0 * third);
      }
  }

private:
  View<double* [3]>::HostMirror vertex_;
  View<double* [2][3]>::HostMirror face_;
  View<int* [3]>::HostMirror simplex_;
  View<double*>::HostMirror pressure_;
  FrontSight sight_;
  double reach_;
};

} // namespace

bool isPressed(const State<3>& state)
{
  return state.clock.step > 0 && state.cracks.pressure.extent(0) > 0 &&
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
  const Nodes<3> nodes = state.mesh.nodes;
  Kokkos::parallel_for(
      "rhegma::accelerationByFacePressure", Kokkos::RangePolicy<ExecSpace>(0, acceleration.extent(0)),
      KOKKOS_LAMBDA(const int n) {
        const double mass = nodes.sums(n, Nodes<3>::massAt);
        for (int d = 0; d < 3; ++d)
          acceleration(n, d) += mass > 0.0 ? force(n, d) / mass : 0.0;
      });
}

void addForceOfPressure(const State<3>& state, int crack, const FrontLine& line, const FrontTube& tube,
                        const View<double* [3]>& force)
{
  if (!isPressed(state) || line.empty())
    return;
  // Functions of nodes in the tube reach two of the largest cells further.
  const PressedTriangles triangles(state.cracks, line, tube.radii.outer + 2.0 * state.mesh.grid.spacing);
  const Crack<3>& own = state.cracks.cracks[crack];
  std::vector<PointForce> forces;
  for (int s = own.firstSimplex; s < own.firstSimplex + own.numSimplices; ++s)
    triangles.add(s, forces);

  ObservedPoints<3> points;
  points.onAllRanks = true;
  points.count = static_cast<int>(forces.size());
  points.position = View<double* [3]>("rhegma::pressedPosition", points.count);
  points.half = View<double* [3]>("rhegma::pressedHalf", points.count);
  points.side = View<int*>("rhegma::pressedSide", points.count); // q is the same for both fields of a node
  const View<double* [3]> pressed("rhegma::pressedForce", points.count);
  const auto position = Kokkos::create_mirror_view(points.position),
             host = Kokkos::create_mirror_view(pressed);
  for (int k = 0; k < points.count; ++k)
    for (int d = 0; d < 3; ++d)
    {
      position(k, d) = forces[k].position[d];
      host(k, d) = forces[k].force[d];
    }
  Kokkos::deep_copy(points.position, position);
  Kokkos::deep_copy(pressed, host);
  StencilTable<3> table;
  pointStencils(state, points, table, false);
  forEachPushing(
      "rhegma::configurationalForceOfPressure", points.count, KOKKOS_LAMBDA(const int k) {
        for (int e = 0; e < table.count(k); ++e)
          for (int d = 0; d < 3; ++d)
            Kokkos::atomic_add(&force(table.node(k, e), d), table.weight(k, e) * pressed(k, d));
      });
}

} // namespace Rhegma::energy_release
