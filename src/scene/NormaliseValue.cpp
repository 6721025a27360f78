#include "scene/NormaliseValue.hpp"

#include "base/EntryValue.hpp"
#include "base/Numbers.hpp"
#include "material/TemperatureTable.hpp"
#include "scene/EntryNumbers.hpp"
#include "scene/NearestName.hpp"
#include "scene/TimeFunction.hpp"
#include "scene/Validators.hpp"

#include <Teuchos_Array.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace Rhegma
{

namespace
{

using Teuchos::ParameterEntry;

std::optional<std::vector<int>> wholeNumbers(const std::vector<double>& values)
{
  std::vector<int> whole;
  for (const double value : values)
  {
    const auto integer = wholeNumber(value);
    if (!integer)
      return {};
    whole.push_back(*integer);
  }
  return whole;
}

/// The entry as a value of the parameter's own type.
std::optional<ParameterValue> convert(const ParameterEntry& entry, const Parameter& parameter)
{
  const ParameterType type = parameter.type;
  const auto pack = [](const auto& value)
  { return value ? std::optional<ParameterValue>(*value) : std::nullopt; };
  switch (type)
  {
  case ParameterType::Real:
    return pack(numberIn(entry));
  case ParameterType::Integer:
  {
    const auto value = numberIn(entry);
    return pack(value ? wholeNumber(*value) : std::nullopt);
  }
  case ParameterType::Boolean:
    if (entry.isType<bool>())
      return ParameterValue(Teuchos::getValue<bool>(entry));
    return {};
  case ParameterType::Text:
  case ParameterType::Choice:
    if (parameter.unit.empty())
      return pack(textIn(entry));
    [[fallthrough]]; // a text with a unit is an expression
  case ParameterType::TimeFunction:
    if (const auto value = numberIn(entry))
      return ParameterValue(formatExactly(*value));
    return pack(textIn(entry));
  case ParameterType::RealArray:
    return pack(numbersIn(entry));
  case ParameterType::IntegerArray:
  {
    const auto values = numbersIn(entry);
    return pack(values ? wholeNumbers(*values) : std::nullopt);
  }
  }
  return {};
}

/// What an entry holds, for a message.
std::string found(const ParameterEntry& entry)
{
  if (const auto value = textIn(entry))
    return "the text \"" + *value + "\"";
  if (entry.isType<bool>())
    return Teuchos::getValue<bool>(entry) ? "the truth value true" : "the truth value false";
  if (const auto value = numberIn(entry))
    return "the number " + formatReal(*value);
  if (const auto values = numbersIn(entry))
  {
    std::string list;
    for (const double value : *values)
      list += (list.empty() ? "" : ", ") + formatReal(value);
    return "the array {" + list + "}";
  }
  return "a value of the type " + entry.getAny(false).typeName();
}

std::string howToWrite(ParameterType type)
{
  switch (type)
  {
  case ParameterType::Real:
    return "type=\"double\"";
  case ParameterType::Integer:
    return "type=\"int\"";
  case ParameterType::Boolean:
    return "type=\"bool\" value=\"true\"";
  case ParameterType::RealArray:
    return "type=\"Array(double)\"";
  case ParameterType::IntegerArray:
    return "type=\"Array(int)\"";
  default:
    return "type=\"string\"";
  }
}

/// The error in a table of temperature, or nothing.
std::optional<std::string> wrongTable(const Parameter& parameter, const std::string& given)
{
  try
  {
    for (const double value : TemperatureTable::parse(given).value)
      if (value < parameter.lower || value > parameter.upper ||
          (parameter.lowerOpen && value == parameter.lower) ||
          (parameter.upperOpen && value == parameter.upper))
        return "has the value " + formatReal(value) + (parameter.unit.empty() ? "" : " " + parameter.unit) +
               " in its table; all must be " + parameter.rangeAsText() + ".";
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return {};
}

bool finite(const ParameterValue& value)
{
  if (const auto* real = std::get_if<double>(&value))
    return std::isfinite(*real);
  if (const auto* reals = std::get_if<std::vector<double>>(&value))
    for (const double x : *reals)
      if (!std::isfinite(x))
        return false;
  return true;
}

std::optional<std::string> wrongLength(const Parameter& parameter, const ParameterValue& value, int dimension)
{
  const auto* reals = std::get_if<std::vector<double>>(&value);
  const auto* integers = std::get_if<std::vector<int>>(&value);
  if (!reals && !integers)
    return {};
  const auto n = static_cast<int>(reals ? reals->size() : integers->size());
  if (parameter.length.holds(n, dimension))
    return {};
  return "has " + std::to_string(n) + (n == 1 ? " number" : " numbers") + "; write " +
         parameter.length.asText(dimension) +
         (dimension == 0 ? "." : " (the scene is " + std::to_string(dimension) + "D).");
}

bool isInRange(const Parameter& parameter, double value)
{
  return std::isfinite(value) && (parameter.lowerOpen ? value > parameter.lower : value >= parameter.lower) &&
         (parameter.upperOpen ? value < parameter.upper : value <= parameter.upper);
}

template <class Number>
bool areInRange(const Parameter& parameter, const Teuchos::Array<Number>& values, int dimension)
{
  return parameter.length.holds(static_cast<int>(values.size()), dimension) &&
         std::all_of(values.begin(), values.end(),
                     [&](Number value) { return isInRange(parameter, static_cast<double>(value)); });
}

/// Whether an entry is as it should be: by far the most are, and they need neither copy nor validator.
bool isRight(const ParameterEntry& entry, const Parameter& parameter, int dimension)
{
  if (!entry.validator().is_null()) // of an application
    return false;
  switch (parameter.type)
  {
  case ParameterType::Real:
    if (const auto* value = valueIf<double>(entry))
      return isInRange(parameter, *value);
    return false;
  case ParameterType::Integer:
    if (const auto* value = valueIf<int>(entry))
      return isInRange(parameter, *value);
    return false;
  case ParameterType::Boolean:
    return entry.isType<bool>();
  case ParameterType::Text:
    if (const auto* value = valueIf<std::string>(entry))
      return parameter.mayBeEmpty || !trimmed(*value).empty();
    return false;
  case ParameterType::Choice:
    if (const auto* value = valueIf<std::string>(entry))
      return std::find(parameter.choices.begin(), parameter.choices.end(), *value) != parameter.choices.end();
    return false;
  case ParameterType::RealArray:
    if (const auto* values = valueIf<Teuchos::Array<double>>(entry))
      return areInRange(parameter, *values, dimension);
    return false;
  case ParameterType::IntegerArray:
    if (const auto* values = valueIf<Teuchos::Array<int>>(entry))
      return areInRange(parameter, *values, dimension);
    return false;
  case ParameterType::TimeFunction: // is to be parsed
    return false;
  }
  return false;
}

/// The message when the validator refuses a value.
std::string refused(const Parameter& parameter, const ParameterEntry& entry, const std::string& reason)
{
  switch (parameter.type)
  {
  case ParameterType::Choice:
  {
    const std::string given = Teuchos::getValue<std::string>(entry);
    const std::string nearest = nearestName(given, parameter.choices);
    return "is \"" + given + "\"; write " + asText(parameter.choices) +
           (nearest.empty() ? "." : " (did you mean \"" + nearest + "\"?).");
  }
  case ParameterType::TimeFunction:
    return reason;
  case ParameterType::Text:
    return "is empty; write a text.";
  default:
    return "is " + (numberIn(entry) ? formatReal(*numberIn(entry)) : found(entry)) +
           (parameter.unit.empty() ? "" : " " + parameter.unit) + "; it must be " + parameter.rangeAsText() +
           (parameter.unit.empty() ? "." : " " + parameter.unit + ".");
  }
}

} // namespace

std::string typeAsText(ParameterType type)
{
  switch (type)
  {
  case ParameterType::Real:
    return "a real number";
  case ParameterType::Integer:
    return "a whole number";
  case ParameterType::Boolean:
    return "true or false";
  case ParameterType::Text:
    return "a text";
  case ParameterType::Choice:
    return "one of the allowed values";
  case ParameterType::RealArray:
    return "an array of real numbers";
  case ParameterType::IntegerArray:
    return "an array of whole numbers";
  case ParameterType::TimeFunction:
    return "a function of time";
  }
  return {};
}

void setValue(Teuchos::ParameterList& list, const Parameter& parameter, const ParameterValue& value)
{
  list.remove(parameter.name, false); // an entry keeps its type and the validator of an application
  addValue(list, parameter, value);
}

void addValue(Teuchos::ParameterList& list, const Parameter& parameter, const ParameterValue& value)
{
  std::visit(
      [&](const auto& v)
      {
        using Value = std::decay_t<decltype(v)>;
        if constexpr (std::is_same_v<Value, std::vector<double>>)
          addValue(list, parameter.name, Teuchos::Array<double>(v));
        else if constexpr (std::is_same_v<Value, std::vector<int>>)
          addValue(list, parameter.name, Teuchos::Array<int>(v));
        else
          addValue(list, parameter.name, v);
      },
      value);
}

std::optional<std::string> normaliseValue(Teuchos::ParameterList& list, const Parameter& parameter,
                                          int dimension)
{
  const ParameterEntry& entry = list.getEntry(parameter.name);
  if (isRight(entry, parameter, dimension))
    return {};
  if (const auto table = textIn(entry);
      parameter.mayBeTable && table && table->find(':') != std::string::npos)
    return wrongTable(parameter, *table);
  const auto value = convert(entry, parameter);
  if (const auto whole = numberIn(entry); !value && whole && parameter.type == ParameterType::Integer &&
                                          std::fabs(*whole) > std::numeric_limits<int>::max())
    return "is " + formatReal(*whole) + "; write at most " + std::to_string(std::numeric_limits<int>::max()) +
           ".";
  if (!value)
    return "is " + found(entry) + "; write " + typeAsText(parameter.type) + " (" +
           howToWrite(parameter.type) + ").";
  if (!finite(*value))
    return "is not finite; write a finite number.";
  if (auto wrong = wrongLength(parameter, *value, dimension))
    return wrong;
  setValue(list, parameter, *value);
  const auto validator = makeValidator(parameter);
  if (!validator.is_null())
    try
    {
      validator->validate(list.getEntry(parameter.name), parameter.name, list.name());
    }
    catch (const std::exception& error)
    {
      return refused(parameter, list.getEntry(parameter.name), error.what());
    }
  return {};
}

std::optional<ParameterValue> valueFromText(const Parameter& parameter, const std::string& given)
{
  const auto pack = [](const auto& value)
  { return value ? std::optional<ParameterValue>(*value) : std::nullopt; };
  const std::string value = trimmed(given);
  switch (parameter.type)
  {
  case ParameterType::Real:
    if (parameter.mayBeTable && given.find(':') != std::string::npos)
      return ParameterValue(given);
    return pack(parseReal(given));
  case ParameterType::Integer:
    return pack(parseInteger(given));
  case ParameterType::Boolean:
    if (value == "true" || value == "false")
      return ParameterValue(value == "true");
    return {};
  case ParameterType::RealArray:
    return pack(parseReals(given));
  case ParameterType::IntegerArray:
  {
    const auto values = parseReals(given);
    return pack(values ? wholeNumbers(*values) : std::nullopt);
  }
  default:
    return ParameterValue(given);
  }
}

} // namespace Rhegma
