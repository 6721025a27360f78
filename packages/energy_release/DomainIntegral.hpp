#pragma once
/// The energy release rate and the stress intensities of a front by integrals over a disk around it.

#include "energy_release/Contour.hpp"

namespace Rhegma::energy_release
{

struct DomainIntegral
{
  double J = 0.0;      ///< energy released per new area [J/m2]
  double modeI = 0.0;  ///< K_I [Pa m^0.5]
  double modeII = 0.0; ///< K_II, positive where side +1 slides ahead [Pa m^0.5]
};

/// Dynamic J and the interaction integrals of a front of a 2D scene.
///
///     J   = int (P_iJ u_i,1 - (W + T) d_1J) q,J + rho0 (a_i u_i,1 - v_i v_i,1) q  dV0 / thickness
///     M   = int (s_ij w_i,1 + z_ij u_i,1 - s_ij e_ij d_1j) q,j + rho a_i w_i,1 q  dV / thickness
///     K   = E' M / 2
///
/// with the kinetic energy density T and Williams' field of unit intensity w, z, e.
///
/// Without T, or with one of the two terms of inertia, J depends on the radii as soon as anything moves: a
/// plane wave has P_11 u_1,1 = W + T.
///
/// Loads inside the disk, such as pressure on the faces, are in the integrals when `a` is the acceleration by
/// internal forces alone (InternalAcceleration.hpp).
///
/// Displacement gradients and velocities are taken relative to the mean turn and motion of the disk, which
/// changes no integral of the exact field but keeps digits; so a turned body is measured in its turned frame.
///
/// M is for small strain and one linear material around the tip. K belongs to a tip at the front's place, J
/// to the tip that the cells have. The two differ by a fraction of a cell, so that K^2 / E' and J come
/// together only with the cells: in a double cantilever beam K is 4.1 % below the root of E' J with 8 cells
/// an arm, 2.2 % with 16; round a crack in a large plate (a = 8 cells) 0.8 % below in the mean, 1 % scatter.
///
/// \param acceleration of the nodes, a row a node [m/s2]
/// Source: Nishioka and Atluri, Eng. Fract. Mech. 18 (1983) 1; Li, Shih and Needleman, Eng. Fract. Mech. 21
/// (1985) 405; Yau, Wang and Corten, J. Appl. Mech. 47 (1980) 335.
DomainIntegral integrateDomain(const State<2>& state, const CrackFront<2>& front, const ContourRadii& radii,
                               const View<double* [2]>& acceleration);

/// The same with the acceleration by internal forces.
DomainIntegral integrateDomain(const State<2>& state, const CrackFront<2>& front, const ContourRadii& radii);

} // namespace Rhegma::energy_release
