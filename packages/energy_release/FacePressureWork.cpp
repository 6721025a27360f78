#include "energy_release/FacePressureWork.hpp"

#include "energy_release/NodalDisplacement.hpp"
#include "geometry/Cross.hpp"
#include "state/Subdomain.hpp"
#include "transfer/LocalSpacing.hpp"
#include "transfer/PushNodes.hpp"
#include "transfer/Stencils.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace Rhegma::energy_release
{

namespace
{

/// Longest edge of the parts that triangles are cut into [cells]: the shape functions are not linear within
/// them.
constexpr double longestPart = 0.5;

/// A force at a position [N], to be multiplied by the gradients of the nodal weights there.
struct PointForce
{
  Vector<3> position, force;
};

/// A part of a triangle: the numbers of its corners in the list of forces, and the force of a unit opening on
/// each [N/m].
struct Part
{
  std::array<int, 3> corner;
  std::array<Vector<3>, 3> force;
  Vector<3> normal; ///< from side -1 to side +1
};

/// The parts of triangles of a crack near a front, on the host.
struct PressedParts
{
  std::vector<PointForce> corners;
  std::vector<Part> parts;
  std::vector<Vector<3>> middles; ///< of the parts

  /// Cuts a triangle. \param number parts of an edge
  void add(const Vector<3> (&corner)[3], double pressure, int number)
  {
    const Vector<3> area = cross(corner[1] - corner[0], corner[2] - corner[0]);
    const Vector<3> normal = (1.0 / norm(area)) * area;
    const int first = static_cast<int>(corners.size());
    const auto at = [&](int i, int j) { return first + i * (number + 1) - i * (i - 1) / 2 + j; };
    for (int i = 0; i <= number; ++i)
      for (int j = 0; i + j <= number; ++j)
      {
        const double a = double(i) / number, b = double(j) / number;
        corners.push_back({(1.0 - a - b) * corner[0] + a * corner[1] + b * corner[2], {0.0, 0.0, 0.0}});
      }
    for (int i = 0; i < number; ++i)
      for (int j = 0; i + j < number; ++j)
      {
        addPart({at(i, j), at(i + 1, j), at(i, j + 1)}, normal, pressure);
        if (i + j + 1 < number)
          addPart({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}, normal, pressure);
      }
  }

private:
  void addPart(const std::array<int, 3>& corner, const Vector<3>& normal, double pressure)
  {
    Part part{corner, {}, normal};
    for (int i = 0; i < 3; ++i)
    {
      const Vector<3> opposite =
          corners[corner[(i + 2) % 3]].position - corners[corner[(i + 1) % 3]].position;
      part.force[i] = 0.5 * pressure * cross(normal, opposite);
    }
    parts.push_back(part);
    middles.push_back((1.0 / 3.0) * (corners[corner[0]].position + corners[corner[1]].position +
                                     corners[corner[2]].position));
  }
};

/// The parts of the triangles of a crack within `reach` of a front that pressure acts on.
PressedParts partsNear(const State<3>& state, const Crack<3>& crack, const FrontLine& line, double reach)
{
  const auto vertex = onHost(state.cracks.vertex);
  const auto simplex = onHost(state.cracks.simplex);
  const auto pressure = onHost(state.cracks.pressure);
  const FrontSight sight(line, 0.0);
  PressedParts all;
  for (int s = crack.firstSimplex; s < crack.firstSimplex + crack.numSimplices; ++s)
  {
    Vector<3> corner[3];
    double nearest = 1e300, longest = 0.0;
    for (int i = 0; i < 3; ++i)
      for (int d = 0; d < 3; ++d)
        corner[i][d] = vertex(simplex(s, i), d);
    for (int i = 0; i < 3; ++i)
    {
      nearest = std::min(nearest, sight.locate(corner[i]).distance);
      longest = std::max(longest, norm(corner[(i + 1) % 3] - corner[i]));
    }
    if (pressure(s) == 0.0 || nearest >= reach + longest)
      continue;
    const double part = longestPart * spacingAt(state, corner[0]);
    all.add(corner, pressure(s), std::max(1, static_cast<int>(std::ceil(longest / part))));
  }
  return all;
}

} // namespace

void addForceOfPressure(const State<3>& state, int crack, const FrontLine& line, const FrontTube& tube,
                        const ConfigurationalForces& force)
{
  if (!isPressed(state) || line.empty())
    return;
  // Functions of nodes in the tube reach two of the largest cells further.
  const double reach = tube.radii.outer + 2.0 * state.mesh.grid.spacing;
  PressedParts cut = partsNear(state, state.cracks.cracks[crack], line, reach);
  const std::vector<Vector<3>> opening =
      openingAt(state, displacementOfNodes(state, regionAround(line, 2.0 * reach)), crack, cut.middles);
  std::vector<PointForce>& forces = cut.corners;
  for (std::size_t k = 0; k < cut.parts.size(); ++k)
  {
    const Part& part = cut.parts[k];
    const double open = dot(opening[k], part.normal);
    for (int i = 0; i < 3; ++i)
      forces[part.corner[i]].force = forces[part.corner[i]].force + open * part.force[i];
  }

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
