#pragma once
/// A plate of steel without Poisson's effect, for tests of supports.

#include "Simulation.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_DefaultMpiComm.hpp>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace Rhegma
{
namespace Test
{

using Reals = Teuchos::Array<double>;

inline Reals pair(double x, double y) { return Reals(std::vector<double>{x, y}); }

/// A box in a square domain from `from` to `to` [m] along both axes, 1 ms.
inline Teuchos::RCP<Teuchos::ParameterList> steelPlate(double from, double to, double cell,
                                                       const Reals& lower, const Reals& upper)
{
  const auto scene = Teuchos::rcp(new Teuchos::ParameterList("Rhegma"));
  Teuchos::ParameterList& domain = scene->sublist("Domain");
  domain.set("Dimension", 2);
  domain.set("Lower Corner", Reals(2, from));
  domain.set("Upper Corner", Reals(2, to));
  domain.set("Cell Size", cell);
  scene->sublist("Time").set("Final Time", 1e-3);
  Teuchos::ParameterList& steel = scene->sublist("Materials").sublist("Steel");
  steel.set<std::string>("Model", "Linear Elastic");
  steel.set("Density", 7800.0);
  steel.set("Young Modulus", 2.1e11);
  steel.set("Poisson Ratio", 0.0);
  Teuchos::ParameterList& body = scene->sublist("Bodies").sublist("Plate");
  body.set<std::string>("Material", "Steel");
  body.set<std::string>("Shape", "Box");
  body.set("Lower Corner", lower);
  body.set("Upper Corner", upper);
  return scene;
}

/// The error message of a scene; empty if a step of it runs.
inline std::string refusal(const Teuchos::RCP<Teuchos::ParameterList>& scene)
{
  try
  {
    Simulation simulation(Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD)), scene);
    simulation.initialize();
    simulation.advance(1e-9);
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  return "";
}

} // namespace Test
} // namespace Rhegma
