#include "step/PlaceBodies.hpp"

#include "base/Attempts.hpp"
#include "base/EntryValue.hpp"
#include "base/MemoryNeed.hpp"
#include "base/Numbers.hpp"
#include "base/PointText.hpp"
#include "geometry/NearBoxes.hpp"
#include "geometry/Overlap.hpp"
#include "geometry/Slivers.hpp"
#include "step/OutsideDomain.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Rhegma
{

namespace
{

template <int D>
std::vector<PlacedBody<D>> planBodies(const Teuchos::ParameterList& section)
{
  std::vector<PlacedBody<D>> bodies;
  Attempts attempts;
  bodies.reserve(section.numParams());
  for (const auto& entry : section)
    if (const auto* list = valueIf<Teuchos::ParameterList>(entry.second))
      attempts.attempt([&] { bodies.push_back({entry.first, list, makeShape<D>(*list)}); });
  attempts.throwIfAny();
  return bodies;
}

/// Checks the memory before any is allocated.
template <int D>
void refuseTooMuch(const std::vector<PlacedBody<D>>& bodies, const State<D>& state)
{
  double particles = 0.0, filled = 0.0; // cells
  for (const PlacedBody<D>& body : bodies)
  {
    const double seeds = estimateSeeds(body.shape, state.mesh.grid.spacing, body.particlesPerCell());
    particles += seeds;
    filled += seeds / std::pow(body.particlesPerCell(), D);
  }
  double fields = 0.0, largest = 0.0;
  for (const Field& field : state.particles.fields())
  {
    const double bytes = field.components * double(field.integer ? sizeof(int) : sizeof(double));
    fields += bytes;
    largest = std::max(largest, bytes);
  }
  // Next to its fields a particle takes its seed, its numbers in the order of blocks, and a copy of one field
  // while they are sorted; a node its rows and three marks.
  const double perParticle = fields + largest + 2.0 * sizeof(Geometry::LatticePart<D>) + 8.0 * sizeof(int);
  const double perNode =
      (Nodes<D>::sumWidth + Nodes<D>::motionWidth + Nodes<D>::projectionWidth) * sizeof(double) +
      2.0 * sizeof(int);
  // The stiffness couples a node with those two cells away; what solves it takes as much again or more.
  const double ofMatrix = state.method.equilibrium()
                              ? filled * std::pow(5.0, D) * D * D * sizeof(double) / std::max(particles, 1.0)
                              : 0.0;
  refuseWithoutMemory(state.mesh.grid.numNodes, perNode, particles, perParticle + ofMatrix,
                      freeMemoryBytes() / state.ranks.onThisMachine());
}

template <int D>
void seed(PlacedBody<D>& body, const Grid<D>& grid, const SeedRules<D>& rules)
{
  body.seeds = seedParticles<D>(body.shape, grid.spacing, body.particlesPerCell(), body.where(), rules);
  for (const Vector<D>& x : body.seeds.position)
    if (!grid.inside(x))
      throw std::invalid_argument(body.where() + ": " + textOfOutside(x, grid));
}

/// How deep particles of a body lie in another one, to their outer faces [m].
template <int D>
double depthOf(const Seeds<D>& seeds, const Shape<D>& other)
{
  double deepest = 0.0;
  for (std::size_t p = 0; p < seeds.position.size(); ++p)
    if (other.contains(seeds.position[p]))
      deepest = std::max(deepest, other.depth(seeds.position[p]) +
                                      0.5 * *std::min_element(seeds.box[p].c, seeds.box[p].c + D));
  return deepest;
}

template <int D>
void refuseOverlap(const PlacedBody<D>& one, const PlacedBody<D>& other)
{
  const int inOther = findOverlap(one.seeds, other.shape);
  const int inOne = findOverlap(other.seeds, one.shape);
  if (inOther < 0 && inOne < 0)
    return;
  throw std::invalid_argument(
      other.where() + ": overlaps " + one.where() + " by up to " +
      readableLength(std::max(depthOf(one.seeds, other.shape), depthOf(other.seeds, one.shape))) +
      ", such as at " +
      formatPoint<D>(inOther >= 0 ? one.seeds.position[inOther] : other.seeds.position[inOne]) +
      ", so the mass there would be counted twice; move one of them, or cut it with Operations");
}

/// Looks at pairs of bodies whose bounds touch, up to so many overlaps that nobody reads them all.
template <int D>
void refuseOverlaps(const std::vector<PlacedBody<D>>& bodies, Attempts& attempts)
{
  constexpr int most = 1000;
  std::vector<Geometry::Bounds<D>> bounds;
  bounds.reserve(bodies.size());
  for (const PlacedBody<D>& body : bodies)
    bounds.push_back(body.shape.bounds());
  const Geometry::NearBoxes<D> boxes(bounds);
  int overlaps = 0;
  for (int a = 0; a < static_cast<int>(bodies.size()); ++a)
    for (const int b : boxes.near(bounds[a], 0.0))
    {
      if (b <= a)
        continue;
      overlaps += attempts.attempt([&] { refuseOverlap(bodies[a], bodies[b]); }) ? 0 : 1;
      if (overlaps < most)
        continue;
      attempts.attempt(
          [&]
          {
            throw std::invalid_argument("Bodies: more than " + std::to_string(most) +
                                        " pairs overlap; the search ended there");
          });
      return;
    }
}

} // namespace

template <int D>
std::vector<PlacedBody<D>> placeBodies(const Teuchos::ParameterList& section, const State<D>& state,
                                       const SeedRules<D>& rules)
{
  std::vector<PlacedBody<D>> bodies = planBodies<D>(section);
  refuseTooMuch(bodies, state);
  Attempts attempts;
  for (PlacedBody<D>& body : bodies)
    attempts.attempt([&] { seed(body, state.mesh.grid, rules); });
  refuseOverlaps(bodies, attempts);
  attempts.throwIfAny();
  return bodies;
}

template std::vector<PlacedBody<2>> placeBodies(const Teuchos::ParameterList&, const State<2>&,
                                                const SeedRules<2>&);
template std::vector<PlacedBody<3>> placeBodies(const Teuchos::ParameterList&, const State<3>&,
                                                const SeedRules<3>&);

} // namespace Rhegma
