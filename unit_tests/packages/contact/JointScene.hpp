#pragma once
/// A bar with a closed joint across it, at rest, after one step: all that contact acts on exists.

#include "plan/EffectSchema.hpp"
#include "scene/Scene.hpp"
#include "step/Run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace Rhegma::contact::test
{

constexpr double cell = 1e-3, width = 4e-3,
                 height = 0.04; ///< of the cells, the bar and the joint's position [m]
constexpr double young = 3e9, poisson = 0.3;
const double modulus = young * (1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
const double shear = young / (2.0 * (1.0 + poisson));

/// \param levels how often all its cells are refined
inline std::unique_ptr<Run<2>> barAtRest(std::vector<std::string> overrides = {}, int levels = 0)
{
  overrides.push_back("Boundaries:Pulse:Stress={0, 0}");
  const SceneResult scene =
      readScene(std::string(RHEGMA_SOURCE_DIR) + "/xml_inputs/verification/contact_pulse_compressive.xml",
                overrides, effectSchema());
  std::vector<SceneError> errors = scene.errors;
  if (levels > 0)
  {
    Teuchos::ParameterList& adaptivity = scene.list->sublist("Adaptivity");
    adaptivity.set("Maximum Level", levels);
    Teuchos::ParameterList& all = adaptivity.sublist("All");
    all.set("Lower Corner", Teuchos::Array<double>(2, -1.0));
    all.set("Upper Corner", Teuchos::Array<double>(2, 1.0));
    all.set("Level", levels);
    validateList(*scene.list, effectSchema(), errors);
  }
  for (const SceneError& error : errors)
    ADD_FAILURE() << toString(error);
  auto run = std::make_unique<Run<2>>(*scene.list);
  run->initialize();
  run->step(1e-8, false);
  return run;
}

/// Gives the nodes a velocity: `upper` to those of the upper face and beyond, `lower` to the others.
inline void moveSides(State<2>& state, const Vector<2>& upper, const Vector<2>& lower)
{
  const auto projection = onHost(state.mesh.nodes.projection);
  const auto side = onHost(state.cracks.nodeSide);
  const auto second = onHost(state.cracks.enrichedField);
  for (int n = 0; n < state.mesh.nodes.numLattice; ++n)
    for (int d = 0; d < 2; ++d)
    {
      // A enriched field belongs to the side on which its node is not.
      const bool above = side(n) != 0 ? side(n) > 0 : state.mesh.grid.nodePosition(n)[1] >= height;
      projection(n, d) = above ? upper[d] : lower[d];
      if (second(n) >= 0)
        projection(second(n), d) = above ? lower[d] : upper[d];
    }
  Kokkos::deep_copy(state.mesh.nodes.projection, projection);
}

/// Forces on nodes above (1) and below (0) the joint [N], counted by which face's nodes they act on.
inline std::vector<Vector<2>> forcesOnSides(const State<2>& state)
{
  std::vector<Vector<2>> sum{{0.0, 0.0}, {0.0, 0.0}};
  const auto sums = onHost(state.mesh.nodes.sums);
  const auto side = onHost(state.cracks.nodeSide);
  const auto second = onHost(state.cracks.enrichedField);
  for (int n = 0; n < state.mesh.nodes.numLattice; ++n)
    for (int d = 0; d < 2; ++d)
    {
      const bool above = side(n) != 0 ? side(n) > 0 : state.mesh.grid.nodePosition(n)[1] >= height;
      sum[above ? 1 : 0][d] += sums(n, Nodes<2>::forceAt + d);
      if (second(n) >= 0)
        sum[above ? 0 : 1][d] += sums(second(n), Nodes<2>::forceAt + d);
    }
  return sum;
}

inline void clearForces(State<2>& state)
{
  const auto sums = onHost(state.mesh.nodes.sums);
  for (std::size_t n = 0; n < sums.extent(0); ++n)
    for (int d = 0; d < 2; ++d)
      sums(n, Nodes<2>::forceAt + d) = 0.0;
  Kokkos::deep_copy(state.mesh.nodes.sums, sums);
}

} // namespace Rhegma::contact::test
