#pragma once
/// Which front nodes advance, by how much and in which direction.

#include "propagation/FrontState.hpp"
#include "propagation/Options.hpp"

#include <vector>

namespace Rhegma::propagation
{

/// Marks the fronts whose driving forces are needed at the end of the step (CrackFront::due): those that may
/// advance, and those whose last are older than Options::samplingCells allows. A wave takes many steps across
/// the domain of a J integral. In equilibrium, all.
template <int D>
void markDue(State<D>& state, const Options& options, std::vector<FrontState<D>>& fronts);

/// Marks the front nodes that may advance after the step that ends (FrontNode::advances): those whose J
/// reaches the toughness Gc(v, T), of fronts that are due. Whether J opens the crack follows from their
/// stress intensities, which are computed next. Sets the speeds of all nodes, and State::failure where a
/// toughness is not positive. Stops nodes whose J can't be computed (DrivingForce::lost). In equilibrium all
/// nodes are marked that can advance.
template <int D>
void selectAdvancing(State<D>& state, const Options& options, std::vector<FrontState<D>>& fronts);

/// In equilibrium: finds the largest G/Gc of the marked nodes (EquilibriumGrowth::drive), of the opening part
/// of G. Needs their stress intensities.
template <int D>
void measureDrive(State<D>& state, const Options& options, std::vector<FrontState<D>>& fronts);

/// Advances the selected front nodes (CrackSet::advances) where the opening part of J reaches Gc(v, T), in
/// the direction of Options::direction. In equilibrium, if EquilibriumGrowth::advance is set, those advance
/// whose G/Gc is near the largest.
template <int D>
void advanceSelected(State<D>& state, const Options& options, std::vector<FrontState<D>>& fronts);

} // namespace Rhegma::propagation
