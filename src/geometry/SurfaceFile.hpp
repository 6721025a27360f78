#pragma once
/// Surfaces of triangles from files.

#include "geometry/SurfaceMesh.hpp"

#include <string>

namespace Rhegma::Geometry
{

/// Reads a surface from an STL file (ascii or binary) or an OBJ file, by the extension. Points are as in the
/// file, in metres; an STL file repeats them for each triangle.
/// \throws std::invalid_argument, whose message begins with the path, for a file that is missing, empty, cut
/// short or of another kind
SurfaceMesh readSurfaceFile(const std::string& path);

/// The same for the content of an STL or OBJ file.
SurfaceMesh parseStl(const std::string& text);
SurfaceMesh parseObj(const std::string& text);

/// The content of a file. \throws std::invalid_argument, whose message begins with the path, for one that is
/// missing, empty or too large
std::string readBytes(const std::string& path);

/// Begin of a text, after the byte order mark of UTF-8 if there is one.
std::size_t textBegin(const std::string& text);

} // namespace Rhegma::Geometry
