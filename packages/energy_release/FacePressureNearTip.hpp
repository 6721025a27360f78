#pragma once
/// Pressure on the faces right behind a front, which cancels on the nodes.

#include "state/State.hpp"

namespace Rhegma::energy_release
{

/// K_I [Pa m^0.5] of the part of a pressure on the faces that the domain integrals miss (CrackSet::pressure);
/// 0 without one.
///
/// Integrals with the acceleration by internal forces contain the work of every load on the nodes. Near the
/// front the two faces have nodes in common, on which their pressures cancel: for a front on a column of
/// nodes a fraction 1 - r / h of it in the last cell. The pressure still loads the crack: opposite line
/// forces P at the distance r give K_I = P sqrt(2 / (pi r)) (Tada, Paris and Irwin, The Stress Analysis of
/// Cracks Handbook, 3rd ed., 2000, 3.6), so K_I = sqrt(2 / pi) int lost(r) p r^-1/2 dr. Without it K_I under
/// a pressure would be low by p sqrt(32 h / (9 pi)).
///
/// \param tipOffset how far the tip of the crack in the cells lies ahead of the front [m]: r is measured from
/// there, and no pressure acts ahead of the front
double intensityLostAtFront(const State<2>& state, const CrackFront<2>& front, double tipOffset);

} // namespace Rhegma::energy_release
