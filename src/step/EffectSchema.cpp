#include "step/EffectSchema.hpp"

#include "step/Effect.hpp"

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
  schema.setSectionsToCome(effectsToCome());
  for (const EffectEntry& entry : knownEffects())
    if (entry.check)
      schema.addCheck(entry.check);
  return schema;
}

} // namespace

const SceneSchema& effectSchema()
{
  static const SceneSchema schema = makeSchema();
  return schema;
}

} // namespace Rhegma
