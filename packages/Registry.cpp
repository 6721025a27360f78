#include "adaptivity/Adaptivity.hpp"
#include "combustion/Combustion.hpp"
#include "contact/Contact.hpp"
#include "cracks/Cracks.hpp"
#include "damping/Damping.hpp"
#include "energy_release/EnergyRelease.hpp"
#include "face_pressure/FacePressure.hpp"
#include "load_balance/LoadBalance.hpp"
#include "mass_matrix/MassMatrix.hpp"
#include "propagation/Propagation.hpp"
#include "step/Effect.hpp"
#include "sub_cycling/SubCycling.hpp"
#include "thermal/Thermal.hpp"

namespace Rhegma
{

/// Every effect that the program knows. A new effect adds one line.
const std::vector<EffectEntry>& knownEffects()
{
  static const std::vector<EffectEntry> effects = {
      cracks::cracksEntry(),
      thermal::thermalEntry(),
      adaptivity::adaptivityEntry(),
      combustion::combustionEntry(),
      contact::contactEntry(),
      damping::dampingEntry(),
      energy_release::energyReleaseEntry(),
      face_pressure::facePressureEntry(),
      load_balance::loadBalanceEntry(),
      mass_matrix::massMatrixEntry(),
      propagation::propagationEntry(),
      sub_cycling::subCyclingEntry(),
  };
  return effects;
}

/// A scene that asks for one of these is told so. A new effect takes its name out.
const std::vector<std::string>& effectsToCome()
{
  static const std::vector<std::string> names = {};
  return names;
}

} // namespace Rhegma
