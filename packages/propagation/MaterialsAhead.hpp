#pragma once
/// Fronts that come from one material into another, of which the toughness knows nothing.

#include "propagation/Options.hpp"

namespace Rhegma::propagation
{

/// Warns of each front that would come into a stiffer or softer material if it ran straight on. Reads all
/// particles: call it before they are divided among ranks.
template <int D>
void judgeMaterialsAhead(const Options& options, State<D>& state);

/// Warns, once for each front, when one of its nodes comes into a stiffer or softer material. Collective.
/// \param from position of the node [m] \param by its advance [m]
template <int D>
void warnOfOtherMaterial(const Options& options, const CrackFront<D>& front, const Vector<D>& from,
                         const Vector<D>& by, State<D>& state);

} // namespace Rhegma::propagation
