#pragma once
/// Springs and cohesive tractions between the two fields of nodes behind a front.

#include "cracks/NodalSprings.hpp"
#include "cracks/Sides.hpp"
#include "state/State.hpp"

#include <functional>
#include <utility>
#include <vector>

namespace Rhegma::cracks
{

/// Energy per area of the last face that each node of a front made [J/m2], at least one number.
/// \param front its index
template <int D>
using ToughnessAlong = std::function<std::vector<double>(const CrackSet<D>&, int front)>;

/// Front springs of the dual field.
///
/// Nodes open one by one, so that without springs the crack of the cells ends up to half a cell before or
/// behind its front. A spring between the two fields of a node that lies less than a cell behind the front
/// lets it open by as much as it lies behind (frontSpringStiffness). In motion, inertia is added to the
/// relative motion of the fields, with which a spring of any stiffness is stable (slowRelativeMotion); where
/// springs are limited, none is stiffer than its two masses allow in the step that their node takes. Two
/// opposite forces: momentum is exact. Measured: test InclinedCracks.
///
/// A spring follows the jump of the velocity that strains the particles, from the step in which its node gets
/// two fields; it is unstretched then, as a node that a front has just passed is closed. Where refined cells
/// change, a spring stays at its position if there is still a node. Its elastic energy counts as strain
/// energy. A stretched spring becomes softer as its front moves on, but never stiffer, as this would add
/// energy.
///
/// In motion a spring is damped (springs::damping): the masses of its node on the spring would oscillate next
/// to the front for the whole run, as grids radiate waves of a few cells poorly. Measured: study
/// sudden_cracks.py. What the damping takes is EnergyBalance::stabilised. Cracks whose fronts are advected
/// through the cells by a moving body lose their springs (AdvectedFronts.hpp).
///
/// Where fronts grow, a node that a front passes gets a cohesive traction instead (CohesiveLaw.hpp), and
/// springs of a front that is initiated soften to such tractions.
template <int D>
class FrontSprings
{
public:
  /// \param grows whether fronts may grow \param limited whether steps limit the stiffness of springs
  FrontSprings(bool grows, bool limited) : grows_(grows), limited_(limited) {}

  /// Finds the springs of this step, once nodes have masses, and leaves their stiffness in
  /// state.cracks.spring.
  void prepare(State<D>& state, const Surroundings& surroundings);

  /// Adds the forces of the springs to both fields of their nodes and leaves them in state.cracks.spring.
  void addForces(State<D>& state) const;

  /// Gives nodes that have got two fields behind a front that grows their traction, once all other forces on
  /// nodes are known (Release.hpp).
  void release(State<D>& state, const Surroundings& surroundings, const ToughnessAlong<D>& toughness);

  /// Energy of new faces that is not yet dissipated, of nodes and of fronts [J].
  /// \param step number of the last step, from 1
  double pendingEnergy(const State<D>& state, int step) const;

  /// The forces of springs on nodes that move in substeps: of front springs by their stiffness, of cohesive
  /// tractions by their law. These springs must outlive what is returned.
  DisplacementDependentForce<D> displacementDependentForce() const;

  /// Stretches the springs over the step.
  void advance(State<D>& state);

  /// Records the work that the damping of springs takes in a step as EnergyBalance::stabilised, on each rank
  /// that of its nodes. Call in stageOfFaceVelocity (plan/LastStage.hpp).
  void recordDamping(State<D>& state) const;

private:
  void readMaterials(const State<D>& state);
  void fitToNodes(State<D>& state);
  /// Adds the work of damping in a substep to dampedInSubsteps_ (DisplacementDependentForce::work).
  typename DisplacementDependentForce<D>::Work dampingInSubsteps() const;
  NodalSprings<D> springs(const State<D>& state) const
  {
    return {state.mesh.nodalFields.template real<NodalSpring<D>::size>(springField<D>().field.name), front_};
  }

  bool grows_, limited_;
  View<int*> front_;               ///< see NodalSprings
  View<double*> damping_;          ///< of the spring of each node in this step [N s/m]
  View<double* [D]> dampingForce_; ///< of damping on the primary field of each node, in this substep [N]
  View<double*> dampedInSubsteps_; ///< energy taken in the substeps of this step so far, of each node [J]
  int passed_ = 0;                 ///< nodes of this rank that wait for `release`
  NearestFront<D> frontOf_;        ///< of this step
  double modulus_ = 0.0;           ///< the smallest E' of the scene [Pa]
  double density_ = 0.0;           ///< the largest of the scene [kg/m3]
};

/// Sums an energy of nodes with two fields by the front that NodalSprings::front says, over all ranks [J].
template <int D>
std::vector<double> sumByFront(const State<D>& state, const NodalSprings<D>& springs,
                               const View<double*>& energyOfNode);

} // namespace Rhegma::cracks
