#pragma once
/// How a scene gets contact of crack faces that the program accepts.

#include "state/State.hpp"

#include <string>

namespace Rhegma
{

/// What to write for contact, as the end of a message. Contact excludes other parts of some scenes, and in
/// equilibrium pieces that only faces without friction hold can move. \param state of the run \param cuts
/// whether the crack divides its body \param startsInEquilibrium as by Time > Initial State = Equilibrium
template <int D>
std::string contactAdvice(const State<D>& state, bool cuts, bool startsInEquilibrium)
{
  const bool atRest = state.method.equilibrium();
  std::string text = "add a section Contact";
  if (atRest)
    text += cuts ? " with Law = Stick, or Coulomb and a Friction Coefficient, if the loads press its faces "
                   "together (without friction the pieces can slide)"
                 : " (with Law = Stick, or Coulomb and a Friction Coefficient, if no equilibrium is "
                   "found without friction)";
  if (state.method.analysis == Analysis::LoadFactor)
    text +=
        " and write Propagation > Load Control = Functions of Time, because no factor of loads that close "
        "a crack makes it grow";
  if (atRest && !state.cracks.dualField)
    text += " and write Cracks > Formulation = Dual Field";
  if (atRest && state.ranks.many())
    text += " and start the program without mpirun";
  if (startsInEquilibrium)
    text += " and write Time > Initial State = Unloaded or Equilibrium Without Cracks";
  if (D == 3 && state.cracks.driven && state.mesh.smallestSpacing() < state.mesh.grid.spacing)
    text += " and remove Adaptivity";
  return text;
}

} // namespace Rhegma
