#pragma once
/// The cracks of a scene while they grow, in host memory.

#include "state/CrackSet.hpp"
#include "surface/GrowingPolyline.hpp"
#include "surface/GrowingSurface.hpp"

#include <type_traits>
#include <vector>

namespace Rhegma::cracks
{

/// Of the nodes of each front: the toughness of the last face that the node made [J/m2].
using FaceToughness = std::vector<std::vector<double>>;

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
std::vector<GrowingCrack<D>> readGrowing(const CrackSet<D>& set, const FaceToughness& toughness);

/// Copies the cracks back to the set and rebuilds its views, with the toughness at their front nodes. \param
/// spacing of the coarse cells [m]
template <int D>
void writeGrowing(CrackSet<D>& set, std::vector<GrowingCrack<D>>& cracks, FaceToughness& toughness,
                  double spacing);

} // namespace Rhegma::cracks
