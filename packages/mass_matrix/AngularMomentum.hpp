#pragma once
/// Angular momentum of the particles.

#include "state/State.hpp"

namespace Rhegma::mass_matrix
{

/// Sum of m x cross v about the origin [kg m2/s]; in 2D the component out of the plane, in the last position.
template <int D>
Vector<3> angularMomentum(const State<D>& state);

} // namespace Rhegma::mass_matrix
