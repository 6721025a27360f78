#pragma once
/// Plane bodies from files of polygons.

#include "geometry/MendSurface.hpp"

#include <string>
#include <vector>

namespace Rhegma::Geometry
{

/// A closed polygon of a file.
struct Outline
{
  std::vector<Vector<2>> points; ///< the first is not repeated
  int line;                      ///< where it begins, from 1
};

/// The polygons of a text: a point a line, as two numbers with a blank or a comma between them; polygons are
/// separated by empty lines, and what follows # is a comment.
/// \throws std::invalid_argument with the line of anything else
std::vector<Outline> parseOutlines(const std::string& text);

/// The area inside an odd number of polygons. Repeated points are left out, with a note.
/// \throws std::invalid_argument, which says where, for polygons without area or that meet themselves or
/// others
MendedSurface<2> mendOutlines(const std::vector<Outline>& outlines);

} // namespace Rhegma::Geometry
