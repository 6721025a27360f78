#pragma once
/// The part of a crack that is nearest to a node.

#include "cracks/Sides.hpp"

namespace Rhegma::cracks
{

/// In Surroundings::nearest, where no simplex is near.
constexpr std::uint64_t noSimplex = ~std::uint64_t(0);

/// Finds the nearest simplex of each node in the band, independent of the order of threads.
/// Surroundings::nearest must hold noSimplex before.
template <int D>
void findNearest(const State<D>& state, const Surroundings& around);

} // namespace Rhegma::cracks
