#pragma once
/// Configurational forces of the particles around a front in 3D, of which J is the sum.

#include "energy_release/InternalAcceleration.hpp"

namespace Rhegma::energy_release
{

/// The configurational force [N] on each row of nodes, G_n of FrontIntegral.hpp, of the particles of this
/// rank in a box. Turned by the mean rotation of all particles in it, and relative to their mean velocity, as
/// neither releases energy. Collective. \param acceleration of nodes by internal forces, and by pressure on
/// faces [m/s2], row by row
View<double* [3]> configurationalForces(const State<3>& state, const Region<3>& box,
                                        const NodalAcceleration<3>& acceleration);

} // namespace Rhegma::energy_release
