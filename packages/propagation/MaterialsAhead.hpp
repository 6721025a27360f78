#pragma once
/// Fronts that come from one material into another, of which the toughness knows nothing.

#include "propagation/Options.hpp"

namespace Rhegma::propagation
{

/// Warns of each front that would come into a stiffer or softer material if it ran straight on, as far as it
/// gets up to the end of the run and not across gaps between bodies. Not of cracks along a border of
/// materials, whose toughness is that of the border. Reads all particles: call it before they are divided
/// among ranks. \param scene its core
template <int D>
void judgeMaterialsAhead(const Teuchos::ParameterList& scene, const Options& options, State<D>& state);

/// Warns, once for each front, when one of its nodes comes into a stiffer or softer material, unless the
/// crack runs along the border. Collective. \param by advance of the node [m]
template <int D>
void warnOfOtherMaterial(const Options& options, const CrackFront<D>& front, const FrontNode<D>& node,
                         const Vector<D>& by, State<D>& state);

} // namespace Rhegma::propagation
