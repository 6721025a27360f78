#include "equilibrium/LinearSystem.hpp"

#include <algorithm>

namespace Rhegma::equilibrium
{

namespace
{

constexpr double linearTolerance = 1e-11;
constexpr int mostLinearIterations = 50000;

/// Residual of a linear solve, relative to its right side, with which an iteration of Newton's method still
/// gains digits: rounding keeps large matrices from the tolerance.
constexpr double usefulResidual = 1e-3;

} // namespace

template <int D>
LinearSystem<D>::LinearSystem(const State<D>&, const RowGraph& graph, const Held& held)
    : graph_(graph), free_(D * graph.rows, -1), gradients_(linearTolerance, mostLinearIterations)
{
  for (int k = 0; k < D * graph.rows; ++k)
    if (held.is[k] == 0)
      free_[k] = unknowns_++;
  first_.assign(1, 0);
  for (int r = 0; r < graph.rows; ++r)
    for (int i = 0; i < D; ++i)
    {
      if (free_[D * r + i] < 0)
        continue;
      for (int e = graph.first(r); e < graph.first(r + 1); ++e)
        for (int k = 0; k < D; ++k)
          if (const int to = free_[D * graph.column(e) + k]; to >= 0)
          {
            column_.push_back(to);
            entry_.push_back(D * D * e + D * i + k);
          }
      first_.push_back(static_cast<int>(column_.size()));
    }
  value_.resize(column_.size());
  gradients_.resize(unknowns_);
}

template <int D>
LinearAnswer LinearSystem<D>::solve(const StiffnessBlocks& stiffness, const Values& right,
                                    const Values& change)
{
  for (std::size_t k = 0; k < value_.size(); ++k)
    value_[k] = stiffness(entry_[k]);
  const auto b = gradients_.right();
  double size = 0.0;
  for (int r = 0; r < graph_.rows; ++r)
    for (int i = 0; i < D; ++i)
    {
      const int row = free_[D * r + i];
      if (row < 0)
        continue;
      double sum = right(D * r + i);
      for (int e = graph_.first(r); e < graph_.first(r + 1); ++e)
        for (int k = 0; k < D; ++k)
          if (const int other = D * graph_.column(e) + k; free_[other] < 0)
            sum -= stiffness(D * D * e + D * i + k) * change(other);
      b(row) = sum;
      size += sum * sum;
    }
  size = std::sqrt(size);
  for (int k = 0; k < unknowns_; ++k)
    b(k) /= size > 0.0 ? size : 1.0;
  std::vector<double> diagonal(unknowns_, 1.0);
  for (int r = 0; r < unknowns_; ++r)
    for (int k = first_[r]; k < first_[r + 1]; ++k)
      if (column_[k] == r)
        diagonal[r] = value_[k];
  const SolveResult result = gradients_.solve(
      [&](const BorrowedView<const double*>& x, const BorrowedView<double*>& y)
      {
        for (int r = 0; r < unknowns_; ++r)
        {
          double sum = 0.0;
          for (int k = first_[r]; k < first_[r + 1]; ++k)
            sum += value_[k] * x(column_[k]);
          y(r) = sum;
        }
      },
      [&](const BorrowedView<const double*>& x, const BorrowedView<double*>& y)
      {
        for (int r = 0; r < unknowns_; ++r)
          y(r) = x(r) / diagonal[r];
      });
  const auto x = gradients_.solution();
  for (int k = 0; k < D * graph_.rows; ++k)
    if (free_[k] >= 0)
      change(k) = size * x(free_[k]);
  // Newton's method corrects the rest.
  return {result.converged || result.residual < usefulResidual, result.iterations};
}

template class LinearSystem<2>;
template class LinearSystem<3>;

} // namespace Rhegma::equilibrium
