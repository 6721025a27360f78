#pragma once
/// Whether domain integrals fit round the fronts of a scene.

#include "energy_release/ReadOptions.hpp"
#include "state/State.hpp"

namespace Rhegma::energy_release
{

/// Refuses radii that the scene gives and that do not fit, and scenes without a front; warns of radii that
/// are reduced, of contours that meet cracks, and of those through the cells of a front. Collective.
/// \param driving contours by which cracks grow; null where none does
///
/// Throws std::invalid_argument, with the section's path.
template <int D>
void checkTubes(State<D>& state, const Options& options, const DrivingContours* driving = nullptr);

} // namespace Rhegma::energy_release
