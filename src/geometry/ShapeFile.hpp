#pragma once
/// Solids from files.

#include "geometry/Solid.hpp"

#include <memory>
#include <string>
#include <vector>

namespace Rhegma::Geometry
{

/// The solid of a file, in its unit.
template <int D>
struct SolidOfFile
{
  std::shared_ptr<const Solid<D>> solid;
  std::vector<std::string> notes; ///< what was mended in it, a message each
};

/// Reads a solid: in 3D from an STL or OBJ file with a closed surface (mendSurface), in 2D from a file of
/// polygons (parseOutlines). A file that has not changed since the last time is not read again; the last few
/// solids stay in memory.
/// \throws std::invalid_argument, whose message begins with the path, if the file is missing or is no solid
template <int D>
SolidOfFile<D> readSolid(const std::string& path);

} // namespace Rhegma::Geometry
