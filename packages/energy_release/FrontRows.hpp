#pragma once
/// Values of the nodes around a front that the domain integrals interpolate.

#include "energy_release/Contour.hpp"
#include "energy_release/CrackPath.hpp"
#include "energy_release/InternalAcceleration.hpp"

namespace Rhegma::energy_release
{

/// A row a node, enriched fields included, of which a kernel interpolates all numbers at once. In 2D: the
/// weight q, q times the direction of the crack, a spare number, velocity [m/s] and acceleration times q
/// [m/s2]. In 3D: velocity, acceleration, two spare numbers.
///
/// The work of a node's forces on the virtual advance is that of its own weight. With the acceleration and
/// the weight interpolated one by one, forces on nodes without weight, such as those that support a surface
/// or load it, would do work on the particles between these nodes and those with a weight: where the crack
/// ends at the surface within a cell of the outer radius, J was wrong by the energy density of the stress
/// along the crack times a cell.
template <int D>
struct FrontRows
{
  static constexpr int width = 8, weightAt = 0, motionAt = D == 2 ? 4 : 0, accelerationAt = motionAt + D;
  const double* data = nullptr; ///< on the device
};

/// Owns the rows. Those of one front overwrite those of another.
template <int D>
class FrontRowTable
{
public:
  /// Fills the motion of the nodes in a box. \param moving whether nodes move
  FrontRows<D> fillMotion(const State<D>& state, const Region<D>& box, bool moving,
                          const NodalAcceleration<D>& acceleration);

  /// Fills the motion and the weights of the nodes in a box, with accelerations multiplied by the weights (2D
  /// only). \param path of a bent crack; without simplices of a straight one, whose rows have no direction
  FrontRows<D> fill(const State<D>& state, const Region<D>& box, bool moving,
                    const NodalAcceleration<D>& acceleration, const NodalWeight<D>& weight,
                    const CrackPath& path);

  /// Forces that integrals sum on nodes, a row a node, zero in a box; the last column is spare.
  View<double* [4]> clearForces(const State<D>& state, const Region<D>& box);

  /// Rows of mass times the gradient of displacement that integrals sum on nodes, zero in a box: one row of
  /// the gradient after the other, each with a spare number [kg]. Empty where nodes do not move.
  View<double * [4 * D]> clearMoments(const State<D>& state, const Region<D>& box, bool moving);

  /// Adds to the forces in a box what accelerations do on the moments.
  void addWorkOfAcceleration(const State<D>& state, const Region<D>& box) const;

private:
  void reserve(const State<D>& state);

  View<double * [FrontRows<D>::width]> rows_;
  View<double* [4]> forces_;
  View<double * [4 * D]> moments_; ///< empty where nodes do not move
};

template <>
FrontRows<2> FrontRowTable<2>::fill(const State<2>& state, const Region<2>& box, bool moving,
                                    const NodalAcceleration<2>& acceleration, const NodalWeight<2>& weight,
                                    const CrackPath& path);

/// What the integrals around a front reuse: their cost is that of the particles and nodes around it.
template <int D>
struct FrontWork
{
  FrontRowTable<D>& rows;   ///< of all fronts, one after the other
  BlocksInReach<D>& blocks; ///< of this front
};

} // namespace Rhegma::energy_release
