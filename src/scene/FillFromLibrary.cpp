#include "scene/FillFromLibrary.hpp"

#include "base/EntryValue.hpp"
#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "material/MaterialTable.hpp"
#include "scene/MaterialLibrary.hpp"
#include "scene/NearestName.hpp"
#include "scene/Validation.hpp"

#include <Teuchos_Array.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace Rhegma
{

namespace
{

using Teuchos::ParameterEntry;
using Teuchos::ParameterList;

/// A law that needs no more than any material has.
const char* const rigidLaw = "Rigid";

bool isOneOf(const std::string& name, const std::vector<std::string>& names)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool isOfHeat(const std::string& name)
{
  return isOneOf(name, {"Specific Heat", "Conductivity", "Thermal Expansion"});
}

/// Whether the scene has a value of its own: one from the library, or a default, is none.
bool isWritten(const ParameterList& list, const std::string& name)
{
  return list.isParameter(name) && !list.getEntry(name).isDefault();
}

bool hasLibrary(const Section& section)
{
  const auto any = [](const std::vector<Section>& sections)
  { return std::any_of(sections.begin(), sections.end(), hasLibrary); };
  return !section.libraryKey.empty() || any(section.sections) || any(section.entry);
}

/// A list that may name a material of the library.
using Visit = std::function<void(ParameterList& list, const Section& section, const std::string& path)>;

void visitLists(ParameterList& list, const Section& section, const std::string& path, const Visit& visit)
{
  if (!section.libraryKey.empty() && valueIf<std::string>(list, section.libraryKey) != nullptr)
    visit(list, section, path);
  for (const auto& entry : list)
    if (const auto* sublist = valueIf<ParameterList>(entry.second))
    {
      const Section* sub = section.findSection(entry.first);
      sub = sub == nullptr && section.userNamed() ? &section.entry.front() : sub;
      if (sub != nullptr && hasLibrary(*sub))
        visitLists(const_cast<ParameterList&>(*sublist), *sub, scenePath(path, entry.first), visit);
    }
}

const std::string& nameIn(const ParameterList& list, const Section& section)
{
  return *valueIf<std::string>(list, section.libraryKey);
}

/// The law that a list has, from the scene or from the library.
std::string lawOf(const ParameterList& list, const Section& section)
{
  const auto* law = section.key.empty() ? nullptr : valueIf<std::string>(list, section.key);
  return law == nullptr ? std::string() : *law;
}

void setFromLibrary(ParameterList& list, const std::string& name, const ParameterEntry& value)
{
  ParameterEntry entry(value);
  entry.setAnyValue(entry.getAny(false), true); // so that isDefault() says who has written it
  list.setEntry(name, entry);
}

/// The usual law of a material, where the scene has none of its own.
void setLaw(ParameterList& list, const Section& section, const LibraryMaterial& material)
{
  if (section.key.empty() || isWritten(list, section.key))
    return;
  ParameterEntry law;
  law.setValue(material.laws.front());
  setFromLibrary(list, section.key, law);
}

/// A constant as a scene would have it, in SI units; of a table of speeds its value at rest, where the scene
/// has a number.
ParameterEntry entryOf(const LibraryConstant& constant, const Parameter& parameter)
{
  ParameterEntry entry;
  std::optional<double> number = parseReal(constant.value);
  if (const double atRest = constant.atRest(); !number && !parameter.mayBeTable && std::isfinite(atRest))
    number = atRest;
  if (const auto numbers = parseReals(constant.value); numbers && parameter.type == ParameterType::RealArray)
    entry.setValue(Teuchos::Array<double>(*numbers)); // in SI units
  else if (parameter.type != ParameterType::Real || !number)
    entry.setValue(constant.value);
  else if (constant.unit.empty() || constant.unit == parameter.unit)
    entry.setValue(*number);
  else
    entry.setValue(conversionOf(constant.unit, parameter.unit, parameter.temperature)(*number));
  return entry;
}

/// Calls work(constant, parameter) for each constant of a material that a list can have.
template <class Work>
void forEachConstant(const LibraryMaterial& material, const ActiveSection& active, const Work& work)
{
  for (const LibraryConstant& constant : material.constants)
    if (const Parameter* parameter = active.findParameter(constant.name))
      work(constant, *parameter);
}

class Filling
{
public:
  Filling(const ParameterList& scene, const SceneSchema& schema, std::vector<SceneError>& errors)
      : errors_(errors)
  {
    for (const Section& section : schema.root().sections)
      heat_ = heat_ || (isOneOf(capability::heat, section.provides) && scene.isSublist(section.name));
  }

  void fill(ParameterList& list, const Section& section, const std::string& path)
  {
    const LibraryMaterial* material = materialLibrary().find(nameIn(list, section));
    if (material == nullptr)
      errors_.push_back({scenePath(path, section.libraryKey), unknownMaterial(nameIn(list, section))});
    else if (const auto mistake = misfit(list, section, path, *material))
    {
      errors_.push_back(*mistake);
      material = nullptr;
    }
    if (material == nullptr) // another one, so that no missing constants are reported in addition
      material = standIn(list, section);
    if (material == nullptr)
      return;
    setLaw(list, section, *material);
    forEachConstant(*material, ActiveSection(section, list),
                    [&](const LibraryConstant& constant, const Parameter& parameter)
                    {
                      if (!isWritten(list, constant.name) && isWanted(list, constant.name))
                        setFromLibrary(list, constant.name, entryOf(constant, parameter));
                    });
  }

private:
  /// Why a list can't have a material.
  static std::optional<SceneError> misfit(const ParameterList& list, const Section& section,
                                          const std::string& path, const LibraryMaterial& material)
  {
    if (section.key.empty())
    {
      if (material.find("Toughness") != nullptr)
        return {};
      return SceneError{scenePath(path, section.libraryKey),
                        "the library has no toughness of " + material.name + "; write Toughness."};
    }
    const std::string law = isWritten(list, section.key) ? lawOf(list, section) : material.laws.front();
    if (law == rigidLaw || material.hasLaw(law) || section.findVariant(law) == nullptr) // reported later
      return {};
    return SceneError{scenePath(path, section.key),
                      "is \"" + law + "\", but the library has constants of " + material.name + " for " +
                          asText(material.laws, " and ") + " only; choose one of these laws, or remove " +
                          section.libraryKey + " and write all constants."};
  }

  static const LibraryMaterial* standIn(const ParameterList& list, const Section& section)
  {
    for (const LibraryMaterial& one : materialLibrary().materials)
      if (!misfit(list, section, "", one))
        return &one;
    return nullptr;
  }

  bool isWanted(const ParameterList& list, const std::string& name) const
  {
    static const std::vector<std::string> hardening = {"Hardening Modulus", "Saturation Stress",
                                                       "Saturation Rate"};
    const auto written = [&](const std::string& one) { return isWritten(list, one); };
    if (isOneOf(name, hardening))
      return !written("Yield Stress") && std::none_of(hardening.begin(), hardening.end(), written);
    const auto* law = valueIf<std::string>(list, "Model");
    if (name == "Specific Heat" && law != nullptr && warmsWithoutHeat(*law))
      return true;
    return heat_ || !isOfHeat(name);
  }

  std::vector<SceneError>& errors_;
  bool heat_ = false; ///< a section of the scene provides it
};

/// A value for a message.
std::string valueText(const LibraryUse::Value& value)
{
  std::string text;
  if (const auto* number = valueIf<double>(value.entry))
    text = formatShort(*number);
  else if (const auto* word = valueIf<std::string>(value.entry))
    text = *word;
  else if (const auto* numbers = valueIf<Teuchos::Array<double>>(value.entry))
  {
    for (const double one : *numbers)
      text += (text.empty() ? "{" : ", ") + formatShort(one);
    text += "}";
  }
  return value.name + " = " + text + (value.unit.empty() ? "" : " " + value.unit);
}

} // namespace

void addLibraryLaws(ParameterList& scene, const SceneSchema& schema)
{
  visitLists(scene, schema.root(), "",
             [](ParameterList& list, const Section& section, const std::string&)
             {
               if (const LibraryMaterial* material = materialLibrary().find(nameIn(list, section)))
                 setLaw(list, section, *material);
             });
}

void fillFromLibrary(ParameterList& scene, const SceneSchema& schema, std::vector<SceneError>& errors)
{
  Filling filling(scene, schema, errors);
  visitLists(scene, schema.root(), "",
             [&](ParameterList& list, const Section& section, const std::string& path)
             { filling.fill(list, section, path); });
}

std::vector<LibraryUse> libraryUses(const ParameterList& scene, const SceneSchema& schema)
{
  std::vector<LibraryUse> uses;
  const auto add = [&](ParameterList& list, const Section& section, const std::string& path)
  {
    const LibraryMaterial* material = materialLibrary().find(nameIn(list, section));
    if (material == nullptr)
      return;
    LibraryUse use{path, material->name, {}, {}};
    if (!section.key.empty())
    {
      if (isWritten(list, section.key))
        use.written.push_back(section.key);
      else
        use.taken.push_back({section.key, list.getEntry(section.key), ""});
    }
    forEachConstant(*material, ActiveSection(section, list),
                    [&](const LibraryConstant& constant, const Parameter& parameter)
                    {
                      if (!list.isParameter(constant.name))
                        return;
                      const ParameterEntry& entry = list.getEntry(constant.name);
                      if (!entry.isDefault())
                        use.written.push_back(constant.name);
                      else if (entry.getAny(false) == entryOf(constant, parameter).getAny(false))
                        use.taken.push_back({constant.name, entry, parameter.unit});
                    });
    uses.push_back(use);
  };
  visitLists(const_cast<ParameterList&>(scene), schema.root(), "", add);
  return uses;
}

std::string libraryUsesAsText(const ParameterList& scene, const SceneSchema& schema)
{
  std::string text;
  for (const LibraryUse& use : libraryUses(scene, schema))
  {
    std::string taken;
    for (const LibraryUse::Value& value : use.taken)
      taken += (taken.empty() ? "" : ", ") + valueText(value);
    text += "  " + use.where + ": " + (taken.empty() ? "nothing" : taken) + " (" + use.material +
            " of the library)" +
            (use.written.empty() ? "" : "; the scene's own: " + asText(use.written, ", ")) + "\n";
  }
  return text;
}

} // namespace Rhegma
