#pragma once
/// Warnings of scenes, for tests of what judges them.

#include "src/boundary/SteelPlate.hpp"

#include <algorithm>

namespace Rhegma
{
namespace Test
{

using Warnings = std::vector<std::string>;

/// Those before the first step, with those that a run replaces by what it computes.
inline Warnings warningsOf(const Teuchos::RCP<Teuchos::ParameterList>& scene)
{
  Simulation simulation(Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_WORLD)), scene);
  simulation.initialize();
  const auto report = simulation.report();
  Warnings all = report["warnings"].get<Warnings>();
  const Warnings estimates = report.value("warnings_of_a_check", Warnings{});
  all.insert(all.end(), estimates.begin(), estimates.end());
  return all;
}

/// Whether one contains a text.
inline bool say(const Warnings& warnings, const std::string& text)
{
  return std::any_of(warnings.begin(), warnings.end(),
                     [&](const std::string& warning) { return warning.find(text) != std::string::npos; });
}

/// A plate of 1 m by 1 m with room of 0.4 m around it.
inline Teuchos::RCP<Teuchos::ParameterList> freePlate(double cell = 0.1)
{
  return steelPlate(-0.4, 1.4, cell, pair(0.0, 0.0), pair(1.0, 1.0));
}

/// A boundary of a type.
inline Teuchos::ParameterList& boundary(Teuchos::ParameterList& scene, const std::string& name,
                                        const std::string& type)
{
  Teuchos::ParameterList& list = scene.sublist("Boundaries").sublist(name);
  list.set("Type", type);
  return list;
}

/// A traction on the plate's right side, along x [Pa].
inline Teuchos::ParameterList& pull(Teuchos::ParameterList& scene, double stress)
{
  Teuchos::ParameterList& list = boundary(scene, "Pull", "Traction");
  list.set<std::string>("Body", "Plate");
  list.set("From", pair(1.0, 0.0));
  list.set("To", pair(1.0, 1.0));
  list.set("Stress", pair(stress, 0.0));
  return list;
}

/// A support of the nodes in a box.
inline Teuchos::ParameterList& hold(Teuchos::ParameterList& scene, const std::string& name,
                                    const Reals& lower, const Reals& upper,
                                    const Reals& value = Reals(2, 0.0))
{
  Teuchos::ParameterList& list = boundary(scene, name, "Velocity");
  list.set("Lower Corner", lower);
  list.set("Upper Corner", upper);
  list.set("Value", value);
  return list;
}

/// A cut out of the plate.
inline void bore(Teuchos::ParameterList& scene, const Reals& lower, const Reals& upper)
{
  Teuchos::ParameterList& list =
      scene.sublist("Bodies").sublist("Plate").sublist("Operations").sublist("Bore");
  list.set<std::string>("Operation", "Cut");
  list.set<std::string>("Shape", "Box");
  list.set("Lower Corner", lower);
  list.set("Upper Corner", upper);
}

} // namespace Test
} // namespace Rhegma
