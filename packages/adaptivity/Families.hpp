#pragma once
/// Particles that were split and lie in coarse cells again. A family is all parts of one particle.

#include "state/State.hpp"

#include <array>
#include <vector>

namespace Rhegma::adaptivity
{

/// How many parts a particle is split into.
template <int D>
constexpr int parts = 1 << D;

/// Rows of the parts of one particle, in the order of their lineage.
template <int D>
using Family = std::array<int, parts<D>>;

/// Rows of this rank's particles that are finer than the leaf in which they lie.
template <int D>
View<int*> tooSmall(const State<D>& state);

/// Families of which all parts are among the listed rows, in an order that does not depend on that of the
/// rows.
template <int D>
std::vector<Family<D>> wholeFamilies(const State<D>& state, const View<int*>& list);

} // namespace Rhegma::adaptivity
