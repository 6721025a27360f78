#pragma once
/// What every constitutive law shares: its kind, its numbers, and the size of its history.
///
/// A law is a struct with three static members, each a template of the dimension and of the plane:
///
///     bool   stress<D, P>(properties, F, tau, history)     once per particle and step
///     double energy<D, P>(properties, F, history)          [J/m3], stored, per undeformed volume
///     double waveSpeed<D, P>(properties, F, history)       [m/s], in space, relative to the material
///
/// `F` is the deformation gradient (gradientSize<D>), `tau` the Kirchhoff stress J sigma [Pa]
/// (symmetricSize<D>), so that the force of a particle on a node is -V0 tau grad N. In plane stress `stress`
/// writes the thickness stretch that lets tau_zz vanish into F[4]; on entry F[4] is only the place where the
/// search starts. `stress` returns false, with tau zero, when F is inverted or not a number: the run can't go
/// on. `waveSpeed` and `energy` want the F that `stress` has completed. `waveSpeed` is an upper bound of the
/// speed of every small plane wave in the deformed state, and is the dilatational wave speed where F = 1.

#include "base/Types.hpp"

namespace Rhegma
{

enum class LawKind : int
{
  LinearElastic,
  NeoHookean,
  MooneyRivlin,
  J2Plastic
};

/// Numbers of one material; plain data for a View<Properties*>. `makeProperties` (MaterialTable.hpp) fills
/// it. lambda, mu and bulk are set for every law: they are its moduli at small strain.
struct Properties
{
  LawKind kind = LawKind::LinearElastic;
  Plane plane = Plane::Solid;
  double density = 0.0;        ///< of the undeformed material [kg/m3]
  double lambda = 0.0;         ///< Lame's first parameter [Pa]
  double mu = 0.0;             ///< shear modulus [Pa]
  double bulk = 0.0;           ///< bulk modulus [Pa]
  double planeLambda = 0.0;    ///< lambda, in plane stress 2 lambda mu / (lambda + 2 mu) [Pa]
  double thicknessRatio = 0.0; ///< lambda / (lambda + 2 mu), contraction of the thickness in plane stress [-]
  double c10 = 0.0;            ///< Mooney-Rivlin [Pa]
  double c01 = 0.0;            ///< Mooney-Rivlin [Pa]
  double yield = 0.0;          ///< J2: initial yield stress [Pa]
  double hardening = 0.0;      ///< J2: linear isotropic hardening modulus [Pa]
  double saturation = 0.0;     ///< J2: by how much Voce hardening raises the yield stress in the end [Pa]
  double saturationRate = 0.0; ///< J2: exponent of Voce hardening [-]
};

/// Numbers that a law keeps per particle. All zero is the undeformed, unused material.
/// J2: plastic deformation (symmetricSize<D>), equivalent plastic strain, dissipated energy.
constexpr int historySize(LawKind kind, int dimension)
{
  return kind == LawKind::J2Plastic ? (dimension == 2 ? 4 : 6) + 2 : 0;
}

/// Places in the history of the J2 law.
template <int D>
constexpr int plasticStrainIndex = symmetricSize<D>;
template <int D>
constexpr int dissipationIndex = symmetricSize<D> + 1;

} // namespace Rhegma
