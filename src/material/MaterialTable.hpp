#pragma once
/// From the Materials section of a scene to the numbers of kernels.

#include "material/Law.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace Rhegma
{

/// Reads one sublist of `Materials`: `Model`, the name of a law, `Density`, and what the law's `read` takes.
/// \param plane Solid in 3D. \throws std::invalid_argument the path, such as `Materials > Steel > Poisson
/// Ratio`, what is wrong, what to write
Properties makeProperties(const Teuchos::ParameterList& material, const std::string& name, Plane plane);

/// Whether the law of a name has a use for Specific Heat in scenes without heat.
bool warmsWithoutHeat(const std::string& model);

/// Why the law of a material can't be used in a scene with heat; null where it can.
const char* refusesHeat(const Properties& properties);

/// Names of the laws that have a damage; at least one.
const std::vector<std::string>& lawsWithDamage();

/// Stress in tension at which a material first flows; 0 where it does not [Pa].
double firstYield(const Properties& properties);

/// Density times the square of the largest speed of waves at small strain [Pa] (LawStiffness.hpp).
double stiffestModulus(const Properties& properties);

/// Moduli at small strain, the same for every law; of an anisotropic one means over all directions, but for
/// the last.
struct Elasticity
{
  double young;              ///< [Pa]
  double poisson;            ///< [-]
  double shear;              ///< [Pa]
  double lambda;             ///< Lame's first parameter of the solid [Pa]
  double effectiveModulus;   ///< E' of fracture mechanics: E in plane stress, else E / (1 - nu^2) [Pa]
  double constrainedModulus; ///< of the fastest wave: lambda + 2 mu, in plane stress E / (1 - nu^2) [Pa]
};

inline Elasticity elasticity(const Properties& properties)
{
  const double mu = properties.mu;
  const double bulk = properties.bulk;
  Elasticity e;
  e.young = 9.0 * bulk * mu / (3.0 * bulk + mu);
  e.poisson = (3.0 * bulk - 2.0 * mu) / (6.0 * bulk + 2.0 * mu);
  e.shear = mu;
  e.lambda = properties.lambda;
  e.effectiveModulus = properties.plane == Plane::Stress ? e.young : e.young / (1.0 - e.poisson * e.poisson);
  e.constrainedModulus = stiffestModulus(properties);
  return e;
}

} // namespace Rhegma
