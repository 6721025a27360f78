#include "combustion/Combustion.hpp"

#include "scene/RoundBodies.hpp"

namespace Rhegma::combustion
{

namespace
{

Section wardSonBrewsterSection()
{
  Section s("Ward-Son-Brewster",
            "Burn rate of a solid whose surface decomposes and is heated by the reaction of its gas.");
  s.real("Solid Prefactor").unit("1/s").positive().meaning("Prefactor of the decomposition of the solid.");
  s.real("Solid Activation Energy")
      .unit("J/mol")
      .positive()
      .meaning("Activation energy of the decomposition of the solid.");
  s.real("Gas Prefactor")
      .unit("m3/(kg s K2)")
      .positive()
      .meaning("Prefactor of the reaction in the gas, whose activation energy is zero.");
  s.real("Solid Heat Release")
      .unit("J/kg")
      .notNegative()
      .meaning("Heat that the decomposing solid releases.");
  s.real("Gas Heat Release").unit("J/kg").positive().meaning("Heat that the reacting gas releases.");
  s.real("Solid Conductivity").unit("W/(m K)").positive().meaning("Thermal conductivity of the solid.");
  s.real("Gas Conductivity").unit("W/(m K)").positive().meaning("Thermal conductivity of the gas.");
  s.real("Specific Heat").unit("J/(kg K)").positive().meaning("Specific heat capacity of solid and gas.");
  s.real("Molar Mass").unit("kg/mol").positive().meaning("Molar mass of the gas.");
  s.real("Solid Temperature")
      .unit("K")
      .positive()
      .optional("Thermal > Initial Temperature, or 293")
      .meaning("Temperature of the solid away from its faces.");
  return s;
}

void addBurnLaw(Section& crack)
{
  crack.chosenBy("Burn Law")
      .meaning("Burn rate law: regression rate of a burning face as a function of pressure.");
  Section vieille("Vieille", "Burn rate r = a p^n.");
  vieille.real("Burn Coefficient").unit("m/s/Pa^n").notNegative().meaning("Coefficient a.");
  vieille.real("Burn Exponent")
      .notNegative()
      .meaning("Exponent n. Above 1, the pressure in a closed crack grows without bound in finite time.");
  crack.variant(vieille);
  Section table("Table", "Burn rate by linear interpolation in a table.");
  table.text("Burn Table")
      .unit("Pa:m/s")
      .notEmpty()
      .meaning("Table of pressure:rate, such as \"1e5:1e-3, 1e6:5e-3\". Constant beyond both ends.");
  crack.variant(table);
  crack.variant(wardSonBrewsterSection());
}

void addGas(Section& crack)
{
  crack.real("Solid Density")
      .unit("kg/m3")
      .positive()
      .optional("density of the only material of the scene")
      .meaning("Density of the burning solid.");
  crack.real("Gas Constant").unit("J/(kg K)").positive().meaning("Specific gas constant R.");
  crack.real("Heat Capacity Ratio")
      .above(1.0)
      .atMost(2.0)
      .byDefault(1.25)
      .meaning("Ratio of specific heats c_p / c_v of the gas.");
  crack.real("Covolume")
      .unit("m3/kg")
      .notNegative()
      .byDefault(0.0)
      .meaning("Covolume b of the Noble-Abel equation p (V - b m) = m R T; 0 is an ideal gas.");
  crack.real("Flame Temperature")
      .unit("K")
      .positive()
      .meaning("Flame temperature of the solid at constant volume.");
  crack.choice("Gas Model", {"Uniform", "Flow"})
      .byDefault("Uniform")
      .meaning("Uniform: one pressure in the whole crack. Flow: one-dimensional gas flow along the crack (2D "
               "only).");
  crack.real("Viscosity")
      .unit("Pa s")
      .notNegative()
      .byDefault(0.0)
      .meaning("Viscosity mu of the gas, for Gas Model = Flow. Laminar wall friction is 12 mu u / w^2 per "
               "volume, w being the opening.");
  crack.real("Friction Factor")
      .notNegative()
      .byDefault(0.0)
      .meaning("Darcy friction factor f, for Gas Model = Flow between rough faces. The wall shear stress is "
               "f rho u^2 / 8 on each face.");
  crack.choice("Gas Temperature", {"Energy Balance", "Constant"})
      .byDefault("Energy Balance")
      .meaning("Energy Balance: the temperature follows from the energy balance of the gas; work on the "
               "faces and venting cool it. Constant: the gas stays at the flame temperature.");
}

void addCavity(Section& crack)
{
  crack.real("Initial Temperature")
      .unit("K")
      .positive()
      .byDefault(293.0)
      .meaning("Initial temperature of the gas in the crack.");
  crack.real("Initial Pressure")
      .unit("Pa")
      .positive()
      .optional("Outside Pressure")
      .meaning("Initial pressure of the gas in the crack.");
  crack.real("Outside Pressure")
      .unit("Pa")
      .notNegative()
      .byDefault(101325.0)
      .meaning(
          "Ambient pressure around the body. The faces are loaded by the gas pressure minus this pressure.");
  crack.real("Initial Gap")
      .unit("m")
      .notNegative()
      .byDefault(0.0)
      .meaning("Gap between touching faces, from their roughness.");
  crack.real("Cavity Volume")
      .unit("m3")
      .notNegative()
      .byDefault(0.0)
      .meaning("Gas volume in addition to that between the faces; in 2D for the whole thickness.");
}

void addIgnition(Section& crack)
{
  crack.real("Ignition Time")
      .unit("s")
      .notNegative()
      .byDefault(0.0)
      .meaning("Nothing burns before this time.");
  crack.realArray("Ignition Point")
      .unit("m")
      .perAxis()
      .optional("the whole crack ignites at once")
      .meaning("Point where ignition starts. Needs Flame Speed.");
  crack.realArray("Ignition Lower Corner")
      .unit("m")
      .perAxis()
      .optional("the whole crack ignites at once")
      .meaning("Lower corner of a box in which the faces are ignited.");
  crack.realArray("Ignition Upper Corner")
      .unit("m")
      .perAxis()
      .optional("the whole crack ignites at once")
      .meaning("Upper corner of this box.");
  crack.allOrNoneOf({"Ignition Lower Corner", "Ignition Upper Corner"});
  crack.real("Ignition Temperature")
      .unit("K")
      .positive()
      .optional("no autoignition")
      .meaning("Autoignition temperature of a crack face; the opposite face ignites with it. Needs the "
               "section Thermal.");
  crack.real("Flame Speed")
      .unit("m/s")
      .positive()
      .optional("burning does not spread")
      .meaning("Speed at which burning spreads from the ignition point or box, in a straight line.");
  crack.real("Flame Speed Exponent")
      .notNegative()
      .byDefault(0.0)
      .meaning("Exponent n of a flame speed that depends on the pressure p in the crack: Flame Speed times "
               "(p / Flame Speed Pressure)^n.");
  crack.real("Flame Speed Pressure")
      .unit("Pa")
      .positive()
      .byDefault(1e5)
      .meaning("Pressure at which Flame Speed is given.");
  crack.real("Quenching Coefficient")
      .unit("m2 Pa^n")
      .positive()
      .optional("faces burn at any opening")
      .meaning("Coefficient C of the least opening sqrt(C / p^n), at a gas pressure p, at which faces burn.");
  crack.real("Quenching Exponent")
      .notNegative()
      .optional("faces burn at any opening")
      .meaning("Exponent n of the pressure in the least opening.");
  crack.allOrNoneOf({"Quenching Coefficient", "Quenching Exponent"});
}

void addLosses(Section& crack)
{
  crack.real("Wall Heat Fraction")
      .notNegative()
      .below(1.0)
      .byDefault(0.0)
      .meaning(
          "Fraction of the heat of combustion that goes into the burning faces. Needs the section Thermal.");
  crack.real("Heat Transfer Coefficient")
      .unit("W/(m2 K)")
      .notNegative()
      .byDefault(0.0)
      .meaning(
          "Heat transfer coefficient between the gas and all faces of the crack. Needs the section Thermal.");
  crack.boolean("Venting").byDefault(false).meaning(
      "If true, gas vents where the crack opens at the surface of its body.");
  crack.real("Discharge Coefficient")
      .above(0.0)
      .atMost(1.0)
      .byDefault(0.85)
      .meaning("Discharge coefficient: effective fraction of the opening for flow to the outside or into "
               "another crack.");
}

} // namespace

Section combustionSection()
{
  Section s("Combustion", "Combustion of crack faces: gas production, gas pressure on the faces, venting.");
  refuseAxisymmetric(s, "the gas in cracks has the volume and faces of plane cracks");
  s.refuse({when::present("Combustion"), when::equilibrium()},
           "combustion in equilibrium is not implemented; write Analysis = Dynamic");
  Section crack("crack", "Combustion of one crack. The sublist has the name of the crack.");
  addBurnLaw(crack);
  addGas(crack);
  addCavity(crack);
  addIgnition(crack);
  addLosses(crack);
  s.namedByUser(crack);
  s.namedAfter("Cracks", "there are no cracks; add the section Cracks or leave Combustion out");
  s.refuse({when::present("Combustion"), when::is("Thermal", "Mechanics", {"false"})},
           "it can't be combined with Thermal > Mechanics = false; remove one of the two");
  s.refuse({when::present("Combustion > *"), when::present("Face Pressure > *")},
           "Face Pressure prescribes a pressure in this crack too; remove one of the two");
  s.refuse({when::is("Combustion > *", "Gas Model", {"Flow"})},
           "flow along a crack is available in 2D only; write Uniform", 0, 3);
  s.refuse({when::given("Combustion > *", "Ignition Temperature"), when::unprovided(capability::heat)},
           "it needs the section Thermal; add it or leave this parameter out");
  for (const char* name : {"Wall Heat Fraction", "Heat Transfer Coefficient"})
    s.refuse({when::above("Combustion > *", name, 0.0), when::unprovided(capability::heat)},
             "it needs the section Thermal; add it or leave this parameter out");
  return s;
}

} // namespace Rhegma::combustion
