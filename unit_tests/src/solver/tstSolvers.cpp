#include "solver/DirectSolver.hpp"
#include "solver/KrylovSolver.hpp"
#include "solver/Multigrid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <vector>

namespace
{

using namespace Rhegma;

/// A matrix from dense rows.
SparseMatrix sparse(const std::vector<std::vector<double>>& rows)
{
  const int n = static_cast<int>(rows.size());
  std::vector<int> column;
  std::vector<double> value;
  SparseMatrix matrix;
  matrix.first = View<std::size_t*>("first", n + 1);
  for (int r = 0; r < n; ++r)
  {
    for (int c = 0; c < n; ++c)
      if (rows[r][c] != 0.0 || r == c)
      {
        column.push_back(c);
        value.push_back(rows[r][c]);
      }
    matrix.first(r + 1) = column.size();
  }
  matrix.column = View<int*>("column", column.size());
  matrix.value = View<double*>("value", value.size());
  std::copy(column.begin(), column.end(), matrix.column.data());
  std::copy(value.begin(), value.end(), matrix.value.data());
  return matrix;
}

/// Springs of stiffness one between the points of a row of n, which the ground holds at one end.
SparseMatrix chain(int n)
{
  SparseMatrix matrix;
  matrix.first = View<std::size_t*>("first", n + 1);
  matrix.column = View<int*>("column", 3 * n - 2);
  matrix.value = View<double*>("value", 3 * n - 2);
  std::size_t at = 0;
  for (int r = 0; r < n; ++r)
  {
    for (int c = std::max(r - 1, 0); c <= std::min(r + 1, n - 1); ++c, ++at)
    {
      matrix.column(at) = c;
      matrix.value(at) = c != r ? -1.0 : r + 1 < n ? 2.0 : 1.0;
    }
    matrix.first(r + 1) = at;
  }
  return matrix;
}

View<double*> product(const SparseMatrix& matrix, const std::vector<double>& x)
{
  View<double*> in("in", x.size()), out("out", x.size());
  std::copy(x.begin(), x.end(), in.data());
  matrix.multiply(BorrowedView<const double*>(in.data(), in.extent(0)),
                  BorrowedView<double*>(out.data(), out.extent(0)));
  return out;
}

std::vector<double> numbers(int n)
{
  std::mt19937 engine(static_cast<unsigned>(n));
  std::uniform_real_distribution<double> draw(-1.0, 1.0);
  std::vector<double> list(n);
  for (double& x : list)
    x = draw(engine);
  return list;
}

/// Column and value of the entries of each row; those of one column are added.
using Entries = std::vector<std::vector<std::pair<int, double>>>;

SparseMatrix fromEntries(Entries rows)
{
  std::vector<std::size_t> first(1, 0);
  std::vector<int> column;
  std::vector<double> value;
  for (auto& row : rows)
  {
    std::sort(row.begin(), row.end());
    for (const auto& [c, v] : row)
      if (column.size() > first.back() && column.back() == c)
        value.back() += v;
      else
      {
        column.push_back(c);
        value.push_back(v);
      }
    first.push_back(column.size());
  }
  const SparseMatrix matrix{View<std::size_t*>("first", first.size()), View<int*>("column", column.size()),
                            View<double*>("value", value.size())};
  std::copy(first.begin(), first.end(), matrix.first.data());
  std::copy(column.begin(), column.end(), matrix.column.data());
  std::copy(value.begin(), value.end(), matrix.value.data());
  return matrix;
}

/// Joins two points with a spring.
void join(Entries& rows, int a, int b, double stiffness)
{
  rows[a].push_back({b, -stiffness});
  rows[b].push_back({a, -stiffness});
  rows[a].push_back({a, stiffness});
  rows[b].push_back({b, stiffness});
}

/// Solves for random numbers. \return how
SolveResult solveWith(const Multigrid& multigrid, const SparseMatrix& matrix)
{
  const int n = matrix.rows();
  KrylovSolver gradients(1e-8, 100);
  gradients.resize(n);
  const View<double*> y = product(matrix, numbers(n));
  for (int k = 0; k < n; ++k)
    gradients.right()(k) = y(k);
  return gradients.solve([&](const BorrowedView<const double*>& from, const BorrowedView<double*>& to)
                         { matrix.multiply(from, to); },
                         [&](const BorrowedView<const double*>& from, const BorrowedView<double*>& to)
                         { multigrid.apply(from, to); });
}

} // namespace

TEST(SparseMatrix, MultipliesRowByRow)
{
  const View<double*> y = product(sparse({{2.0, 1.0, 0.0}, {1.0, 3.0, -1.0}, {0.0, -1.0, 4.0}}), {1, 2, 3});
  EXPECT_DOUBLE_EQ(y(0), 4.0);
  EXPECT_DOUBLE_EQ(y(1), 4.0);
  EXPECT_DOUBLE_EQ(y(2), 10.0);
}

/// A matrix with eigenvalues of both signs.
TEST(DirectSolver, SolvesAndCountsNegativeEigenvalues)
{
  if (!DirectSolver::available())
    GTEST_SKIP() << "the library was built without MUMPS";
  const SparseMatrix matrix =
      sparse({{2.0, 1.0, 0.0, 0.5}, {1.0, -3.0, 0.2, 0.0}, {0.0, 0.2, 1.0, 0.1}, {0.5, 0.0, 0.1, -1.5}});
  DirectSolver solver;
  EXPECT_GT(solver.analyse(matrix), 0.0);
  ASSERT_TRUE(solver.factorise(matrix));
  EXPECT_EQ(solver.negativeEigenvalues(), 2); // by the circles of Gershgorin
  const std::vector<double> x = numbers(4);
  const View<double*> y = product(matrix, x);
  solver.solve(y);
  for (int k = 0; k < 4; ++k)
    EXPECT_NEAR(y(k), x[k], 1e-14);
}

TEST(DirectSolver, TakesNewValuesInTheSameOrder)
{
  if (!DirectSolver::available())
    GTEST_SKIP() << "the library was built without MUMPS";
  const SparseMatrix matrix = chain(500);
  DirectSolver solver;
  solver.analyse(matrix);
  for (const double scale : {1.0, 1e6})
  {
    for (std::size_t k = 0; k < matrix.value.extent(0); ++k)
      matrix.value(k) *= scale;
    ASSERT_TRUE(solver.factorise(matrix));
    EXPECT_EQ(solver.negativeEigenvalues(), 0);
    const std::vector<double> x = numbers(500);
    const View<double*> y = product(matrix, x);
    solver.solve(y);
    for (int k = 0; k < 500; ++k)
      ASSERT_NEAR(y(k), x[k], 500.0 * 500.0 * 1e-15); // the condition of a chain is the square of its length
  }
}

TEST(DirectSolver, SingularMatricesAreRefused)
{
  if (!DirectSolver::available())
    GTEST_SKIP() << "the library was built without MUMPS";
  const SparseMatrix matrix = sparse({{1.0, -1.0, 0.0}, {-1.0, 1.0, 0.0}, {0.0, 0.0, 0.0}});
  DirectSolver solver;
  solver.analyse(matrix);
  EXPECT_FALSE(solver.factorise(matrix));
}

/// The number of iterations with multigrid does not grow with the chain; with the diagonal it is its length.
TEST(Multigrid, IterationsDoNotGrowWithTheMatrix)
{
  if (!Multigrid::available())
    GTEST_SKIP() << "the library was built without multigrid";
  for (const int n : {5000, 50000})
  {
    const SparseMatrix matrix = chain(n);
    const Multigrid multigrid(matrix, 1, {std::vector<double>(n, 1.0)});
    const SolveResult result = solveWith(multigrid, matrix);
    EXPECT_TRUE(result.converged);
    EXPECT_LE(result.iterations, 30) << n;
  }
}

/// A cube of springs between points, which the ground holds at one face, with points that hang on it by
/// springs of 1e-13 of the others' stiffness: those are left to the smoother.
TEST(Multigrid, PointsThatHardlyHangAreNoHindrance)
{
  if (!Multigrid::available())
    GTEST_SKIP() << "the library was built without multigrid";
  const int edge = 18, cube = edge * edge * edge, n = cube + cube / 7;
  Entries rows(n);
  for (int k = 0; k < cube; ++k)
    for (const int step : {1, edge, edge * edge})
      if (k / step % edge + 1 < edge)
        join(rows, k, k + step, 1.0);
      else if (step == 1)
        rows[k].push_back({k, 1.0});
  for (int k = cube; k < n; ++k)
    join(rows, k, 7 * (k - cube), 1e-13);
  const SparseMatrix matrix = fromEntries(rows);
  const Multigrid multigrid(matrix, 1, {std::vector<double>(n, 1.0)});
  const SolveResult result = solveWith(multigrid, matrix);
  EXPECT_TRUE(result.converged);
  EXPECT_LE(result.iterations, 30);
}

/// A block of points in space with springs along the edges and diagonals of its cells, six unknowns of which
/// are held as supports hold a body against its rigid motions: one point, two unknowns of another and one of
/// a third.
struct FreeBlock
{
  static constexpr int edge = 10, points = edge * edge * edge, n = 3 * points;
  SparseMatrix matrix;
  Multigrid::Vectors motions = Multigrid::Vectors(6, std::vector<double>(n, 0.0));

  FreeBlock()
  {
    Entries rows(n);
    for (int k = 0; k < points; ++k)
      for (int direction = 14; direction < 27; ++direction) // of 27, one of each pair
        joinAlong(rows, k, {direction % 3 - 1, direction / 3 % 3 - 1, direction / 9 - 1});
    for (const int held : {0, 1, 2, 3 * (edge - 1) + 1, 3 * (edge - 1) + 2, 3 * (edge * edge - 1) + 2})
      hold(rows, held);
    matrix = fromEntries(rows);
    for (int k = 0; k < points; ++k)
      for (int d = 0; d < 3; ++d)
      {
        const int next = (d + 1) % 3, other = (d + 2) % 3;
        motions[d][3 * k + d] = 1.0;
        motions[3 + d][3 * k + next] = -at(k)[other];
        motions[3 + d][3 * k + other] = at(k)[next];
      }
  }

  static std::array<int, 3> at(int k) { return {k % edge, k / edge % edge, k / edge / edge}; }

  static void joinAlong(Entries& rows, int a, const std::array<int, 3>& along)
  {
    int b = 0;
    for (int d = 2; d >= 0; --d)
    {
      const int to = at(a)[d] + along[d];
      if (to < 0 || to >= edge)
        return;
      b = edge * b + to;
    }
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (const double stiffness = along[i] * along[j]; stiffness != 0.0)
        {
          rows[3 * a + i].push_back({3 * b + j, -stiffness});
          rows[3 * b + i].push_back({3 * a + j, -stiffness});
          rows[3 * a + i].push_back({3 * a + j, stiffness});
          rows[3 * b + i].push_back({3 * b + j, stiffness});
        }
  }

  static void hold(Entries& rows, int unknown)
  {
    for (int r = 0; r < n; ++r)
      for (auto& [column, value] : rows[r])
        value = (r == unknown) != (column == unknown) ? 0.0 : value;
  }
};

/// With the diagonal the iterations go with the number of points along an edge, times the root of the ratio
/// of the body's stiffness to that of the points that hold it.
TEST(Multigrid, TakesRigidMotionsOfABodyThatIsHeldAtSixUnknowns)
{
  if (!Multigrid::available())
    GTEST_SKIP() << "the library was built without multigrid";
  const FreeBlock block;
  KrylovSolver gradients(1e-8, 10000);
  gradients.resize(block.n);
  const View<double*> right = product(block.matrix, numbers(block.n));
  const auto solve = [&](const KrylovSolver::Apply& precondition)
  {
    for (int k = 0; k < block.n; ++k)
      gradients.right()(k) = right(k);
    return gradients.solve([&](const BorrowedView<const double*>& from, const BorrowedView<double*>& to)
                           { block.matrix.multiply(from, to); },
                           precondition);
  };
  const Multigrid multigrid(block.matrix, 3, block.motions);
  const SolveResult with = solve([&](const BorrowedView<const double*>& from, const BorrowedView<double*>& to)
                                 { multigrid.apply(from, to); });
  const SolveResult without = solve(
      [&](const BorrowedView<const double*>& from, const BorrowedView<double*>& to)
      {
        for (int r = 0; r < block.n; ++r)
          for (std::size_t k = block.matrix.first(r); k < block.matrix.first(r + 1); ++k)
            if (block.matrix.column(k) == r)
              to(r) = from(r) / block.matrix.value(k);
      });
  EXPECT_TRUE(with.converged);
  EXPECT_TRUE(without.converged);
  EXPECT_LT(3 * with.iterations, without.iterations);
}

/// A square of springs that the ground holds at one edge. Three of its points, anywhere, are kept by another
/// spring from moving together: the largest eigenvalue, of the matrix over its diagonal, is that of their
/// motion, 2.9 for 2 of all others, and in a large matrix a small part of any start of the power method. The
/// preconditioner is positive there only if the smoother knows it.
TEST(Multigrid, FewStiffPointsInALargeMatrixAreFound)
{
  if (!Multigrid::available())
    GTEST_SKIP() << "the library was built without multigrid";
  const int edge = 500, n = edge * edge;
  Entries rows(n);
  for (int k = 0; k < n; ++k)
    for (const int step : {1, edge})
      if (k / step % edge + 1 < edge)
        join(rows, k, k + step, 1.0);
      else if (step == 1)
        rows[k].push_back({k, 1.0});
  std::random_device seeds;
  const unsigned seed = seeds();
  std::mt19937 engine(seed);
  const int first = std::uniform_int_distribution<int>(0, n - edge - 2)(engine);
  const int stiff[] = {first, first + 1, first + edge};
  for (const int a : stiff)
    for (const int b : stiff)
      rows[a].push_back({b, 100.0});
  const SparseMatrix matrix = fromEntries(rows);
  const Multigrid multigrid(matrix, 1, {std::vector<double>(n, 1.0)});
  std::vector<double> together(n, 0.0);
  for (const int a : stiff)
    together[a] = 1.0;
  const View<double*> force = product(matrix, together), answer("answer", n);
  multigrid.apply(BorrowedView<const double*>(force.data(), n), BorrowedView<double*>(answer.data(), n));
  double work = 0.0;
  for (int k = 0; k < n; ++k)
    work += force(k) * answer(k);
  EXPECT_GT(work, 0.0) << "seed " << seed;
  const SolveResult result = solveWith(multigrid, matrix);
  EXPECT_TRUE(result.converged) << "seed " << seed;
  EXPECT_LE(result.iterations, 30) << "seed " << seed;
}
