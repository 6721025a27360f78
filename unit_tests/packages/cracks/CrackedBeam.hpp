#pragma once
/// The double cantilever beam of verification/dcb_h4.xml without its loads' motion: a crack from the left end
/// to the middle, and the stencils of the particles next to it.

#include "cracks/CrackGeometry.hpp"
#include "plan/EffectSchema.hpp"
#include "scene/Scene.hpp"
#include "step/Run.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace Rhegma::cracks::test
{

constexpr double cell = 2.5e-3; ///< [m]

/// Where the crack lies in the cells; the first is a row of nodes at 10 mm.
inline const std::string onRow = "{0, 0.01, 0.05, 0.01}";
inline const std::string withinTolerance = "{0, 0.01024, 0.05, 0.01024}"; ///< the row still counts as above
inline const std::string midCell = "{0, 0.01125, 0.05, 0.01125}";
inline const std::string steep = "{0, 0.0053, 0.02, 0.006, 0.026, 0.0125, 0.05, 0.0132}"; ///< 47 degrees
inline const std::string inclined = "{0, 0.0063, 0.03, 0.0107, 0.05, 0.0118}";

/// A beam at rest after one very small step.
inline std::unique_ptr<Run<2>> beamAtRest(const std::string& formulation, const std::string& shape,
                                          const std::string& points,
                                          const std::vector<std::string>& more = {})
{
  std::vector<std::string> overrides{
      "Cracks:Formulation=" + formulation,   "Domain:Shape Functions=" + shape,
      "Cracks:Notch:Points=" + points,       "Energy Release:Crack Closure=false",
      "Energy Release:Lumped Closure=false", "Energy Release:Inner Radius=1e-4",
      "Energy Release:Outer Radius=2.7e-3",  "Time:CFL=0.4"};
  overrides.insert(overrides.end(), more.begin(), more.end());
  const SceneResult scene = readScene(std::string(RHEGMA_SOURCE_DIR) + "/xml_inputs/verification/dcb_h4.xml",
                                      overrides, effectSchema());
  for (const SceneError& error : scene.errors)
    ADD_FAILURE() << toString(error);
  auto run = std::make_unique<Run<2>>(*scene.list);
  run->initialize();
  run->step(1e-15, false);
  return run;
}

/// One entry of a particle's stencil.
struct Entry
{
  int node;
  double weight, slope[2];
};

/// A particle next to the crack and the nodes that it sees.
struct Seeing
{
  int particle, side;
  Vector<2> x;
  std::vector<Entry> entries;
};

inline std::vector<Seeing> stencilsNearCrack(const State<2>& state)
{
  const auto copy = [](const auto& view) { return onHost(view); };
  const auto particle = copy(state.stored.particle), count = copy(state.stored.table.count);
  const auto node = copy(state.stored.table.node);
  const auto weight = copy(state.stored.table.weight);
  const auto slope = copy(state.stored.table.slope);
  const auto position = copy(state.particles.real<2>(fields::position));
  const auto side = copy(state.particles.integer(fields::side));
  std::vector<Seeing> all;
  for (int r = 0; r < state.stored.count; ++r)
  {
    const int p = particle(r);
    Seeing one{p, side(p), {position(p, 0), position(p, 1)}, {}};
    for (int k = 0; k < count(r); ++k)
      one.entries.push_back({node(r, k), weight(r, k), {slope(r, k, 0), slope(r, k, 1)}});
    all.push_back(one);
  }
  return all;
}

/// Nodal masses [kg], and the mass of all particles.
inline std::vector<double> nodalMasses(const State<2>& state)
{
  const auto sums = onHost(state.mesh.nodes.sums);
  std::vector<double> mass;
  for (int n = 0; n < state.mesh.nodes.numLattice + state.mesh.nodes.numEnriched; ++n)
    mass.push_back(sums(n, Nodes<2>::massAt));
  return mass;
}

inline double bodyMass(const State<2>& state)
{
  const auto mass = onHost(state.particles.scalar(fields::mass));
  double sum = 0.0;
  for (int p = 0; p < state.particles.size(); ++p)
    sum += mass(p);
  return sum;
}

} // namespace Rhegma::cracks::test
