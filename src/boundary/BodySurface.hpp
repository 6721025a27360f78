#pragma once
/// The part of a body's surface on which a boundary acts: a flat piece, or a choice of all of it.

#include "geometry/SurfacePoints.hpp"
#include "scene/Schema.hpp"
#include "scene/SectionChecks.hpp"
#include "state/Method.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace Rhegma
{

/// Adds the parameters of a part of a body's surface: Body; From, To (2D); Corner, Edge 1, Edge 2 (3D); or
/// Surface = Body with Part, Lower Corner, Upper Corner, Facing, Around, Largest Angle.
void describeSurface(Section& section);

/// Checks them.
void checkSurface(SectionChecks& checks, const Teuchos::ParameterList& list, const std::string& where);

/// Whether a boundary acts on a choice of its body's surface (Surface = Body).
bool choosesSurface(const Teuchos::ParameterList& list);

/// Points all over the surface that a boundary with Surface = Body chooses, a quarter of a cell apart. Of
/// pieces at the edge of the choice all counts or nothing. Throws std::invalid_argument, with the boundary's
/// path, where nothing is left. \param scene validated \param where path of the boundary
template <int D>
std::vector<Geometry::SurfacePoint<D>> chosenSurface(const Teuchos::ParameterList& scene,
                                                     const Teuchos::ParameterList& list,
                                                     const std::string& where);

/// The size of a surface.
template <int D>
struct SurfaceMeasure
{
  double area = 0.0;   ///< in 2D the length times the thickness [m2]
  Vector<D> outward{}; ///< integral of the outward unit normal over it; zero for all of a closed surface [m2]
};

/// Of the surface on which a boundary acts, flat or chosen. \param scene, list, where as for chosenSurface
template <int D>
SurfaceMeasure<D> measureSurface(const Teuchos::ParameterList& scene, const Teuchos::ParameterList& list,
                                 const std::string& where);

/// Of points of a surface. \param depth of the scene normal to its plane
template <int D>
SurfaceMeasure<D> measureSurface(const std::vector<Geometry::SurfacePoint<D>>& points, const Depth& depth);

} // namespace Rhegma
