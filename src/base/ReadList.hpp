#pragma once
/// Values out of a validated scene.

#include "base/EntryValue.hpp"
#include "base/Types.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace Rhegma
{

/// An array of D numbers.
template <int D>
Vector<D> readVector(const Teuchos::ParameterList& list, const std::string& name)
{
  const auto* const found = valueIf<Teuchos::Array<double>>(list, name);
  const auto& values = found != nullptr ? *found : list.get<Teuchos::Array<double>>(name); // which throws
  Vector<D> v;
  for (int d = 0; d < D; ++d)
    v[d] = values[d];
  return v;
}

/// Names of the sublists in the order of the scene.
inline std::vector<std::string> sublistNames(const Teuchos::ParameterList& list)
{
  std::vector<std::string> names;
  for (const auto& entry : list)
    if (entry.second.isList())
      names.push_back(entry.first);
  return names;
}

} // namespace Rhegma
