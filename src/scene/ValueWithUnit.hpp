#pragma once
/// A value of a scene that is given in a unit, until it is converted (scene/ConvertUnits.hpp).

#include <Teuchos_ParameterEntry.hpp>

#include <ostream>
#include <string>

namespace Rhegma
{

/// What <Parameter ... unit="..."/> gives; an entry of a list may hold it.
struct ValueWithUnit
{
  Teuchos::ParameterEntry value; ///< as it would be without the unit
  std::string unit;              ///< as written
};

// Teuchos compares and prints what an entry holds.
inline bool operator==(const ValueWithUnit& a, const ValueWithUnit& b)
{
  return a.unit == b.unit && a.value == b.value;
}

inline std::ostream& operator<<(std::ostream& out, const ValueWithUnit& given)
{
  return out << given.value << " " << given.unit;
}

} // namespace Rhegma
