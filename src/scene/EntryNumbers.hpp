#pragma once
/// Numbers and texts of entries of a list, whatever their type is.

#include <Teuchos_ParameterEntry.hpp>

#include <optional>
#include <string>
#include <vector>

namespace Rhegma
{

/// A number of any arithmetic type; not a bool.
std::optional<double> numberIn(const Teuchos::ParameterEntry& entry);

/// An array of numbers, or one number as an array of one.
std::optional<std::vector<double>> numbersIn(const Teuchos::ParameterEntry& entry);

/// A text of either type.
std::optional<std::string> textIn(const Teuchos::ParameterEntry& entry);

} // namespace Rhegma
