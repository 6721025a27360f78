#pragma once
/// Substeps of fine cells within a step.

#include "state/State.hpp"
#include "sub_cycling/FineParticles.hpp"

namespace Rhegma
{
class Archive;
}

namespace Rhegma::sub_cycling
{

/// Moves the nodes of fine cells in substeps through one step, and computes the equivalent force and velocity
/// of that step.
///
/// Particles of a class (FineParticles.hpp) act on the nodes by an impulse at the start of each step of their
/// class, and nodes drift between impulses: with h the length of a step of class l and f_l the force of its
/// particles where the nodes are now,
///
///     step(l, h):  v += h B f_l;   in the last class u += h v,   else step(l + 1, h / 2) twice.
///
/// The step is step(first - 1, dt), whose impulse is that of all other particles. Each impulse is the
/// gradient of an energy and each drift that of another, so with fixed weights the steps are symplectic in v
/// and u: energy stays bounded without damping, and momentum is kept to round-off since every f_l sums to
/// zero. Particles then get the sum of impulses over dt as their force, and u over dt as the velocity that
/// strains and moves them. The state after a step is that of its substeps, so weights and cells may change
/// from step to step. (A scheme that feeds back a mean force, as Diaz and Grote, SIAM J. Sci. Comput. 31
/// (2009) 1985, does not store the phase of motions with a period of about a step; in a body that moves
/// through its cells it gained energy at two levels and was unstable at three.)
///
/// Impulses at large intervals would excite a body at rest, and may resonate with motions of fine cells. So
/// only the change of a force acts in impulses: loads, and the mean of each force over some hundred steps,
/// act continuously; and each class has a border of coarser cells. Source: asynchronous variational
/// integrators, Lew, Marsden, Ortiz and West, Int. J. Numer. Meth. Engng 60 (2004) 153; impulses as
/// Tuckerman, Berne and Martyna, J. Chem. Phys. 97 (1992) 1990; the mass of MUSL.
template <int D>
class LocalSteps
{
public:
  /// Lists the particles of fine cells and separates the forces of the others. To be called when nodes have
  /// internal forces and no other. \param first, last levels that are subcycled; `first` takes two substeps
  void begin(State<D>& state, int first, int last);
  /// Changes the force of the nodes. To be called when nodes have all forces.
  void evolve(State<D>& state);
  /// Change the velocity after the solve and the projected one.
  void correctMotion(State<D>& state) const;
  void correctProjection(State<D>& state) const;

  /// Particle substeps in addition to the steps so far.
  double extraSteps() const { return extraSteps_; }

  /// Saves or loads their number.
  void serialize(Archive& archive);

  // What follows is public because compilers for devices want kernels in public functions.

  using Values = View<double* [D]>;
  void reserveRows(int slots);
  void step(const State<D>& state, int level, double length);
  /// Adds the impulse of a class to the pending ones.
  void addImpulse(const State<D>& state, int level, double length);
  /// Applies the pending impulses to the nodes, those of several classes at once.
  void kick(const State<D>& state);
  void drift(double length);
  /// Lets displacement-dependent forces record their work at the present velocity. \param duration [s]
  void recordWorkOfDependentForces(const State<D>& state, double duration) const;
  /// Applies the force of the whole step to nodes without fine particles.
  void finishOuterNodes();
  /// Whether the work of impulses is needed.
  static bool needsWork(const State<D>& state)
  {
    return state.clock.observing || !state.motion.constraints.empty();
  }
  /// Adds the work of a force at the start of the step. \param duration that it acts by then [s]
  void addStartWork(const State<D>& state, const Values& force, double duration);
  /// Records the work of supports in substeps, and leaves the remaining impulses in the state.
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
  Values loads_;  ///< continuous forces [N], then their acceleration [m/s2]
  Values force_;  ///< of particles of one class [N]
  Values start_[deepestLevel + 1];      ///< that of each class at the start of the step [N]
  Values mean_[deepestLevel + 1];       ///< of the force of each class [N]
  bool atStart_[deepestLevel + 1] = {}; ///< whether nodes have not moved since that of a class was computed
  Values waiting_;                      ///< pending impulses [N s]
  int waitingFrom_ = 0;                 ///< the lowest class among them
  bool atFirst_ = false;                ///< whether these are the first of the step
  Values impulse_;                      ///< so far [N s]
  Values velocity_, displacement_;      ///< so far
  double elapsed_ = 0.0;                ///< of the step so far [s]
  typename FineParticles<D>::ImpulseWork startWork_; ///< of the impulses at the start of the step
};

} // namespace Rhegma::sub_cycling
