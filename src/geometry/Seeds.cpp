#include "geometry/Seeds.hpp"

#include "geometry/LatticeParts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>

namespace Rhegma
{
namespace
{

using Geometry::Lattice;
using Geometry::PartsOfLevels;
using Geometry::tiny;

template <int D>
void refuseMany(const Lattice<D>& lattice, const std::string& section)
{
  const double total = lattice.total();
  if (total < std::numeric_limits<int>::max())
    return;
  std::ostringstream message;
  message << section << ": the body would need about " << total << " particles, more than "
          << std::numeric_limits<int>::max() << "; make the cells larger or the body smaller.";
  throw std::invalid_argument(message.str());
}

template <int D>
Seeds<D> seedsOf(const Lattice<D>& lattice, const Geometry::Frame<D>& frame, const PartsOfLevels<D>& parts)
{
  Seeds<D> seeds;
  seeds.edge = lattice.edge;
  seeds.axes = frame.axes;
  std::map<int, int> firstOf; // of each family
  Vector<D> edge = lattice.edge;
  for (std::size_t level = 0; level < parts.size(); ++level, edge = 0.5 * edge)
  {
    double whole = 1.0;
    for (int d = 0; d < D; ++d)
      whole *= edge[d];
    for (const Geometry::LatticePart<D>& part : parts[level])
    {
      Vector<D> box;
      for (int d = 0; d < D; ++d)
      {
        box[d] = std::sqrt(12.0 * part.variance[d]);
        if (std::abs(box[d] - edge[d]) < tiny * edge[d])
          box[d] = edge[d];
      }
      const int number = static_cast<int>(seeds.position.size());
      seeds.position.push_back(frame.toSpace(part.centroid));
      seeds.box.push_back(box);
      seeds.volume.push_back(part.fraction * whole);
      seeds.level.push_back(static_cast<int>(level));
      seeds.family.push_back(part.family < 0 ? number : firstOf.emplace(part.family, number).first->second);
      seeds.lineage.push_back(part.family < 0 ? 0 : part.lineage);
    }
  }
  return seeds;
}

} // namespace

template <int D>
double estimateSeeds(const Shape<D>& shape, double cell, int particlesPerCell)
{
  const Lattice<D> lattice = Geometry::makeLattice(shape, cell / particlesPerCell);
  const double total = lattice.total();
  constexpr int samples = 100000;
  if (!(total > samples))
    return total;
  // Fractions of multiples of an irrational number fill the interval evenly (Weyl); square roots of primes do
  // so in each axis without regard to the others.
  const double steps[3] = {std::sqrt(2.0), std::sqrt(3.0), std::sqrt(5.0)};
  int inside = 0;
  for (int k = 1; k <= samples; ++k)
  {
    double index[3] = {};
    for (int d = 0; d < D; ++d)
      index[d] = (k * steps[d] - std::floor(k * steps[d])) * lattice.count[d];
    inside += shape.contains(shape.base().frame.toSpace(lattice.positionOf(index))) ? 1 : 0;
  }
  return total * std::max(inside, 1) / samples;
}

template <int D>
Seeds<D> seedParticles(const Shape<D>& shape, double cell, int particlesPerCell, const std::string& section,
                       const SeedRules<D>& rules)
{
  if (!(cell > 0.0) || particlesPerCell < 1)
    throw std::invalid_argument(section +
                                ": particles need a positive cell size and at least one particle per cell.");
  const Lattice<D> lattice = Geometry::makeLattice(shape, cell / particlesPerCell, rules.node);
  refuseMany(lattice, section);
  const Geometry::Frame<D>& frame = shape.base().frame;
  PartsOfLevels<D> parts = Geometry::partsOfCells(lattice, shape, rules);
  const double slack = -tiny * norm(lattice.edge);
  const Geometry::IsSeen<D> isSeen = [&](const Vector<D>& a, const Vector<D>& b)
  {
    bool seen = !rules.cuts.separate || !rules.cuts.separate(frame.toSpace(a), frame.toSpace(b));
    for (const double s : {0.25, 0.5, 0.75})
      seen = seen && shape.depth(frame.toSpace(a + s * (b - a))) >= slack;
    return seen;
  };
  for (std::size_t level = 0; level < parts.size(); ++level)
    Geometry::joinSlivers<D>(parts[level], std::ldexp(1.0, -static_cast<int>(level)) * lattice.edge, isSeen);
  Geometry::joinOverLevels<D>(parts, lattice.edge, isSeen);
  bool any = false, stands = false;
  for (const std::vector<Geometry::LatticePart<D>>& these : parts)
  {
    any = any || !these.empty();
    stands = stands || std::any_of(these.begin(), these.end(),
                                   [](const Geometry::LatticePart<D>& part) { return part.stands(); });
  }
  if (!any)
    throw std::invalid_argument(section + ": the body contains no particle; it is fully cut away; cut less.");
  if (!stands)
  {
    std::ostringstream message;
    message << section << ": the body contains no particle; it fills less than half of one ("
            << cell / particlesPerCell << " m) anywhere; make the body larger or the cells smaller.";
    throw std::invalid_argument(message.str());
  }
  return seedsOf(lattice, frame, parts);
}

template double estimateSeeds<2>(const Shape<2>&, double, int);
template double estimateSeeds<3>(const Shape<3>&, double, int);
template Seeds<2> seedParticles<2>(const Shape<2>&, double, int, const std::string&, const SeedRules<2>&);
template Seeds<3> seedParticles<3>(const Shape<3>&, double, int, const std::string&, const SeedRules<3>&);

} // namespace Rhegma
