#include "scene/HeatWords.hpp"

#include "material/ThermoMaterials.hpp"
#include "scene/NearestName.hpp"

#include <algorithm>

namespace Rhegma
{

namespace
{

const std::vector<std::string> heatBoundaries = {"Temperature", "Heat Flux", "Convection"};

} // namespace

bool isHeatBoundary(const std::string& type)
{
  return std::find(heatBoundaries.begin(), heatBoundaries.end(), type) != heatBoundaries.end();
}

void addHeatRules(std::vector<Section>& core)
{
  const std::string add = "; add the section Thermal or leave it out";
  const Condition noHeat = when::unprovided(capability::heat);
  for (Section& s : core)
    if (s.name == "Materials")
    {
      s.refuse({when::satisfies("Materials > *", "with a table of temperature",
                                [](const auto& list) { return !tableTemperatures(list).empty(); }),
                noHeat},
               "it is a table of temperature, but the scene has no section Thermal" + add);
      s.refuse(
          {when::is("Materials > *", "Model", {"Rigid"}), noHeat},
          "Rigid is for scenes with heat only; choose a law with stress, or add Thermal with Mechanics = "
          "false");
    }
    else if (s.name == "Boundaries")
      s.refuse({when::satisfies("Boundaries > *", "of Type " + inWords(heatBoundaries),
                                [](const auto& list)
                                {
                                  return list.template isType<std::string>("Type") &&
                                         isHeatBoundary(list.template get<std::string>("Type"));
                                }),
                noHeat},
               "it is a thermal boundary condition, but the scene has no section Thermal" + add);
    else if (s.name == "Bodies")
      for (const char* name : {"Temperature", "Temperature Field"})
        s.refuse({when::given("Bodies > *", name), noHeat}, "the scene has no section Thermal" + add);
}

} // namespace Rhegma
