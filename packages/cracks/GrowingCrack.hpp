#pragma once
/// The cracks of a scene while they grow, in host memory.

#include "state/CrackSet.hpp"
#include "surface/GrowingPolyline.hpp"
#include "surface/GrowingSurface.hpp"

#include <type_traits>
#include <vector>

namespace Rhegma::cracks
{

/// What growth remembers of a front node.
struct FrontMark
{
  double toughness = 0.0; ///< of the last face that it made [J/m2]
  bool landed = false;    ///< it has reached the surface of the body
};

/// The marks of each front's nodes.
using FrontMarks = std::vector<std::vector<FrontMark>>;

/// A crack and its fronts. Only the mesh depends on the dimension.
template <int D>
struct GrowingCrack
{
  std::conditional_t<D == 2, surface::GrowingPolyline, surface::GrowingSurface> mesh;
  std::vector<surface::FrontLines<D>> fronts; ///< in the order of the set's
  std::vector<int> numbers;                   ///< of these fronts in the set
  surface::FrontLines<D> ends;                ///< of each front the vertex where it is, or was when it ended
};

/// The cracks of a set.
template <int D>
std::vector<GrowingCrack<D>> readGrowing(const CrackSet<D>& set, const FrontMarks& marks);

/// Copies the cracks back to the set and rebuilds its views, with the marks of their front nodes. \param
/// spacing of the coarse cells [m]
template <int D>
void writeGrowing(CrackSet<D>& set, std::vector<GrowingCrack<D>>& cracks, FrontMarks& marks, double spacing);

} // namespace Rhegma::cracks
