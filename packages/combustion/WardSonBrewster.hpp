#pragma once
/// Steady burning of a solid whose surface decomposes, and whose gas reacts near it.

namespace Rhegma::combustion
{

/// Constants of the model of Ward, Son and Brewster (Combust. Flame 114 (1998) 556).
struct WardSonBrewster
{
  double prefactor = 0.0;         ///< A_c, of the decomposition of the solid [1/s]
  double activation = 0.0;        ///< E_c, of the same [J/mol]
  double gasPrefactor = 0.0;      ///< B_g, of the reaction in the gas [m3/(kg s K2)]
  double heatOfSolid = 0.0;       ///< Q_c, released in the solid [J/kg]
  double heatOfGas = 0.0;         ///< Q_g, released in the gas [J/kg]
  double solidConductivity = 0.0; ///< k_c [W/(m K)]
  double gasConductivity = 0.0;   ///< k_g [W/(m K)]
  double capacity = 0.0;          ///< c, of solid and gas [J/(kg K)]
  double molarMass = 0.0;         ///< M, of the gas [kg/mol]
  double temperature = 0.0;       ///< T_0, of the solid away from the surface [K]
  double density = 0.0;           ///< of the solid [kg/m3]
};

/// A steadily burning surface.
struct BurningSurface
{
  double temperature; ///< of the surface [K]
  double rate;        ///< at which it recedes [m/s]
};

/// The surface at a pressure [Pa]. The temperature T_s is that at which two mass fluxes m [kg/(m2 s)] agree,
/// with the gas constant R:
///
/// decomposition in the solid, of large activation energy: m^2 = A_c R T_s^2 k_c rho exp(-E_c / (R T_s)) /
/// (E_c c (T_s - T_0 - Q_c / (2 c)));
///
/// the energy of the surface, heated by a gas that reacts with zero activation energy: T_s = T_0 + Q_c / c +
/// Q_g / c C / (m + sqrt(m^2 + C))^2, C = 4 k_g B_g (M p / R)^2 / c.
///
/// The difference of the two sides rises with T_s, so that there is one solution between T_0 + Q_c / c and
/// T_0 + (Q_c + Q_g) / c.
BurningSurface burningSurface(const WardSonBrewster& solid, double pressure);

} // namespace Rhegma::combustion
