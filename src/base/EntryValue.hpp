#pragma once
/// Values of entries of lists, for loops over many lists: Teuchos looks entries up again for every question,
/// makes the texts of its messages before it needs them, and copies values several times.

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <utility>

namespace Rhegma
{

/// The value of an entry if it is of this type, else null.
template <class Value>
const Value* valueIf(const Teuchos::ParameterEntry& entry)
{
  using Holder = Teuchos::any::holder<Value>;
  const Teuchos::any& any = entry.getAny(false);
  return any.type() == typeid(Value)
             ? &static_cast<const Holder*>(const_cast<Teuchos::any&>(any).access_content())->held
             : nullptr;
}

/// The same of the entry of this name; null also if there is none.
template <class Value>
const Value* valueIf(const Teuchos::ParameterList& list, const std::string& name)
{
  const Teuchos::ParameterEntry* const entry = list.getEntryPtr(name);
  return entry == nullptr ? nullptr : valueIf<Value>(*entry);
}

/// The same, to be changed.
template <class Value>
Value* valueIf(Teuchos::ParameterEntry& entry)
{
  return const_cast<Value*>(valueIf<Value>(static_cast<const Teuchos::ParameterEntry&>(entry)));
}

/// Adds an entry. \param name of no entry of the list \return the value in the list
template <class Value>
Value& addValue(Teuchos::ParameterList& list, const std::string& name, const Value& value)
{
  list.setEntry(name, Teuchos::ParameterEntry());
  auto last = list.end();
  auto& entry = const_cast<Teuchos::ParameterEntry&>((--last)->second);
  entry.getAny(false) = value;
  return *valueIf<Value>(entry);
}

} // namespace Rhegma
