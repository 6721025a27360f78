/// GMRES for matrices that are not symmetric, on the vectors of conjugate gradients.

#include "solver/KrylovSolver.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace
{

using namespace Rhegma;

/// Points of a row, each coupled with its neighbours by -1 - drift and -1 + drift.
struct Row
{
  double diagonal, drift;

  void multiply(const BorrowedView<const double*>& x, const BorrowedView<double*>& y) const
  {
    const int n = static_cast<int>(x.extent(0));
    for (int r = 0; r < n; ++r)
      y(r) = diagonal * x(r) - (r > 0 ? (1.0 + drift) * x(r - 1) : 0.0) -
             (r + 1 < n ? (1.0 - drift) * x(r + 1) : 0.0);
  }
};

constexpr double tolerance = 1e-9;

/// Solves for the right side of a known solution. \return the largest error
double solveFor(const Row& row, int n, bool symmetric, KrylovSolver& krylov, SolveResult& result)
{
  std::mt19937 engine(static_cast<unsigned>(n));
  std::uniform_real_distribution<double> draw(-1.0, 1.0);
  const View<double*> known("known", n);
  for (int k = 0; k < n; ++k)
    known(k) = draw(engine);
  krylov.resize(n);
  row.multiply(BorrowedView<const double*>(known.data(), n), krylov.right());
  const auto apply = [&](const auto& x, const auto& y) { row.multiply(x, y); };
  const auto precondition = [&](const BorrowedView<const double*>& x, const BorrowedView<double*>& y)
  {
    for (std::size_t k = 0; k < x.extent(0); ++k)
      y(k) = x(k) / row.diagonal;
  };
  result = symmetric ? krylov.solve(apply, precondition) : krylov.solveUnsymmetric(apply, precondition);
  const auto x = krylov.solution();
  double error = 0.0;
  for (int k = 0; k < n; ++k)
    error = std::max(error, std::fabs(x(k) - known(k)));
  return error;
}

/// Norm of the inverse of a row times the 2-norm of the residual bounds the error: diagonal - 2 is the least
/// excess of the diagonal over the sum of the others, where |drift| < 1.
double errorOf(const Row& row, int n) { return std::sqrt(n) * tolerance / (row.diagonal - 2.0); }

TEST(Gmres, SolvesAnUnsymmetricMatrix)
{
  KrylovSolver krylov(tolerance, 1000);
  const Row row{2.5, 0.6};
  SolveResult result;
  EXPECT_LE(solveFor(row, 200, false, krylov, result), errorOf(row, 200));
  EXPECT_TRUE(result.converged);
  EXPECT_LE(result.residual, tolerance);
  EXPECT_LE(result.iterations, mostBasisVectors);
}

TEST(Gmres, RestartsWhereTheBasisIsFull)
{
  KrylovSolver krylov(tolerance, 5000);
  const Row row{2.002, 0.01};
  SolveResult result;
  EXPECT_LE(solveFor(row, 600, false, krylov, result), errorOf(row, 600));
  EXPECT_TRUE(result.converged);
  EXPECT_GT(result.iterations, mostBasisVectors);
}

TEST(Gmres, SharesItsVectorsWithConjugateGradients)
{
  KrylovSolver krylov(tolerance, 1000);
  const Row symmetric{2.2, 0.0}, drifting{2.2, 0.3};
  SolveResult result;
  for (int round = 0; round < 2; ++round)
  {
    EXPECT_LE(solveFor(symmetric, 150, true, krylov, result), errorOf(symmetric, 150));
    EXPECT_TRUE(result.converged);
    EXPECT_LE(solveFor(drifting, 150, false, krylov, result), errorOf(drifting, 150));
    EXPECT_TRUE(result.converged);
  }
}

TEST(Gmres, EndsAfterItsIterations)
{
  KrylovSolver krylov(tolerance, 7);
  SolveResult result;
  solveFor({2.01, 0.2}, 300, false, krylov, result);
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.iterations, 7);
  EXPECT_GT(result.residual, tolerance);
}

} // namespace
