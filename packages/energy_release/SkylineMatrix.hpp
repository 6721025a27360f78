#pragma once
/// Symmetric positive definite matrices whose entries lie near the diagonal.

#include <array>
#include <cstddef>
#include <vector>

namespace Rhegma::energy_release
{

/// A symmetric matrix of which each row is stored from its first entry up to the diagonal. Its factor has the
/// same shape, so that a matrix of n rows with entries within b of the diagonal takes n b^2 operations
/// instead of n^3 / 3 (Jennings, Comput. J. 9 (1966) 281).
class SkylineMatrix
{
public:
  /// Two columns.
  using Pair = std::array<double, 2>;

  SkylineMatrix() = default;
  /// A matrix of zeros. \param first column of the first entry of each row, at most the row itself
  explicit SkylineMatrix(std::vector<int> first);

  int size() const { return static_cast<int>(first_.size()); }

  /// An entry, column at most row, and not left of the row's first.
  double& operator()(int row, int column) { return value_[start_[row] + column - first_[row]]; }

  /// Multiplies all entries by a number.
  void scale(double factor);

  /// The matrix times two columns.
  std::vector<Pair> times(const std::vector<Pair>& x) const;

  /// Replaces the matrix by its Cholesky factor. \return whether it is positive definite
  bool factor();

  /// Solves with the factor, in place.
  void solve(std::vector<Pair>& x) const;

private:
  const double* rowOf(int row) const { return &value_[start_[row]]; }

  std::vector<int> first_;
  std::vector<std::size_t> start_; ///< of each row in value_
  std::vector<double> value_;
};

} // namespace Rhegma::energy_release
