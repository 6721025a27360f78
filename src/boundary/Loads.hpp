#pragma once
/// Loads whose points move with particles.

#include "geometry/LoadPoints.hpp"
#include "plan/LoadOverStep.hpp"
#include "scene/TimeFunction.hpp"
#include "state/State.hpp"

#include <vector>

namespace Rhegma
{

/// The force of a load: one for all of its points, and one along each point's normal.
template <int D>
struct LoadForce
{
  Vector<D> even{};          ///< divided among the points by their fractions [N]
  double alongNormals = 0.0; ///< sum of the sizes of what acts along normals, divided in the same way [N]

  /// What a load of fraction 1 would get at a point with this normal [N].
  KOKKOS_INLINE_FUNCTION double at(const View<double* [D]>& normal, int point, int axis) const
  {
    return even[axis] + alongNormals * normal(point, axis);
  }
};

/// A load spread over points of a body's surface. Dead load: its direction is constant; its points move and
/// rotate with their particles. If a particle was split, its point is divided among its parts along the
/// surface, so that small cells get an even load.
template <int D>
class Load
{
public:
  /// \param ids id of the particle that carries each point, which may be split: then of a part of it
  /// \param carriers where these particles start [m] \param force at history 1
  Load(std::string name, const std::vector<LoadPoint<D>>& points, const std::vector<int>& ids,
       const std::vector<Vector<D>>& carriers, const LoadForce<D>& force, TimeFunction history);

  /// Adds the load to the nodal force. The nodal loads sum to the total load; otherwise the run fails: points
  /// none of whose nodes has mass would lose their part.
  void apply(State<D>& state);

  /// Moves the points with their particles, and finds the nodes around them.
  void place(State<D>& state);
  int points() const { return points_.count; }
  /// Nodes around each point, and its fraction of the load, zero where another rank has its particle; valid
  /// after `place`.
  const StencilTable<D>& nodesAround() const { return stencils_; }
  const View<double*>& fractions() const { return here_; }

  /// Adds the work of the load over the step to the external work (addWorkOfLoad).
  void addWork(State<D>& state) const;

  /// Mean displacement of its points over the step along the direction of the force at each, weighted by
  /// their fractions of the load [m].
  double shift(const State<D>& state) const;

  const std::string& name() const { return name_; }
  /// The resultant of the load over this step [N], on all ranks.
  Vector<D> force() const { return now_.acts * resultant_; }

private:
  /// Work of a force in place of the load over the step [J]. \param velocity of a node along an axis [m/s]
  template <class Velocity>
  double workOf(const State<D>& state, const Velocity& velocity, const LoadForce<D>& force) const;
  /// Makes the points anew where their particles were split or merged.
  void updateLevels(const State<D>& state);
  void makePoints(const std::vector<int>& levels);

  std::vector<LoadPoint<D>> whole_;     ///< the points of particles that were not split
  std::vector<int> carrier_;            ///< id of the particle that carries each of them
  std::vector<Vector<D>> carrierStart_; ///< where that particle starts [m]
  View<int*> wholeId_, level_;          ///< for each of them: the id again, and how often it is split now
  std::string name_;
  LoadForce<D> force_;
  Vector<D> resultant_; ///< of it [N]
  TimeFunction history_;
  View<int*> id_;
  View<double* [D]> start_;  ///< of each point [m]
  View<double* [D]> normal_; ///< of each point; zero where it has none
  View<double*> fraction_;
  View<double*> here_; ///< the fraction where this rank has the particle that carries the point, else zero
  ObservedPoints<D> points_;
  StencilTable<D> stencils_;       ///< of all nodes with mass, which the load pushes
  StencilTable<D> massedStencils_; ///< without light nodes, for the velocity at which the load does work
  LoadOverStep now_;               ///< its history over the step
};

} // namespace Rhegma
