#pragma once
/// Bodies that lie in a tool at the start.

#include "geometry/Shape.hpp"
#include "rigid_tools/Tool.hpp"
#include "state/State.hpp"

#include <Teuchos_ParameterList.hpp>

#include <vector>

namespace Rhegma::rigid_tools
{

/// Throws std::invalid_argument where a body overlaps a tool by more than a few hundredths of a cell.
///
/// The overlap is the largest depth in the tool of points of the domains of particles, among these only of
/// points that lie in the body's shape: domains are rectangular, and those of a round body extend beyond it.
/// \param touches of each body: not 0 where the tool touches it \param bodies section of the scene
template <int D>
void refuseOverlap(const State<D>& state, const Tool<D>& tool, const std::vector<char>& touches,
                   const Teuchos::ParameterList& bodies);

} // namespace Rhegma::rigid_tools
