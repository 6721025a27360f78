#pragma once
/// Which front nodes advance, by how much and in which direction.

#include "propagation/FrontState.hpp"
#include "propagation/Options.hpp"

#include <vector>

namespace Rhegma::propagation
{

/// Marks the front nodes that may advance after the step that ends (FrontNode::advances): those whose J
/// reaches the toughness Gc(v, T). Only their stress intensities, which are computed next, say whether J
/// opens the crack. Sets the speeds of all nodes, and State::failure where a toughness is not positive.
template <int D>
void selectAdvancing(State<D>& state, const Options& options, std::vector<FrontState<D>>& fronts);

/// Asks the selected front nodes to advance (CrackSet::advances) where what opens the crack reaches Gc(v, T),
/// in the direction of Options::direction.
template <int D>
void advanceSelected(State<D>& state, const Options& options, std::vector<FrontState<D>>& fronts);

} // namespace Rhegma::propagation
