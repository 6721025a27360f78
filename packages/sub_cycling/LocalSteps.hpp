#pragma once
/// Substeps of small cells within a long one.

#include "state/State.hpp"
#include "sub_cycling/FineParticles.hpp"

namespace Rhegma
{
class Archive;
}

namespace Rhegma::sub_cycling
{

/// Moves the nodes of small cells in steps of their own through one step, and turns what they did into
/// the force and the velocity of that step.
///
/// Particles of a class (FineParticles.hpp) act on the nodes by an impulse at the start of each step of their
/// class, and nodes drift between impulses: with h the length of a step of class l and f_l the force of its
/// particles where the nodes are now,
///
///     step(l, h):  v += h B f_l;   in the last class u += h v,   else step(l + 1, h / 2) twice.
///
/// The step is step(first - 1, dt), whose impulse is that of all other particles. Each impulse is the
/// gradient of an energy and each drift that of another, so with fixed weights the steps are symplectic in
/// v and u: energy stays bounded without damping, and momentum is kept to round-off since every f_l sums to
/// zero. Particles then get the sum of impulses over dt as their force, and u over dt as the velocity that
/// strains and moves them. What a step leaves is what the short ones came to, so weights and cells may
/// change from one to the next. (A scheme that feeds back a mean force, as Diaz and Grote, SIAM J. Sci.
/// Comput. 31 (2009) 1985, has no memory of the phase of motions that turn about as often as there are long
/// steps; in a body that travels through its cells it gained energy at two levels and burst at three.)
///
/// Impulses at long intervals would make a body at rest tremble, and may drive a motion of small cells that
/// fits the interval. So only what changes comes in impulses: loads, and the mean of each force over some
/// hundred steps, pull all the time; and each class has a rim of larger cells.
/// Source: asynchronous variational integrators, Lew, Marsden, Ortiz and West, Int. J. Numer. Meth. Engng
/// 60 (2004) 153; impulses as Tuckerman, Berne and Martyna, J. Chem. Phys. 97 (1992) 1990; the mass of MUSL.
template <int D>
class LocalSteps
{
public:
  /// Lists the particles of small cells and separates the forces of the others. To be called when nodes have
  /// internal forces and no other. \param first, last levels that take steps of their own; `first` takes two
  /// a step
  void begin(State<D>& state, int first, int last);
  /// Changes the force of the nodes. To be called when nodes have all forces.
  void evolve(State<D>& state);
  /// Change the velocity after the solve and the projected one.
  void correctMotion(State<D>& state) const;
  void correctProjection(State<D>& state) const;

  /// Steps of particles beyond the long ones' so far.
  double extraSteps() const { return extraSteps_; }

  /// Saves or loads their number.
  void store(Archive& archive);

  // What follows is public because compilers for devices want kernels in public functions.

  using Values = View<double* [D]>;
  void reserveRows(int slots);
  void step(const State<D>& state, int level, double length);
  /// Adds the impulse of a class to those that wait.
  void addImpulse(const State<D>& state, int level, double length);
  /// Gives the nodes what waits; impulses of several classes at a time come at once.
  void kick(const State<D>& state);
  void drift(double length);
  /// Takes all of the force on nodes that no small particle touches for one of the step.
  void finishOuterNodes();
  /// Whether anybody asks for the work of impulses.
  static bool needsWork(const State<D>& state)
  {
    return state.clock.observing || !state.motion.constraints.empty();
  }
  /// Adds the work of a force at the start of the step. \param duration that it acts by then [s]
  void addStartWork(const State<D>& state, const Values& force, double duration);
  /// Books what supports give in substeps, and leaves the rest with the state.
  void recordWork(State<D>& state);
  /// Moves the mean of a force of one class to the loads.
  void steady(const State<D>& state, int level, const Values& force, const Values& mean);

private:
  int first_ = 1, last_ = 0;
  bool active_ = false;
  double extraSteps_ = 0.0;
  FineParticles<D> fine_;
  Values others_; ///< all other forces but loads: of particles of no class here, frozen ones; without the
                  ///< mean [N]
  Values loads_;  ///< what pulls all the time [N], then what it does to the velocity [m/s2]
  Values force_;  ///< of particles of one class [N]
  Values start_[deepestLevel + 1];      ///< that of each class at the start of the step [N]
  Values mean_[deepestLevel + 1];       ///< of the force of each class [N]
  bool atStart_[deepestLevel + 1] = {}; ///< whether nodes are still where that of a class was reckoned
  Values waiting_;                      ///< impulses that are to be given next [N s]
  int waitingFrom_ = 0;                 ///< the lowest class among them
  bool atFirst_ = false;                ///< whether these are the first of the step
  Values impulse_;                      ///< so far [N s]
  Values velocity_, displacement_;      ///< so far
  double elapsed_ = 0.0;                ///< of the step so far [s]
  typename FineParticles<D>::ImpulseWork startWork_; ///< of the impulses at the start of the step
};

} // namespace Rhegma::sub_cycling
