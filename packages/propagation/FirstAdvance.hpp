#pragma once
/// What is known of the first advance of a front: G, its modes, and what kept it from advancing before.

#include "propagation/FrontState.hpp"
#include "propagation/Options.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace Rhegma::propagation
{

/// Adds to the entry of a front G over the initiation toughness of its first advance (`start_release`), the
/// stress intensities of that time (`start_K_I`, `start_K_II`, in 3D `start_K_III`), null where it has not
/// advanced; the largest G over the initiation toughness before `Propagation > Start Time` of the samples
/// that there were
/// (`release_before_start_time`), null where there was none; and `held_until_start_time`: whether G had
/// reached the toughness before that time and the front advanced as soon as it let it.
template <int D>
void reportFirstAdvance(const State<D>& state, const Options& options, const FrontState<D>& own,
                        nlohmann::json& entry);

/// What the answer says of a front that was held: ", held by Propagation > Start Time until 20 us: it started
/// at 3.2 times the initiation toughness"; of one whose G had reached the toughness before, but that started
/// later, " (before Propagation > Start Time = 20 us G had reached 1.7 times the initiation toughness)";
/// empty of any other. \param front its entry in the summary
std::string holdAsText(const Options& options, const nlohmann::json& front);

/// What it says of a front whose faces pressed together as it started, with K_I; empty of any other, and
/// where K_I is above minus a twentieth of K.
std::string closureAsText(const nlohmann::json& front);

/// Of a front in 3D the shear as it started, which the toughness is not compared with apart: "as it started,
/// K_II is 23 % of K_I, but in 3D only G is compared"; empty where it is small, and in 2D.
std::string shearAtStart(const nlohmann::json& front);

} // namespace Rhegma::propagation
