#include "combustion/BurnRate.hpp"
#include "combustion/Combustion.hpp"
#include "scene/Numbers.hpp"
#include "scene/ReadList.hpp"

#include <cmath>
#include <stdexcept>

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
      .meaning("Share of the opening at the surface that the flow has.");
  s.namedByUser(crack);
  return s;
}

namespace
{

std::string joined(const std::vector<std::string>& names)
{
  std::string all;
  for (const std::string& name : names)
    all += (all.empty() ? "" : ", ") + name;
  return all;
}

double realOf(const Teuchos::ParameterList& list, const char* name, double other)
{
  return list.isType<double>(name) ? list.get<double>(name) : other;
}

/// What burns is one of the materials of the scene.
void checkDensity(const Teuchos::ParameterList& scene, const Teuchos::ParameterList& list,
                  const std::string& path, std::vector<SceneError>& errors)
{
  if (!list.isType<double>("Solid Density") || !scene.isSublist("Materials"))
    return;
  const double density = list.get<double>("Solid Density");
  std::vector<std::string> known;
  for (const std::string& name : sublistNames(scene.sublist("Materials")))
  {
    const double other = realOf(scene.sublist("Materials").sublist(name), "Density", -1.0);
    if (!(other > 0.0) || std::fabs(density - other) <= 1e-6 * other)
      return;
    known.push_back(name + " has " + formatReal(other) + " kg/m3");
  }
  if (!known.empty())
    errors.push_back({path + " > Solid Density", "no material of the scene has it, and what burns is one of "
                                                 "them; " +
                                                     joined(known)});
}

void checkIgnition(const Teuchos::ParameterList& scene, const Teuchos::ParameterList& list,
                   const std::string& path, std::vector<SceneError>& errors)
{
  const bool point = list.isParameter("Ignition Point"), box = list.isParameter("Ignition Lower Corner");
  if (point && box)
    errors.push_back(
        {path, "has both an Ignition Point and a box (Ignition Lower Corner); take one of the two out"});
  if (point && !list.isParameter("Flame Speed"))
    errors.push_back({path, "an Ignition Point without a Flame Speed lights nothing; write one"});
  if (!point && !box && list.isParameter("Flame Speed"))
    errors.push_back({path, "a flame has a Flame Speed and nowhere to set out from; write an Ignition Point "
                            "or a box (Ignition Lower Corner, Ignition Upper Corner)"});
  if (!list.isParameter("Ignition Temperature"))
    return;
  if (!scene.isSublist("Thermal"))
  {
    errors.push_back({path + " > Ignition Temperature",
                      "faces have no temperature without a section Thermal; add one or leave it out"});
    return;
  }
  if (realOf(list, "Ignition Temperature", 1e300) <=
      realOf(scene.sublist("Thermal"), "Initial Temperature", 0.0))
    errors.push_back({path + " > Ignition Temperature",
                      "is not above Thermal > Initial Temperature, so that all faces burn at once; leave "
                      "it out for that"});
}

void checkHeat(const Teuchos::ParameterList& scene, const Teuchos::ParameterList& list,
               const std::string& path, std::vector<SceneError>& errors)
{
  for (const char* name : {"Wall Heat Fraction", "Heat Transfer Coefficient"})
  {
    if (!(realOf(list, name, 0.0) > 0.0))
      continue;
    if (!scene.isSublist("Thermal"))
      errors.push_back({path + " > " + name,
                        "heat goes to the gas only without a section Thermal; add one or leave it out"});
    if (list.isType<std::string>("Gas Temperature") && list.get<std::string>("Gas Temperature") == "Constant")
      errors.push_back({path + " > " + name,
                        "gas whose temperature is kept (Gas Temperature = Constant) loses no heat to the "
                        "faces that is reckoned; write Energy Balance or leave it out"});
  }
}

void checkModel(const Teuchos::ParameterList& scene, const Teuchos::ParameterList& list,
                const std::string& path, std::vector<SceneError>& errors)
{
  const bool flows = list.isType<std::string>("Gas Model") && list.get<std::string>("Gas Model") == "Flow";
  if (flows && scene.isSublist("Domain") && scene.sublist("Domain").isType<int>("Dimension") &&
      scene.sublist("Domain").get<int>("Dimension") == 3)
    errors.push_back({path + " > Gas Model", "gas flows along cracks in 2D only; write Uniform"});
  for (const char* name : {"Viscosity", "Friction Factor"})
    if (!flows && realOf(list, name, 0.0) > 0.0)
      errors.push_back(
          {path + " > " + name,
           "gas of one pressure does not flow along the faces; write Gas Model = Flow or leave it "
           "out"});
  if (flows && !(realOf(list, "Initial Gap", 0.0) > 0.0))
    errors.push_back({path + " > Initial Gap",
                      "gas that flows needs room everywhere along the crack, also where its faces touch; "
                      "write their roughness"});
}

void checkCrack(const Teuchos::ParameterList& scene, const std::string& name, std::vector<SceneError>& errors)
{
  const Teuchos::ParameterList& list = scene.sublist("Combustion").sublist(name);
  const std::string path = "Combustion > " + name;
  const auto real = [&](const char* parameter, double other) { return realOf(list, parameter, other); };
  if (!scene.sublist("Cracks").isSublist(name))
    errors.push_back({path, "there is no crack of this name; Cracks has " +
                                joined(sublistNames(scene.sublist("Cracks")))});
  if (scene.isSublist("Face Pressure") && scene.sublist("Face Pressure").isSublist(name))
    errors.push_back({path, "Face Pressure gives this crack a pressure too; take one of the two out"});
  if (!(real("Initial Gap", 0.0) > 0.0) && !(real("Cavity Volume", 0.0) > 0.0))
    errors.push_back({path, "a closed crack has no room for gas; give an Initial Gap (the roughness of the "
                            "faces) or a Cavity Volume"});
  if (real("Flame Temperature", 1e300) < real("Initial Temperature", 293.0))
    errors.push_back(
        {path + " > Flame Temperature", "is below Initial Temperature; burning would cool the gas"});
  if (list.isType<std::string>("Burn Table"))
    try
    {
      BurnRate::table(list.get<std::string>("Burn Table"));
    }
    catch (const std::invalid_argument& problem)
    {
      errors.push_back({path + " > Burn Table", problem.what()});
    }
  checkDensity(scene, list, path, errors);
  checkIgnition(scene, list, path, errors);
  checkHeat(scene, list, path, errors);
  checkModel(scene, list, path, errors);
  if (!list.isParameter("Solid Density") && scene.isSublist("Materials") &&
      sublistNames(scene.sublist("Materials")).size() > 1)
    errors.push_back(
        {path + " > Solid Density", "there are several materials; write the density of what burns"});
}

} // namespace

void checkCombustion(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors)
{
  if (!scene.isSublist("Combustion"))
    return;
  if (!scene.isSublist("Cracks"))
  {
    errors.push_back({"Combustion", "there are no crack faces that could burn; add a section Cracks or leave "
                                    "Combustion out"});
    return;
  }
  if (sublistNames(scene.sublist("Combustion")).empty())
    errors.push_back({"Combustion", "the section names no crack; write one as <ParameterList name=\"" +
                                        joined(sublistNames(scene.sublist("Cracks"))) + "\">"});
  if (scene.isSublist("Thermal") && scene.sublist("Thermal").isType<bool>("Mechanics") &&
      !scene.sublist("Thermal").get<bool>("Mechanics"))
    errors.push_back(
        {"Combustion", "nothing moves, for Thermal > Mechanics is false; leave one of the two out"});
  for (const std::string& name : sublistNames(scene.sublist("Combustion")))
    checkCrack(scene, name, errors);
}

} // namespace Rhegma::combustion
