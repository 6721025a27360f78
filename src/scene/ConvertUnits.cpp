#include "scene/ConvertUnits.hpp"

#include "base/EntryValue.hpp"
#include "base/Numbers.hpp"
#include "base/PairTable.hpp"
#include "scene/EntryNumbers.hpp"
#include "scene/NormaliseValue.hpp"
#include "scene/TimeFunction.hpp"
#include "scene/UnitConversion.hpp"
#include "scene/UnitText.hpp"
#include "scene/Validation.hpp"
#include "scene/ValueWithUnit.hpp"

#include <Teuchos_Array.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <stdexcept>

namespace Rhegma
{

namespace
{

using Teuchos::ParameterEntry;
using Teuchos::ParameterList;

/// A value and the unit that it is given in; no unit where a text is none that can be converted.
struct Given
{
  ParameterEntry value;
  std::optional<std::string> unit;
};

/// Whether a text may be a number with a unit.
bool takesQuantity(const Parameter& parameter)
{
  switch (parameter.type)
  {
  case ParameterType::Real:
  case ParameterType::RealArray:
    return true;
  case ParameterType::Text:
  case ParameterType::TimeFunction:
    return !parameter.unit.empty();
  default:
    return false;
  }
}

/// Whether an entry is, or may be, given in a unit.
bool mayHaveUnit(const ParameterEntry& entry)
{
  if (valueIf<ValueWithUnit>(entry) != nullptr)
    return true;
  const auto* content = valueIf<std::string>(entry);
  return content != nullptr && quantityOf(*content);
}

/// By far the most scenes have no units.
bool hasUnits(const ParameterList& list)
{
  for (const auto& entry : list)
    if (const auto* sublist = valueIf<ParameterList>(entry.second);
        sublist != nullptr ? hasUnits(*sublist) : mayHaveUnit(entry.second))
      return true;
  return false;
}

/// The shortest of two texts of a number that reads as the same one.
std::string exactText(double value)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.15g", value);
  return *parseReal(text) == value ? text : formatExactly(value);
}

/// "a:1, b:2" with the second number of each pair converted.
std::string convertTable(const std::string& table, const UnitConversion& conversion)
{
  std::string converted;
  for (std::size_t begin = 0; begin <= table.size();)
  {
    const std::size_t end = std::min(table.find(',', begin), table.size());
    const std::string pair = table.substr(begin, end - begin);
    const std::size_t colon = pair.find(':');
    const auto value = colon == std::string::npos ? std::nullopt : parseReal(pair.substr(colon + 1));
    converted += (begin == 0 ? "" : ",") +
                 (value ? pair.substr(0, colon + 1) + exactText(conversion(*value)) : pair); // reported later
    begin = end + 1;
  }
  return converted;
}

/// An expression of time with a factor, if it is one.
std::string convertExpression(const std::string& expression, const UnitConversion& conversion)
{
  try
  {
    TimeFunction::parse(expression);
  }
  catch (const std::invalid_argument&)
  {
    return expression; // reported later, as it was written
  }
  std::string sum = "(" + expression + ")";
  if (conversion.offset != 0.0)
    sum = "(" + sum + " + " + exactText(conversion.offset) + ")";
  return exactText(conversion.factor) + "*" + sum;
}

/// The value of a number, also of one in a text.
std::optional<double> oneNumber(const ParameterEntry& entry)
{
  const auto content = textIn(entry);
  return content ? parseReal(*content) : numberIn(entry);
}

/// What a parameter without a unit is, such as "a number without a unit".
std::string withoutUnit(const Parameter& parameter)
{
  if (parameter.type == ParameterType::Real)
    return "a number without a unit";
  return parameter.type == ParameterType::RealArray ? "an array of numbers without a unit"
                                                    : typeAsText(parameter.type);
}

/// Converts values of the types that have units.
class Converter
{
public:
  Converter(const Parameter& parameter, const UnitConversion& conversion)
      : parameter_(parameter), conversion_(conversion)
  {
  }

  /// \throws std::invalid_argument with what is wrong
  ParameterValue operator()(const ParameterEntry& given) const
  {
    if (parameter_.type == ParameterType::RealArray)
      return array(given);
    if (const auto value = oneNumber(given))
    {
      const double converted = conversion_(*value);
      return parameter_.type == ParameterType::Real ? ParameterValue(converted)
                                                    : ParameterValue(exactText(converted));
    }
    const auto content = textIn(given);
    if (!content)
      throw std::invalid_argument("has a unit, but no number; write " + typeAsText(parameter_.type) + ".");
    if (quantityOf(*content))
      throw std::invalid_argument("has a unit in its value, \"" + *content +
                                  "\", and another one; keep one of the two.");
    if (parameter_.type == ParameterType::TimeFunction)
      return PairTable::isMeant(*content) ? convertTable(*content, conversion_)
                                          : convertExpression(*content, conversion_);
    if (parameter_.type == ParameterType::Real && parameter_.mayBeTable && PairTable::isMeant(*content))
      return convertTable(*content, conversion_);
    if (parameter_.type == ParameterType::Text)
      throw std::invalid_argument("has a unit, but it is an expression or a table, which are in SI units (" +
                                  parameter_.unit + "); leave the unit out.");
    throw std::invalid_argument("is \"" + *content + "\" with a unit; write a number.");
  }

private:
  ParameterValue array(const ParameterEntry& given) const
  {
    const auto content = textIn(given);
    auto values = content ? parseReals(*content) : numbersIn(given);
    if (!values)
      throw std::invalid_argument("has a unit, but it is no array of numbers; write numbers such as {1, 2}.");
    for (double& value : *values)
      value = conversion_(value);
    return *values;
  }

  const Parameter& parameter_;
  const UnitConversion& conversion_;
};

/// Walks through a list and its section together.
class UnitPass
{
public:
  explicit UnitPass(std::vector<SceneError>& errors) : errors_(errors) {}

  void convert(ParameterList& list, const Section& section, const std::string& path)
  {
    const ActiveSection& active = sections_.of(section, list);
    std::vector<std::string> given;
    for (const auto& entry : list)
      if (const auto* sublist = valueIf<ParameterList>(entry.second))
      {
        const Section* sub = active.findSection(entry.first);
        sub = sub == nullptr ? active.entry : sub;
        if (sub != nullptr)
          convert(const_cast<ParameterList&>(*sublist), *sub, scenePath(path, entry.first));
        else
          dropUnits(const_cast<ParameterList&>(*sublist));
      }
      else if (mayHaveUnit(entry.second))
        given.push_back(entry.first);
    for (const std::string& name : given)
      convertOne(list, name, active.findParameter(name), scenePath(path, name));
  }

private:
  /// In a section that is reported as unknown.
  static void dropUnits(ParameterList& list)
  {
    for (const auto& entry : list)
    {
      auto& held = const_cast<ParameterEntry&>(entry.second);
      if (auto* sublist = valueIf<ParameterList>(held))
        dropUnits(*sublist);
      else if (const auto* withUnit = valueIf<ValueWithUnit>(held))
        held = ParameterEntry(withUnit->value);
    }
  }

  /// \param parameter null where the section has none of the name, which the validation reports
  void convertOne(ParameterList& list, const std::string& name, const Parameter* parameter,
                  const std::string& where)
  {
    const Given given = read(list.getEntry(name), parameter);
    if (!given.unit)
      return;
    list.setEntry(name, given.value);
    if (parameter == nullptr)
      return;
    if (parameter->unit.empty() || !takesQuantity(*parameter))
    {
      report(where, "is given in " + *given.unit + ", but it is " + withoutUnit(*parameter) +
                        "; leave the unit out.");
      if (takesQuantity(*parameter)) // its number may be wrong without the unit
        list.remove(name);
      return;
    }
    try
    {
      const UnitConversion conversion = conversionOf(*given.unit, parameter->unit, parameter->temperature);
      setValue(list, *parameter, Converter(*parameter, conversion)(given.value));
    }
    catch (const std::invalid_argument& error)
    {
      report(where, error.what());
      list.remove(name);
    }
  }

  static Given read(const ParameterEntry& entry, const Parameter* parameter)
  {
    if (const auto* withUnit = valueIf<ValueWithUnit>(entry))
      return {withUnit->value, withUnit->unit};
    if (parameter == nullptr || !takesQuantity(*parameter))
      return {entry, {}};
    const auto quantity = quantityOf(*textIn(entry));
    ParameterEntry value(entry);
    value.setValue(quantity->value);
    return {value, quantity->unit};
  }

  void report(const std::string& where, const std::string& message) { errors_.push_back({where, message}); }

  std::vector<SceneError>& errors_;
  ActiveSections sections_;
};

} // namespace

void convertUnits(ParameterList& scene, const SceneSchema& schema, std::vector<SceneError>& errors)
{
  if (hasUnits(scene))
    UnitPass(errors).convert(scene, schema.root(), "");
}

} // namespace Rhegma
