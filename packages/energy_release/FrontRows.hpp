#pragma once
/// Values of the nodes around a front that the domain integrals interpolate.

#include "energy_release/Contour.hpp"
#include "energy_release/CrackPath.hpp"
#include "energy_release/InternalAcceleration.hpp"

namespace Rhegma::energy_release
{

/// A row a node, enriched fields included, of which a kernel interpolates all numbers at once. In 2D: the
/// weight q, q times the direction of the crack, a spare number, velocity [m/s] and acceleration [m/s2]. In
/// 3D: velocity, acceleration, two spare numbers.
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

  /// Fills the weights of the nodes in a box (2D only). \param path of a bent crack; without simplices of a
  /// straight one, whose rows have no direction
  void fillWeights(const State<D>& state, const Region<D>& box, const NodalWeight<D>& weight,
                   const CrackPath& path);

  /// Forces that integrals sum on nodes, a row a node, zero in a box; the last column is spare.
  View<double* [4]> clearForces(const State<D>& state, const Region<D>& box);

private:
  void reserve(const State<D>& state);

  View<double * [FrontRows<D>::width]> rows_;
  View<double* [4]> forces_;
};

template <>
void FrontRowTable<2>::fillWeights(const State<2>& state, const Region<2>& box, const NodalWeight<2>& weight,
                                   const CrackPath& path);

/// What the integrals around a front reuse: their cost is that of the particles and nodes around it.
template <int D>
struct FrontWork
{
  FrontRowTable<D>& rows;   ///< of all fronts, one after the other
  BlocksInReach<D>& blocks; ///< of this front
};

} // namespace Rhegma::energy_release
