#include "base/FieldTable.hpp"

#include "base/RowOrder.hpp"

#include <algorithm>

namespace Rhegma
{

namespace
{

/// Copies rows of a view behind its first `size` rows. \param spare rows to add where it has no place for
/// them
template <class Data>
void appendRows(View<Data>& view, int size, const View<int*>& rows, int spare)
{
  const int more = static_cast<int>(rows.extent(0));
  if (static_cast<int>(view.extent(0)) < size + more)
    Kokkos::resize(view, size + more + spare, view.extent(1));
  const auto* const from = view.data();
  const int columns = static_cast<int>(view.extent(1));
  copyRows(from, view.data() + static_cast<std::size_t>(size) * columns, rows, size, columns);
}

} // namespace

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
  {
    const int components = column.field.components;
    // Spare rows have no values; without them all new rows are zero.
    if (column.field.integer)
    {
      Kokkos::resize(column.whole, std::min(size, size_), components);
      Kokkos::resize(column.whole, size, components);
    }
    else
    {
      Kokkos::resize(column.real, std::min(size, size_), components);
      Kokkos::resize(column.real, size, components);
    }
  }
  size_ = size;
}

void FieldTable::reorder(const View<int*>& order)
{
  const int size = static_cast<int>(order.extent(0));
  for (Column& column : columns_)
    if (column.field.integer)
      column.whole = inOrder(column.whole, order, size_, spareRows(size));
    else
      column.real = inOrder(column.real, order, size_, spareRows(size));
  size_ = size;
}

void FieldTable::append(const View<int*>& rows)
{
  grows_ = true;
  const int size = size_ + static_cast<int>(rows.extent(0));
  for (Column& column : columns_)
    if (column.field.integer)
      appendRows(column.whole, size_, rows, spareRows(size));
    else
      appendRows(column.real, size_, rows, spareRows(size));
  size_ = size;
}

double FieldTable::bytes() const
{
  double sum = 0.0;
  for (const Column& column : columns_)
    sum += column.field.components * double(size_) * (column.field.integer ? sizeof(int) : sizeof(double));
  return sum;
}

} // namespace Rhegma
