#pragma once
/// Sets of fronts, each by its crack and its number there.

#include "archive/Archive.hpp"

#include <set>
#include <utility>
#include <vector>

namespace Rhegma::energy_release
{

using FrontSet = std::set<std::pair<int, int>>;

/// Saves a set or loads it.
inline void storeFronts(FrontSet& fronts, const char* name, Archive& archive)
{
  std::vector<int> numbers;
  numbers.reserve(2 * fronts.size());
  for (const auto& [crack, number] : fronts)
    numbers.insert(numbers.end(), {crack, number});
  archive(name, numbers, 2);
  for (std::size_t k = 0; k + 1 < numbers.size(); k += 2)
    fronts.insert({numbers[k], numbers[k + 1]});
}

} // namespace Rhegma::energy_release
