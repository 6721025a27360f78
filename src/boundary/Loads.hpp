#pragma once
/// Loads that ride on particles.

#include "geometry/LoadPoints.hpp"
#include "scene/TimeFunction.hpp"
#include "state/State.hpp"

#include <vector>

namespace Rhegma
{

/// A load spread over points of a body's surface. Dead: its direction stays, its points move and turn with
/// the particles that carry them. Where these were split, a point becomes as many as its particle has parts
/// along the surface, so that small cells feel an even load; else one of them would take what is meant for
/// all.
template <int D>
class Load
{
public:
  /// \param ids id of the particle that carries each point, which may be split: then of a part of it
  /// \param carriers where these particles start [m] \param force whole load at history 1 [N]
  Load(std::string name, const std::vector<LoadPoint<D>>& points, const std::vector<int>& ids,
       const std::vector<Vector<D>>& carriers, const Vector<D>& force, TimeFunction history);

  /// Adds the load to the nodal force. The nodal loads sum to the load asked for, or the run is in failure:
  /// points whose nodes all lack mass would lose theirs.
  void apply(State<D>& state);

  /// Brings the points to where their particles are now, and finds the nodes around them.
  void place(State<D>& state);
  int points() const { return points_.count; }
  /// Nodes around each point, after `position`; and its fraction, zero where another rank has its particle.
  const StencilTable<D>& nodesAround() const { return stencils_; }
  const View<double*>& shares() const { return here_; }

  /// Work [J] of the load over the step, at the velocity that gives the particles their kinetic energy
  /// (LoadVelocity).
  double work(const State<D>& state) const;

  const std::string& name() const { return name_; }
  /// The whole load over this step [N], on all ranks.
  Vector<D> force() const { return now_ * force_; }

private:
  /// Makes the points anew where particles that carry them were split or have become one again.
  void updateLevels(const State<D>& state);
  void makePoints(const std::vector<int>& levels);

  std::vector<LoadPoint<D>> whole_; ///< the points of particles that were not split
  std::vector<int> carrier_;        ///< id of the particle that carries each of them
  std::vector<Vector<D>> seat_;     ///< where that particle starts [m]
  View<int*> wholeId_, level_;      ///< for each of them: the id again, and how often it is split now
  std::string name_;
  Vector<D> force_;
  TimeFunction history_;
  View<int*> id_;
  View<double* [D]> start_; ///< of each point [m]
  View<double*> fraction_;
  View<double*> here_; ///< the fraction where this rank has the particle that carries the point, else zero
  ObservedPoints<D> points_;
  StencilTable<D> stencils_; ///< of all nodes with mass, which the load pushes
  StencilTable<D> followed_; ///< without light nodes, for the velocity at which the load does work
  double now_ = 0.0;
};

} // namespace Rhegma
