#pragma once
/// How a crack may end beside at a mouth or at a front (CrackSet.hpp).

namespace Rhegma::facet
{

constexpr int joined = -3; ///< beyond it lies another crack, on which this one has ended: no way out of it

} // namespace Rhegma::facet
