#pragma once
/// Pressure on the faces right behind a front, which nodes can't feel.

#include "state/State.hpp"

namespace Rhegma::energy_release
{

/// K_I [Pa m^0.5] that the domain integrals miss of a pressure on the faces (CrackSet::pressure); 0 without
/// one.
///
/// Integrals with the acceleration by internal forces contain the work of every load that the nodes feel. On
/// the way to the front the two faces come to share their nodes, where their pressures cancel: for a front on
/// a column of nodes a fraction 1 - r / h of it in the last cell. The crack does feel it: opposite line
/// forces P at the distance r give K_I = P sqrt(2 / (pi r)) (Tada, Paris and Irwin, The Stress Analysis of
/// Cracks Handbook, 3rd ed., 2000, 3.6), so K_I = sqrt(2 / pi) int lost(r) p r^-1/2 dr. Without it K_I under
/// a pressure would be low by p sqrt(32 h / (9 pi)).
///
/// \param tipOffset how far ahead of the front the tip lies that the cells have [m]: r counts from there, and
/// ahead of the front no pressure is felt at all
double intensityLostAtFront(const State<2>& state, const CrackFront<2>& front, double tipOffset);

} // namespace Rhegma::energy_release
