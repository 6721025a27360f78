#pragma once
/// Numbers in messages that are none.

#include <string>

namespace Rhegma
{

/// Position of the next "nan" or "inf" in a message that stands for a number, and not in a quotation or for a
/// name of the user's, which follows "> " or a noun such as "crack ", or is longer than these letters, with
/// hyphens, points and underscores; std::string::npos: there is none.
std::size_t findNonNumber(const std::string& message, std::size_t from = 0);

/// The message with words in place of what is no number: "the crack is endlessly many cells long".
std::string withWordsForNonNumbers(std::string message);

} // namespace Rhegma
