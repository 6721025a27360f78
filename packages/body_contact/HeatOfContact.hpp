#pragma once
/// Heat that bodies which touch pass to each other, and heat by friction between them.

#include "body_contact/HeatLaw.hpp"
#include "body_contact/NodalContact.hpp"

namespace Rhegma::body_contact
{

/// What lasts from step to step.
template <int D>
struct HeatOfContact
{
  bool used = false; ///< whether particles have temperatures
  Conductances conductance;
  View<double*> change; ///< of the temperature of each row of the nodes, zero between steps [K]
};

/// Heats the particles of pairs that press on each other, or that springs join; needs the energy that contact
/// has taken in the step. Each node does so by itself, with the capacities C = sum N c V and temperatures
/// sum N c V (T + g . (x_i - x)) / C of its two fields: exact for linear temperatures.
///
/// The energy that friction takes becomes heat. Its parts are those of two half spaces that slide on each
/// other and have one temperature at their faces: in proportion to the effusivity sqrt(k c) (Blok 1937;
/// Carslaw and Jaeger, Conduction of Heat in Solids, 2.9), or to the capacity where neither conducts.
///
/// Through faces of area A the heat dt h A (T_1 - T_2) passes, with the temperatures at the end of the step
/// (backward Euler), so that any conductance h is stable. A is what bounds both fields, the lesser of +-sum V
/// grad N . n. Heat is conserved to round-off: what one field gets the other one loses, and particles get the
/// changes of their nodes. Writes heat by friction and heat passed of each pair, and takes the first from the
/// energy that contact has taken.
template <int D>
void passHeat(State<D>& state, const SharedNodes<D>& shared, NodalPairs<D>& pairs, HeatOfContact<D>& heat);

} // namespace Rhegma::body_contact
