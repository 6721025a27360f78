#include "plan/KnownEffects.hpp"

#include "plan/EffectSchema.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace Rhegma
{

namespace
{

std::vector<EffectEntry>& all()
{
  static std::vector<EffectEntry> effects = builtInEffects();
  return effects;
}

template <class List, class NameOf>
bool has(const List& list, const std::string& name, const NameOf& nameOf)
{
  return std::any_of(list.begin(), list.end(), [&](const auto& item) { return nameOf(item) == name; });
}

} // namespace

const std::vector<EffectEntry>& knownEffects() { return all(); }

RunOptions declaredOptions(const Teuchos::ParameterList& scene)
{
  RunOptions options;
  for (const EffectEntry& entry : knownEffects())
    if (entry.declare && scene.isSublist(entry.section.name))
      entry.declare(scene.sublist(entry.section.name), options);
  if (!options.endAtRest || !scene.isSublist("Time"))
    return options;
  for (DrivingFunction& function : drivingFunctions(scene, effectSchema()))
    options.driving.push_back(std::move(function));
  options.endAtRest->notBefore =
      Changes(options.driving, scene.sublist("Time").get<double>("Final Time")).last();
  return options;
}

const std::vector<std::string>& effectsToCome()
{
  static const std::vector<std::string> names = {};
  return names;
}

void addEffect(EffectEntry entry)
{
  const std::string& name = entry.section.name;
  const auto ofEffect = [](const EffectEntry& effect) { return effect.section.name; };
  const auto ofSection = [](const Section& section) { return section.name; };
  if (has(all(), name, ofEffect) || has(coreSections(), name, ofSection))
    throw std::invalid_argument("the effect \"" + name + "\" can't be added: a section of this name exists");
  if (!entry.make2 || !entry.make3)
    throw std::invalid_argument("the effect \"" + name +
                                "\" can't be added: it needs functions that make it in 2D and in 3D");
  all().push_back(std::move(entry));
}

} // namespace Rhegma
