#pragma once
/// The initial particles of a body.

#include "geometry/SeedRules.hpp"
#include "geometry/Shape.hpp"

#include <string>
#include <vector>

namespace Rhegma
{

/// Particles on a lattice along the own axes of a body's base shape.
template <int D>
struct Seeds
{
  std::vector<Vector<D>> position; ///< centroids [m]
  std::vector<Vector<D>> box;      ///< edge lengths along `axes` of the box with each particle's moments [m]
  std::vector<double> volume;      ///< an area in 2D [m^D]
  std::vector<int> level;          ///< how often the cell of the lattice was halved
  std::vector<int> family;         ///< the first of the particles that a whole cell was divided into
  /// Which part of that cell: D bits for every division, the last one lowest. Bit d is set in the upper half
  /// along the body's axis d.
  std::vector<int> lineage;
  Vector<D> edge;         ///< edge lengths of a cell of the lattice [m]
  Geometry::Axes<D> axes; ///< unit directions of the lattice
};

/// Fills a shape with particles.
///
/// The lattice starts at the lower corner of the base shape's bounds, in the base shape's own axes, and its
/// edges are cell / particlesPerCell, changed along each axis so that a whole number of particles spans those
/// bounds. So the particles of a box tile it, those of a box on grid lines sit evenly in the cells, and those
/// of a ball are mirror images of each other. With a node of the grid (SeedRules::node) the lattice follows
/// the cells instead, and particles sit evenly in the cells wherever the body is.
///
/// A particle is the part of a cell of the lattice that is inside the shape: it has the part's volume and
/// centroid, and a box with its second moments along the axes. A part below a fraction of a cell
/// (SeedRules::joinedBelow) belongs to the particle of a cell next to it. So the volume, the first
/// moments and the second moments along the axes of a shape are those of its particles, as exactly as
/// partOfBox (geometry/PartOfBox.hpp) finds them.
///
/// Where a crack passes through a cell, the part on each side of it is a particle, so that the mass on each
/// side is exact; parts on different sides are never joined.
///
/// A cell of the lattice is divided into 2^D, and those again, until `isDivided` is content:
/// parts of cells are exact at each size. The cells of a box, all whole, stay undivided: dividing their
/// particles later is exact, too.
///
/// \param cell              edge of a grid cell [m]
/// \param particlesPerCell  along one axis
/// \param section           the body's section, for messages (`Bodies > Beam`)
///
/// Throws std::invalid_argument where the shape is empty, or where there would be more particles than an int
/// can count.
template <int D>
Seeds<D> seedParticles(const Shape<D>& shape, double cell, int particlesPerCell, const std::string& section,
                       const SeedRules<D>& rules = {});

/// Estimated number of particles of seedParticles, from a sample of positions; fast and without memory.
template <int D>
double estimateSeeds(const Shape<D>& shape, double cell, int particlesPerCell);

} // namespace Rhegma
