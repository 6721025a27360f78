#pragma once
/// The particles that short steps move, and the nodes they touch, packed together for one long step.

#include "state/State.hpp"

namespace Rhegma::sub_cycling
{

/// Values of the nodes of small cells are kept in slots 0 .. numSlots - 1; sums over particles are formed in
/// a fixed number of parts, so that they do not depend on the number of threads.
template <int D>
class FineParticles
{
public:
  using Values = View<double* [D]>;

  /// Lists the particles with stored stencils that touch a node of a leaf of level `first` or deeper, and the
  /// nodes that these touch.
  void update(const State<D>& state, int first);

  int numSlots() const { return numSlots_; }
  int numParticles() const { return numParticles_; }

  /// Force of the nodes, and back [N].
  void load(const State<D>& state, const Values& force) const;
  void store(const State<D>& state, const Values& force) const;

  /// Displacement `factor` P B P force of the nodes of leaves of a level and deeper, held nodes at rest [m];
  /// zero elsewhere. B takes a force to the acceleration of the nodes, that to the particles, and back with
  /// their masses.
  void displace(const State<D>& state, int level, double factor, const Values& force,
                const Values& displacement);

  /// to = from - K displacement, of a displacement of nodes of a level and deeper. K holds the ties behind
  /// crack fronts too.
  void relax(const State<D>& state, int level, const Values& displacement, const Values& from,
             const Values& to);

  int particlesOf(int level) const;

private:
  void listParticles(const State<D>& state, int first);
  void listNodes(const State<D>& state);
  void holdNodes(const State<D>& state);
  void gatherParticles(const State<D>& state);
  void relaxTies(const State<D>& state, const Values& displacement, const Values& to) const;
  /// Zeroes the parts and runs add(particle, part) for the particles of a level and deeper.
  template <class Add>
  void sumInParts(const char* label, int level, const Add& add);

  int numParticles_ = 0, numSlots_ = 0, numParts_ = 0;
  View<int*> row_;       ///< stored stencil of each of the particles
  View<int*> rowLevel_;  ///< of every stored stencil: level of the smallest leaf around its nodes
  View<int*> level_;     ///< the same, of each of the particles
  View<int*> slotOf_;    ///< of every node, -1 where it has none
  View<int*> nodeOf_;    ///< of every slot
  View<int*> nodeLevel_; ///< of every slot
  View<double*> mass_;   ///< of every slot [kg]
  View<int* [D]> held_;  ///< of every slot
  View<double * [symmetricSize<D>]> stress_; ///< of each particle, by its law at its strain now [Pa]
  View<double** [D]> parts_;
  View<int*> count_; ///< of particles of each level
  int countOf_[deepestLevel + 1] = {};
};

} // namespace Rhegma::sub_cycling
