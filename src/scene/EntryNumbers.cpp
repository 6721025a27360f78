#include "scene/EntryNumbers.hpp"

#include <Teuchos_Array.hpp>

namespace Rhegma
{

using Teuchos::ParameterEntry;

namespace
{

template <class Number>
std::optional<double> asNumber(const ParameterEntry& entry)
{
  if (entry.isType<Number>())
    return static_cast<double>(Teuchos::getValue<Number>(entry));
  return {};
}

template <class Number>
std::optional<std::vector<double>> asNumbers(const ParameterEntry& entry)
{
  if (!entry.isType<Teuchos::Array<Number>>())
    return {};
  const auto& array = Teuchos::getValue<Teuchos::Array<Number>>(entry);
  return std::vector<double>(array.begin(), array.end());
}

} // namespace

std::optional<double> numberIn(const ParameterEntry& entry)
{
  for (const auto& value :
       {asNumber<double>(entry), asNumber<int>(entry), asNumber<float>(entry), asNumber<long>(entry),
        asNumber<long long>(entry), asNumber<unsigned>(entry), asNumber<unsigned long>(entry)})
    if (value)
      return value;
  return {};
}

std::optional<std::vector<double>> numbersIn(const ParameterEntry& entry)
{
  for (const auto& values : {asNumbers<double>(entry), asNumbers<int>(entry), asNumbers<float>(entry),
                             asNumbers<long long>(entry)})
    if (values)
      return values;
  if (const auto value = numberIn(entry))
    return std::vector<double>{*value};
  return {};
}

std::optional<std::string> textIn(const ParameterEntry& entry)
{
  if (entry.isType<std::string>())
    return Teuchos::getValue<std::string>(entry);
  if (entry.isType<const char*>())
    return std::string(Teuchos::getValue<const char*>(entry));
  return {};
}

} // namespace Rhegma
