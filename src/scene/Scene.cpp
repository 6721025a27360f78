#include "scene/Scene.hpp"

#include "base/EntryValue.hpp"
#include "scene/Accuracy.hpp"
#include "scene/ConvertUnits.hpp"
#include "scene/CrossChecks.hpp"
#include "scene/FillFromIntensity.hpp"
#include "scene/FillFromLibrary.hpp"
#include "scene/Overrides.hpp"
#include "scene/ReadFile.hpp"
#include "scene/ReadXml.hpp"
#include "scene/SceneParts.hpp"
#include "scene/Validation.hpp"

#include <exception>
#include <filesystem>
#include <string>

namespace Rhegma
{

namespace
{

/// Validates in place: fills in defaults and removes invalid entries.
void validateInPlace(Teuchos::ParameterList& list, const SceneSchema& schema, std::vector<SceneError>& errors)
{
  list.setName(schema.root().name);
  fillFromLibrary(list, schema, errors);
  convertUnits(list, schema, errors);
  fillFromIntensity(list, schema, errors);
  chooseCells(list, schema, errors);
  addAxis(list);
  Validation(dimensionOf(list), errors).check(list, schema.root(), "");
  deriveDefaults(list);
  crossCheckCore(list, errors);
  checkRules(list, schema, errors);
  const auto run = [&](const CrossCheck& check, const Teuchos::ParameterList& part)
  {
    try
    {
      check(part, errors);
    }
    catch (const std::exception&)
    {
      if (errors.empty()) // otherwise it may miss an entry that was reported
        throw;
    }
  };
  for (const CrossCheck& check : schema.checks())
    run(check, list);
  SceneParts parts(schema, list);
  for (const auto& [name, effect] : schema.effects())
    if (effect.check && list.isSublist(name))
      run(effect.check, parts.of(name));
}

/// A text whose name is or ends in File is a path relative to the folder of the scene.
void resolveFiles(Teuchos::ParameterList& list, const std::filesystem::path& folder)
{
  const std::string mark = " File", whole = "File";
  for (const auto& entry : list)
  {
    const std::string& name = entry.first;
    if (const auto* sublist = valueIf<Teuchos::ParameterList>(entry.second))
      resolveFiles(const_cast<Teuchos::ParameterList&>(*sublist), folder);
    else if ((name == whole || (name.size() > mark.size() &&
                                name.compare(name.size() - mark.size(), mark.size(), mark) == 0)) &&
             entry.second.isType<std::string>() && !list.get<std::string>(name).empty())
      list.set(name, (folder / list.get<std::string>(name)).string());
  }
}

} // namespace

void validateList(Teuchos::ParameterList& list, const SceneSchema& schema, std::vector<SceneError>& errors)
{
  Teuchos::ParameterList copy(list);
  const std::size_t before = errors.size();
  validateInPlace(copy, schema, errors);
  if (errors.size() == before)
    list = copy;
}

namespace
{

/// \param folder of the scene
SceneResult readParts(const std::string& xml, const std::vector<std::string>& overrides,
                      const SceneSchema& schema, const std::filesystem::path& folder)
{
  SceneResult result;
  result.list = parseXml(xml, schema.root().name, result.errors);
  if (result.list.is_null())
    return result;
  addLibraryLaws(*result.list, schema);
  for (const auto& text : overrides)
    applyOverride(*result.list, text, schema, result.errors);
  resolveFiles(*result.list, folder); // before the validation, which reads files of bodies
  validateInPlace(*result.list, schema, result.errors);
  return result;
}

} // namespace

SceneResult readSceneText(const std::string& xml, const std::vector<std::string>& overrides,
                          const SceneSchema& schema)
{
  return readParts(xml, overrides, schema, {});
}

SceneResult readScene(const std::string& file, const std::vector<std::string>& overrides,
                      const SceneSchema& schema)
{
  SceneResult result;
  const std::string xml = readText(file, result.errors);
  if (!result.errors.empty())
    return result;
  return readParts(xml, overrides, schema, std::filesystem::path(file).parent_path());
}

} // namespace Rhegma
