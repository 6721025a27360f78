#pragma once
/// What the border of a crack surface is.

#include "cracks/CrackMesh.hpp"

#include <functional>

namespace Rhegma::cracks
{

enum class BorderKind
{
  Mouth,
  FrontIfMaterialAhead, ///< for a cell, as in 2D; else a mouth
  Front
};

/// Tells what an edge of a border is by its middle [m].
using KindOfBorder = std::function<BorderKind(const Vector<3>&)>;

/// Finds what lies beyond the edges of a surface whose triangles have one orientation.
void markBorder(CrackMesh<3>& mesh, const KindOfBorder& kindOf, const MaterialPlaces<3>& material,
                double spacing);

} // namespace Rhegma::cracks
