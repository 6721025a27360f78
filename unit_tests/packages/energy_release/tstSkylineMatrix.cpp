// Symmetric matrices that are stored by rows from their first entry on.

#include "energy_release/SkylineMatrix.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace Rhegma::energy_release
{

namespace
{

using Pair = SkylineMatrix::Pair;

/// A random matrix with dominant diagonal, and the same with all entries.
struct Example
{
  SkylineMatrix matrix;
  std::vector<std::vector<double>> full;

  Example(int size, std::mt19937& engine) : full(size, std::vector<double>(size, 0.0))
  {
    std::uniform_real_distribution<double> entry(-1.0, 1.0);
    std::vector<int> first(size);
    for (int i = 0; i < size; ++i)
      first[i] = std::uniform_int_distribution<int>(std::max(0, i - 9), i)(engine);
    matrix = SkylineMatrix(first);
    for (int i = 0; i < size; ++i)
      for (int j = first[i]; j <= i; ++j)
      {
        const double value = i == j ? 25.0 : entry(engine); // rows and columns have fewer than 20 others
        matrix(i, j) = full[i][j] = full[j][i] = value;
      }
  }

  std::vector<Pair> times(const std::vector<Pair>& x) const
  {
    std::vector<Pair> sum(x.size(), Pair{0.0, 0.0});
    for (std::size_t i = 0; i < x.size(); ++i)
      for (std::size_t j = 0; j < x.size(); ++j)
        for (int d = 0; d < 2; ++d)
          sum[i][d] += full[i][j] * x[j][d];
    return sum;
  }
};

} // namespace

/// A diagonally dominant matrix has a condition number below 25 + 20 over 25 - 20: nine digits of rounding.
TEST(SkylineMatrix, MultipliesAndSolvesAsAFullMatrix)
{
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  for (const int size : {1, 2, 7, 60})
  {
    Example example(size, engine);
    std::vector<Pair> x(size);
    for (Pair& pair : x)
      pair = {number(engine), number(engine)};
    const std::vector<Pair> image = example.times(x), own = example.matrix.times(x);
    std::vector<Pair> solution = image;
    ASSERT_TRUE(example.matrix.factor());
    example.matrix.solve(solution);
    for (int i = 0; i < size; ++i)
      for (int d = 0; d < 2; ++d)
      {
        EXPECT_NEAR(own[i][d], image[i][d], 1e-13);
        EXPECT_NEAR(solution[i][d], x[i][d], 1e-13);
      }
  }
}

TEST(SkylineMatrix, IsNotFactoredWhereItIsNotPositive)
{
  SkylineMatrix matrix({0, 0});
  matrix(0, 0) = matrix(1, 1) = 1.0;
  matrix(1, 0) = 2.0; // the square of a row is -2 in some direction
  EXPECT_FALSE(matrix.factor());
}

} // namespace Rhegma::energy_release
