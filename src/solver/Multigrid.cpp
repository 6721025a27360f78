#include "solver/Multigrid.hpp"

#include <stdexcept>

#ifdef RHEGMA_HAVE_MUELU
#include "solver/WeakRows.hpp"

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

/// The unknowns of `count` columns of a matrix, on all its ranks.
RCP<const Map> mapOf(const SparseMatrix& matrix, int count)
{
  if (!matrix.ranks.many())
    return rcp(new Map(count, 0, rcp(new Teuchos::MpiComm<int>(MPI_COMM_SELF))));
  std::vector<Map::global_ordinal_type> numbers;
  numbers.reserve(count);
  for (int k = 0; k < count; ++k)
    numbers.push_back(matrix.numberOf(k));
  return rcp(new Map(Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid(),
                     Teuchos::arrayViewFromVector(numbers), 0, matrix.ranks.comm()));
}

/// Consecutive numbers on consecutive ranks.
RCP<const Map> consecutive(const SparseMatrix& matrix, int count)
{
  return rcp(
      new Map(Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid(), count, 0, matrix.ranks.comm()));
}

RCP<MultiVector> columnsOf(const RCP<const Map>& map, const Multigrid::Vectors& vectors)
{
  const RCP<MultiVector> columns = rcp(new MultiVector(map, vectors.size()));
  for (std::size_t m = 0; m < vectors.size(); ++m)
    for (std::size_t k = 0; k < vectors[m].size(); ++k)
      columns->replaceLocalValue(static_cast<int>(k), m, vectors[m][k]);
  return columns;
}

/// Rows of a rank below which coarse levels move to fewer ranks. The coarsest is then on one rank: spread
/// over ranks, KLU2 of Trilinos 13.2 solves it wrongly (the cycle of a free body on two ranks took 30 times
/// the iterations).
constexpr int leastRowsOfRank = 2000;

void gatherCoarseLevels(Teuchos::ParameterList& list)
{
  list.set("repartition: enable", true);
  list.set("repartition: partitioner", "zoltan2");
  list.set("repartition: start level", 1);
  list.set("repartition: min rows per proc", leastRowsOfRank);
}

} // namespace

struct Multigrid::Hierarchy
{
  RCP<const Map> map;
  RCP<Cycle> cycle; ///< null where there are no rows

  void apply(const BorrowedView<const double*>& x, const BorrowedView<double*>& y) const;
};

bool Multigrid::available() { return true; }
const char* Multigrid::name() { return "MueLu"; }

Multigrid::Multigrid(const SparseMatrix& matrix, int perNode, const Vectors& rigidMotions,
                     const Vectors& coordinates)
    : hierarchy_(std::make_unique<Hierarchy>())
{
  const int n = matrix.rows();
  if (matrix.ranks.sum(n) == 0.0)
    return;
  hierarchy_->map = mapOf(matrix, n);
  const RCP<const Map> columns =
      matrix.ranks.many() ? mapOf(matrix, static_cast<int>(matrix.number.extent(0))) : hierarchy_->map;
  const RCP<Matrix> shared =
      rcp(new Matrix(hierarchy_->map, columns, matrix.first, matrix.column, withoutWeakRows(matrix)));
  shared->fillComplete();
  Teuchos::ParameterList list = settings(perNode);
  Teuchos::ParameterList& data = list.sublist("user data");
  data.set("Nullspace", columnsOf(hierarchy_->map, rigidMotions));
  if (matrix.ranks.many())
  {
    gatherCoarseLevels(list);
    data.set("Coordinates", columnsOf(consecutive(matrix, n / perNode), coordinates));
  }
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

#elif !defined(RHEGMA_HAVE_HYPRE)

struct Multigrid::Hierarchy
{
};

bool Multigrid::available() { return false; }
const char* Multigrid::name() { return "none"; }
Multigrid::Multigrid(const SparseMatrix&, int, const Vectors&, const Vectors&)
{
  throw std::logic_error("this build has no multigrid");
}
Multigrid::~Multigrid() = default;
void Multigrid::apply(const BorrowedView<const double*>&, const BorrowedView<double*>&) const {}

#endif

} // namespace Rhegma
