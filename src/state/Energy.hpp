#pragma once
/// The energy ledger.

namespace Rhegma
{

/// Energies of a run [J]. What the books cannot account for is the residual:
/// (kinetic + strain) now - at the start - external work + damped + plastic + contact + fracture + merged -
/// combustion.
struct EnergyLedger
{
  double kinetic = 0.0;
  double strain = 0.0;
  double start = 0.0; ///< kinetic + strain when the run began
  double thermal = 0.0;
  double externalWork = 0.0;
  double ties = 0.0;    ///< elastic, of ties just behind crack fronts; a part of `strain`
  double damped = 0.0;  ///< by the damping effect
  double plastic = 0.0; ///< spent in plastic flow
  double contact = 0.0;
  double fracture = 0.0;
  double merged = 0.0;
  double combustion = 0.0;

  double residual() const
  {
    return kinetic + strain - start - externalWork + damped + plastic + contact + fracture + merged -
           combustion;
  }
};

} // namespace Rhegma
