#pragma once
/// The velocity of a tool with a mass and the impulses of its contacts.

#include "material/FrictionLaw.hpp"

#include <vector>

namespace Rhegma::rigid_tools
{

/// A field of a node that a tool with a mass may press on.
template <int D>
struct FieldAtTool
{
  double mass = 0.0;    ///< [kg]
  Vector<D> normal{};   ///< unit normal out of the tool, along free axes; zero: there is no contact
  Vector<D> velocity{}; ///< without the impulse of the tool [m/s]
  bool free[D]{};       ///< axes that no support holds
};

/// A tool with a mass as it moves without contact.
template <int D>
struct MovingMass
{
  double mass = 0.0; ///< [kg]
  Vector<D> alone{}; ///< velocity without the impulses of its contacts [m/s]
  Vector<D> guess{}; ///< with them, to begin with; along axes that do not move it is kept [m/s]
  bool moves[D]{};   ///< axes along which impulses change its velocity
  FrictionLaw law{}; ///< of its surface
};

/// The velocity of the tool, and what each field gets from it.
template <int D>
struct FreeVelocity
{
  Vector<D> velocity{};                    ///< of the tool [m/s]
  std::vector<ContactImpulse<D>> contacts; ///< in the order of the fields
  int cut = 0; ///< contacts that slide with less friction than their law has, because no other solution was
               ///< found
};

/// Finds the velocity of a tool with a mass: its momentum changes by the opposite of the impulses that the
/// fields get at this velocity.
///
/// Newton's method on the balance of momentum, where a step is taken only if the residual falls. Where this
/// ends without a solution, friction is given as a bound for each contact: then impulses are the gradient of
/// a convex function of the velocity, and its minimum is always found. The bounds follow the pressure. If
/// they do not settle, those that are too large are lowered only, until none is: then there is a solution
/// in which friction is nowhere larger than its law allows, and in some contacts (`cut`) smaller. It also
/// conserves momentum, takes energy, and leaves no velocity of bodies into the tool.
template <int D>
FreeVelocity<D> findFreeVelocity(const MovingMass<D>& tool, const std::vector<FieldAtTool<D>>& fields);

} // namespace Rhegma::rigid_tools
