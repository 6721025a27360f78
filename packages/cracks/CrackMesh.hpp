#pragma once
/// One crack as the scene gives it, made ready for a run.

#include "cracks/MaterialPlaces.hpp"
#include "state/CrackSet.hpp"

#include <Teuchos_ParameterList.hpp>

#include <array>
#include <string>
#include <vector>

namespace Rhegma::cracks
{

/// Vertices and simplices of one crack.
template <int D>
struct CrackMesh
{
  std::vector<Vector<D>> vertices;
  std::vector<std::array<int, D>> simplices;
  std::vector<std::array<int, D>> beyond; ///< neighbour beyond each facet, or facet::mouth or front
  std::vector<std::string> warnings;      ///< what a user must know of it
};

/// What to say of a crack none of which is in a body.
inline constexpr char outsideOfBodies[] =
    "the crack lies outside of all bodies; give points inside one of them";

/// What to say of a polyline that has a point twice.
inline constexpr char samePoints[] =
    "two points in a row are the same, so a piece of the crack has no length; leave one of them out";

/// Reads a polyline: clips it to the bodies at both ends, splits long segments, and finds which ends are
/// fronts (material ahead of them) and which are mouths.
///
/// \param where section's path, for messages. Throws std::invalid_argument for a crack that has no length or
/// lies outside of all bodies.
CrackMesh<2> readPolyline(const Teuchos::ParameterList& list, const std::string& where,
                          const MaterialPlaces<2>& material, double spacing);

/// Reads a planar polygon: covers it with triangles, cuts off what lies outside of the bodies, and finds
/// which pieces of its border are fronts and which are mouths.
///
/// \param where section's path, for messages
/// \param spacing of the large cells [m]
/// \param edge length that edges of the triangles have about [m]
/// Throws std::invalid_argument for a polygon that has fewer than
/// three points, no area, crosses itself, is not planar to a hundredth of a cell, or lies outside of all
/// bodies.
CrackMesh<3> readPolygon(const Teuchos::ParameterList& list, const std::string& where,
                         const MaterialPlaces<3>& material, double spacing, double edge);

/// The same for a disk or an ellipse by its centre, normal and radii. Its rim is a polygon with edges of
/// about that length and the area of the ellipse.
CrackMesh<3> readDisk(const Teuchos::ParameterList& list, const std::string& where,
                      const MaterialPlaces<3>& material, double spacing, double edge);

/// The same for a surface from a file (SurfaceFile.hpp), which may be curved: points closer than a thousandth
/// of a cell are made one, triangles get one orientation and edges of about that length.
CrackMesh<3> readSurface(const Teuchos::ParameterList& list, const std::string& where,
                         const MaterialPlaces<3>& material, double spacing, double edge);

} // namespace Rhegma::cracks
