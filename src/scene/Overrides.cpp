#include "scene/Overrides.hpp"

#include "base/Numbers.hpp"
#include "scene/NearestName.hpp"
#include "scene/NormaliseValue.hpp"
#include "scene/UnitText.hpp"
#include "scene/Validation.hpp"

#include <algorithm>

namespace Rhegma
{

namespace
{

std::vector<std::string> parts(const std::string& path)
{
  std::vector<std::string> names;
  std::size_t begin = 0;
  while (begin <= path.size())
  {
    const std::size_t end = std::min(path.find(':', begin), path.size());
    names.push_back(trimmed(path.substr(begin, end - begin)));
    begin = end + 1;
  }
  return names;
}

std::vector<std::string> sublists(const Teuchos::ParameterList& list)
{
  std::vector<std::string> names;
  for (const auto& entry : list)
    if (entry.second.isList())
      names.push_back(entry.first);
  return names;
}

bool isReal(const Parameter& parameter)
{
  return parameter.type == ParameterType::Real || parameter.type == ParameterType::RealArray;
}

void setParameter(Teuchos::ParameterList& scene, const std::string& text, const SceneSchema& schema,
                  std::vector<SceneError>& errors)
{
  const std::string quoted = "--set '" + text + "' ";
  const std::size_t equals = text.find('=');
  const auto names = parts(text.substr(0, equals));
  if (equals == std::string::npos || names.size() < 2)
  {
    errors.push_back({"", quoted + "is not of the form 'Section:Parameter=value'."});
    return;
  }
  Teuchos::ParameterList* list = &scene;
  const Section* section = &schema.root();
  std::string path;
  for (std::size_t i = 0; i + 1 < names.size(); ++i)
  {
    const ActiveSection active(*section, *list);
    const Section* next = active.findSection(names[i]);
    const bool there = list->isSublist(names[i]);
    if (!next && there)
      next = active.entry;
    const std::string where = scenePath(path, names[i]);
    if (!next || (list->isParameter(names[i]) && !there))
    {
      auto possible = active.sectionNames();
      if (active.entry)
        for (const auto& name : sublists(*list))
          possible.push_back(name);
      errors.push_back(
          {where, quoted + "can't be applied: there is no such section; " + suggestion(names[i], possible)});
      return;
    }
    list = &list->sublist(names[i]);
    section = next;
    path = where;
  }
  const ActiveSection active(*section, *list);
  const std::string where = scenePath(path, names.back());
  const Parameter* parameter = active.findParameter(names.back());
  if (!parameter)
  {
    const Parameter* renamed = section->findFormer(names.back());
    const auto moved = section->moved.find(names.back());
    errors.push_back(
        {where, quoted + "can't be applied: " +
                    (renamed ? renamedTo(renamed->name)
                     : moved != section->moved.end()
                         ? renamedTo(moved->second)
                         : "there is no such parameter; " +
                               suggestion(names.back(), active.parameterNames(dimensionOf(scene))))});
    return;
  }
  const std::string given = text.substr(equals + 1);
  if (const auto value = valueFromText(*parameter, given))
    setValue(*list, *parameter, *value);
  else if (isReal(*parameter) && quantityOf(given)) // its unit is converted with those of the scene
    setValue(*list, *parameter, given);
  else
    errors.push_back({where, quoted + "gives \"" + given + "\"; write " + typeAsText(parameter->type) +
                                 (parameter->type == ParameterType::RealArray && !parameter->unit.empty()
                                      ? ", such as {1, 2} or {1, 2} " + parameter->unit
                                      : "") +
                                 "."});
}

} // namespace

void applyOverride(Teuchos::ParameterList& scene, const std::string& text, const SceneSchema& schema,
                   std::vector<SceneError>& errors)
{
  Teuchos::ParameterList changed(scene); // an invalid path must not add sections
  const std::size_t before = errors.size();
  setParameter(changed, text, schema, errors);
  if (errors.size() == before)
    scene = changed;
}

} // namespace Rhegma
