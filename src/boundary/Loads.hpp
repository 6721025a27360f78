#pragma once
/// Loads that ride on particles.

#include "geometry/LoadPoints.hpp"
#include "scene/TimeFunction.hpp"
#include "state/State.hpp"

#include <vector>

namespace Rhegma
{

/// A load spread over points of a body's surface. Dead: its direction stays, its points move and turn with
/// the particles that carry them.
template <int D>
class Load
{
public:
  /// \param ids id of the particle that carries each point, which may be split: then of a part of it
  /// \param carriers where these particles start [m] \param force whole load at history 1 [N]
  Load(std::string name, const std::vector<LoadPoint<D>>& points, const std::vector<int>& ids,
       const std::vector<Vector<D>>& carriers, const Vector<D>& force, TimeFunction history);

  /// Adds the load to the nodal force. The nodal loads sum to the load asked for, or the run is in trouble:
  /// points whose nodes all lack mass would lose theirs.
  void apply(State<D>& state);

  /// Work [J] of the load over the step, from the mean of old and new nodal velocity.
  double work(const State<D>& state) const;

private:
  std::string name_;
  Vector<D> force_;
  TimeFunction history_;
  View<int*> id_;
  View<double* [D]> start_; ///< of each point [m]
  View<double*> share_;
  ObservedPoints<D> points_;
  StencilTable<D> stencils_; ///< of all nodes with mass, which the load pushes
  StencilTable<D> followed_; ///< without light nodes, for the velocity at which the load does work
  double now_ = 0.0;
};

} // namespace Rhegma
