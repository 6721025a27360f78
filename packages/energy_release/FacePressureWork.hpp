#pragma once
/// The contribution of a pressure on the faces of a crack to J along its fronts in 3D.

#include "energy_release/ConfigurationalForces.hpp"
#include "energy_release/ForceOfPressure.hpp"
#include "energy_release/FrontLine.hpp"
#include "energy_release/FrontTube.hpp"

namespace Rhegma::energy_release
{

/// Adds the work of the pressure to the configurational forces of nodes, which are without it
/// (ForceOfPressure.hpp), as it follows from the opening, by integration by parts, where the opening
/// is accurate (Li, Shih and Needleman, Eng. Fract. Mech. 21 (1985) 405, for the term - int p [u_n],e q dS):
///
///     G_n = int p [u_n] grad N_n dS
///
/// over the triangles of the crack, grad in their plane, so that q is interpolated as FrontIntegral.hpp does
/// it in the body: its kinks and turns then have the same weight in both. The gradient of a pressure along
/// the crack is neglected. Only forces on nodes in the tube are added, on each rank those on its own nodes.
/// Collective.
///
/// \param force of each row of nodes [N]
void addForceOfPressure(const State<3>& state, int crack, const FrontLine& line, const FrontTube& tube,
                        const ConfigurationalForces& force);

} // namespace Rhegma::energy_release
