#pragma once
/// The energy release rate along a front in 3D by domain integrals.

#include "energy_release/FrontRows.hpp"
#include "energy_release/FrontTube.hpp"
#include "energy_release/InternalAcceleration.hpp"

#include <optional>
#include <vector>

namespace Rhegma::energy_release
{

/// Dynamic J [J/m2] at every front node of a front; none where no material is left in the tube, or where the
/// front is folded so that a shift along its directions makes no area.
///
///     J_s = sum_n q_s(n) e(n) . G_n / int q_s ds
///     G_n = sum_p V0 [(F^T tau - (W + T) F^T) grad N_n + rho0 (F^T a - (grad v F)^T v) N_n] less the terms
///           of the unit matrix in F^T
///
/// G_n are the nodes' configurational forces (Mueller and Maugin, Comput. Mech. 29 (2002) 52), e(n) is the
/// direction of the front at the point of it that is nearest to the node, so that a virtual advance follows a
/// curved front, and q_s = ramp(r) hat(s) with the ramp of ContourRadii and a hat of half width `halfWidth`
/// in arc length about the front node. q_s is interpolated by the functions of the motion, cuts included. The
/// denominator is the integral along the front of q_s e as the cells interpolate it: with the hat's own area
/// J would be low by as much as the ramp falls between the nodes next to the front.
///
/// Where temperature strains the material, W is the energy of the non-thermal strain, and dW/dT grad T N_n is
/// subtracted as in 2D. Turn, motion and loads are treated as in DomainIntegral.hpp. Collective.
///
/// \param crack of the front, the pressure on whose faces counts (FacePressureWork.hpp)
/// Source: Li, Shih and Needleman, Eng. Fract. Mech. 21 (1985) 405; Nikishkov and Atluri, Int. J. Numer.
/// Methods Eng. 24 (1987) 1801.
std::vector<std::optional<double>> integrateAlongFront(const State<3>& state, int crack,
                                                       const FrontLine& line, const FrontTube& tube,
                                                       InternalAcceleration<3>& acceleration);

/// The same with what is reused.
std::vector<std::optional<double>> integrateAlongFront(const State<3>& state, int crack,
                                                       const FrontLine& line, const FrontTube& tube,
                                                       InternalAcceleration<3>& acceleration,
                                                       const FrontWork<3>& kept);

/// The same with a given acceleration of nodes.
std::vector<std::optional<double>> integrateWithAcceleration(const State<3>& state, const FrontLine& line,
                                                             const FrontTube& tube,
                                                             const NodalAcceleration<3>& acceleration);

/// The particles that give the nodes in the integrals of a front their acceleration.
Region<3> accelerationRange(const State<3>& state, const FrontLine& line, const FrontTube& tube);

} // namespace Rhegma::energy_release
