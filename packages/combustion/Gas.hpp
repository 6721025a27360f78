#pragma once
/// The gas in a crack.

#include <string>

namespace Rhegma
{
class Archive;
}

namespace Rhegma::combustion
{

/// Equation of state: p (V - b m) = m R T (Noble and Abel; ideal where b = 0), c_v = R / (gamma - 1).
struct GasLaw
{
  double constant = 0.0;            ///< R [J/(kg K)]
  double heatRatio = 1.4;           ///< gamma [-]
  double covolume = 0.0;            ///< b [m3/kg]
  double flameTemperature = 0.0;    ///< of what burns at constant volume [K]
  bool constantTemperature = false; ///< the walls keep the gas at the flame temperature

  double heatCapacity() const { return constant / (heatRatio - 1.0); } ///< c_v [J/(kg K)]
  /// Mass that flows in a second [kg/s] from gas at rest into an outside pressure: choked below the critical
  /// ratio of pressures, else isentropic; nothing flows in. Source: Shapiro, The Dynamics and Thermodynamics
  /// of Compressible Fluid Flow, 1953, section 4.5; with a covolume as derived in Gas.cpp.
  /// \param area times the coefficient of discharge [m2]
  double outflow(double area, double pressure, double temperature, double outside) const;
  /// Changes pressure and temperature of gas that moves at a speed [m/s] to those of stagnation without
  /// losses: p (1/rho - b)^gamma and the total enthalpy are conserved.
  void stagnate(double& pressure, double& temperature, double speed) const;
};

/// Mass and energy of the gas in one crack, with all that has been added and removed.
///
/// Solid that burns brings the internal energy c_v T_f, so that gas that burns in a rigid cavity has the
/// temperature T_f. Work on the faces reduces the internal energy; an outflow removes its enthalpy. The
/// balance is
///
///     U = U_start + c_v T_f burnt + heat of what burnt + passed enthalpy - work - vented enthalpy
///         - heat to the walls,
///
/// where the heat of what burnt is that of the solid above its temperature at the start, and the passed
/// enthalpy is what came from other cracks less what went there.
class Gas
{
public:
  Gas() = default;
  explicit Gas(const GasLaw& law) : law_(law) {}

  /// Fills a volume [m3] at the start.
  void fill(double pressure, double temperature, double volume);

  /// With a mass [kg] and an energy [J] instead.
  void fillWith(double mass, double energy);

  void burn(double mass, double heat);   ///< [kg], and the heat that it had as a solid [J]
  void doWork(double energy);            ///< that the gas did [J]
  void vent(double mass, double volume); ///< [kg]
  void heatWalls(double heat);           ///< [J]
  /// Records an outflow with its enthalpy [kg, J].
  void recordOutflow(double mass, double enthalpy);
  /// Records an inflow from the gas of another crack with its enthalpy; negative: an outflow to it [kg, J].
  void pass(double mass, double enthalpy);
  /// Where the temperature is constant, records the heat that the walls supply or take to keep it.
  void settle();

  double mass() const { return mass_; }     ///< [kg]
  double burnt() const { return burnt_; }   ///< [kg]
  double vented() const { return vented_; } ///< [kg]
  double energy() const { return energy_; } ///< internal [J]
  double temperature() const;               ///< [K]
  double pressure(double volume) const;     ///< [Pa]
  /// c_v T + p V / m of the gas in a volume [J/kg].
  double enthalpy(double volume) const;
  /// Lower bound of the volume [m3].
  double leastVolume() const { return law_.covolume * mass_; }
  const GasLaw& law() const { return law_; }

  double startMass() const { return startMass_; }
  double startEnergy() const { return startEnergy_; }
  double workDone() const { return work_; }             ///< [J]
  double ventedEnergy() const { return ventedEnergy_; } ///< [J]
  double wallHeat() const { return wallHeat_; }         ///< to the walls [J]
  double solidHeat() const { return solidHeat_; }       ///< of what burnt [J]
  double passed() const { return passed_; }             ///< come from other cracks less gone there [kg]
  double passedEnergy() const { return passedEnergy_; } ///< of that [J]

  /// Mass that flows out through an opening [kg/s]: GasLaw::outflow.
  double outflow(double area, double volume, double outside) const;

  void serialize(Archive& archive);

private:
  GasLaw law_;
  double mass_ = 0.0, energy_ = 0.0;
  double startMass_ = 0.0, startEnergy_ = 0.0;
  double burnt_ = 0.0, vented_ = 0.0, work_ = 0.0, ventedEnergy_ = 0.0, wallHeat_ = 0.0, solidHeat_ = 0.0;
  double passed_ = 0.0, passedEnergy_ = 0.0;
};

} // namespace Rhegma::combustion
