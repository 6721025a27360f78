#pragma once
/// What a run says first in its summary and last on the terminal.

#include <nlohmann/json.hpp>

#include <ostream>
#include <string>

namespace Rhegma::program
{

/// Completes `answers` of a summary, in which effects have theirs: before these how the run ended and the
/// fronts that stopped numerically, after these the energy balance, and how many warnings there are and of
/// what. Adds `energy_balance` with the numbers of the balance. \param summary with status, time, steps and
/// warnings
void addAnswers(nlohmann::json& summary);

/// Prints them. \param failed the program says itself why the run could not go on, which is the first answer
void printAnswers(const nlohmann::json& summary, bool failed, std::ostream& out);

} // namespace Rhegma::program
