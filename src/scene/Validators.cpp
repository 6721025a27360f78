#include "scene/Validators.hpp"

#include "base/Numbers.hpp"
#include "scene/TimeFunction.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_StandardParameterEntryValidators.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>
#include <stdexcept>

namespace Rhegma
{

namespace
{

/// Accepts the texts that TimeFunction::parse accepts.
class TimeFunctionValidator : public Teuchos::ParameterEntryValidator
{
public:
  const std::string getXMLTypeName() const override { return "TimeFunctionValidator"; }
  void printDoc(std::string const& text, std::ostream& out) const override
  {
    Teuchos::StrUtils::printLines(out, "# ", text);
    out << "#\tAn expression of t or a table \"0:0, 1e-3:5\".\n";
  }
  ValidStringsList validStringValues() const override { return Teuchos::null; }
  void validate(Teuchos::ParameterEntry const& entry, std::string const& name,
                std::string const&) const override
  {
    if (!entry.isType<std::string>())
      throw Teuchos::Exceptions::InvalidParameterType(name + " must be a text.");
    try
    {
      TimeFunction::parse(Teuchos::getValue<std::string>(entry));
    }
    catch (const std::invalid_argument& error)
    {
      throw Teuchos::Exceptions::InvalidParameterValue(error.what());
    }
  }
};

/// Accepts every text but an empty one.
class NotEmptyValidator : public Teuchos::ParameterEntryValidator
{
public:
  const std::string getXMLTypeName() const override { return "NotEmptyValidator"; }
  void printDoc(std::string const& text, std::ostream& out) const override
  {
    Teuchos::StrUtils::printLines(out, "# ", text);
    out << "#\tMust not be empty.\n";
  }
  ValidStringsList validStringValues() const override { return Teuchos::null; }
  void validate(Teuchos::ParameterEntry const& entry, std::string const& name,
                std::string const&) const override
  {
    if (!entry.isType<std::string>())
      throw Teuchos::Exceptions::InvalidParameterType(name + " must be a text.");
    if (trimmed(Teuchos::getValue<std::string>(entry)).empty())
      throw Teuchos::Exceptions::InvalidParameterValue(name + " must not be empty.");
  }
};

using RealValidator = Teuchos::EnhancedNumberValidator<double>;
using IntegerValidator = Teuchos::EnhancedNumberValidator<int>;

/// Smallest and largest allowed double: an open bound is replaced by its neighbour, an absent one by the
/// largest finite number, which refuses infinity and NaN.
Teuchos::RCP<const RealValidator> realValidator(const Parameter& parameter)
{
  const double huge = std::numeric_limits<double>::max();
  const double lower = parameter.lowerOpen ? std::nextafter(parameter.lower, huge) : parameter.lower;
  const double upper = parameter.upperOpen ? std::nextafter(parameter.upper, -huge) : parameter.upper;
  return Teuchos::rcp(new RealValidator(std::max(lower, -huge), std::min(upper, huge)));
}

Teuchos::RCP<const IntegerValidator> integerValidator(const Parameter& parameter)
{
  const double least = std::numeric_limits<int>::min();
  const double most = std::numeric_limits<int>::max();
  const double lower = parameter.lowerOpen ? std::floor(parameter.lower) + 1.0 : std::ceil(parameter.lower);
  const double upper = parameter.upperOpen ? std::ceil(parameter.upper) - 1.0 : std::floor(parameter.upper);
  return Teuchos::rcp(new IntegerValidator(static_cast<int>(std::clamp(lower, least, most)),
                                           static_cast<int>(std::clamp(upper, least, most))));
}

std::string presenceAsText(const Parameter& parameter)
{
  if (!parameter.derivedDefault.empty())
    return "default: " + parameter.derivedDefault;
  if (parameter.byDefault)
    return {};
  return parameter.required ? "required" : "absent unless given";
}

void setEntry(Teuchos::ParameterList& list, const Parameter& parameter)
{
  const std::string& name = parameter.name;
  const std::string text = documentation(parameter);
  const auto validator = makeValidator(parameter);
  const ParameterValue* given = parameter.defaultIn(2);
  switch (parameter.type)
  {
  case ParameterType::Real:
  {
    const auto range = realValidator(parameter);
    const double some = std::clamp(0.0, range->getMin(), range->getMax());
    list.set(name, given ? std::get<double>(*given) : some, text, validator);
    break;
  }
  case ParameterType::Integer:
  {
    const auto range = integerValidator(parameter);
    const int some = std::clamp(0, range->getMin(), range->getMax());
    list.set(name, given ? std::get<int>(*given) : some, text, validator);
    break;
  }
  case ParameterType::Boolean:
    list.set(name, given ? std::get<bool>(*given) : false, text, validator);
    break;
  case ParameterType::Text:
    list.set(name, given ? std::get<std::string>(*given) : std::string("text"), text, validator);
    break;
  case ParameterType::Choice:
  {
    const std::string first = parameter.choices.empty() ? std::string() : parameter.choices.front();
    list.set(name, given ? std::get<std::string>(*given) : first, text, validator);
    break;
  }
  case ParameterType::TimeFunction:
    list.set(name, given ? std::get<std::string>(*given) : std::string("1"), text, validator);
    break;
  case ParameterType::RealArray:
    list.set(name,
             Teuchos::Array<double>(given ? std::get<std::vector<double>>(*given) : std::vector<double>()),
             text, validator);
    break;
  case ParameterType::IntegerArray:
    list.set(name, Teuchos::Array<int>(given ? std::get<std::vector<int>>(*given) : std::vector<int>()), text,
             validator);
    break;
  }
}

void setSection(Teuchos::ParameterList& list, const Section& section)
{
  for (const auto& parameter : section.parameters)
    setEntry(list, parameter);
  for (const auto& sub : section.sections)
    setSection(list.sublist(sub.name, false, sub.meaning), sub);
}

} // namespace

Teuchos::RCP<const Teuchos::ParameterEntryValidator> makeValidator(const Parameter& parameter)
{
  switch (parameter.type)
  {
  case ParameterType::Real:
    return realValidator(parameter);
  case ParameterType::Integer:
    return integerValidator(parameter);
  case ParameterType::RealArray:
    return Teuchos::rcp(new Teuchos::ArrayNumberValidator<double>(realValidator(parameter)));
  case ParameterType::IntegerArray:
    return Teuchos::rcp(new Teuchos::ArrayNumberValidator<int>(integerValidator(parameter)));
  case ParameterType::Choice:
    return Teuchos::rcp(new Teuchos::StringValidator(Teuchos::Array<std::string>(parameter.choices)));
  case ParameterType::TimeFunction:
    return Teuchos::rcp(new TimeFunctionValidator);
  case ParameterType::Text:
    if (!parameter.mayBeEmpty)
      return Teuchos::rcp(new NotEmptyValidator);
    break;
  case ParameterType::Boolean:
    break;
  }
  return Teuchos::null;
}

std::string documentation(const Parameter& parameter)
{
  std::string text = parameter.meaning;
  if (!parameter.unit.empty())
    text += " [" + parameter.unit + "]";
  for (const auto& part : {parameter.rangeAsText(), presenceAsText(parameter)})
    if (!part.empty())
      text += (text.empty() ? "" : "; ") + part;
  return text;
}

Teuchos::RCP<const Teuchos::ParameterList> validParameters(const Section& section)
{
  const auto list = Teuchos::parameterList(section.name);
  setSection(*list, section);
  return list;
}

} // namespace Rhegma
