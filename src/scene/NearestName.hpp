#pragma once
/// The name that a user most likely meant.

#include <string>
#include <vector>

namespace Rhegma
{

/// The text with ASCII letters in lower case.
std::string lowerCase(std::string text);

/// Fewest letters to insert, delete, change or swap with a neighbour, blind to case (Damerau 1964; each pair
/// of neighbours at most once).
int editDistance(const std::string& a, const std::string& b);

/// The nearest of the names, or an empty text if none is near enough to be a misspelling.
std::string nearestName(const std::string& given, const std::vector<std::string>& names);

/// `did you mean "Young Modulus"?`, or all of the names if none is near.
std::string suggestion(const std::string& given, const std::vector<std::string>& names);

/// The message for a parameter that had another name in an earlier version.
std::string renamedTo(const std::string& newName);

/// "A", "A or B", "A, B or C".
std::string asText(const std::vector<std::string>& names, const std::string& lastJoin = " or ");

} // namespace Rhegma
