#include "scene/Compatibility.hpp"

#include "base/EntryValue.hpp"
#include "base/ReadList.hpp"
#include "base/ShortNumber.hpp"
#include "scene/NearestName.hpp"
#include "scene/Validation.hpp"

#include <algorithm>
#include <optional>

namespace Rhegma
{

namespace
{

using Teuchos::ParameterList;

/// A text, or true or false, as a text.
std::optional<std::string> textOf(const ParameterList& list, const std::string& name)
{
  if (list.isType<bool>(name))
    return list.get<bool>(name) ? "true" : "false";
  return list.isType<std::string>(name) ? std::optional(list.get<std::string>(name)) : std::nullopt;
}

bool contains(const std::vector<std::string>& values, const std::optional<std::string>& value)
{
  return value && std::find(values.begin(), values.end(), *value) != values.end();
}

} // namespace

namespace when
{

Condition satisfies(const std::string& section, const std::string& text,
                    std::function<bool(const ParameterList&)> holds)
{
  return {section, "", " " + text, false, std::move(holds)};
}

Condition present(const std::string& section)
{
  return {section, "", "", false, [](const ParameterList&) { return true; }};
}

Condition absent(const std::string& section) { return {section, "", "", true, {}}; }

Condition given(const std::string& section, const std::string& parameter)
{
  return {section, parameter, "", false, [=](const ParameterList& s) { return s.isParameter(parameter); }};
}

Condition is(const std::string& section, const std::string& parameter, std::vector<std::string> values)
{
  return {section, parameter, " = " + asText(values), false,
          [=](const ParameterList& s) { return contains(values, textOf(s, parameter)); }};
}

Condition isNot(const std::string& section, const std::string& parameter, std::vector<std::string> values)
{
  return {section, parameter, " other than " + asText(values), false, [=](const ParameterList& s) {
            return textOf(s, parameter) && !contains(values, textOf(s, parameter));
          }};
}

Condition above(const std::string& section, const std::string& parameter, double bound)
{
  return {section, parameter, " above " + formatShort(bound), false, [=](const ParameterList& s) {
            return s.isType<double>(parameter) && s.get<double>(parameter) > bound;
          }};
}

Condition below(const std::string& section, const std::string& parameter, double bound)
{
  return {section, parameter, " below " + formatShort(bound), false, [=](const ParameterList& s) {
            return s.isType<double>(parameter) && s.get<double>(parameter) < bound;
          }};
}

Condition equilibrium() { return isNot("Time", "Analysis", {"Dynamic"}); }

Condition unprovided(const std::string& capability) { return {"", "", capability, false, {}, capability}; }

} // namespace when

std::string Rule::asText() const
{
  std::string text;
  for (const Condition& c : conditions)
  {
    const std::string path = c.parameter.empty() ? c.section : scenePath(c.section, c.parameter);
    text +=
        (text.empty() ? "" : ", ") +
        (!c.capability.empty() ? "without " + c.text : (c.absent ? "without section " : "") + path + c.text);
  }
  return text + (onlyDimension > 0 ? " (" + std::to_string(onlyDimension) + "D)" : "");
}

namespace
{

/// A list for which a condition holds, with the name that "*" stands for there.
struct Match
{
  std::string path, name;
};

/// A list on the way to one that is looked for. Texts are made of those that are found only.
struct Position
{
  const Position* above;
  const std::string* list; ///< its name; null: the scene
  const std::string* name; ///< that "*" stands for; null: any

  std::string path() const { return list == nullptr ? std::string() : scenePath(above->path(), *list); }
  Match match() const { return {path(), name == nullptr ? std::string() : *name}; }
};

/// The lists of a path of names. \param rest of the path, from `here` on
void findLists(const ParameterList& list, const std::string& rest, const Position& here,
               const std::function<void(const ParameterList&, const Position&)>& found)
{
  if (rest.empty())
    return found(list, here);
  const auto end = rest.find(" > ");
  const std::string first = rest.substr(0, end);
  const std::string next = end == std::string::npos ? "" : rest.substr(end + 3);
  const auto enter = [&](const std::string& name, const Teuchos::ParameterEntry& entry, bool any)
  {
    if (const auto* sublist = valueIf<ParameterList>(entry))
      findLists(*sublist, next, {&here, &name, any ? &name : here.name}, found);
  };
  if (first == "*" && here.name == nullptr)
    for (const auto& entry : list)
      enter(entry.first, entry.second, true);
  else if (const std::string& name = first == "*" ? *here.name : first; list.isParameter(name))
    enter(name, list.getEntry(name), first == "*");
}

bool provided(const ParameterList& scene, const SceneSchema& schema, const std::string& capability)
{
  return std::any_of(schema.root().sections.begin(), schema.root().sections.end(),
                     [&](const Section& s)
                     {
                       return scene.isSublist(s.name) &&
                              std::find(s.provides.begin(), s.provides.end(), capability) != s.provides.end();
                     });
}

/// Checks one scene.
struct RuleCheck
{
  const ParameterList& scene;
  const SceneSchema& schema;
  std::vector<SceneError>& errors;

  /// The lists for which a condition holds. \param name that "*" stands for; empty: any
  std::vector<Match> matches(const Condition& condition, const std::string& name) const
  {
    std::vector<Match> all;
    if (!condition.capability.empty())
    {
      if (!provided(scene, schema, condition.capability))
        all.push_back({"", name});
      return all;
    }
    bool any = false;
    findLists(scene, condition.section, {nullptr, nullptr, name.empty() ? nullptr : &name},
              [&](const ParameterList& list, const Position& position)
              {
                any = true;
                if (condition.absent || !condition.holds(list))
                  return;
                all.push_back(position.match());
                if (!condition.parameter.empty())
                  all.back().path = scenePath(all.back().path, condition.parameter);
              });
    if (condition.absent && !any)
      all.push_back({condition.section, name});
    return all;
  }

  bool hold(const std::vector<Condition>& conditions, const std::string& name) const
  {
    return std::all_of(conditions.begin(), conditions.end(),
                       [&](const Condition& c) { return !matches(c, name).empty(); });
  }

  void check(const Rule& rule)
  {
    if (rule.onlyDimension != 0 && rule.onlyDimension != dimensionOf(scene))
      return;
    for (const Match& match : matches(rule.conditions[rule.at], ""))
      if (hold(rule.conditions, match.name))
        errors.push_back({match.path, rule.reason});
  }

  /// Lists that are named after those of another section.
  void checkNames(const ParameterList& list, const Section& section, const std::string& path)
  {
    if (!section.namesOf.empty() && scene.isSublist(section.namesOf))
      for (const std::string& name : sublistNames(list))
        if (!scene.sublist(section.namesOf).isSublist(name))
          errors.push_back(
              {scenePath(path, name), "there is no " + section.entry.front().name + " of this name; " +
                                          section.namesOf + " has " +
                                          asText(sublistNames(scene.sublist(section.namesOf)), ", ")});
    for (const Section& sub : section.sections)
      if (list.isSublist(sub.name))
        checkNames(list.sublist(sub.name), sub, scenePath(path, sub.name));
  }
};

} // namespace

std::vector<KeptParameter> keptParameters(const ParameterList& scene, const SceneSchema& schema)
{
  std::vector<SceneError> none;
  const RuleCheck check{scene, schema, none};
  std::vector<KeptParameter> all;
  for (const Section& section : schema.root().sections)
    for (const KeptParameter& kept : section.kept)
      if (check.hold(kept.conditions, ""))
        all.push_back(kept);
  return all;
}

void checkRules(const ParameterList& scene, const SceneSchema& schema, std::vector<SceneError>& errors)
{
  RuleCheck check{scene, schema, errors};
  for (const Section& section : schema.root().sections)
  {
    for (const Rule& rule : section.rules)
      check.check(rule);
    if (scene.isSublist(section.name))
      check.checkNames(scene.sublist(section.name), section, section.name);
  }
}

} // namespace Rhegma
