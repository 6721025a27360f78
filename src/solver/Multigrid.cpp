#include "solver/Multigrid.hpp"

#include <algorithm>
#include <stdexcept>

#ifdef RHEGMA_HAVE_MUELU
#include <MueLu_CreateTpetraPreconditioner.hpp>
#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_CrsMatrix.hpp>
#endif

namespace Rhegma
{

#ifdef RHEGMA_HAVE_MUELU

namespace
{

using Teuchos::RCP;
using Teuchos::rcp;
using Map = Tpetra::Map<>;
using MultiVector = Tpetra::MultiVector<double>;
using Operator = Tpetra::Operator<double>;
using Matrix = Tpetra::CrsMatrix<double>;
using Cycle =
    MueLu::TpetraOperator<double, Matrix::local_ordinal_type, Matrix::global_ordinal_type, Matrix::node_type>;

/// Steps of the power method for the largest eigenvalue that the smoother treats, on each level. The vectors
/// of a few nodes of cut cells have eigenvalues a quarter larger than all others, and are 1 / sqrt(unknowns)
/// of the start: ten steps miss them in large systems (2.3 for 3.26 with 300,000 unknowns), and a smoother
/// for too small an eigenvalue is indefinite.
constexpr int powerSteps = 40;

/// Couplings, over the root of the product of the diagonals, below which nodes do not aggregate. Larger
/// values leave nodes of cells that an edge cuts alone: 0.02 takes 1.5 times the iterations in a block that
/// is turned relative to the cells.
constexpr double leastCoupling = 0.003;

/// Chebyshev's polynomials of degree three smooth independently of the order of unknowns.
Teuchos::ParameterList settings(int perNode)
{
  Teuchos::ParameterList list;
  list.set("verbosity", "none");
  list.set("number of equations", perNode);
  list.set("multigrid algorithm", "sa");
  list.set("aggregation: drop tol", leastCoupling);
  list.set("smoother: type", "CHEBYSHEV");
  list.sublist("smoother: params").set("chebyshev: degree", 3);
  list.sublist("smoother: params").set("chebyshev: ratio eigenvalue", 20.0);
  list.sublist("smoother: params").set("chebyshev: eigenvalue max iterations", powerSteps);
  list.set("coarse: max size", 1000);
  // A node in 3D that couples strongly with none has fewer unknowns than there are rigid motions: some of its
  // coarse unknowns are empty.
  list.set("rap: fix zero diagonals", true);
  return list;
}

/// The couplings among the rows of this rank; the matrix itself with one rank.
SparseMatrix amongOwnRows(const SparseMatrix& matrix)
{
  if (!matrix.ranks.many())
    return matrix;
  const int n = matrix.rows();
  SparseMatrix own;
  own.first = View<std::size_t*>("rhegma::Multigrid::first", n + 1);
  for (int r = 0; r < n; ++r)
  {
    own.first(r + 1) = own.first(r);
    for (std::size_t k = matrix.first(r); k < matrix.first(r + 1); ++k)
      own.first(r + 1) += matrix.column(k) < n ? 1 : 0;
  }
  own.column = View<int*>("rhegma::Multigrid::column", own.first(n));
  own.value = View<double*>("rhegma::Multigrid::ownValue", own.first(n));
  std::size_t at = 0;
  for (std::size_t k = 0; k < matrix.column.extent(0); ++k)
    if (matrix.column(k) < n)
    {
      own.column(at) = matrix.column(k);
      own.value(at++) = matrix.value(k);
    }
  return own;
}

/// Fraction of the largest diagonal entry below which a row is weak. Rows between it and one belong to cells
/// that an edge cuts, and need the coarse levels: with 1e-4, blocks anywhere in their cells take two to three
/// times the iterations.
constexpr double weakDiagonal = 1e-11;

/// The values of a matrix with weak rows reduced to their diagonals; its own values where no row is weak. A
/// node that hangs on a corner of a particle has 1e-13 of the stiffness of others: coarse levels of such rows
/// are singular to rounding, and the smoother treats them as well.
View<double*> withoutWeakRows(const SparseMatrix& matrix)
{
  const int n = matrix.rows();
  std::vector<double> diagonal(n, 0.0);
  double largest = 0.0;
  for (int r = 0; r < n; ++r)
    for (std::size_t k = matrix.first(r); k < matrix.first(r + 1); ++k)
      if (matrix.column(k) == r)
        largest = std::max(largest, diagonal[r] = matrix.value(k));
  const auto weak = [&](int r) { return diagonal[r] < weakDiagonal * largest; };
  bool any = false;
  for (int r = 0; r < n; ++r)
    any = any || weak(r);
  if (!any)
    return matrix.value;
  View<double*> value("rhegma::Multigrid::value", matrix.value.extent(0));
  for (int r = 0; r < n; ++r)
    for (std::size_t k = matrix.first(r); k < matrix.first(r + 1); ++k)
      value(k) = matrix.column(k) != r && (weak(r) || weak(matrix.column(k))) ? 0.0 : matrix.value(k);
  return value;
}

} // namespace

struct Multigrid::Hierarchy
{
  RCP<const Map> map;
  RCP<Cycle> cycle; ///< null where there are no rows

  void apply(const BorrowedView<const double*>& x, const BorrowedView<double*>& y) const;
};

bool Multigrid::available() { return true; }

Multigrid::Multigrid(const SparseMatrix& ofRanks, int perNode,
                     const std::vector<std::vector<double>>& rigidMotions)
    : hierarchy_(std::make_unique<Hierarchy>())
{
  const SparseMatrix matrix = amongOwnRows(ofRanks);
  const auto n = static_cast<std::size_t>(matrix.rows());
  if (n == 0)
    return;
  hierarchy_->map = rcp(new Map(n, 0, rcp(new Teuchos::MpiComm<int>(MPI_COMM_SELF))));
  const RCP<Matrix> shared =
      rcp(new Matrix(hierarchy_->map, hierarchy_->map, matrix.first, matrix.column, withoutWeakRows(matrix)));
  shared->fillComplete();
  const RCP<MultiVector> modes = rcp(new MultiVector(hierarchy_->map, rigidMotions.size()));
  for (std::size_t m = 0; m < rigidMotions.size(); ++m)
    for (std::size_t k = 0; k < n; ++k)
      modes->replaceLocalValue(static_cast<int>(k), m, rigidMotions[m][k]);
  Teuchos::ParameterList list = settings(perNode);
  list.sublist("user data").set("Nullspace", modes);
  hierarchy_->cycle = MueLu::CreateTpetraPreconditioner(RCP<Operator>(shared), list);
}

Multigrid::~Multigrid() = default;

void Multigrid::apply(const BorrowedView<const double*>& x, const BorrowedView<double*>& y) const
{
  if (!hierarchy_->cycle.is_null())
    hierarchy_->apply(x, y);
}

void Multigrid::Hierarchy::apply(const BorrowedView<const double*>& x, const BorrowedView<double*>& y) const
{
  MultiVector in(map, 1), out(map, 1);
  Kokkos::deep_copy(Kokkos::subview(in.getLocalViewDevice(Tpetra::Access::OverwriteAll), Kokkos::ALL(), 0),
                    x);
  cycle->apply(in, out);
  Kokkos::deep_copy(y, Kokkos::subview(out.getLocalViewDevice(Tpetra::Access::ReadOnly), Kokkos::ALL(), 0));
}

#else

struct Multigrid::Hierarchy
{
};

bool Multigrid::available() { return false; }
Multigrid::Multigrid(const SparseMatrix&, int, const std::vector<std::vector<double>>&)
{
  throw std::logic_error("this build has no multigrid");
}
Multigrid::~Multigrid() = default;
void Multigrid::apply(const BorrowedView<const double*>&, const BorrowedView<double*>&) const {}

#endif

} // namespace Rhegma
