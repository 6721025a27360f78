#pragma once
/// Time-symmetric local time stepping.

#include "state/State.hpp"
#include "sub_cycling/FineParticles.hpp"

#include <vector>

namespace Rhegma::sub_cycling
{

/// Turns the force on the nodes of small cells into the one that gives, over one long step, the motion that
/// they would have in short steps of their own.
///
/// Half steps of a level stand for two steps of half the length: with d the length of the short step, F the
/// force and K the stiffness of the cells,
///
///     T(l, F) = (T(l+1, F) + T(l+1, F - (1 + nu) d^2/2 K P_l B P_l T(l+1, F))) / 2,   T(beyond the last) =
///     F,
///
/// where P_l keeps the nodes of leaves of level l and deeper, and B is what a step makes of a force: to
/// accelerations of the nodes, to the particles, and back to the nodes. Since T is the same forwards and
/// backwards in time, energy stays bounded; since K maps to forces whose sum is zero, momentum is kept to
/// round-off. nu damps what the coupling of levels feeds: a force that is frozen instead would be unstable.
/// Stiffness is that of the constitutive law at the strain that the displacement adds, so any law will do;
/// weights, sides of cracks and supports are those of the long step.
/// Source: Diaz and Grote, SIAM J. Sci. Comput. 31 (2009) 1985, with the mass of MUSL.
template <int D>
class LocalSteps
{
public:
  /// \param damping nu
  explicit LocalSteps(double damping) : damping_(damping) {}

  /// Changes the force of the nodes. \param first, last levels that take steps of their own; `first` takes
  /// two a long step
  void act(State<D>& state, int first, int last);

  /// Steps of particles beyond the long ones' so far.
  double extraSteps() const { return extraSteps_; }

private:
  using Values = View<double* [D]>;
  /// T(level, from): the view that holds it.
  Values evolve(const State<D>& state, int level, int last, double length, const Values& from);
  void makeRoom(int levels, int nodes);

  double damping_;
  double extraSteps_ = 0.0;
  FineParticles<D> fine_;
  std::vector<Values> changed_, mean_; ///< of each level
  Values displacement_;
};

} // namespace Rhegma::sub_cycling
