#pragma once
/// Energy release rates and stress intensities of crack fronts.

#include "plan/Effect.hpp"

namespace Rhegma::energy_release
{

/// The effect `Energy Release`: at every sample the energy release rate of each front by a dynamic J and by
/// crack closure, and its stress intensities by interaction integrals.
///
/// Columns NAME.N.G_J, NAME.N.G_closure [J/m2], NAME.N.K_I, NAME.N.K_II [Pa m^0.5], NAME.N.length [m],
/// NAME.N.speed [m/s], NAME.N.x, NAME.N.y [m], of front N of the crack NAME. A front that does not run along
/// the grid has no G_closure, nor has one in the formulation Broken Cell: without linear completeness its
/// opening can't be recovered from the particles.
///
/// summary.json has them too, and next to them of each front kink_angle (counter-clockwise, degrees: the
/// direction of the largest hoop stress), tip_offset (how far ahead of the front's position the tip of the
/// crack in the cells lies) and the radii used, inner_radius and outer_radius [m].
EffectEntry energyReleaseEntry();

} // namespace Rhegma::energy_release
