#pragma once
/// Scenes of one elastic box, advanced by the test.

#include "src/step/Bodies.hpp"

namespace Rhegma
{
namespace Test
{

struct ElasticSolid
{
  double density = 1200.0; ///< [kg/m3]
  double young = 3e9;      ///< [Pa]
  double poisson = 0.3;
};

/// \param lower, upper corners of the body [m] \param cell [m] \param gap from the body to the edge of the
/// domain [cells] \param name of the body
template <int D>
Teuchos::ParameterList elasticBox(const Vector<D>& lower, const Vector<D>& upper, double cell, double gap,
                                  const ElasticSolid& solid = {}, const std::string& name = "Plate",
                                  const std::string& plane = "Strain")
{
  const Vector<D> margin = all<D>(gap * cell);
  Teuchos::ParameterList scene = emptyScene<D>(lower - margin, upper + margin, cell, "MUSL", "GIMP", plane);
  scene.sublist("Time").set("Final Time", 1.0);
  addMaterial(scene, "Linear Elastic", solid.poisson);
  Teuchos::ParameterList& material = scene.sublist("Materials").sublist("Solid");
  material.set("Density", solid.density);
  material.set("Young Modulus", solid.young);
  addBox<D>(scene, name, lower, upper);
  return scene;
}

} // namespace Test
} // namespace Rhegma
