#include "plan/EffectSchema.hpp"

#include "plan/BoundaryType.hpp"
#include "plan/KnownEffects.hpp"
#include "scene/CoreSections.hpp"

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

} // namespace

SceneSchema schemaOf(const std::vector<EffectEntry>& effects)
{
  std::vector<Section> sections = coreSections(boundarySections());
  for (const EffectEntry& entry : effects)
    sections.push_back(entry.section);
  SceneSchema schema(sections);
  std::vector<std::string> missing = effectsToCome();
  missing.insert(missing.end(), effectsLeftOut().begin(), effectsLeftOut().end());
  schema.setSectionsToCome(missing);
  schema.addCheck(checkBoundaries);
  for (const EffectEntry& entry : effects)
  {
    if (entry.check)
      schema.addCheck(entry.check);
    schema.addCellHook(entry.section.name, entry.cells);
  }
  return schema;
}

const SceneSchema& effectSchema()
{
  // What an application adds makes another schema; who has the one before keeps it.
  static std::map<std::size_t, SceneSchema> schemas;
  const std::size_t count = knownEffects().size() + boundaryTypes().size();
  auto found = schemas.find(count);
  if (found == schemas.end())
    found = schemas.emplace(count, schemaOf(knownEffects())).first;
  return found->second;
}

} // namespace Rhegma
