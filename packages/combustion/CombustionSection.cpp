#include "combustion/Combustion.hpp"

namespace Rhegma::combustion
{

Section combustionSection()
{
  Section s("Combustion", "Burns the faces of cracks: gas in the crack, and its pressure on the faces.");
  Section crack("crack", "The burning of the crack of this name.");
  crack.chosenBy("Burn Law").meaning("How fast a burning face recedes.");
  Section vieille("Vieille", "r = a p^n.");
  vieille.real("Burn Coefficient").unit("m/s/Pa^n").notNegative().meaning("The factor a of the law.");
  vieille.real("Burn Exponent")
      .notNegative()
      .meaning("The exponent n of the law. Above 1 a closed crack runs away.");
  crack.variant(vieille);
  Section table("Table", "Straight lines between points.");
  table.text("Burn Table")
      .unit("Pa:m/s")
      .notEmpty()
      .meaning("Pressures and rates, such as \"1e5:1e-3, 1e6:5e-3\"; constant beyond the ends.");
  crack.variant(table);
  crack.real("Solid Density")
      .unit("kg/m3")
      .positive()
      .optional("that of the scene's only material")
      .meaning("Density of what burns.");
  crack.real("Gas Constant").unit("J/(kg K)").positive().meaning("R of the gas for a kilogram of it.");
  crack.real("Heat Capacity Ratio").above(1.0).atMost(2.0).byDefault(1.25).meaning("c_p / c_v of the gas.");
  crack.real("Covolume")
      .unit("m3/kg")
      .notNegative()
      .byDefault(0.0)
      .meaning("b of p (V - b m) = m R T (Noble and Abel); 0 is the ideal gas.");
  crack.real("Flame Temperature").unit("K").positive().meaning("Of solid that burns in a rigid cavity.");
  crack.choice("Gas Model", {"Uniform", "Flow"})
      .byDefault("Uniform")
      .meaning("Uniform: one pressure in the crack. Flow: gas that flows along the crack, in 2D.");
  crack.real("Viscosity")
      .unit("Pa s")
      .notNegative()
      .byDefault(0.0)
      .meaning("Of gas that flows: 12 mu u / w^2 is what the faces take of a laminar flow between them.");
  crack.real("Friction Factor")
      .notNegative()
      .byDefault(0.0)
      .meaning("Darcy's, of gas that flows between rough faces: f rho u^2 / 8 on each of them.");
  crack.choice("Gas Temperature", {"Energy Balance", "Constant"})
      .byDefault("Energy Balance")
      .meaning(
          "Energy Balance: work on the faces and venting cool the gas. Constant: the walls keep it at the "
          "flame temperature.");
  crack.real("Initial Temperature")
      .unit("K")
      .positive()
      .byDefault(293.0)
      .meaning("Of the gas in the crack at the start.");
  crack.real("Initial Pressure")
      .unit("Pa")
      .positive()
      .optional("Outside Pressure")
      .meaning("Of the gas in the crack at the start.");
  crack.real("Outside Pressure")
      .unit("Pa")
      .notNegative()
      .byDefault(101325.0)
      .meaning("What the faces feel is the pressure of the gas less this one, which acts on the body from "
               "all sides.");
  crack.real("Initial Gap")
      .unit("m")
      .notNegative()
      .byDefault(0.0)
      .meaning("Room between the faces where they touch: their roughness.");
  crack.real("Cavity Volume")
      .unit("m3")
      .notNegative()
      .byDefault(0.0)
      .meaning("Room for gas beside that between the faces; in 2D for the whole thickness.");
  crack.real("Ignition Time").unit("s").notNegative().byDefault(0.0).meaning("Nothing burns before it.");
  crack.realArray("Ignition Point")
      .unit("m")
      .perAxis()
      .optional("all faces at once")
      .meaning("Where the flame sets out from.");
  crack.realArray("Ignition Lower Corner")
      .unit("m")
      .perAxis()
      .optional("all faces at once")
      .meaning("Of a box in which the faces catch fire.");
  crack.realArray("Ignition Upper Corner")
      .unit("m")
      .perAxis()
      .optional("all faces at once")
      .meaning("Of the same box.");
  crack.allOrNoneOf({"Ignition Lower Corner", "Ignition Upper Corner"});
  crack.real("Ignition Temperature")
      .unit("K")
      .positive()
      .optional("no face by its temperature")
      .meaning("Of a face that catches fire by itself, with that opposite to it. Needs Thermal.");
  crack.real("Flame Speed")
      .unit("m/s")
      .positive()
      .optional("the flame stays")
      .meaning("How fast burning spreads from the ignition point or box, in a straight line.");
  crack.real("Wall Heat Fraction")
      .notNegative()
      .below(1.0)
      .byDefault(0.0)
      .meaning("Share of the heat of what burns that goes into the faces that burn. Needs Thermal.");
  crack.real("Heat Transfer Coefficient")
      .unit("W/(m2 K)")
      .notNegative()
      .byDefault(0.0)
      .meaning("Between the gas and all faces of the crack. Needs Thermal.");
  crack.boolean("Venting").byDefault(false).meaning(
      "Gas flows out where the crack opens at the surface of its body.");
  crack.real("Discharge Coefficient")
      .above(0.0)
      .atMost(1.0)
      .byDefault(0.85)
      .meaning("Share of the opening at the surface, or into another crack, that the flow has.");
  s.namedByUser(crack);
  s.namedAfter("Cracks",
               "there are no crack faces that could burn; add a section Cracks or leave Combustion out");
  s.refuse({when::present("Combustion"), when::is("Thermal", "Mechanics", {"false"})},
           "nothing moves, for Thermal > Mechanics is false; leave one of the two out");
  s.refuse({when::present("Combustion > *"), when::present("Face Pressure > *")},
           "Face Pressure gives this crack a pressure too; take one of the two out");
  s.refuse({when::given("Combustion > *", "Ignition Temperature"), when::unprovided(capability::heat)},
           "faces have no temperature without a section Thermal; add one or leave it out");
  for (const char* name : {"Wall Heat Fraction", "Heat Transfer Coefficient"})
    s.refuse({when::above("Combustion > *", name, 0.0), when::unprovided(capability::heat)},
             "heat goes to the gas only without a section Thermal; add one or leave it out");
  return s;
}

} // namespace Rhegma::combustion
