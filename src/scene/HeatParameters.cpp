#include "scene/HeatParameters.hpp"

#include "material/ThermoMaterials.hpp"

namespace Rhegma
{

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
               "a table of temperature needs the section Thermal, which the scene does not have; add it or "
               "write a number");
      s.refuse(
          {when::is("Materials > *", "Model", {"Rigid"}), noHeat},
          "Rigid is for scenes with heat only; choose a law with stress, or add Thermal with Mechanics = "
          "false");
    }
    else if (s.name == "Bodies")
      for (const char* name : {"Temperature", "Temperature Field"})
        s.refuse({when::given("Bodies > *", name), noHeat}, "the scene has no section Thermal" + add);
}

} // namespace Rhegma
