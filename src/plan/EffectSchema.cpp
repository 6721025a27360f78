#include "plan/EffectSchema.hpp"

#include "plan/KnownEffects.hpp"

#include <map>

namespace Rhegma
{

namespace
{

SceneSchema makeSchema()
{
  std::vector<Section> sections = coreSections();
  for (const EffectEntry& entry : knownEffects())
    sections.push_back(entry.section);
  SceneSchema schema(sections);
  std::vector<std::string> missing = effectsToCome();
  missing.insert(missing.end(), effectsLeftOut().begin(), effectsLeftOut().end());
  schema.setSectionsToCome(missing);
  for (const EffectEntry& entry : knownEffects())
  {
    if (entry.check)
      schema.addCheck(entry.check);
    schema.addCellHook(entry.section.name, entry.cells);
  }
  return schema;
}

} // namespace

const SceneSchema& effectSchema()
{
  // Effects that an application adds make another schema; who has the one before keeps it.
  static std::map<std::size_t, SceneSchema> schemas;
  const std::size_t count = knownEffects().size();
  auto found = schemas.find(count);
  if (found == schemas.end())
    found = schemas.emplace(count, makeSchema()).first;
  return found->second;
}

} // namespace Rhegma
