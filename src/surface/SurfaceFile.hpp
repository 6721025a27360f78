#pragma once
/// Surfaces of triangles from files.

#include "surface/SurfaceMesh.hpp"

#include <string>

namespace Rhegma::surface
{

/// Reads a surface from an STL file (ascii or binary, whichever it is) or from an OBJ file, by the end of its
/// name. Points are as in the file, in metres; an STL file gives those of each triangle anew.
/// \throws std::invalid_argument, in one sentence that begins with the path, for a file that is not there,
/// empty, cut short or of another kind
SurfaceMesh readSurfaceFile(const std::string& path);

/// The same for what such a file holds.
SurfaceMesh parseStl(const std::string& text);
SurfaceMesh parseObj(const std::string& text);

/// Where a text begins: behind the mark of UTF-8 that some editors put before it, if there is one.
std::size_t textBegin(const std::string& text);

} // namespace Rhegma::surface
