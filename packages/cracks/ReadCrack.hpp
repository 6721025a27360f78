#pragma once
/// The cracks of a scene, cut to the bodies.

#include "cracks/BodyRegion.hpp"
#include "surface/Border.hpp"
#include "surface/CrackMesh.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace Rhegma::cracks
{

/// The message for a crack that lies outside of all bodies.
inline constexpr char outsideOfBodies[] =
    "the crack lies outside of all bodies; write points inside one of them";

/// The message for a polyline that has a point twice.
inline constexpr char samePoints[] =
    "two consecutive points are the same, so a segment of the crack has no length; remove one of them";

/// The context in which a crack is read.
template <int D>
struct ReadingContext
{
  const BodyRegion<D>& bodies;
  double cell;  ///< size of the coarse cells [m]
  double edge;  ///< length that edges of triangles have about [m]
  double front; ///< size of the cells at fronts, once they are refined [m]
};

/// Reads one crack, cuts off what lies outside of the bodies, and finds which of its ends or border edges are
/// fronts (material ahead of them) and which are surface-breaking.
///
/// In 2D a polyline, whose long segments are split. In 3D a flat polygon, a disk or an ellipse, or a surface
/// from a file, covered with triangles.
///
/// \param where section's path, for messages \param warnings are added to
/// \throws std::invalid_argument for a crack that has no size, crosses itself, is far too large, or lies
/// outside of all bodies
template <int D>
surface::CrackMesh<D> readCrack(const Teuchos::ParameterList& list, const std::string& where,
                                const ReadingContext<D>& context, std::vector<std::string>& warnings);

/// Warns where edges of a crack in 3D are too near to a surface of the body to be fronts.
/// \param where parameter's path \param cell size of cells at fronts [m] \param warnings are added to
void warnOfLigament(const surface::BrokenLigament& broken, const std::string& where, double cell,
                    std::vector<std::string>& warnings);

/// The 3D ones. A polygon must be flat to a hundredth of a cell; the rim of a disk is a polygon of its area
/// with edges of about `edge`; points of a file closer than a thousandth of a cell are made one.
surface::CrackMesh<3> readPolygon(const Teuchos::ParameterList& list, const std::string& where,
                                  const ReadingContext<3>& context, std::vector<std::string>& warnings);
surface::CrackMesh<3> readDisk(const Teuchos::ParameterList& list, const std::string& where,
                               const ReadingContext<3>& context, std::vector<std::string>& warnings);
surface::CrackMesh<3> readSurface(const Teuchos::ParameterList& list, const std::string& where,
                                  const ReadingContext<3>& context, std::vector<std::string>& warnings);

} // namespace Rhegma::cracks
