#pragma once
/// A dynamic run that starts in equilibrium under the loads at its start.

#include "plan/Plan.hpp"
#include "plan/RunOptions.hpp"

#include <Teuchos_ParameterList.hpp>

namespace Rhegma
{

/// Time > Initial State
namespace initialState
{
inline const char* const unloaded = "Unloaded";
inline const char* const equilibrium = "Equilibrium";
inline const char* const withoutCracks = "Equilibrium Without Cracks";
} // namespace initialState

/// Gives particles, and the faces of cracks if the equilibrium has them, the positions, stresses and
/// histories of the equilibrium under the loads at time 0. Velocities stay as they are. Throws
/// std::invalid_argument where the bodies can move freely, where there is no equilibrium, or where the
/// equilibrium has other particles. Ranks solve together; then each gets all of the equilibrium, as it has
/// all particles until they are divided. Collective. \param scene validated, of the dynamic run \param motion
/// that run, whose laws the equilibrium has \param state of it, before its first step, in its first cells
template <int D>
void startInEquilibrium(const Teuchos::ParameterList& scene, const MotionToCome& motion, const Plan<D>& plan,
                        State<D>& state);

} // namespace Rhegma
