#pragma once
/// The velocity of a rigid tool and its position.

#include "geometry/Frame.hpp"

namespace Rhegma::rigid_tools
{

template <int D>
constexpr int spinSize = D == 2 ? 1 : 3; ///< numbers of an angular velocity

/// Velocities of the points of a rigid tool.
template <int D>
struct RigidVelocity
{
  Vector<D> ofCentre{};       ///< of the centre of rotation [m/s]
  double spin[spinSize<D>]{}; ///< angular velocity, counter-clockwise in 2D [rad/s]

  /// Velocity of a point. \param arm from the centre of rotation to the point [m]
  KOKKOS_INLINE_FUNCTION Vector<D> at(const Vector<D>& arm) const
  {
    Vector<D> v = ofCentre;
    if constexpr (D == 2)
    {
      v[0] -= spin[0] * arm[1];
      v[1] += spin[0] * arm[0];
    }
    else
      for (int d = 0; d < 3; ++d)
        v[d] += spin[(d + 1) % 3] * arm[(d + 2) % 3] - spin[(d + 2) % 3] * arm[(d + 1) % 3];
    return v;
  }
};

/// The mean of two velocities.
template <int D>
RigidVelocity<D> meanOf(const RigidVelocity<D>& a, const RigidVelocity<D>& b)
{
  RigidVelocity<D> mean;
  mean.ofCentre = 0.5 * (a.ofCentre + b.ofCentre);
  for (int k = 0; k < spinSize<D>; ++k)
    mean.spin[k] = 0.5 * (a.spin[k] + b.spin[k]);
  return mean;
}

/// Where a rigid tool is: how its points in the scene have moved and turned.
template <int D>
struct Placement
{
  Vector<D> centre{};                                ///< of rotation, in the scene [m]
  Vector<D> moved{};                                 ///< displacement of the centre since the start [m]
  Geometry::Axes<D> axes = Geometry::spaceAxes<D>(); ///< the axes of space, turned with the tool

  /// The position now of a point of the scene.
  Vector<D> toSpace(const Vector<D>& own) const
  {
    Vector<D> x = centre + moved;
    for (int d = 0; d < D; ++d)
      x = x + (own[d] - centre[d]) * axes[d];
    return x;
  }

  /// The point of the scene that is at a position now.
  Vector<D> toOwn(const Vector<D>& x) const
  {
    Vector<D> own = centre;
    const Vector<D> arm = x - centre - moved;
    for (int d = 0; d < D; ++d)
      own[d] += dot(arm, axes[d]);
    return own;
  }

  /// A direction of the scene as it is now.
  Vector<D> turn(const Vector<D>& own) const
  {
    Vector<D> direction{};
    for (int d = 0; d < D; ++d)
      direction = direction + own[d] * axes[d];
    return direction;
  }
};

} // namespace Rhegma::rigid_tools
