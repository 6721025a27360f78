#pragma once
/// Configurational forces of the particles around a front in 3D, of which J is the sum.

#include "energy_release/FrontRows.hpp"
#include "state/BodyGroup.hpp"

namespace Rhegma::energy_release
{

/// Configurational force of nodes, enriched fields included [N]; the last column is spare.
using ConfigurationalForces = View<double* [4]>;

/// The configurational force on each row of nodes, G_n of FrontIntegral.hpp, of the particles of this rank in
/// a box. Turned by the mean rotation of all particles in it, and relative to their mean velocity, as neither
/// releases energy. Rows of nodes that no particle of the box touches are those of earlier calls. Collective.
/// \param own the particles that count \param acceleration of nodes by internal forces, and by pressure on
/// faces [m/s2], row by row
ConfigurationalForces configurationalForces(const State<3>& state, const ParticlesOfGroup& own,
                                            const Region<3>& box, const NodalAcceleration<3>& acceleration,
                                            const FrontWork<3>& kept);

} // namespace Rhegma::energy_release
