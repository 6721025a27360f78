#include "scene/Validation.hpp"

#include "base/EntryValue.hpp"
#include "scene/NearestName.hpp"
#include "scene/NormaliseValue.hpp"
#include "scene/Utf8.hpp"

#include <algorithm>

namespace Rhegma
{

namespace
{

/// The variant that a list chooses; empty where the section has none.
std::string chosenIn(const Section& section, const Teuchos::ParameterList& list)
{
  if (section.key.empty())
    return {};
  if (const auto* chosen = valueIf<std::string>(list, section.key))
    return *chosen;
  const Parameter* key = section.findParameter(section.key);
  return key->byDefault && !list.isParameter(section.key) ? std::get<std::string>(*key->byDefault)
                                                          : std::string();
}

} // namespace

ActiveSection::ActiveSection(const Section& section, const Teuchos::ParameterList& list)
    : ActiveSection(section, chosenIn(section, list))
{
}

ActiveSection::ActiveSection(const Section& section, const std::string& chosen)
{
  const auto add = [this](const Section& s)
  {
    for (const auto& parameter : s.parameters)
      parameters.push_back(&parameter);
    for (const auto& sub : s.sections)
      sections.push_back(&sub);
    for (const auto& rule : s.together)
      together.push_back(&rule);
    if (s.userNamed())
      entry = &s.entry.front();
  };
  add(section);
  if (section.key.empty())
    return;
  variant = section.findVariant(chosen);
  variantKnown = variant != nullptr;
  if (variant)
    add(*variant);
}

const Parameter* ActiveSection::findParameter(const std::string& name) const
{
  for (const auto* parameter : parameters)
    if (parameter->name == name)
      return parameter;
  return nullptr;
}

const Section* ActiveSection::findSection(const std::string& name) const
{
  for (const auto* section : sections)
    if (section->name == name)
      return section;
  return nullptr;
}

std::vector<std::string> ActiveSection::parameterNames(int dimension) const
{
  std::vector<std::string> names;
  for (const auto* parameter : parameters)
    if (parameter->existsIn(dimension))
      names.push_back(parameter->name);
  return names;
}

std::vector<std::string> ActiveSection::sectionNames() const
{
  std::vector<std::string> names;
  for (const auto* section : sections)
    names.push_back(section->name);
  return names;
}

int dimensionOf(const Teuchos::ParameterList& scene)
{
  if (!scene.isSublist("Domain"))
    return 0;
  const auto& domain = scene.sublist("Domain");
  double dimension = 0.0;
  if (domain.isType<int>("Dimension"))
    dimension = domain.get<int>("Dimension");
  else if (domain.isType<double>("Dimension"))
    dimension = domain.get<double>("Dimension");
  return dimension == 2.0 ? 2 : dimension == 3.0 ? 3 : 0;
}

bool Validation::mentioned(const std::string& where) const
{
  return m_meant.count(where) > 0 || m_found.has(where);
}

const ActiveSection& ActiveSections::of(const Section& section, const Teuchos::ParameterList& list)
{
  std::pair<const Section*, std::string> key(&section, chosenIn(section, list));
  auto found = made_.find(key);
  if (found == made_.end())
  {
    ActiveSection active(section, key.second);
    found = made_.emplace(std::move(key), std::move(active)).first;
  }
  return found->second;
}

void Validation::check(Teuchos::ParameterList& list, const Section& section, const std::string& path)
{
  const ActiveSection& active = m_active.of(section, list);
  // An entry stays where it is in memory while others are removed and added.
  std::vector<std::pair<std::string, Teuchos::ParameterEntry*>> all;
  int entries = 0;
  for (const auto& entry : list)
  {
    all.emplace_back(entry.first, const_cast<Teuchos::ParameterEntry*>(&entry.second));
    entries += entry.second.isList() && !active.findSection(entry.first) ? 1 : 0;
  }
  for (const auto& [name, entry] : all)
    checkEntry(list, name, *entry, section, active, path);
  checkDimension(section, active, path);
  if (section.presence == Section::Presence::Required && active.entry && entries == 0 &&
      !m_found.hasBelow(path, {}))
    report(path, "is empty; write at least one " + active.entry->name + " as <ParameterList name=\"...\">.");
  fillIn(list, active, path);
  for (const auto* rule : active.together)
    checkTogether(list, *rule, path);
}

void Validation::checkDimension(const Section& section, const ActiveSection& active, const std::string& path)
{
  const auto exists = [this](const Section& s)
  { return s.onlyDimension == 0 || m_dimension == 0 || s.onlyDimension == m_dimension; };
  const std::string inThisScene = "D scene has, and this one is " + std::to_string(m_dimension) + "D; ";
  if (!exists(section))
    report(path, "is a section that only a " + std::to_string(section.onlyDimension) + inThisScene +
                     "leave it out.");
  if (!active.variant || exists(*active.variant))
    return;
  std::vector<std::string> others;
  for (const auto& variant : section.variants)
    if (exists(variant))
      others.push_back(variant.name);
  report(scenePath(path, section.key), "is " + active.variant->name + ", which only a " +
                                           std::to_string(active.variant->onlyDimension) + inThisScene +
                                           "write " + asText(others) + ".");
}

void Validation::checkEntry(Teuchos::ParameterList& list, const std::string& name,
                            Teuchos::ParameterEntry& entry, const Section& section,
                            const ActiveSection& active, const std::string& path)
{
  const Section* sub = active.findSection(name);
  const Parameter* parameter = active.findParameter(name);
  // Also where an application gives the list, which no XML has passed.
  if (const std::string mistake = mistakeInName(name); !mistake.empty())
  {
    report(scenePath(path, printable(name)), mistake);
    list.remove(name);
    return;
  }
  if (auto* sublist = valueIf<Teuchos::ParameterList>(entry))
  {
    if (!sub && !parameter)
      sub = active.entry;
    if (sub)
    {
      sublist->setName(list.name() + "->" + name);
      check(*sublist, *sub, scenePath(path, name));
      return;
    }
    if (parameter)
      report(scenePath(path, name),
             "is a parameter, not a section; write <Parameter name=\"" + name + "\" ...>.");
    else
      unknownSection(name, section, active, path);
  }
  else if (sub)
    report(scenePath(path, name),
           "is a section, not a parameter; write <ParameterList name=\"" + name + "\">.");
  else if (parameter)
  {
    checkParameter(list, *parameter, path);
    return;
  }
  else
    unknownParameter(name, section, active, path);
  list.remove(name);
}

void Validation::unknownSection(const std::string& name, const Section& section, const ActiveSection& active,
                                const std::string& path)
{
  const std::string where = scenePath(path, name);
  if (std::find(section.toCome.begin(), section.toCome.end(), name) != section.toCome.end())
    report(where, "is not part of this program: it was switched off when the program was built; leave the "
                  "section out.");
  else if (active.variantKnown)
  {
    const auto sectionNames = active.sectionNames();
    report(where, "there is no such section; " + suggestion(name, sectionNames));
    m_meant.insert(scenePath(path, nearestName(name, sectionNames)));
  }
}

void Validation::checkParameter(Teuchos::ParameterList& list, const Parameter& parameter,
                                const std::string& path)
{
  if (!parameter.existsIn(m_dimension))
    report(scenePath(path, parameter.name), "only a " + std::to_string(parameter.onlyDimension) +
                                                "D scene has it, and this one is " +
                                                std::to_string(m_dimension) + "D; leave it out.");
  else if (const auto wrong = normaliseValue(list, parameter, m_dimension))
    report(scenePath(path, parameter.name), *wrong);
  else
    return;
  list.remove(parameter.name);
}

void Validation::unknownParameter(const std::string& name, const Section& section,
                                  const ActiveSection& active, const std::string& path)
{
  const std::string where = scenePath(path, name);
  if (const Parameter* renamed = section.findFormer(name))
  {
    report(where, renamedTo(renamed->name));
    m_meant.insert(scenePath(path, renamed->name));
    return;
  }
  if (const auto now = section.moved.find(name); now != section.moved.end())
  {
    report(where, renamedTo(now->second));
    return;
  }
  std::vector<std::string> owners;
  for (const auto& variant : section.variants)
    if (variant.findParameter(name))
      owners.push_back(variant.name);
  if (!active.variantKnown)
  {
    // The valid names depend on the key, whose error is reported.
    auto names = active.parameterNames(m_dimension);
    for (const auto& variant : section.variants)
      for (const auto& parameter : variant.parameters)
        names.push_back(parameter.name);
    if (owners.empty())
      report(where, "there is no such parameter; " + suggestion(name, names));
    return;
  }
  if (!owners.empty())
  {
    report(where, "belongs to the " + section.key + " " + asText(owners) + "; leave it out or change " +
                      section.key + ".");
    return;
  }
  const auto names = active.parameterNames(m_dimension);
  if (names.empty() && active.entry)
    report(where, "is a parameter, but only sections are allowed here: write <ParameterList name=\"" + name +
                      "\"> for one " + active.entry->name + ".");
  else if (names.empty())
    report(where,
           "is a parameter, but only sections are allowed here: " + suggestion(name, active.sectionNames()));
  else
    report(where, "there is no such parameter; " + suggestion(name, names));
  m_meant.insert(scenePath(path, nearestName(name, names.empty() ? active.sectionNames() : names)));
}

void Validation::fillIn(Teuchos::ParameterList& list, const ActiveSection& active, const std::string& path)
{
  for (const auto* parameter : active.parameters)
  {
    if (!parameter->existsIn(m_dimension) || list.isParameter(parameter->name))
      continue;
    // Without a dimension it is unknown whether the parameter exists, and its length.
    if (m_dimension == 0 && parameter->onlyDimension != 0)
      continue;
    if (const auto* value = parameter->defaultIn(m_dimension))
    {
      addValue(list, *parameter, *value);
      Teuchos::ParameterEntry& entry = list.getEntry(parameter->name);
      entry.setAnyValue(entry.getAny(false), true); // so that isDefault() says who has written it
    }
    else if (parameter->required)
      missing(*parameter, path);
  }
  for (const auto* section : active.sections)
  {
    if (list.isSublist(section->name))
      continue;
    const std::string where = scenePath(path, section->name);
    if (section->presence == Section::Presence::Filled && !mentioned(where))
      check(list.sublist(section->name), *section, where);
    else if (section->presence == Section::Presence::Required && !mentioned(where))
      report(where, "the section is missing; write <ParameterList name=\"" + section->name + "\">.");
  }
}

void Validation::missing(const Parameter& parameter, const std::string& path)
{
  const std::string where = scenePath(path, parameter.name);
  if (!mentioned(where))
    report(where, "is missing; write " + typeAsText(parameter.type) +
                      (parameter.unit.empty() ? "" : " [" + parameter.unit + "]") +
                      (parameter.choices.empty() ? "." : ": " + asText(parameter.choices) + "."));
}

void Validation::checkTogether(const Teuchos::ParameterList& list, const Together& rule,
                               const std::string& path)
{
  std::vector<std::string> given;
  for (const auto& name : rule.names)
  {
    if (list.isParameter(name))
      given.push_back(name);
    else if (mentioned(scenePath(path, name))) // given, but wrong
      return;
  }
  const std::string names = asText(rule.names);
  if (rule.rule == Together::Rule::AllOrNone)
  {
    if (!given.empty() && given.size() < rule.names.size())
      report(path, "has " + asText(given, " and ") + " alone; write all of " + asText(rule.names, " and ") +
                       " or none.");
  }
  else if (given.size() > 1)
    report(path, "has " + asText(given, " and ") + "; write only one of " + names + ".");
  else if (given.empty() && rule.rule == Together::Rule::ExactlyOne)
    report(path, "needs one of " + names + "; write one.");
}

} // namespace Rhegma
