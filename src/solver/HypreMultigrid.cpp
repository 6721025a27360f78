/// Multigrid by BoomerAMG of hypre.

#include "solver/Multigrid.hpp"

#ifdef RHEGMA_HAVE_HYPRE

#include "solver/WeakRows.hpp"

#include <HYPRE.h>
#include <HYPRE_IJ_mv.h>
#include <HYPRE_parcsr_ls.h>
#include <Teuchos_DefaultMpiComm.hpp>

#include <stdexcept>
#include <string>

namespace Rhegma
{

namespace
{

/// Couplings, in parts of a row's largest, that count as strong, and the number of levels that are coarsened
/// twice. With 0.5 and none, levels have 3.6 times the entries of the matrix, and a block of 34,000 unknowns
/// takes two to three times the time.
constexpr double strongCoupling = 0.25;
constexpr int aggressiveLevels = 1;

/// What hypre calls its choices.
constexpr int nodalByRowSums = 4, smootherSymmetric = 8, coarsestByElimination = 9, rotationsByColumns = 2;
constexpr int onCoarsest = 3;
/// Entries of a row of the interpolation of rotations.
constexpr int mostRotationEntries = 4;

MPI_Comm communicatorOf(const SparseMatrix& matrix)
{
  if (!matrix.ranks.many())
    return MPI_COMM_SELF;
  const auto comm = Teuchos::rcp_dynamic_cast<const Teuchos::MpiComm<int>>(matrix.ranks.comm(), true);
  return *comm->getRawMpiComm();
}

/// Throws, on all ranks, if hypre found something wrong on one. What it calls a wrong argument is none: it
/// says so of a node of which some unknowns are held, and its cycle serves all the same. Collective.
void check(const Ranks& ranks, const char* what)
{
  const int error = HYPRE_GetError();
  HYPRE_ClearAllErrors();
  if (ranks.max(HYPRE_CheckError(error, HYPRE_ERROR_GENERIC) != 0 ||
                        HYPRE_CheckError(error, HYPRE_ERROR_MEMORY) != 0
                    ? 1.0
                    : 0.0) > 0.0)
    throw std::runtime_error(std::string("hypre: ") + what);
}

/// A vector of this rank's rows.
class RowVector
{
public:
  RowVector(MPI_Comm comm, const std::vector<HYPRE_BigInt>& rows, HYPRE_BigInt first)
  {
    HYPRE_IJVectorCreate(comm, first, first + static_cast<HYPRE_BigInt>(rows.size()) - 1, &vector_);
    HYPRE_IJVectorSetObjectType(vector_, HYPRE_PARCSR);
    const std::vector<double> zeros(rows.size(), 0.0);
    set(rows, zeros.data());
  }
  ~RowVector() { HYPRE_IJVectorDestroy(vector_); }
  RowVector(const RowVector&) = delete;
  RowVector& operator=(const RowVector&) = delete;

  void set(const std::vector<HYPRE_BigInt>& rows, const double* values)
  {
    HYPRE_IJVectorInitialize(vector_);
    HYPRE_IJVectorSetValues(vector_, static_cast<HYPRE_Int>(rows.size()), rows.data(), values);
    HYPRE_IJVectorAssemble(vector_);
  }
  void get(const std::vector<HYPRE_BigInt>& rows, double* values) const
  {
    HYPRE_IJVectorGetValues(vector_, static_cast<HYPRE_Int>(rows.size()), rows.data(), values);
  }
  HYPRE_ParVector object() const
  {
    void* object = nullptr;
    HYPRE_IJVectorGetObject(vector_, &object);
    return static_cast<HYPRE_ParVector>(object);
  }

private:
  HYPRE_IJVector vector_ = nullptr;
};

} // namespace

struct Multigrid::Hierarchy
{
  HYPRE_BigInt first = 0;         ///< number of this rank's first row
  std::vector<HYPRE_BigInt> rows; ///< numbers of this rank's rows
  HYPRE_IJMatrix matrix = nullptr;
  HYPRE_Solver solver = nullptr;
  std::unique_ptr<RowVector> right, solution;
  std::vector<std::unique_ptr<RowVector>> rotations;
  std::vector<HYPRE_ParVector> rotationObjects;

  Hierarchy() = default;
  Hierarchy(const Hierarchy&) = delete;
  Hierarchy& operator=(const Hierarchy&) = delete;
  ~Hierarchy()
  {
    if (solver != nullptr)
      HYPRE_BoomerAMGDestroy(solver);
    if (matrix != nullptr)
      HYPRE_IJMatrixDestroy(matrix);
  }

  void fill(const SparseMatrix& from);
  void choose(int perNode, const Vectors& rigidMotions, MPI_Comm comm);
  HYPRE_ParCSRMatrix object() const
  {
    void* object = nullptr;
    HYPRE_IJMatrixGetObject(matrix, &object);
    return static_cast<HYPRE_ParCSRMatrix>(object);
  }
};

bool Multigrid::available() { return true; }
const char* Multigrid::name() { return "hypre"; }

void Multigrid::Hierarchy::fill(const SparseMatrix& from)
{
  const int n = from.rows();
  const std::vector<double> counts = from.ranks.gatherOnAll({static_cast<double>(n)});
  for (int rank = 0; rank < from.ranks.rank(); ++rank)
    first += static_cast<HYPRE_BigInt>(counts[rank]);
  for (int r = 0; r < n; ++r)
    rows.push_back(first + r);
  HYPRE_IJMatrixCreate(communicatorOf(from), first, first + n - 1, first, first + n - 1, &matrix);
  HYPRE_IJMatrixSetObjectType(matrix, HYPRE_PARCSR);
  std::vector<HYPRE_Int> entries(n);
  for (int r = 0; r < n; ++r)
    entries[r] = static_cast<HYPRE_Int>(from.first(r + 1) - from.first(r));
  HYPRE_IJMatrixSetRowSizes(matrix, entries.data());
  HYPRE_IJMatrixInitialize(matrix);
  const View<double*> value = withoutWeakRows(from);
  std::vector<HYPRE_BigInt> columns;
  for (int r = 0; r < n; ++r)
  {
    columns.clear();
    for (std::size_t k = from.first(r); k < from.first(r + 1); ++k)
      columns.push_back(static_cast<HYPRE_BigInt>(from.numberOf(from.column(k))));
    HYPRE_IJMatrixSetValues(matrix, 1, &entries[r], &rows[r], columns.data(), value.data() + from.first(r));
  }
  HYPRE_IJMatrixAssemble(matrix);
  check(from.ranks, "the matrix");
}

void Multigrid::Hierarchy::choose(int perNode, const Vectors& rigidMotions, MPI_Comm comm)
{
  HYPRE_BoomerAMGCreate(&solver);
  HYPRE_BoomerAMGSetPrintLevel(solver, 0);
  HYPRE_BoomerAMGSetMaxIter(solver, 1);
  HYPRE_BoomerAMGSetTol(solver, 0.0);
  HYPRE_BoomerAMGSetStrongThreshold(solver, strongCoupling);
  HYPRE_BoomerAMGSetAggNumLevels(solver, aggressiveLevels);
  HYPRE_BoomerAMGSetRelaxType(solver, smootherSymmetric);
  HYPRE_BoomerAMGSetCycleRelaxType(solver, coarsestByElimination, onCoarsest);
  HYPRE_BoomerAMGSetNumFunctions(solver, perNode);
  // Translations are interpolated exactly in any case.
  for (std::size_t m = perNode; m < rigidMotions.size(); ++m)
  {
    rotations.push_back(std::make_unique<RowVector>(comm, rows, first));
    rotations.back()->set(rows, rigidMotions[m].data());
    rotationObjects.push_back(rotations.back()->object());
  }
  if (rotations.empty())
    return;
  HYPRE_BoomerAMGSetNodal(solver, nodalByRowSums);
  HYPRE_BoomerAMGSetNodalDiag(solver, 1);
  HYPRE_BoomerAMGSetInterpVecVariant(solver, rotationsByColumns);
  HYPRE_BoomerAMGSetInterpVecQMax(solver, mostRotationEntries);
  HYPRE_BoomerAMGSetInterpVectors(solver, static_cast<HYPRE_Int>(rotationObjects.size()),
                                  rotationObjects.data());
}

Multigrid::Multigrid(const SparseMatrix& matrix, int perNode, const Vectors& rigidMotions, const Vectors&)
    : hierarchy_(std::make_unique<Hierarchy>())
{
  static const int once = HYPRE_Init();
  if (once != 0)
    throw std::runtime_error("hypre does not start");
  if (matrix.ranks.sum(matrix.rows()) == 0.0)
    return;
  hierarchy_->fill(matrix);
  const MPI_Comm comm = communicatorOf(matrix);
  hierarchy_->choose(perNode, rigidMotions, comm);
  hierarchy_->right = std::make_unique<RowVector>(comm, hierarchy_->rows, hierarchy_->first);
  hierarchy_->solution = std::make_unique<RowVector>(comm, hierarchy_->rows, hierarchy_->first);
  HYPRE_BoomerAMGSetup(hierarchy_->solver, hierarchy_->object(), hierarchy_->right->object(),
                       hierarchy_->solution->object());
  check(matrix.ranks, "the coarse levels");
}

Multigrid::~Multigrid() = default;

void Multigrid::apply(const BorrowedView<const double*>& x, const BorrowedView<double*>& y) const
{
  Hierarchy& of = *hierarchy_;
  if (of.solver == nullptr)
    return;
  of.right->set(of.rows, x.data());
  const std::vector<double> zeros(of.rows.size(), 0.0);
  of.solution->set(of.rows, zeros.data());
  HYPRE_BoomerAMGSolve(of.solver, of.object(), of.right->object(), of.solution->object());
  HYPRE_ClearAllErrors(); // one cycle does not reach a tolerance of 0
  of.solution->get(of.rows, y.data());
}

} // namespace Rhegma

#endif
