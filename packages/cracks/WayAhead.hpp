#pragma once
/// How much material is ahead of a front in 2D.

#include "cracks/Chains.hpp"

namespace Rhegma::cracks
{

/// What becomes of an advance.
struct Outcome
{
  double length;     ///< [m]
  bool ends = false; ///< at the surface
};

/// Whether a front can make its advance or runs on to a surface, of which less than half a cell of material
/// then is left. Collective. \param first whether it lies at the first end of its crack
Outcome findRoom(const State<2>& state, const Chain& chain, bool first, const CrackFront<2>& front,
                 const FrontAdvance<2>& advance);

} // namespace Rhegma::cracks
