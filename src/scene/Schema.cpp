#include "scene/Schema.hpp"

#include "base/Numbers.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma
{

bool ArrayLength::holds(int n, int dimension) const
{
  switch (rule)
  {
  case Rule::Any:
    return n >= atLeast;
  case Rule::Exactly:
    return n == number;
  case Rule::MultipleOf:
    return n >= atLeast && n % number == 0;
  case Rule::Axes:
    return dimension == 0 || n == dimension;
  case Rule::MultipleOfAxes:
    return dimension == 0 || (n % dimension == 0 && n / dimension >= atLeast);
  case Rule::RotationAxes:
    return dimension == 0 || n == (dimension == 2 ? 1 : 3);
  }
  return false;
}

namespace
{

std::string count(int n, const std::string& noun)
{
  return std::to_string(n) + " " + noun + (n == 1 ? "" : "s");
}

} // namespace

std::string ArrayLength::asText(int dimension) const
{
  const std::string fewest = atLeast > 0 ? ", at least " + std::to_string(atLeast) : "";
  switch (rule)
  {
  case Rule::Any:
    return atLeast > 0 ? "at least " + count(atLeast, "number") : "any number of values";
  case Rule::Exactly:
    return count(number, "number");
  case Rule::MultipleOf:
    return "a multiple of " + count(number, "number") + fewest;
  case Rule::Axes:
    return dimension == 0 ? "a number per axis" : count(dimension, "number");
  case Rule::MultipleOfAxes:
  {
    const std::string points = atLeast > 1 ? ", at least " + count(atLeast, "point") : "";
    return dimension == 0 ? "a number per axis for each point" + points
                          : std::to_string(dimension) + " numbers for each point" + points;
  }
  case Rule::RotationAxes:
    return dimension == 0 ? "1 number in 2D, 3 numbers in 3D" : count(dimension == 2 ? 1 : 3, "number");
  }
  return {};
}

const ParameterValue* Parameter::defaultIn(int dimension) const
{
  if (dimension == 3 && byDefaultIn3D)
    return &*byDefaultIn3D;
  return byDefault ? &*byDefault : nullptr;
}

std::string Parameter::rangeAsText() const
{
  const bool hasUpper = std::isfinite(upper);
  if (!std::isfinite(lower))
    return hasUpper ? (upperOpen ? "below " : "at most ") + formatReal(upper) : std::string();
  if (hasUpper && !lowerOpen && !upperOpen)
    return "from " + formatReal(lower) + " to " + formatReal(upper);
  const std::string to = hasUpper ? (upperOpen ? " and below " : " and at most ") + formatReal(upper) : "";
  return (lowerOpen ? "above " : "at least ") + formatReal(lower) + to;
}

Section::Section(std::string n, std::string m) : name(std::move(n)), meaning(std::move(m)) {}

ParameterBuilder Section::add(const std::string& parameter, ParameterType type)
{
  parameters.emplace_back();
  parameters.back().name = parameter;
  parameters.back().type = type;
  return ParameterBuilder(parameters.back());
}

ParameterBuilder Section::real(const std::string& parameter) { return add(parameter, ParameterType::Real); }
ParameterBuilder Section::integer(const std::string& parameter)
{
  return add(parameter, ParameterType::Integer);
}
ParameterBuilder Section::boolean(const std::string& parameter)
{
  return add(parameter, ParameterType::Boolean);
}
ParameterBuilder Section::text(const std::string& parameter) { return add(parameter, ParameterType::Text); }
ParameterBuilder Section::choice(const std::string& parameter, std::vector<std::string> choices)
{
  const ParameterBuilder builder = add(parameter, ParameterType::Choice);
  parameters.back().choices = std::move(choices);
  return builder;
}
ParameterBuilder Section::realArray(const std::string& parameter)
{
  return add(parameter, ParameterType::RealArray);
}
ParameterBuilder Section::integerArray(const std::string& parameter)
{
  return add(parameter, ParameterType::IntegerArray);
}
ParameterBuilder Section::timeFunction(const std::string& parameter)
{
  return add(parameter, ParameterType::TimeFunction);
}

Section& Section::subsection(Section section)
{
  sections.push_back(std::move(section));
  return *this;
}

Section& Section::namedByUser(Section section)
{
  entry.clear();
  entry.push_back(std::move(section));
  return *this;
}

ParameterBuilder Section::fromLibrary(const std::string& parameter)
{
  libraryKey = parameter;
  return text(parameter).notEmpty().optional();
}

ParameterBuilder Section::chosenBy(const std::string& parameter)
{
  key = parameter;
  return choice(parameter, {});
}

Section& Section::variant(Section section)
{
  for (auto& parameter : parameters)
    if (parameter.name == key)
      parameter.choices.push_back(section.name);
  variants.push_back(std::move(section));
  return *this;
}

Section& Section::require()
{
  presence = Presence::Required;
  return *this;
}

Section& Section::fill()
{
  presence = Presence::Filled;
  return *this;
}

Section& Section::onlyIn(int dimension)
{
  onlyDimension = dimension;
  return *this;
}

Section& Section::mayChange()
{
  changeable = true;
  return *this;
}

Section& Section::exactlyOneOf(std::vector<std::string> names)
{
  together.push_back({Together::Rule::ExactlyOne, std::move(names)});
  return *this;
}

Section& Section::atMostOneOf(std::vector<std::string> names)
{
  together.push_back({Together::Rule::AtMostOne, std::move(names)});
  return *this;
}

Section& Section::allOrNoneOf(std::vector<std::string> names)
{
  together.push_back({Together::Rule::AllOrNone, std::move(names)});
  return *this;
}

namespace
{

template <class Item>
const Item* findByName(const std::vector<Item>& items, const std::string& name)
{
  for (const auto& item : items)
    if (item.name == name)
      return &item;
  return nullptr;
}

} // namespace

Section& Section::refuse(std::vector<Condition> conditions, const std::string& reason, int at, int dimension)
{
  rules.push_back({std::move(conditions), reason, at, dimension});
  return *this;
}

Section& Section::keep(KeptParameter parameter)
{
  kept.push_back(std::move(parameter));
  return *this;
}

Section& Section::needs(const std::string& other, const std::string& reason)
{
  return refuse({when::present(name), when::absent(other)}, reason);
}

Section& Section::namedAfter(const std::string& other, const std::string& reason)
{
  namesOf = other;
  return needs(other, reason);
}

Section& Section::provide(const std::string& capability)
{
  provides.push_back(capability);
  return *this;
}

const Parameter* Section::findParameter(const std::string& n) const { return findByName(parameters, n); }

const Parameter* Section::findFormer(const std::string& oldName) const
{
  for (const Parameter& parameter : parameters)
    for (const std::string& former : parameter.formerNames)
      if (former == oldName)
        return &parameter;
  for (const Section& variant : variants)
    if (const Parameter* parameter = variant.findFormer(oldName))
      return parameter;
  return nullptr;
}

const Section* Section::findSection(const std::string& n) const { return findByName(sections, n); }
const Section* Section::findVariant(const std::string& n) const { return findByName(variants, n); }

SceneSchema::SceneSchema(std::vector<Section> sections) : m_root("Rhegma", "A scene.")
{
  m_root.sections = std::move(sections);
  // A reader of the reference knows sections, not capabilities.
  for (Section& section : m_root.sections)
    for (Rule& rule : section.rules)
      for (Condition& condition : rule.conditions)
        for (const Section& provider : m_root.sections)
          if (std::find(provider.provides.begin(), provider.provides.end(), condition.capability) !=
              provider.provides.end())
            condition.text = "section " + provider.name;
}

} // namespace Rhegma
