#pragma once
/// Stiffness of orthotropic materials from their engineering constants.

#include "base/Types.hpp"

#include <array>
#include <string>

namespace Rhegma
{

/// Of strain to stress, in the order of symmetricIndex<3>: xx, yy, zz, xy, yz, xz; shear strains are twice
/// the components of the tensor [Pa].
using Stiffness = std::array<std::array<double, 6>, 6>;

/// Poisson's ratio 12 is minus the strain along axis 2 over that along axis 1 under a stress along axis 1.
struct OrthotropicConstants
{
  std::array<double, 3> young;   ///< along axes 1, 2 and 3 [Pa]
  std::array<double, 3> poisson; ///< 12, 23, 13
  std::array<double, 3> shear;   ///< 12, 23, 13 [Pa]
};

/// The inequality, with its numbers, that keeps these constants from being those of a material with a
/// positive energy; empty if there is none. Source: Lempriere, AIAA J. 6 (1968) 2226.
std::string failedInequality(const OrthotropicConstants& constants);

/// \param axes unit vectors of the axes 1, 2 and 3 in the body
Stiffness stiffnessOf(const OrthotropicConstants& constants, const std::array<Vector<3>, 3>& axes);

/// Mean moduli over all directions at a given strain: those of the isotropic stiffness that is nearest to
/// this one (Voigt, Lehrbuch der Kristallphysik, 1928; Norris, J. Elasticity 84 (2006) 51) [Pa].
double meanBulkModulus(const Stiffness& C);
double meanShearModulus(const Stiffness& C);

/// Stiffness of a thin plate in the plane xy. The rows and columns of zz become zero.
/// \param thickness gets -e_zz for unit strains xx, yy and xy
Stiffness reducedStiffness(const Stiffness& C, std::array<double, 3>& thickness);

/// Range of density times squared speed of plane waves at small strain [Pa].
struct WaveModuli
{
  double fastest; ///< of all waves in all directions
  double slowest; ///< of the slowest wave of a direction, the largest over all directions: no wave along a
                  ///< free surface is as fast
};
/// \param dimension 2: of waves in the plane xy that move it
WaveModuli waveModuli(const Stiffness& C, int dimension);

} // namespace Rhegma
