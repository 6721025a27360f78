#include "scene/DerivedConstants.hpp"

#include "material/MaterialTable.hpp"
#include "material/RayleighSpeed.hpp"
#include "scene/FillFromLibrary.hpp"

#include <cmath>

namespace Rhegma
{

DerivedConstants deriveConstants(const LibraryMaterial& material, const SceneSchema& schema)
{
  Teuchos::ParameterList scene;
  Teuchos::ParameterList& list = scene.sublist("Materials").sublist(material.name);
  list.set("Material From Library", material.name);
  std::vector<SceneError> errors;
  fillFromLibrary(scene, schema, errors);
  const Properties properties = makeProperties(list, material.name, Plane::Strain);
  const Elasticity e = elasticity(properties);
  DerivedConstants d;
  d.density = properties.density;
  d.young = e.young;
  d.poisson = e.poisson;
  d.longitudinal = std::sqrt(e.constrainedModulus / properties.density);
  d.shear = std::sqrt(e.shear / properties.density);
  d.rayleigh = rayleighSpeed(properties);
  if (const LibraryConstant* toughness = material.find("Toughness"))
  {
    d.toughness = toughness->atRest();
    d.intensity = std::sqrt(e.effectiveModulus * *d.toughness);
  }
  return d;
}

} // namespace Rhegma
