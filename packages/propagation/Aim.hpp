#pragma once
/// Where a front grows whose toughness depends on direction.

#include "propagation/FrontState.hpp"
#include "propagation/Options.hpp"

#include <vector>

namespace Rhegma::propagation
{

/// The direction of the largest G of a short kink over the toughness in its direction, and what it makes of a
/// comparison of G with `Toughness`. \param modeI, modeII stress intensities [Pa m^0.5] \param ahead angle of
/// the front's direction from the x axis [rad] \param normal 1 or -1: whether the front's normal is to the
/// left of its direction \param straight the front can't turn
Aim aimOf(double modeI, double modeII, double ahead, double normal, const ToughnessRatio& ratio,
          bool straight);

/// Aims the nodes of fronts whose stress intensities are known; nothing where the toughness does not depend
/// on direction, and in 3D.
void aimFronts(const State<2>& state, const Options& options, std::vector<FrontState<2>>& fronts);
void aimFronts(const State<3>& state, const Options& options, std::vector<FrontState<3>>& fronts);

} // namespace Rhegma::propagation
