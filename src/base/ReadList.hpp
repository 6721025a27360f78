#pragma once
/// Values out of a validated scene.

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
  const auto& values = list.get<Teuchos::Array<double>>(name);
  Vector<D> v;
  for (int d = 0; d < D; ++d)
    v[d] = values[d];
  return v;
}

/// Names of the sublists in the order of the scene.
inline std::vector<std::string> sublistNames(const Teuchos::ParameterList& list)
{
  std::vector<std::string> names;
  for (auto entry = list.begin(); entry != list.end(); ++entry)
    if (list.isSublist(list.name(entry)))
      names.push_back(list.name(entry));
  return names;
}

} // namespace Rhegma
