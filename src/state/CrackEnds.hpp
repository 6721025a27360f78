#pragma once
/// A crack may also end at another crack, besides surface-breaking ends and fronts (CrackSet.hpp).

namespace Rhegma::facet
{

constexpr int joined = -3; ///< beyond it lies another crack, which this one has met

} // namespace Rhegma::facet
