#pragma once
/// How a crack may end next to at a surface-breaking end or at a front (CrackSet.hpp).

namespace Rhegma::facet
{

constexpr int joined = -3; ///< beyond it lies another crack, on which this one has ended: no way out of it

} // namespace Rhegma::facet
