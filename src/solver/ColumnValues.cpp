#include "solver/ColumnValues.hpp"

#include <Tpetra_Import.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>

#include <vector>

namespace Rhegma
{

namespace
{

using Map = Tpetra::Map<>;
using MultiVector = Tpetra::MultiVector<double>;
using Teuchos::RCP;
using Teuchos::rcp;

RCP<const Map> mapOf(const SparseMatrix& matrix, int count)
{
  std::vector<Map::global_ordinal_type> numbers;
  for (int k = 0; k < count; ++k)
    numbers.push_back(matrix.numberOf(k));
  return rcp(new Map(Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid(),
                     Teuchos::arrayViewFromVector(numbers), 0, matrix.ranks.comm()));
}

} // namespace

struct ColumnValues::Exchange
{
  explicit Exchange(const SparseMatrix& matrix)
      : rows(mapOf(matrix, matrix.rows())),
        columns(mapOf(matrix, static_cast<int>(matrix.number.extent(0)))),
        import(rows, columns),
        own(rows, 1),
        all(columns, 1)
  {
  }

  RCP<const Map> rows, columns;
  Tpetra::Import<> import;
  MultiVector own, all;
};

ColumnValues::ColumnValues(const SparseMatrix& matrix)
    : exchange_(matrix.ranks.many() ? std::make_unique<Exchange>(matrix) : nullptr)
{
}

ColumnValues::~ColumnValues() = default;

BorrowedView<const double*> ColumnValues::of(const BorrowedView<const double*>& own) const
{
  if (!exchange_)
    return own;
  {
    const auto to = exchange_->own.getLocalViewDevice(Tpetra::Access::OverwriteAll);
    Kokkos::deep_copy(Kokkos::subview(to, Kokkos::ALL(), 0), own);
  }
  exchange_->all.doImport(exchange_->own, exchange_->import, Tpetra::INSERT);
  const auto all =
      Kokkos::subview(exchange_->all.getLocalViewDevice(Tpetra::Access::ReadOnly), Kokkos::ALL(), 0);
  return BorrowedView<const double*>(all.data(), all.extent(0));
}

} // namespace Rhegma
