#pragma once
/// Functions one after the other.

#include <functional>
#include <utility>

namespace Rhegma
{

/// Calls both with the same arguments, the first if it is not empty.
template <class... Arguments, class Then>
std::function<void(Arguments...)> inOrder(std::function<void(Arguments...)> first, Then then)
{
  return [first = std::move(first), then = std::move(then)](Arguments... arguments)
  {
    if (first)
      first(arguments...);
    then(arguments...);
  };
}

} // namespace Rhegma
