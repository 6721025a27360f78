#pragma once
/// Units with a square root of a length, such as MPa m^0.5.

#include <optional>
#include <string>

namespace Rhegma
{

/// The square of a unit with one root, as a unit of whole powers: "(MPa)^2 m" of "MPa m^0.5", "MPa sqrt(m)"
/// or "MPa m^(1/2)", "(N/mm)^2/mm" of "N/mm^1.5". None where a unit has no root, or not in one of these
/// forms.
std::optional<std::string> squareOfRoot(const std::string& unit);

} // namespace Rhegma
