#pragma once
/// What all benchmarks do around their measurement.

#include <Kokkos_Core.hpp>

#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace Rhegma::benchmarks
{

/// Places threads as the program itself does where the user has not decided.
inline void placeThreads()
{
  setenv("OMP_PROC_BIND", "spread", 0);
  setenv("OMP_PLACES", "threads", 0);
}

/// Runs `measure()` while Kokkos runs.
template <class Measure>
nlohmann::json withKokkos(const Measure& measure)
{
  struct Running
  {
    Running() { Kokkos::initialize(); }
    ~Running() { Kokkos::finalize(); }
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;
  };
  const Running running;
  return measure();
}

inline void print(const nlohmann::json& results, bool json, void (*table)(const nlohmann::json&))
{
  if (json)
    std::cout << results.dump(2) << "\n";
  else
    table(results);
}

/// The status of a program that is `body()`; what it throws becomes one line.
template <class Body>
int statusOf(const std::string& program, const Body& body)
{
  try
  {
    body();
  }
  catch (const std::exception& error)
  {
    std::cerr << program << ": " << error.what() << "\n";
    return 1;
  }
  return 0;
}

} // namespace Rhegma::benchmarks
