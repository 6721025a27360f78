#pragma once
/// Which edges of a crack surface's border are fronts.

#include "surface/CrackMesh.hpp"

#include <functional>

namespace Rhegma::surface
{

enum class BorderKind
{
  SurfaceBreaking,
  FrontIfMaterialAhead, ///< for a cell, as in 2D; else surface-breaking
  Front
};

/// The kind of a border edge by its middle [m].
using KindOfBorder = std::function<BorderKind(const Vector<3>&)>;

/// Edges with some material ahead of them, but less than for a cell, that count as surface-breaking: along
/// more than a cell, because each front that leaves a body obliquely has less material ahead at its end.
struct BrokenLigament
{
  double length = 0.0; ///< of the edges together [m]
  Vector<3> middle{};  ///< of the longest edge [m]
};

/// Finds what lies beyond the edges of a surface whose triangles have one orientation. Where material is
/// missing along less than a cell between two fronts, they are one.
/// \param bodies where there is material \param cell its size [m]
/// \return what FrontIfMaterialAhead left as surface-breaking, though the body goes on
BrokenLigament markBorder(CrackMesh<3>& mesh, const KindOfBorder& kindOf, const Region<3>& bodies,
                          double cell);

} // namespace Rhegma::surface
