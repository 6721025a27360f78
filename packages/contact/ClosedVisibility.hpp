#pragma once
/// Contact of the C-SAFE report for broken cells: where a crack is closed, particles see through it.

#include "transfer/FacePoints.hpp"

namespace Rhegma::contact
{

/// Switches the visibility criterion off where a crack is closed, so that its faces stick there.
///
/// Whether it is closed is judged by the unmodified strain interpolation: the separation of a face point
/// follows h n . L n, L the mean velocity gradient by unbroken shape functions over a cell around the point,
/// that is the relative motion of two positions half a cell away on either side. It is zero in the undeformed
/// state; below, the faces are closer than undeformed. A particle uses its nearest face point.
///
/// This contact serves for comparison: it changes the shape functions of particles during the motion, which
/// changes energy (docs/explanation/contact.md).
class ClosedVisibility
{
public:
  /// Hooks into the visibility of the state; the object must outlive the state.
  void install(State<2>& state);

  /// Finds points and their unbroken stencils for this step; needs nodal masses.
  void prepare(const State<2>& state);

  /// Moves the separations on by dt with a nodal velocity (first two columns).
  template <class Velocity>
  void advance(const State<2>& state, const Velocity& velocity);

  void serialize(Archive& archive);

  /// Points of a crack where it is closed.
  int closedPoints(int crack) const;

  /// Part of `prepare`; public because compilers for devices want kernels in public functions.
  void setAround(const State<2>& state);

private:
  void reserveRows();
  void edit(const State<2>& state, const ObservedPoints<2>& points, const StencilTable<2>& table);

  std::function<void(const State<2>&, const ObservedPoints<2>&, const StencilTable<2>&)> cut_;

  FacePoints<2> points_;
  ObservedPoints<2> behind_, ahead_; ///< half a cell away from each face point, on both sides of it
  StencilTable<2> below_, above_;    ///< unbroken
  StencilTable<2> kept_;             ///< rows as they were before the cut
  View<double*> seen_;               ///< four numbers a point: jump of the velocity, which faces have nodes
  View<double*> separation_;         ///< since the undeformed state [m]
  bool whole_ = false;               ///< no cuts: the unmodified interpolation is asked for
};

} // namespace Rhegma::contact
