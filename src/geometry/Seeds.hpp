#pragma once
/// The initial particles of a body.

#include "geometry/Shape.hpp"

#include <string>
#include <vector>

namespace Rhegma
{

/// Equal particles on a lattice along the own axes of a body's base shape.
template <int D>
struct Seeds
{
  std::vector<Vector<D>> position; ///< centres, in 3D [m]
  Vector<D> edge;                  ///< edge lengths of every particle along `axes` [m]
  Geometry::Axes<D> axes;          ///< unit directions of the lattice
  double volume;                   ///< of every particle; an area in 2D [m^D]
};

/// Fills a shape with particles.
///
/// The lattice starts at the lower corner of the base shape's bounds, in the base shape's own axes, and its
/// edges are cell / particlesPerCell, changed along each axis so that a whole number of particles spans those
/// bounds. So the particles of a box tile it and their volumes add up to its own, those of a box on grid
/// lines sit evenly in the cells, and those of a ball are mirror images of each other. Of any shape, the
/// particles whose centre is inside are kept.
///
/// \param cell              edge of a grid cell [m]
/// \param particlesPerCell  along one axis
/// \param section           the body's section, for messages (`Bodies > Beam`)
///
/// Throws std::invalid_argument where no particle is inside, or where there would be more than an int can
/// count.
template <int D>
Seeds<D> seedParticles(const Shape<D>& shape, double cell, int particlesPerCell, const std::string& section);

/// Estimated number of particles of seedParticles, from a sample of positions; fast and without memory.
template <int D>
double estimateSeeds(const Shape<D>& shape, double cell, int particlesPerCell);

} // namespace Rhegma
