#pragma once
/// Bodies in cells that are refined in a box.

#include "../../src/step/Bodies.hpp"

#include "adaptivity/Merging.hpp"
#include "adaptivity/Splitting.hpp"
#include "grid/Branches.hpp"
#include "step/CoreStep.hpp"
#include "transfer/Scatter.hpp"
#include "transfer/Stencils.hpp"

#include <random>

namespace Rhegma
{
namespace Test
{

/// A cube from 0 to `side` in cells of 1 m, refined to `level` in a box.
template <int D>
Teuchos::ParameterList refinedScene(const std::string& shape, double side, const Vector<D>& lower,
                                    const Vector<D>& upper, int level)
{
  Teuchos::ParameterList scene = emptyScene<D>(all<D>(-4.0), all<D>(14.0), 1.0, "MUSL", shape);
  addMaterial(scene, "Neo-Hookean", 0.3);
  addBox<D>(scene, "Cube", all<D>(0.0), all<D>(side));
  Teuchos::ParameterList& adaptivity = scene.sublist("Adaptivity");
  adaptivity.set("Maximum Level", level);
  Teuchos::ParameterList& box = adaptivity.sublist("Box");
  box.set("Lower Corner", array(lower));
  box.set("Upper Corner", array(upper));
  box.set("Level", level);
  return scene;
}

template <int D>
Run<D> refinedCube(const std::string& shape, double side, const Vector<D>& lower, const Vector<D>& upper,
                   int level)
{
  Run<D> run(validated(refinedScene<D>(shape, side, lower, upper, level)));
  run.initialize();
  return run;
}

/// Lets particles split and merge with the present cells.
template <int D>
adaptivity::Merged updateCells(State<D>& state, double mergeLoss = 1.0)
{
  const adaptivity::Merged merged = adaptivity::mergeParticles(state, mergeLoss);
  adaptivity::splitParticles(state);
  sortState(state);
  storeStencils(state);
  return merged;
}

} // namespace Test
} // namespace Rhegma
