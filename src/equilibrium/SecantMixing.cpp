#include "equilibrium/SecantMixing.hpp"

#include <cmath>
#include <utility>
#include <vector>

namespace Rhegma::equilibrium
{

namespace
{

/// Fraction of a diagonal below which a pivot is rounding: secants that are almost parallel say nothing new.
constexpr double leastPivot = 1e-10;

Values copyOf(const Values& values)
{
  Values copy(Kokkos::view_alloc(Kokkos::WithoutInitializing, "rhegma::equilibrium::secant"),
              values.extent(0));
  Kokkos::deep_copy(copy, values);
  return copy;
}

Values difference(const Values& a, const Values& b)
{
  Values result = copyOf(a);
  for (std::size_t k = 0; k < a.extent(0); ++k)
    result(k) -= b(k);
  return result;
}

/// Solves a small symmetric system by Cholesky's method; unknowns without a pivot are zero.
std::vector<double> solveSmall(std::vector<std::vector<double>> matrix, std::vector<double> right)
{
  const std::size_t n = right.size();
  std::vector<double> diagonal(n), solution(n, 0.0);
  std::vector<bool> used(n, false);
  for (std::size_t i = 0; i < n; ++i)
    diagonal[i] = matrix[i][i];
  for (std::size_t i = 0; i < n; ++i)
  {
    used[i] = matrix[i][i] > leastPivot * diagonal[i];
    for (std::size_t j = i + 1; used[i] && j < n; ++j)
    {
      const double factor = matrix[j][i] / matrix[i][i];
      for (std::size_t k = i; k < n; ++k)
        matrix[j][k] -= factor * matrix[i][k];
      right[j] -= factor * right[i];
    }
  }
  for (std::size_t i = n; i-- > 0;)
    if (used[i])
    {
      double sum = right[i];
      for (std::size_t k = i + 1; k < n; ++k)
        sum -= matrix[i][k] * solution[k];
      solution[i] = sum / matrix[i][i];
    }
  return solution;
}

} // namespace

void SecantMixing::improve(const Values& at, const Values& change)
{
  if (lastPosition_.extent(0) > 0)
    secants_.push_front({difference(at, lastPosition_), difference(change, lastChange_)});
  if (secants_.size() > depth_)
    secants_.pop_back();
  lastPosition_ = copyOf(at);
  lastChange_ = copyOf(change);
  std::vector<std::vector<double>> products(secants_.size(), std::vector<double>(secants_.size()));
  std::vector<double> right(secants_.size());
  for (std::size_t i = 0; i < secants_.size(); ++i)
  {
    right[i] = dot_(secants_[i].change, change);
    for (std::size_t j = 0; j <= i; ++j)
      products[i][j] = products[j][i] = dot_(secants_[i].change, secants_[j].change);
  }
  const std::vector<double> part = solveSmall(std::move(products), std::move(right));
  for (std::size_t i = 0; i < secants_.size(); ++i)
    for (std::size_t k = 0; k < change.extent(0); ++k)
      change(k) -= part[i] * (secants_[i].position(k) + secants_[i].change(k));
}

} // namespace Rhegma::equilibrium
