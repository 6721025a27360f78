#pragma once
/// The table that owns the particles' fields: structure of arrays, one view a field.

#include "base/Field.hpp"
#include "base/Types.hpp"

#include <stdexcept>
#include <vector>

namespace Rhegma
{

/// Owns one view per field; all have one row per particle. Borrowed views are valid until the next resize or
/// reorder; stages fetch them anew.
class FieldTable
{
public:
  /// Adds a field of zeros. Throws std::logic_error when the name exists already.
  void add(const Field& field);

  bool has(const std::string& name) const; ///< whether there is a field of this name
  int size() const { return size_; }       ///< how many particles there are
  std::vector<Field> fields() const;       ///< all of them, in the order of adding

  /// A field of C numbers a particle, shape (particles, C).
  template <int C>
  BorrowedView<double* [C]> real(const std::string& name) const {
    const Column& column = find(name, C, false);
    return BorrowedView<double* [C]>(column.real.data(), size_);
  }

  /// A field of one number a particle, shape (particles).
  BorrowedView<double*> scalar(const std::string& name) const
  {
    return BorrowedView<double*>(find(name, 1, false).real.data(), size_);
  }

  /// A field of any number of components, shape (particles, components).
  BorrowedView<double**> table(const std::string& name) const
  {
    const Column& column = find(name, 0, false);
    return BorrowedView<double**>(column.real.data(), size_, column.field.components);
  }

  /// An integer field, shape (particles).
  BorrowedView<int*> integer(const std::string& name) const
  {
    return BorrowedView<int*>(find(name, 1, true).whole.data(), size_);
  }

  /// Changes the number of particles; new rows are zero, rows that stay keep their values.
  void resize(int size);

  /// Row i gets the values of row order(i).
  void reorder(const View<int*>& order);

  /// Adds a copy of each row of a list after the last row, in the order of the list. From then on the fields
  /// have some spare rows, so that rows that stay are not moved each time.
  void append(const View<int*>& rows);

  /// Bytes held by the fields.
  double bytes() const;

private:
  struct Column
  {
    Field field;
    View<double**> real;
    View<int**> whole;
  };
  const Column& find(const std::string& name, int components, bool integer) const;

  /// Rows after the last one in a table of this many.
  int spareRows(int size) const { return grows_ ? size / 8 : 0; }

  std::vector<Column> columns_;
  int size_ = 0;
  bool grows_ = false; ///< whether rows were appended
};

} // namespace Rhegma
