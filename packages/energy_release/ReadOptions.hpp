#pragma once
/// Options of the energy release rates.

#include "energy_release/Contour.hpp"
#include "energy_release/CrackClosure.hpp"
#include "plan/Effect.hpp"

#include <set>
#include <string>
#include <vector>

namespace Rhegma::energy_release
{

struct Options
{
  GivenRadii radii;
  bool contour = true; ///< domain integrals are requested
  bool closure = true;
  std::set<std::string> pushed; ///< cracks with Face Pressure, of which closure would leave out the pressure
  bool lumped = false;
  bool openingKnown = true; ///< shape functions without linear completeness give no opening to close
  int columns = 1;
  double toughness = 0.0;         ///< with which G is compared [J/m2]; 0: none
  double criticalIntensity = 0.0; ///< K_Ic from which that is [Pa m^0.5]; 0: it was not given
  RecoveryMatrix recovery = consistentMatrix();
};

/// The section `Energy Release`.
Section energyReleaseSection();

/// Checks the section against the rest of the scene.
void checkEnergyRelease(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors);

Options readOptions(const Teuchos::ParameterList& scene, const RunOptions& run);

} // namespace Rhegma::energy_release
