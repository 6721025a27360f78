#pragma once
/// The energy release rate and the stress intensities of a front by integrals over a disk around it.

#include "energy_release/Contour.hpp"
#include "energy_release/FrontRows.hpp"
#include "energy_release/InternalAcceleration.hpp"

#include <optional>

namespace Rhegma::energy_release
{

struct DomainIntegral
{
  double J = 0.0;         ///< energy released per new area [J/m2]
  double modeI = 0.0;     ///< K_I [Pa m^0.5]
  double modeII = 0.0;    ///< K_II, positive where side +1 slides ahead [Pa m^0.5]
  double tipOffset = 0.0; ///< how far the tip of the crack in the cells lies ahead of the front [m]
  bool lost = false;      ///< no material is left in the disk, so that there is nothing to integrate over
};

/// Dynamic J and the interaction integrals of a front of a 2D scene.
///
///     J   = int (P_iJ u_i,1 - (W + T) d_1J) q,J + rho0 (a_i u_i,1 - v_i v_i,1) q  dV0 / thickness
///     M   = int (s_ij w_i,1 + z_ij u_i,1 - s_ij e_ij d_1j) q,j + rho a_i w_i,1 q  dV / thickness
///     M   = 2 H K, such as M_I = 2 K_I / E' in an isotropic body
///
/// with the kinetic energy density T and the singular field w, z, e of unit intensity of a mode, of a
/// straight crack in the material at the front (CrackTipFields.hpp); H is the matrix of J = K^T H K
/// (CrackCompliance).
///
/// Where temperature (here t) strains the body or changes its moduli, W is the energy of the non-thermal part
/// of the strain, and J and M have an additional term for the change of temperature with a shift of the disk
/// at fixed strain:
///
///     J  -= int dW/dt t,1 q  dV0 / thickness,     dW/dt = -alpha tr s + W(d moduli / dt)
///     M  += int alpha t,1 tr z q  dV / thickness
///
/// M takes moduli at the temperature of the front, the same in all of the disk.
///
/// Without T, or with one of the two terms of inertia, J depends on the radii as soon as anything moves: a
/// plane wave has P_11 u_1,1 = W + T.
///
/// Where the crack turns inside the disk, J is that of a shift of the disk along the crack (q a vector along
/// it, in the front's direction ahead of it), as faces across the shift would add to it.
///
/// Loads inside the disk are in the integrals when `a` is without them (InternalAcceleration.hpp). The work
/// of tractions on the faces, such as a pressure or those of contact, is added as it follows from the faces
/// (FaceTractions.hpp). Where all faces inside of the disk press on each other, their tractions are replaced
/// by their mean and scaled so that K_I is that of the opening: M would be the small difference of large
/// numbers.
///
/// Displacement gradients and velocities are taken relative to the mean turn and motion of the disk, which
/// changes no integral of the exact field but reduces round-off; a rotated body is measured in its turned
/// frame.
///
/// M is for small strain and one linear material around the tip.
///
/// Nodes open one by one, so that the crack in the cells ends up to a cell before or behind the front. Its
/// field around the front is K (w - c w,1 + ...), c the offset of its tip. A field w about the wrong position
/// mistakes a fraction of the next terms of the real field for K: where they are large, as in slender arms, K
/// is off by c over a quarter of the arm's height (4 % with 8 cells an arm), though J is not. The offset
/// follows from reciprocity, and w is taken about front + c:
///
///     R   = int (s_ij w_i - z_ij u_i) q,j + (rho a_i w_i - (theta - 1) tr z) q  dV / thickness = c M
///     c   = (R_I M_I + R_II M_II) / (M_I^2 + M_II^2)
///
/// Across the crack, w is taken about the cut between the particles where q falls: a crack along the cells
/// lies up to a quarter of a cell from the middle between its two rows of particles, which would show as a
/// K_II of a fiftieth of K_I.
///
/// K, like J, thus belongs to the crack in the cells, and K^T H K = J but for quadrature.
///
/// \param acceleration of the nodes, a row a node [m/s2]
/// Source: Nishioka and Atluri, Eng. Fract. Mech. 18 (1983) 1; for heat Wilson and Yu, Int. J. Fract. 15
/// (1979) 377, and Shih, Moran and Nakamura, Int. J. Fract. 30 (1986) 79; Li, Shih and Needleman, Eng. Fract.
/// Mech. 21 (1985) 405; Yau, Wang and Corten, J. Appl. Mech. 47 (1980) 335; for anisotropic bodies Wang, Yau
/// and Corten, Int. J. Fract. 16 (1980) 247; for R Bueckner, ZAMM 50 (1970)
/// 529, and Stern, Becker and Dunham, Int. J. Fract. 12 (1976) 359.
DomainIntegral integrateDomain(const State<2>& state, const CrackFront<2>& front, const ContourRadii& radii,
                               const NodalAcceleration<2>& acceleration);

/// J alone [J/m2], for less; none where no material is left in the disk.
std::optional<double> integrateRelease(const State<2>& state, const CrackFront<2>& front,
                                       const ContourRadii& radii, const NodalAcceleration<2>& acceleration);

/// The same with what is reused.
DomainIntegral integrateDomain(const State<2>& state, const CrackFront<2>& front, const ContourRadii& radii,
                               const NodalAcceleration<2>& acceleration, const FrontWork<2>& kept);
std::optional<double> integrateRelease(const State<2>& state, const CrackFront<2>& front,
                                       const ContourRadii& radii, const NodalAcceleration<2>& acceleration,
                                       const FrontWork<2>& kept);

/// The particles that give the nodes in the integrals of a front their acceleration.
Disk accelerationRange(const State<2>& state, const CrackFront<2>& front, const ContourRadii& radii);

/// The same with the acceleration by internal forces, which is found here.
DomainIntegral integrateDomain(const State<2>& state, const CrackFront<2>& front, const ContourRadii& radii,
                               InternalAcceleration<2>& acceleration);

} // namespace Rhegma::energy_release
