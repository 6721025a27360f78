#include "scene/Scene.hpp"

#include "scene/CrossChecks.hpp"
#include "scene/Overrides.hpp"
#include "scene/ReadXml.hpp"
#include "scene/Validation.hpp"

#include <exception>

namespace Rhegma
{

namespace
{

/// Validates in place, filling in and removing as it goes.
void validateInPlace(Teuchos::ParameterList& list, const SceneSchema& schema, std::vector<SceneError>& errors)
{
  list.setName(schema.root().name);
  Validation(dimensionOf(list), errors).check(list, schema.root(), "");
  deriveDefaults(list);
  crossCheckCore(list, errors);
  for (const auto& check : schema.checks())
    try
    {
      check(list, errors);
    }
    catch (const std::exception&)
    {
      if (errors.empty()) // else it missed an entry that is reported as wrong
        throw;
    }
}

} // namespace

void validateList(Teuchos::ParameterList& list, const SceneSchema& schema, std::vector<SceneError>& errors)
{
  Teuchos::ParameterList work(list);
  const std::size_t before = errors.size();
  validateInPlace(work, schema, errors);
  if (errors.size() == before)
    list = work;
}

SceneResult readSceneText(const std::string& xml, const std::vector<std::string>& overrides,
                          const SceneSchema& schema)
{
  SceneResult result;
  result.list = parseXml(xml, schema.root().name, result.errors);
  if (result.list.is_null())
    return result;
  for (const auto& text : overrides)
    applyOverride(*result.list, text, schema, result.errors);
  validateInPlace(*result.list, schema, result.errors);
  return result;
}

SceneResult readScene(const std::string& file, const std::vector<std::string>& overrides,
                      const SceneSchema& schema)
{
  SceneResult result;
  const std::string xml = readText(file, result.errors);
  return result.errors.empty() ? readSceneText(xml, overrides, schema) : result;
}

} // namespace Rhegma
