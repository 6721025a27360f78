#pragma once
/// The subcycled particles and their nodes, packed for one step.

#include "base/SmallLoops.hpp"
#include "state/State.hpp"
#include "sub_cycling/NearParticles.hpp"

#include <memory>
#include <string>
#include <vector>

namespace Rhegma::sub_cycling
{

/// Number of slots below which a kernel runs faster on one thread.
constexpr int smallSlots = 1500;

/// The nodal field in which the mean of the force of a class of particles is kept: D numbers and that of the
/// step that renewed it. \param classFromFirst 0: all particles that take the whole step
inline std::string meanForceField(int classFromFirst)
{
  return "mean force of class " + std::to_string(classFromFirst);
}

/// Listed are particles of classes `first` and deeper, the deepest first, and after them their neighbours,
/// which touch one of the same nodes. The class of a node is the level of the smallest leaf that a particle
/// on it reaches; the class of a particle is that of its deepest node. So each class has a border of one
/// particle reach in coarser cells: motions that only fine cells resolve are small at its edge, where the
/// impulses of the next class act (LocalSteps.hpp). Nodes of the listed classes have slots 0 .. numInner - 1,
/// other nodes of neighbours slots up to numSlots - 1; all nodal values here are kept in slots. Sums over
/// particles are formed in a fixed number of parts, so that they do not depend on the number of threads.
/// Where ranks share nodes these have the same class and a slot on all of them, and values in their slots are
/// those of all ranks. Weights, sides of cracks and supports are those at the start of the step.
template <int D>
class FineParticles
{
public:
  using Values = View<double* [D]>;

  /// Collective, as are `load` and `accelerate`.
  void select(const State<D>& state, int first);

  /// Without neighbours, on all ranks.
  double numParticles() const { return onAllRanks_[first_]; }
  /// How many on all ranks are of a class or deeper.
  double particlesFrom(int level) const { return onAllRanks_[level]; }
  int numSlots() const { return numSlots_; }
  int numInner() const { return numInner_; }

  /// Completes values of slots to which each rank has added its part. Collective.
  void sumSlots(const State<D>& state, const Values& values) const;

  /// Reads the force of the nodes in `state` [N].
  void load(const State<D>& state, const Values& force) const;
  /// Writes a force times a factor to the inner nodes in `state`.
  void store(const State<D>& state, const Values& force, double factor) const;

  /// Velocity of the nodes at the start of the step, that of supports where they hold [m/s]. To be called
  /// before impulses change it or their work is computed.
  void startVelocity(const State<D>& state, const Values& velocity);

  /// Internal force of the particles of one class after the nodes moved by `displacement` [m] since the start
  /// of the step: -V0 tau (1 + grad u)^-T grad N, tau by the particle's law at (1 + grad u) F, and the
  /// temperature to which that brings it where there is heat, which for an elastic law is the gradient of its
  /// energy and has no resultant and no torque. This rank's part. \param duration of the motion [s]
  void force(const State<D>& state, int level, const Values& displacement, double duration,
             const Values& force);

  /// Impulses on inner nodes as they change the energy.
  struct ImpulseWork
  {
    double free = 0.0; ///< where nothing holds: times the velocity at the start of the step [J]
    double held = 0.0; ///< at supports that hold coupled masses: times half the change of velocity that they
                       ///< force upon the node [J]
  };
  /// Of the nodes that count on this rank.
  ImpulseWork workOf(const State<D>& state, const Values& impulse) const;

  NodeSlots slots() const { return {slotOf_, numInner_}; }

  /// Writes the fraction of the step that the force of its start acts on listed particles: half of it for
  /// the first class, a quarter for the next.
  void writeFirstFractions(const State<D>& state, const BorrowedView<double*>& fraction) const;

  /// Mean of a force over the last steps, on inner nodes that had a slot in all of them; it grows from
  /// zero elsewhere, and everywhere after cells changed. \param level of the particles whose force it is, or
  /// one below the first: of all others
  void smooth(const State<D>& state, int level, const Values& force, const Values& mean);

  /// velocity += duration B force, of a force on nodes of particles of class `level` and deeper. B is what a
  /// step of MUSL makes of a force: to accelerations of nodes, to the particles, and back to the nodes by
  /// their masses, which may couple them (CoupledSlots). Nothing moves where supports hold, but where
  /// `supports` is set they first take nodes to their velocity, as they do once a step, and particles feel
  /// it.
  void accelerate(const State<D>& state, int level, double duration, const Values& force,
                  const Values& velocity, bool supports = false);

  /// Adds (displacement / duration - velocity) to the velocity after the solve, which moves cracks and by
  /// which work is computed, where no support holds.
  void correctMotion(const State<D>& state, const Values& displacement, double duration,
                     const Values& velocity) const;
  /// The same for the velocity that strains and moves particles.
  void correctProjection(const State<D>& state, const Values& displacement, double duration,
                         const Values& velocity) const;

  // What follows is public because compilers for devices want kernels in public functions.

  /// Lists the nodes that each candidate touches: they decide on all lists below.
  void findTouched(const State<D>& state);
  void classifyNodes(const State<D>& state);
  /// Gives shared nodes the deepest class that any rank has given them. Collective.
  void fractionClasses(const State<D>& state);
  void listParticles(const State<D>& state);
  /// Lists the candidates of a class after the first `before` listed ones. \return the number of listed ones
  int listClass(int own, int before);
  /// Gives the nodes of listed particles begin .. end - 1 the class `own`, or where `onlyNew` only those
  /// without one.
  void markNodes(int begin, int end, int own, bool onlyNew);
  void numberSlots(const State<D>& state, int from);
  void listNeighbours();
  void packStencils(const State<D>& state);
  void holdNodes(const State<D>& state);
  void weighNodes(const State<D>& state);
  /// Forces of one class in parts, with the slopes of the scene's ShearStrain H. \param trial tau of a
  /// particle after a displacement gradient
  template <ShearStrain H, class Trial>
  void sumForces(const State<D>& state, int level, const Values& displacement, const Trial& trial);
  /// Sums the parts of each slot, in their order.
  void addParts(const Values& sum) const;
  /// Makes the relative acceleration of the fields of nodes smaller by added inertia (slowRelativeMotion).
  void slowRelativeMotion(const State<D>& state, const Values& acceleration) const;
  /// The acceleration of the nodes to the particles that touch a node of class `lowest` or deeper, and that
  /// of the particles, times their mass, to the nodes, in parts.
  void roundTrip(const State<D>& state, int lowest);
  /// Zeroes the parts and runs add(particle, sums of its part) for particles begin .. end - 1.
  template <class Add>
  void sumInParts(const char* label, int begin, int end, const Add& add);

private:
  int first_ = 0;
  StencilSource madeOf_; ///< of the stencils that are listed
  int numListed_ = 0;    ///< with neighbours
  int numSlots_ = 0, numInner_ = 0, numParts_ = 0;
  int particlesFrom_[deepestLevel + 2] = {};
  double onAllRanks_[deepestLevel + 2] = {};
  View<double*> reported_;                   ///< by ranks of the class of every shared node
  NearParticles<D> candidates_;              ///< for the list
  View<int*> class_;                         ///< of each of these
  View<int*> numTouched_;                    ///< nodes that each of these touches
  View<int * [stencilCapacity<D>]> touched_; ///< these nodes
  View<int*> particle_;                      ///< those listed
  View<int*> listed_;                        ///< the same, by their numbers among the candidates
  View<int*> reach_;                         ///< of each of them: class of its deepest node
  View<int*> nodeClass_;                     ///< of every node; 0 for outer ones, -1 for those without a slot
  View<int*> slotOf_;                        ///< of every node, -1 where it has none
  View<int*> nodeOf_;                        ///< of every slot
  View<int*> count_;                         ///< nodes of each of the particles
  View<int * [stencilCapacity<D>]> slot_;    ///< of the nodes of each particle
  View<double * [stencilCapacity<D>]> weight_;
  View<double***> slope_; ///< of each node of each particle, as ComponentSlopes has them
  View<double*> mass_;    ///< of every slot [kg]
  View<int* [D]> held_;
  View<double* [D]> heldVelocity_;
  Values before_; ///< velocity at the start of the step before supports hold [m/s]
  Values acceleration_, momentum_;
  View<double** [D]> parts_;
};

} // namespace Rhegma::sub_cycling
