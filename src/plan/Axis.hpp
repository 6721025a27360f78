#pragma once
/// Axisymmetric scenes: x is the radius, y the axis.

#include "state/Method.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>

namespace Rhegma
{

/// Angle of the circle that a point of an axisymmetric scene stands for: masses, forces and energies are
/// those of whole rings.
constexpr double wholeCircle = 6.283185307179586;

/// Whether a scene is axisymmetric. \param scene validated
inline bool isAxisymmetric(const Teuchos::ParameterList& scene)
{
  const Teuchos::ParameterList& domain = scene.sublist("Domain");
  return domain.isType<std::string>("Plane") && domain.get<std::string>("Plane") == "Axisymmetric";
}

/// Extent of a scene normal to its plane; 1 in 3D. \param scene validated
template <int D>
Depth depthOf(const Teuchos::ParameterList& scene)
{
  if (D == 3)
    return {};
  return isAxisymmetric(scene) ? Depth{wholeCircle, true}
                               : Depth{scene.sublist("Domain").get<double>("Thickness"), false};
}

} // namespace Rhegma
