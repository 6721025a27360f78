#include "base/FieldTable.hpp"

#include "base/RowOrder.hpp"

namespace Rhegma
{

void FieldTable::add(const Field& field)
{
  if (has(field.name))
    throw std::logic_error("the particle field \"" + field.name + "\" exists already");
  Column column{field, {}, {}};
  if (field.integer)
    column.whole = View<int**>(field.name, size_, field.components);
  else
    column.real = View<double**>(field.name, size_, field.components);
  columns_.push_back(column);
}

bool FieldTable::has(const std::string& name) const
{
  for (const Column& column : columns_)
    if (column.field.name == name)
      return true;
  return false;
}

std::vector<Field> FieldTable::fields() const
{
  std::vector<Field> all;
  for (const Column& column : columns_)
    all.push_back(column.field);
  return all;
}

const FieldTable::Column& FieldTable::find(const std::string& name, int components, bool integer) const
{
  for (const Column& column : columns_)
    if (column.field.name == name)
    {
      if (column.field.integer != integer || (components != 0 && column.field.components != components))
        throw std::logic_error("the particle field \"" + name + "\" does not have the requested shape");
      return column;
    }
  throw std::logic_error("there is no particle field \"" + name + "\"");
}

void FieldTable::resize(int size)
{
  for (Column& column : columns_)
    if (column.field.integer)
      Kokkos::resize(column.whole, size, column.field.components);
    else
      Kokkos::resize(column.real, size, column.field.components);
  size_ = size;
}

void FieldTable::reorder(const View<int*>& order)
{
  for (Column& column : columns_)
    if (column.field.integer)
      column.whole = inOrder(column.whole, order);
    else
      column.real = inOrder(column.real, order);
  size_ = static_cast<int>(order.extent(0));
}

double FieldTable::bytes() const
{
  double sum = 0.0;
  for (const Column& column : columns_)
    sum += column.field.components * double(size_) * (column.field.integer ? sizeof(int) : sizeof(double));
  return sum;
}

} // namespace Rhegma
