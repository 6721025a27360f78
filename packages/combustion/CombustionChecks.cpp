#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "combustion/BurnRate.hpp"
#include "combustion/Combustion.hpp"
#include "scene/CrackNames.hpp"

#include <cmath>
#include <stdexcept>

namespace Rhegma::combustion
{

namespace
{

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
  if (!checkCrackNames(scene, "Combustion", "could burn", errors))
    return;
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
