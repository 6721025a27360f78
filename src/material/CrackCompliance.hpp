#pragma once
/// What the fields around a crack in 2D need of a material, isotropic or not.

#include "material/PlaneStiffness.hpp"

#include <Kokkos_Complex.hpp>

namespace Rhegma
{

/// Compliance in the plane along the axes of a crack's front, with Lekhnitskii's parameters: the roots mu in
/// the upper half plane of
///
///     a11 mu^4 - 2 a16 mu^3 + (2 a12 + a66) mu^2 - 2 a26 mu + a22 = 0,
///
/// with which displacement and stress follow from analytic functions of x1 + mu x2. An isotropic material has
/// both roots i. The stress intensities give
///
///     J = modeI K_I^2 + 2 coupled K_I K_II + modeII K_II^2,
///
/// in an isotropic material with 1/E', 0 and 1/E'; and the jump of displacement behind the front,
///
///     [u_2] = 8 sqrt(r / 2 pi) (modeI K_I + coupled K_II),   [u_1] = 8 sqrt(r / 2 pi) (coupled K_I + modeII
///     K_II).
///
/// Sources: Lekhnitskii, Theory of Elasticity of an Anisotropic Elastic Body; Sih, Paris and Irwin, Int. J.
/// Fract. Mech. 1 (1965) 189.
struct CrackCompliance
{
  double a11, a12, a16, a22, a26;  ///< strain of stress; shear strain is 2 e_12 [1/Pa]
  Kokkos::complex<double> root[2]; ///< mu_1 and mu_2
  Kokkos::complex<double> product; ///< of both
  /// Displacement along both axes is of p f: p of mu_1, a11 mu^2 + a12 - a16 mu and a12 mu + a22 / mu - a26,
  /// and its divided difference over both roots.
  Kokkos::complex<double> p[2], slope[2];
  double modeI, modeII, coupled; ///< of J [1/Pa]

  /// J of stress intensities [J/m2].
  KOKKOS_INLINE_FUNCTION double release(double K1, double K2) const
  {
    return modeI * K1 * K1 + 2.0 * coupled * K1 * K2 + modeII * K2 * K2;
  }
};

/// \param direction, normal axes of the front in the undeformed body, at right angles and of length one, of
/// either handedness
CrackCompliance crackCompliance(const PlaneStiffness& stiffness, const Vector<2>& direction,
                                const Vector<2>& normal);

} // namespace Rhegma
