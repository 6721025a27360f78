#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "combustion/BurnRate.hpp"
#include "combustion/Combustion.hpp"
#include "scene/NearestName.hpp"

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

/// The burning material must be one of the scene.
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
    errors.push_back(
        {path + " > Solid Density", "no material of the scene has this density; " + asText(known, ", ")});
}

void checkIgnition(const Teuchos::ParameterList& list, const std::string& path,
                   std::vector<SceneError>& errors)
{
  const bool point = list.isParameter("Ignition Point"), box = list.isParameter("Ignition Lower Corner");
  if (point && box)
    errors.push_back(
        {path, "both Ignition Point and a box (Ignition Lower Corner) are given; remove one of them"});
  if (point && !list.isParameter("Flame Speed"))
    errors.push_back({path, "it needs a Flame Speed; write one"});
  if (!list.isParameter("Flame Speed") && realOf(list, "Flame Speed Exponent", 0.0) > 0.0)
    errors.push_back({path + " > Flame Speed Exponent", "it needs a Flame Speed; write one"});
  if (!point && !box && list.isParameter("Flame Speed"))
    errors.push_back({path, "it needs a start; write an Ignition Point or a box (Ignition Lower Corner, "
                            "Ignition Upper Corner)"});
}

void checkHeat(const Teuchos::ParameterList& list, const std::string& path, std::vector<SceneError>& errors)
{
  for (const char* name : {"Wall Heat Fraction", "Heat Transfer Coefficient"})
  {
    if (!(realOf(list, name, 0.0) > 0.0))
      continue;
    if (list.isType<std::string>("Gas Temperature") && list.get<std::string>("Gas Temperature") == "Constant")
      errors.push_back({path + " > " + name, "it can't be combined with Gas Temperature = Constant; write "
                                             "Energy Balance or leave this parameter out"});
  }
}

void checkModel(const Teuchos::ParameterList& list, const std::string& path, std::vector<SceneError>& errors)
{
  const bool flows = list.isType<std::string>("Gas Model") && list.get<std::string>("Gas Model") == "Flow";
  for (const char* name : {"Viscosity", "Friction Factor"})
    if (!flows && realOf(list, name, 0.0) > 0.0)
      errors.push_back({path + " > " + name,
                        "it is used with Gas Model = Flow only; write that or leave this parameter out"});
  if (flows && !(realOf(list, "Initial Gap", 0.0) > 0.0))
    errors.push_back({path + " > Initial Gap", "Gas Model = Flow needs a gap everywhere along the crack, "
                                               "also where the faces touch; write their roughness"});
}

void checkCrack(const Teuchos::ParameterList& scene, const std::string& name, std::vector<SceneError>& errors)
{
  const Teuchos::ParameterList& list = scene.sublist("Combustion").sublist(name);
  const std::string path = "Combustion > " + name;
  const auto real = [&](const char* parameter, double other) { return realOf(list, parameter, other); };
  if (!(real("Initial Gap", 0.0) > 0.0) && !(real("Cavity Volume", 0.0) > 0.0))
    errors.push_back({path, "a closed crack has no gas volume; write an Initial Gap (roughness of the faces) "
                            "or a Cavity Volume"});
  if (real("Flame Temperature", 1e300) < real("Initial Temperature", 293.0))
    errors.push_back(
        {path + " > Flame Temperature",
         "is below Initial Temperature, so burning would cool the gas; write a higher flame temperature"});
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
  checkIgnition(list, path, errors);
  checkHeat(list, path, errors);
  checkModel(list, path, errors);
  if (!list.isParameter("Solid Density") && scene.isSublist("Materials") &&
      sublistNames(scene.sublist("Materials")).size() > 1)
    errors.push_back(
        {path + " > Solid Density", "there are several materials; write the density of the burning solid"});
}

} // namespace

void checkCombustion(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors)
{
  if (sublistNames(scene.sublist("Combustion")).empty())
    errors.push_back({"Combustion",
                      "the section names no crack; write one as <ParameterList name=\"...\"> with its name"});
  for (const std::string& name : sublistNames(scene.sublist("Combustion")))
    checkCrack(scene, name, errors);
}

} // namespace Rhegma::combustion
