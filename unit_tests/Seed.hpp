#pragma once
/// The seed of tests with random numbers.

#include <cstdlib>
#include <iostream>
#include <random>

namespace Rhegma::Test
{

/// A seed, printed; RHEGMA_SEED in the environment repeats one.
inline unsigned seed()
{
  const char* const given = std::getenv("RHEGMA_SEED");
  const unsigned value =
      given != nullptr ? static_cast<unsigned>(std::atol(given)) : std::random_device{}() % 1000000;
  std::cout << "RHEGMA_SEED=" << value << "\n";
  return value;
}

} // namespace Rhegma::Test
