#include "equilibrium/SystemMatrix.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace Rhegma::equilibrium
{

namespace
{

/// For views that are filled before they are read: to set them to zero takes a tenth of a large assembly.
auto uninitialised(const std::string& label)
{
  return Kokkos::view_alloc(Kokkos::WithoutInitializing, label);
}

} // namespace

template <int D>
SystemMatrix<D>::SystemMatrix(const RowGraph& graph, const RowOwners& owners) : graph_(graph), owners_(owners)
{
  std::vector<int> own;
  for (int r = 0; r < graph.rows; ++r)
    if (owners.owns(r))
      own.push_back(r);
  own_ = View<int*>("rhegma::equilibrium::ownRows", own.size());
  std::copy(own.begin(), own.end(), own_.data());
}

template <int D>
void SystemMatrix<D>::build()
{
  const int rows = static_cast<int>(own_.extent(0));
  // Columns: the rows of this rank, then those of others, both in the order of their numbers.
  std::vector<int> column(graph_.rows, -1), others;
  for (int i = 0; i < rows; ++i)
    column[own_(i)] = i;
  std::vector<int> entries;
  entryBegin_ = View<int*>("rhegma::equilibrium::entryBegin", rows + 1);
  for (int i = 0; i < rows; ++i)
  {
    for (int e = graph_.first(own_(i)); e < graph_.first(own_(i) + 1); ++e)
    {
      entries.push_back(e);
      if (int& at = column[graph_.column(e)]; at < 0)
      {
        at = rows;
        others.push_back(graph_.column(e));
      }
    }
    entryBegin_(i + 1) = static_cast<int>(entries.size());
  }
  std::sort(others.begin(), others.end(),
            [this](int a, int b) { return owners_.numberOf(a) < owners_.numberOf(b); });
  for (std::size_t k = 0; k < others.size(); ++k)
    column[others[k]] = rows + static_cast<int>(k);
  matrix_.ranks = owners_.ranks();
  if (matrix_.ranks.many())
  {
    matrix_.number = View<long long*>("rhegma::equilibrium::number", D * (rows + others.size()));
    for (std::size_t k = 0; k < matrix_.number.extent(0); ++k)
    {
      const std::size_t row = k / D;
      matrix_.number(k) = D * owners_.numberOf(row < own_.extent(0) ? own_(row) : others[row - rows]) + k % D;
    }
    for (int i = 0; i < rows; ++i)
      std::sort(entries.begin() + entryBegin_(i), entries.begin() + entryBegin_(i + 1),
                [&](int a, int b) { return column[graph_.column(a)] < column[graph_.column(b)]; });
  }
  entry_ = View<int*>(uninitialised("rhegma::equilibrium::entries"), entries.size());
  std::copy(entries.begin(), entries.end(), entry_.data());
  matrix_.first = View<std::size_t*>("rhegma::equilibrium::first", D * rows + 1);
  matrix_.column = View<int*>(uninitialised("rhegma::equilibrium::column"), D * D * entries.size());
  matrix_.value = View<double*>(uninitialised("rhegma::equilibrium::value"), D * D * entries.size());
  std::size_t next = 0;
  for (int i = 0; i < rows; ++i)
    for (int a = 0; a < D; ++a)
    {
      for (int e = entryBegin_(i); e < entryBegin_(i + 1); ++e)
        for (int k = 0; k < D; ++k)
          matrix_.column(next++) = D * column[graph_.column(entry_(e))] + k;
      matrix_.first(D * i + a + 1) = next;
    }
  columns_ = std::make_unique<ColumnValues>(matrix_);
}

template <int D>
void SystemMatrix<D>::fill(const StiffnessBlocks& stiffness, const View<char*>& held)
{
  const RowGraph graph = graph_;
  const SparseMatrix matrix = matrix_;
  const View<int*> own = own_, entryBegin = entryBegin_, entry = entry_;
  Kokkos::parallel_for(
      "rhegma::equilibrium::fillRows", Kokkos::RangePolicy<ExecSpace>(0, own.extent(0)),
      KOKKOS_LAMBDA(const int r) {
        for (int i = 0; i < D; ++i)
        {
          const int from = D * own(r) + i;
          std::size_t at = matrix.first(D * r + i);
          for (int e = entryBegin(r); e < entryBegin(r + 1); ++e)
            for (int k = 0; k < D; ++k, ++at)
            {
              const int to = D * graph.column(entry(e)) + k;
              const double value = stiffness(D * D * static_cast<std::size_t>(entry(e)) + D * i + k);
              if (to == from)
                matrix.value(at) = held(to) != 0 && value <= 0.0 ? 1.0 : value;
              else
                matrix.value(at) = held(from) == 0 && held(to) == 0 ? value : 0.0;
            }
        }
      });
}

template <int D>
void SystemMatrix<D>::moveHeldToRight(const StiffnessBlocks& stiffness, const View<char*>& held,
                                      const Values& right, const Values& change, const Values& b) const
{
  const RowGraph graph = graph_;
  const View<int*> own = own_;
  Kokkos::parallel_for(
      "rhegma::equilibrium::rightSide", Kokkos::RangePolicy<ExecSpace>(0, own.extent(0)),
      KOKKOS_LAMBDA(const int r) {
        for (int i = 0; i < D; ++i)
        {
          const int from = D * own(r) + i;
          double sum = held(from) != 0 ? 0.0 : right(from);
          for (int e = graph.first(own(r)); e < graph.first(own(r) + 1) && held(from) == 0; ++e)
            for (int k = 0; k < D; ++k)
              if (const int other = D * graph.column(e) + k; held(other) != 0)
                sum -= stiffness(D * D * static_cast<std::size_t>(e) + D * i + k) * change(other);
          b(D * r + i) = sum;
        }
      });
}

template class SystemMatrix<2>;
template class SystemMatrix<3>;

} // namespace Rhegma::equilibrium
