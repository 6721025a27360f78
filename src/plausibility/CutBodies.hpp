#pragma once
/// Bodies that cracks cut in pieces.

#include "plausibility/BodyMeasures.hpp"
#include "plausibility/Pieces.hpp"

#include <set>
#include <string>
#include <vector>

namespace Rhegma
{

/// A body that cracks cut, and its pieces.
template <int D>
struct CutBody
{
  std::size_t body;      ///< its index
  Pieces<D> pieces;      ///< two or more
  std::set<int> cutters; ///< indices of the cracks that lie between pieces
};

/// The bodies that cracks cut at the start; none while no crack meets a surface, and none of those with too
/// many particles near cracks (Pieces::gaveUp). Call it before particles are divided among ranks. \param
/// bodies all of the state
template <int D>
std::vector<CutBody<D>> cutBodies(const std::vector<BodyMeasure<D>>& bodies, const State<D>& state);

/// Names of cracks: "Cracks > A, B". \param cracks their indices
template <int D>
std::string pathsOfCracks(const std::set<int>& cracks, const State<D>& state);

} // namespace Rhegma
