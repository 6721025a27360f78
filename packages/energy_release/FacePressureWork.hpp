#pragma once
/// What a pressure on the faces of a crack adds to J along its fronts in 3D.

#include "energy_release/FrontLine.hpp"
#include "energy_release/FrontTube.hpp"
#include "energy_release/InternalAcceleration.hpp"

namespace Rhegma::energy_release
{

/// Whether anything presses on the faces of cracks (CrackSet::pressure).
bool isPressed(const State<3>& state);

/// Adds to the acceleration of nodes what the pressure gives them: the integral over the tube then leaves the
/// work of the pressure out, of which a good part is done within a cell of the front, where u,k is singular.
/// Collective.
void addAccelerationByPressure(const State<3>& state, const NodalAcceleration<3>& acceleration);

/// Adds that work to the configurational forces of nodes, as it follows by parts from the opening where it is
/// well known (Li, Shih and Needleman, Eng. Fract. Mech. 21 (1985) 405, for the term - int p [u_n],e q dS):
///
///     G_n = int p [u_n] grad N_n dS
///
/// over the triangles of the crack, grad in their plane, so that q is interpolated as FrontIntegral.hpp does
/// it in the body: what its kinks and turns weigh in one then weighs as much in the other. A pressure that
/// changes along the crack counts by its value only. Only what acts on nodes in the tube is added, on each
/// rank what acts on its own. Collective.
///
/// \param force of each row of nodes [N]
void addForceOfPressure(const State<3>& state, int crack, const FrontLine& line, const FrontTube& tube,
                        const View<double* [3]>& force);

} // namespace Rhegma::energy_release
