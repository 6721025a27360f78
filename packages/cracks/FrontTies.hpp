#pragma once
/// Springs and cohesive forces between the two fields of nodes behind a front.

#include "cracks/Cohesion.hpp"
#include "cracks/Sides.hpp"
#include "cracks/TieMemory.hpp"
#include "state/State.hpp"

#include <memory>
#include <utility>
#include <vector>

namespace Rhegma
{
class Archive;
}

namespace Rhegma::cracks
{

template <int D>
class CrackGrowth;

/// Ties of the dual field.
///
/// Nodes open one by one, so that without ties the crack of the cells ends up to half a cell before or behind
/// its front. A spring between the two fields of a node that lies less than a cell behind the front lets it
/// open by as much as it lies behind:
///
///     k = 0.1 E' b (1 - xi) / xi (1 - z),   xi = sqrt(c) behind / dx + 0.05,
///
/// c the larger component of the normal, as springs reach a little further across the cells, E' of fracture
/// mechanics, b the thickness (2D) or dx times the filled share of the node's cells (3D), z the node's
/// distance from the crack along the axis nearest to its normal, in cells, so that the nodes above and below
/// share one spring. The 0.05 keeps the springs finite; for the same reason none is stiffer than its two
/// masses allow in the step that their node takes (with Sub-Cycling the short one). Two opposite forces:
/// momentum is exact. Measured: test InclinedCracks.
///
/// A spring follows the jump of the velocity that strains the particles, from the step in which its node gets
/// two fields; it is unstretched then, as a node that a front has just passed is closed. Where refined cells
/// change, a spring stays at its place if there is still a node. Its elastic energy counts as strain energy.
///
/// A stretched spring slackens where its place wants that, but never stiffens, as this would make energy.
/// Cracks whose fronts a moving body carries through the cells go on without ties (CarriedFronts.hpp).
///
/// Where fronts grow, a node that a front passes gets a cohesive force instead (Cohesion.hpp), and springs of
/// a front that has set out become such forces.
template <int D>
class FrontTies
{
public:
  /// \param grows whether fronts may grow
  explicit FrontTies(bool grows) : grows_(grows), memory_(grows) {}

  /// Tells what 3D fronts do; needed before `release` where they grow.
  void follow(std::shared_ptr<const CrackGrowth<3>> surface) { surface_ = std::move(surface); }

  /// Notes the toughness of the advances that fronts of 2D are about to make: faces that a body's motion
  /// opens later cost the same. To be called before cracks grow.
  void note(const std::vector<FrontAdvance<D>>& advances);

  /// Finds the ties of this step, once nodes have masses, and leaves their stiffness in state.cracks.tie.
  void prepare(State<D>& state, const Surroundings& surroundings);

  /// Adds the forces of the ties to both fields of their nodes and leaves them in state.cracks.tie.
  void addForces(State<D>& state) const;

  /// Gives nodes that have got two fields behind a front that grows the force that held them together, once
  /// all other forces on nodes are known, and the energy that it will take.
  void release(State<D>& state, const Surroundings& surroundings);

  /// What is still to be spent on opening faces whose forces have not come to an end [J]. \param step as in
  /// keep
  double energyInFlight(const State<D>& state, int step) const;

  /// How the forces follow nodes that move in short steps: springs by their stiffness, cohesive forces by
  /// their law. These ties must outlive what is returned.
  FollowingForce<D> following() const;

  /// Stretches the ties over the step.
  void advance(State<D>& state);

  /// Saves or loads the jumps of the nodes that had two fields in the last step. \param step its number, from
  /// 1
  void keep(State<D>& state, int step, Archive& archive);

private:
  void readMaterials(const State<D>& state);
  void placeFronts(const State<D>& state);
  /// Deducts from the new faces of each front what its nodes took beyond their energy. \param torn that of
  /// each front on this rank [J]
  void deduct(State<D>& state, std::vector<double> torn);

  bool grows_;
  TieMemory<D> memory_;
  std::shared_ptr<const CrackGrowth<3>> surface_;
  std::vector<double> debt_; ///< energy that softened ties of each front take instead of its new faces [J]
  std::vector<double>
      torn_; ///< what nodes took beyond their energy, not yet deducted, of each front [J] (2D)
  std::vector<double> toughness_; ///< of the last advance of each front that has made one [J/m2] (2D)
  int waiting_ = 0;               ///< nodes that wait for `release`
  View<double * [D + 1]> fronts_; ///< place of each front, and 1 + its crack if it has grown, else 0
  double modulus_ = 0.0;          ///< the smallest E' of the scene [Pa]
  double density_ = 0.0;          ///< the largest of the scene [kg/m3]
};

/// Gives what nodes would yet take back to the fronts nearest to them, for the nodes that come next, if these
/// nodes are whole again: a front in 3D that evens out may draw back by a part of a cell. Collective. \param
/// fronts as NearestFront's \param stamp number of the step
void giveBack(State<3>& state, const TieMemory<3>& memory, const View<double* [4]>& fronts, int stamp);

} // namespace Rhegma::cracks
