#pragma once
/// How much the loads, supports and velocities of a scene strain its bodies: nominal values from the strength
/// of materials, good to an order of magnitude.

#include "plausibility/BodyMeasures.hpp"
#include "plausibility/HistoryRange.hpp"

#include <Teuchos_ParameterList.hpp>

#include <map>
#include <string>
#include <vector>

namespace Rhegma
{

/// What one load, support or velocity does to a body.
struct LoadEstimate
{
  std::string where;    ///< its path in the scene
  double strain = 0.0;  ///< nominal: of a section that shares the load evenly [-]
  double stress = 0.0;  ///< that strain times Young's modulus [Pa]
  double highest = 0.0; ///< stress that is hardly exceeded: of bending over the longest lever, or of the
                        ///< impact [Pa]
  bool linear = false;  ///< the law of the body that it strains most is linear elastic
};

/// One for each load, moving support and moving body, at the largest value of its history and in the body
/// that it strains most; those without effect are left out. Stresses: traction t; force F over the section V
/// / L, in bending F / A (1 + 6 L / H) at most; gravity rho g L; spin rho w^2 L^2 / 4; impact rho c v / 2
/// (Kolsky, Stress Waves in Solids, 1953); supports that move apart by u: E u H / L^2. \param scene
/// validated; only sections of the core are read \param bodies of measureBodies
template <int D>
std::vector<LoadEstimate> estimateLoads(const Teuchos::ParameterList& scene, const State<D>& state,
                                        const std::vector<BodyMeasure<D>>& bodies);

/// Of pressures on faces of cracks: they strain the softest body as an even stress does. \param pressures
/// functions of time by their paths in the scene [Pa] \param end of the run [s]
template <int D>
std::vector<LoadEstimate> estimatePressures(const std::map<std::string, std::string>& pressures, double end,
                                            const std::vector<BodyMeasure<D>>& bodies);

/// The one with the largest nominal strain that is a finite number, or null.
const LoadEstimate* largestStrain(const std::vector<LoadEstimate>& loads);

/// Force of a Traction, Point Load or Line Load at a history of 1 [N]; zero for another type.
/// \param scene validated \param list of the boundary
template <int D>
Vector<D> forceOf(const Teuchos::ParameterList& scene, const Teuchos::ParameterList& list);

/// Area of the surface that a boundary chooses (Surface = Body) [m2]; zero for others.
/// \param scene, list as for forceOf
template <int D>
double chosenArea(const Teuchos::ParameterList& scene, const Teuchos::ParameterList& list);

} // namespace Rhegma
