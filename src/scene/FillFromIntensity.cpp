#include "scene/FillFromIntensity.hpp"

#include "base/EntryValue.hpp"
#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "material/LawStiffness.hpp"
#include "material/MaterialTable.hpp"
#include "scene/EntryNumbers.hpp"
#include "scene/Validation.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <utility>

namespace Rhegma
{

namespace
{

using Teuchos::ParameterEntry;
using Teuchos::ParameterList;

const char* const energy = "Toughness";
const char* const criticalIntensity = "K_Ic"; // [Pa m^0.5]

bool isGiven(const ParameterList& list, const std::string& name)
{
  return list.isParameter(name) && !list.getEntry(name).isDefault();
}

const Parameter* parameterOf(const Section& section, const std::string& name)
{
  const auto found = std::find_if(section.parameters.begin(), section.parameters.end(),
                                  [&](const Parameter& one) { return one.name == name; });
  return found == section.parameters.end() ? nullptr : &*found;
}

/// A list that gives the intensity, and the toughness that its section has.
using Visit = std::function<void(ParameterList& list, const Section& section, const Parameter& toughness)>;

void visitIntensities(ParameterList& scene, const SceneSchema& schema, const Visit& visit)
{
  for (const Section& section : schema.root().sections)
    if (const Parameter* const toughness = parameterOf(section, energy);
        toughness != nullptr && parameterOf(section, criticalIntensity) != nullptr &&
        scene.isSublist(section.name) && isGiven(scene.sublist(section.name), criticalIntensity))
      visit(scene.sublist(section.name), section, *toughness);
}

void setToughness(ParameterList& list, const Parameter& toughness, double value)
{
  ParameterEntry entry;
  if (toughness.type == ParameterType::Real)
    entry.setValue(value, true);
  else
    entry.setValue(formatExactly(value), true);
  list.setEntry(energy, entry);
}

/// E' of the materials of a scene [Pa].
class Moduli
{
public:
  /// \param scene is validated in a copy, in which the lists have some toughness already
  Moduli(const ParameterList& scene, const SceneSchema& schema)
  {
    ParameterList copy(scene);
    std::vector<SceneError> errors;
    const int dimension = dimensionOf(copy);
    Validation(dimension, errors).check(copy, schema.root(), "");
    const auto* const plane =
        copy.isSublist("Domain") ? valueIf<std::string>(copy.sublist("Domain"), "Plane") : nullptr;
    const bool stress = dimension == 2 && plane != nullptr && *plane == "Stress";
    if (!copy.isSublist("Materials"))
      return;
    for (const auto& entry : copy.sublist("Materials"))
      if (const auto* const material = valueIf<ParameterList>(entry.second))
        add(*material, entry.first, dimension == 3 ? Plane::Solid : stress ? Plane::Stress : Plane::Strain);
  }

  /// \throws std::invalid_argument why there is not one value; 0 where materials are wrong in other ways
  double one() const
  {
    if (!varying_.empty())
      throw std::invalid_argument(
          "the moduli of Materials > " + varying_ +
          " depend on temperature, so that it has no fixed toughness; write Toughness.");
    if (!anisotropic_.empty())
      throw std::invalid_argument("Materials > " + anisotropic_ +
                                  " is anisotropic, and G is not K^2 / E' there; write Toughness.");
    const auto order = [](const auto& a, const auto& b) { return a.second < b.second; };
    const auto [least, most] = std::minmax_element(moduli_.begin(), moduli_.end(), order);
    if (least == moduli_.end())
      return 0.0;
    constexpr double rounding = 1e-9;
    if (most->second > (1.0 + rounding) * least->second)
      throw std::invalid_argument("K_Ic^2 / E' is not the same in Materials > " + least->first +
                                  " (E' = " + formatShort(least->second) + " Pa) and " + most->first + " (" +
                                  formatShort(most->second) + " Pa); write Toughness.");
    return most->second;
  }

private:
  void add(const ParameterList& material, const std::string& name, Plane plane)
  {
    for (const char* const modulus : {"Young Modulus", "Poisson Ratio", "C10", "C01", "Bulk Modulus"})
      if (valueIf<std::string>(material, modulus) != nullptr)
        varying_ = name;
    try
    {
      const Properties properties = makeProperties(material, name, plane);
      if (isAnisotropic(properties))
        anisotropic_ = name;
      if (const double modulus = elasticity(properties).effectiveModulus;
          modulus > 0.0 && std::isfinite(modulus))
        moduli_.emplace_back(name, modulus);
    }
    catch (const std::exception&) // which the checks of materials report
    {
    }
  }

  std::vector<std::pair<std::string, double>> moduli_; ///< name of the material, E'
  std::string varying_;                                ///< a material with a table of temperature
  std::string anisotropic_;                            ///< a material whose stiffness depends on direction
};

} // namespace

void describeToughnessByOtherMeans(Section& section)
{
  section.real(criticalIntensity)
      .unit("Pa m^0.5")
      .positive()
      .optional(energy)
      .meaning(
          "Critical stress intensity, instead of Toughness, which is then K_Ic^2 / E' with the E' of the "
          "scene: E in plane stress, else E / (1 - nu^2), at small strain. For scenes with one material, "
          "or with materials of the same E'.");
  section.fromLibrary("Toughness From Library")
      .meaning("Name of a material of the library, such as PMMA, whose toughness is used if Toughness is "
               "absent (docs/reference/materials.md).");
}

void fillFromIntensity(ParameterList& scene, const SceneSchema& schema, std::vector<SceneError>& errors)
{
  bool any = false;
  visitIntensities(scene, schema,
                   [&](ParameterList& list, const Section& section, const Parameter& toughness)
                   {
                     const bool both = isGiven(list, energy);
                     const bool library = valueIf<std::string>(list, section.libraryKey) != nullptr;
                     if (both || library)
                       errors.push_back({scenePath(section.name, criticalIntensity),
                                         "stands next to " + (both ? energy : section.libraryKey) +
                                             ", which gives the same; keep one of the two."});
                     else
                       setToughness(list, toughness, 1.0); // until the materials are known to be right
                     any = any || !(both || library);
                   });
  if (!any)
    return;
  const Moduli moduli(scene, schema);
  visitIntensities(scene, schema,
                   [&](ParameterList& list, const Section& section, const Parameter& toughness)
                   {
                     const ParameterEntry& entry = list.getEntry(criticalIntensity);
                     const auto text = textIn(entry);
                     const auto intensity = text ? parseReal(*text) : numberIn(entry);
                     if (!intensity || isGiven(list, energy)) // what is no number is reported later
                       return;
                     try
                     {
                       if (const double modulus = moduli.one(); modulus > 0.0)
                         setToughness(list, toughness, *intensity * *intensity / modulus);
                     }
                     catch (const std::invalid_argument& error)
                     {
                       errors.push_back({scenePath(section.name, criticalIntensity), error.what()});
                     }
                   });
}

} // namespace Rhegma
