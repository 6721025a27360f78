#include "energy_release/SkylineMatrix.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace Rhegma::energy_release
{

namespace
{

/// The product of two rows, in four sums, which a processor adds at a time.
double product(const double* a, const double* b, int count)
{
  double sums[4] = {};
  int k = 0;
  for (; k + 4 <= count; k += 4)
    for (int i = 0; i < 4; ++i)
      sums[i] += a[k + i] * b[k + i];
  for (; k < count; ++k)
    sums[0] += a[k] * b[k];
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

} // namespace

SkylineMatrix::SkylineMatrix(std::vector<int> first) : first_(std::move(first))
{
  std::size_t at = 0;
  for (int i = 0; i < size(); ++i)
  {
    start_.push_back(at);
    at += i - first_[i] + 1;
  }
  value_.assign(at, 0.0);
}

void SkylineMatrix::scale(double factor)
{
  for (double& entry : value_)
    entry *= factor;
}

std::vector<SkylineMatrix::Pair> SkylineMatrix::times(const std::vector<Pair>& x) const
{
  std::vector<Pair> sum(x.size(), Pair{0.0, 0.0});
  for (int i = 0; i < size(); ++i)
    for (int j = first_[i]; j <= i; ++j)
    {
      const double entry = rowOf(i)[j - first_[i]];
      for (int d = 0; d < 2; ++d)
      {
        sum[i][d] += entry * x[j][d];
        if (j < i)
          sum[j][d] += entry * x[i][d];
      }
    }
  return sum;
}

bool SkylineMatrix::factor()
{
  for (int i = 0; i < size(); ++i)
    for (int j = first_[i]; j <= i; ++j)
    {
      const int from = std::max(first_[i], first_[j]);
      double& entry = (*this)(i, j);
      entry -= product(rowOf(i) + from - first_[i], rowOf(j) + from - first_[j], j - from);
      if (j < i)
        entry /= (*this)(j, j);
      else if (!(entry > 0.0))
        return false;
      else
        entry = std::sqrt(entry);
    }
  return true;
}

void SkylineMatrix::solve(std::vector<Pair>& x) const
{
  for (int d = 0; d < 2; ++d)
  {
    for (int i = 0; i < size(); ++i)
    {
      const double* const row = rowOf(i);
      for (int j = first_[i]; j < i; ++j)
        x[i][d] -= row[j - first_[i]] * x[j][d];
      x[i][d] /= row[i - first_[i]];
    }
    for (int i = size() - 1; i >= 0; --i)
    {
      const double* const row = rowOf(i);
      x[i][d] /= row[i - first_[i]];
      for (int j = first_[i]; j < i; ++j)
        x[j][d] -= row[j - first_[i]] * x[i][d];
    }
  }
}

} // namespace Rhegma::energy_release
