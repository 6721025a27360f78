#include "plan/EffectSchema.hpp"

#include "plan/BoundaryType.hpp"
#include "plan/KnownEffects.hpp"
#include "scene/CoreSections.hpp"

#include <algorithm>
#include <map>

namespace Rhegma
{

namespace
{

std::vector<Section> boundarySections()
{
  std::vector<Section> sections;
  for (const BoundaryType& type : boundaryTypes())
    sections.push_back(type.section);
  return sections;
}

/// Adds rules to the section Boundaries for types that an effect applies.
void addBoundaryRules(std::vector<Section>& sections)
{
  const auto boundaries =
      std::find_if(sections.begin(), sections.end(), [](const Section& s) { return s.name == "Boundaries"; });
  for (const BoundaryType& type : boundaryTypes())
  {
    if (type.capability.empty())
      continue;
    std::string provider = "an effect for " + type.capability;
    for (const Section& s : sections)
      if (std::find(s.provides.begin(), s.provides.end(), type.capability) != s.provides.end())
        provider = "the section " + s.name;
    boundaries->refuse({when::satisfies("Boundaries > *", "of Type " + type.section.name,
                                        [name = type.section.name](const Teuchos::ParameterList& list)
                                        { return SceneValues::text(list, "Type") == name; }),
                        when::unprovided(type.capability)},
                       "its type needs " + provider +
                           ", but the scene has none; add the section or remove this boundary");
  }
}

} // namespace

SceneSchema schemaOf(const std::vector<EffectEntry>& effects)
{
  std::vector<Section> sections = coreSections(boundarySections());
  for (const EffectEntry& entry : effects)
    sections.push_back(entry.section);
  addBoundaryRules(sections);
  SceneSchema schema(sections);
  std::vector<std::string> missing = effectsToCome();
  missing.insert(missing.end(), effectsLeftOut().begin(), effectsLeftOut().end());
  schema.setSectionsToCome(missing);
  schema.addCheck(checkBoundaries);
  for (const EffectEntry& entry : effects)
    schema.addEffect(entry.section.name, entry.check, entry.cells);
  return schema;
}

const SceneSchema& effectSchema()
{
  // An effect or type added by an application makes another schema; references to the earlier one stay valid.
  static std::map<std::size_t, SceneSchema> schemas;
  const std::size_t count = knownEffects().size() + boundaryTypes().size();
  auto found = schemas.find(count);
  if (found == schemas.end())
    found = schemas.emplace(count, schemaOf(knownEffects())).first;
  return found->second;
}

} // namespace Rhegma
