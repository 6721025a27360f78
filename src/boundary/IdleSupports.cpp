#include "boundary/IdleSupports.hpp"

#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "base/ShortNumber.hpp"
#include "boundary/NodesInBoxes.hpp"
#include "boundary/TouchedNodes.hpp"
#include "plan/LoadOverStep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Rhegma
{

namespace
{

/// How far a node is from being held [m].
template <int D>
double distanceTo(const NodeConstraint<D>& constraint, const Vector<D>& x)
{
  Vector<D> off;
  double inside = std::numeric_limits<double>::infinity();
  for (int d = 0; d < D; ++d)
  {
    off[d] = std::max({0.0, constraint.lower[d] - x[d], x[d] - constraint.upper[d]});
    inside = std::min({inside, x[d] - constraint.lower[d], constraint.upper[d] - x[d]});
  }
  return constraint.outside ? std::max(0.0, inside) : norm(off);
}

/// How far bodies move at most [m]. \param distances of the constraints from the nearest node; only those
/// that hold one move it
template <int D>
double travel(const Teuchos::ParameterList& scene, const std::vector<TimedConstraint<D>>& constraints,
              const std::vector<double>& distances, double reach)
{
  const double end = scene.sublist("Time").get<double>("Final Time");
  double fastest = 0.0, acceleration = 0.0;
  for (const std::string& name : sublistNames(scene.sublist("Bodies")))
    fastest = std::max(fastest, norm(readVector<D>(scene.sublist("Bodies").sublist(name), "Velocity")));
  for (std::size_t c = 0; c < constraints.size(); ++c)
    for (int k = 0; k <= 64 && distances[c] <= reach; ++k)
      fastest =
          std::max(fastest, norm(constraints[c].value) * std::fabs(constraints[c].history(end * k / 64)));
  for (const std::string& name : sublistNames(scene.sublist("Boundaries")))
    if (scene.sublist("Boundaries").sublist(name).isParameter("Acceleration"))
      acceleration += norm(readVector<D>(scene.sublist("Boundaries").sublist(name), "Acceleration"));
  return end * (fastest + 0.5 * acceleration * end);
}

/// Largest displacement that a support prescribes up to a time [s] [m]; trapezoidal rule.
template <int D>
double farthest(const TimedConstraint<D>& timed, double end)
{
  constexpr int intervals = 256;
  double sum = 0.0, most = 0.0;
  for (int k = 0; k < intervals; ++k)
  {
    sum += 0.5 * (timed.history(end * k / intervals) + timed.history(end * (k + 1) / intervals));
    most = std::max(most, std::fabs(sum));
  }
  double square = 0.0;
  for (int d = 0; d < D; ++d)
    square += timed.constraint.holds[d] ? timed.value[d] * timed.value[d] : 0.0;
  return most * std::sqrt(square) * end / intervals;
}

/// Warns of a support that moves the surface of a body from a box that stays where it is.
template <int D>
void warnOfBoxLeftBehind(const TimedConstraint<D>& timed, double end, State<D>& state)
{
  // A bar whose outermost particles left their box by 0.04 cells had a force that was 5 % too small
  // (docs/how-to/supports-and-loads.md); the error grows with the displacement, and is below 1 % here.
  constexpr double harmlessCells = 0.008;
  const double by = farthest(timed, end);
  if (!timed.leftBehind || !(by > harmlessCells * state.mesh.grid.spacing))
    return;
  state.warnings.push_back(
      "Boundaries > " + timed.name +
      ": its box contains nodes at the surface of a body, but no particle. So it stays "
      "where it is, while the body is to move by up to " +
      readableLength(by) + " (" + formatShort(by / state.mesh.grid.spacing) +
      " cells): forces and displacements may be wrong. Extend the box by a cell into the "
      "body, so that both move together, or write Box Motion = Fixed");
}

} // namespace

template <int D>
void warnOfIdleSupports(const Teuchos::ParameterList& scene,
                        const std::vector<TimedConstraint<D>>& constraints, State<D>& state)
{
  if (constraints.empty())
    return;
  const std::vector<Vector<D>> nodes = touchedNodes(state);
  const NodesInBoxes<D> found(nodes, constraints.size());
  std::vector<double> distances;
  for (const TimedConstraint<D>& timed : constraints)
  {
    double nearest = std::numeric_limits<double>::infinity();
    found.visit({timed.constraint.lower, timed.constraint.upper}, timed.constraint.outside,
                [&](const Vector<D>&) { nearest = 0.0; });
    if (nearest > 0.0)
      for (const Vector<D>& x : nodes)
        nearest = std::min(nearest, distanceTo(timed.constraint, x));
    distances.push_back(nearest);
  }
  // A support that bodies come to may move them on to another.
  double reach = 0.0;
  for (double before = -1.0; reach > before;)
  {
    before = reach;
    reach = std::max(reach, travel(scene, constraints, distances, reach));
  }
  // A load step holds the nodes that are in the box when it starts.
  const double last = state.method.equilibrium() ? largestLoadStep(scene) : 0.0;
  const double end = scene.sublist("Time").get<double>("Final Time") - last;
  for (std::size_t c = 0; c < constraints.size(); ++c)
    if (distances[c] == 0.0)
      warnOfBoxLeftBehind(constraints[c], end, state);
  int idle = 0;
  for (std::size_t c = 0; c < constraints.size(); ++c)
    if (constraints[c].reported && distances[c] > reach && ++idle <= 10)
      state.warnings.push_back(
          "Boundaries > " + constraints[c].name + ": it contains no node of any body; the nearest is " +
          readableLength(distances[c]) + " away, and bodies move by " + readableLength(reach) +
          " at most; move it to the body, and check its unit (metres)");
  if (idle > 10)
    state.warnings.push_back("Boundaries: " + std::to_string(idle - 10) +
                             " more that contain no node of any body");
}

template void warnOfIdleSupports(const Teuchos::ParameterList&, const std::vector<TimedConstraint<2>>&,
                                 State<2>&);
template void warnOfIdleSupports(const Teuchos::ParameterList&, const std::vector<TimedConstraint<3>>&,
                                 State<3>&);

} // namespace Rhegma
