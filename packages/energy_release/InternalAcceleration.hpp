#pragma once
/// Acceleration of the nodes around a front by internal forces.

#include "energy_release/FrontRegion.hpp"
#include "state/State.hpp"

#include <type_traits>
#include <vector>

namespace Rhegma::energy_release
{

/// Of each node, enriched fields included: acceleration [m/s2], then the mass to which it belongs [kg].
template <int D>
using NodalAcceleration = View<double * [D + 1]>;

/// Finds the accelerations around fronts, of all fronts at once or of one after the other, in rows that are
/// reused. The cost is that of the particles and nodes around the fronts.
template <int D>
class InternalAcceleration
{
public:
  using Range = std::conditional_t<D == 2, Disk, Region<3>>;

  /// Call it when the state has changed: forces of pressure and ranges that are known are kept until then.
  void renew();

  /// Acceleration [m/s2] of nodes by internal forces, -sum_p V0 tau grad N / m, from the particles within
  /// ranges, and by pressure on the faces of cracks (ForceOfPressure.hpp); a row a node, enriched fields
  /// included. Rows of nodes that particles outside of the ranges touch are incomplete or from earlier calls.
  /// Without other loads it is the nodes' acceleration. Where they act, such as contact, body force or
  /// damping, it is less by what they do: used as `a` in the domain integrals it accounts for their work. The
  /// mass m and N are those of the present positions: a node that a box just reaches has a mass proportional
  /// to the square of the overlap and a force proportional to the overlap, so that with the mass of the start
  /// of the step a small motion of the box would cause an arbitrary acceleration. Collective.
  ///
  /// \return the rows, which the next call overwrites
  const NodalAcceleration<D>& around(const State<D>& state, const std::vector<Range>& ranges);

  /// The same around one front; of a range inside of those that are known nothing is computed.
  const NodalAcceleration<D>& around(const State<D>& state, const Range& range);

private:
  void sumForces(const State<D>& state, const std::vector<Region<D>>& boxes);

  NodalAcceleration<D> rows_;
  NodalAcceleration<D> force_; ///< [N], then mass [kg]
  View<double* [D]> pressure_; ///< [N]; empty where nothing presses
  BlocksInReach<D> blocks_;
  std::vector<Range> ranges_; ///< known in the present state
  bool isPressureKnown_ = false;
};

} // namespace Rhegma::energy_release
