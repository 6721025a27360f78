#pragma once
/// The energy balance.

namespace Rhegma
{

/// Energies of a run [J]. The residual is kinetic + strain + tools - start + thermal - external work -
/// heat + damped + filtered + plastic + contact + fracture + merged + stabilised - combustion.
struct EnergyBalance
{
  double kinetic = 0.0; ///< of the motion, now
  double strain = 0.0;  ///< stored elastically, now
  double tools = 0.0;   ///< kinetic, of rigid tools that move by their mass, now
  double start = 0.0;   ///< kinetic + strain + tools + plastic when the run began; in equilibrium less what
                        ///< stress out of balance then releases in the first load step
  double thermal = 0.0; ///< heat in the bodies, less that at the start
  double thermalStart = 0.0; ///< heat in the bodies when the run began
  double heat = 0.0;         ///< supplied through the surface, by sources or by crack fronts
  double roundOff = 0.0;     ///< estimated rounding error of the largest energies
  double externalWork = 0.0; ///< done by loads, supports and body forces
  double springs = 0.0;      ///< elastic, of springs behind fronts, of interfaces; a part of `strain`
  double damped = 0.0;       ///< by the damping effect
  double filtered = 0.0;     ///< kinetic energy that PIC in the velocity update takes from the particles
  double plastic = 0.0;      ///< spent in plastic flow, less what became heat
  double contact = 0.0;      ///< lost by friction and impact of faces
  double fracture = 0.0;     ///< dissipated by new crack faces
  double merged = 0.0;       ///< lost where particles merged
  double stabilised =
      0.0; ///< spent by the ghost penalty of cut cells in equilibrium, by the damping of springs
  double combustion = 0.0; ///< given to the body by burnt gas

  double residual() const
  {
    return kinetic + strain + tools - start + thermal - externalWork - heat + damped + filtered + plastic +
           contact + fracture + merged + stabilised - combustion;
  }
};

} // namespace Rhegma
