#include "solver/DirectSolver.hpp"

#include <limits>

#ifdef RHEGMA_HAVE_MUMPS
#include <Teuchos_DefaultMpiComm.hpp>
#include <dmumps_c.h>
#include <mpi.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>
#endif

namespace Rhegma
{

#ifdef RHEGMA_HAVE_MUMPS

namespace
{

enum Job
{
  Start = -1,
  End = -2,
  Analyse = 1,
  Factorise = 2,
  Solve = 3
};

MPI_Comm commOf(const Ranks& ranks)
{
  if (!ranks.many())
    return MPI_COMM_SELF;
  return *dynamic_cast<const Teuchos::MpiComm<int>&>(*ranks.comm()).getRawMpiComm();
}

/// Arrays of MUMPS in the numbers of its manual, which start at one.
template <class Array>
auto& numbered(Array& array, int number)
{
  return array[number - 1];
}

} // namespace

struct DirectSolver::Instance
{
  DMUMPS_STRUC_C data{};
  std::vector<MUMPS_INT> row, column;
  std::vector<std::size_t> entry; ///< of the matrix
  std::vector<double> value;
  Ranks ranks;
  int rows = 0;    ///< of this rank
  int failure = 0; ///< code of the last factorisation that failed

  Instance(bool symmetric, const Ranks& of) : ranks(of)
  {
    data.par = 1;
    data.sym = symmetric ? 2 : 0; // symmetric ones are not taken to be definite
    data.comm_fortran = static_cast<MUMPS_INT>(MPI_Comm_c2f(commOf(of)));
    call(Start);
    for (const int stream : {1, 2, 3})
      numbered(data.icntl, stream) = -1; // prints nothing
    numbered(data.icntl, 4) = 0;
    numbered(data.icntl, 18) = of.many() ? 3 : 0; // each rank gives its own entries
  }
  ~Instance() { call(End); }
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  bool call(Job job)
  {
    data.job = job;
    dmumps_c(&data);
    return numbered(data.infog, 1) >= 0;
  }
};

bool DirectSolver::available() { return true; }

DirectSolver::DirectSolver(bool symmetric) : symmetric_(symmetric) {}
DirectSolver::~DirectSolver() = default;

double DirectSolver::analyse(const SparseMatrix& matrix)
{
  instance_ = std::make_unique<Instance>(symmetric_, matrix.ranks);
  Instance& mumps = *instance_;
  const auto first = onHost(matrix.first);
  const auto column = onHost(matrix.column);
  for (int r = 0; r < matrix.rows(); ++r)
    for (std::size_t k = first(r); k < first(r + 1); ++k)
    {
      const long long row = matrix.numberOf(r), to = matrix.numberOf(column(k));
      if (symmetric_ && to > row)
        continue;
      mumps.row.push_back(static_cast<MUMPS_INT>(row + 1));
      mumps.column.push_back(static_cast<MUMPS_INT>(to + 1));
      mumps.entry.push_back(k);
    }
  mumps.value.resize(mumps.entry.size());
  mumps.rows = matrix.rows();
  mumps.data.n = static_cast<MUMPS_INT>(matrix.ranks.sum(matrix.rows()));
  if (matrix.ranks.many())
  {
    mumps.data.nnz_loc = static_cast<MUMPS_INT8>(mumps.entry.size());
    mumps.data.irn_loc = mumps.row.data();
    mumps.data.jcn_loc = mumps.column.data();
  }
  else
  {
    mumps.data.nnz = static_cast<MUMPS_INT8>(mumps.entry.size());
    mumps.data.irn = mumps.row.data();
    mumps.data.jcn = mumps.column.data();
  }
  if (!mumps.call(Analyse))
    return std::numeric_limits<double>::infinity();
  return numbered(mumps.data.rinfog, 1);
}

bool DirectSolver::factorise(const SparseMatrix& matrix)
{
  if (!instance_)
    throw std::logic_error("a matrix is factorised that was not analysed");
  Instance& mumps = *instance_;
  const auto value = onHost(matrix.value);
  for (std::size_t k = 0; k < mumps.entry.size(); ++k)
    mumps.value[k] = value(mumps.entry[k]);
  (mumps.ranks.many() ? mumps.data.a_loc : mumps.data.a) = mumps.value.data();
  // Pivots that are put off need more memory than was expected: -8, -9 and their like say so.
  constexpr int mostRelaxation = 1000; // per cent
  constexpr int shortOfMemory[] = {-8, -9, -14, -15, -17, -20};
  for (int& relaxation = numbered(mumps.data.icntl, 14);; relaxation *= 3)
  {
    if (mumps.call(Factorise))
      return true;
    mumps.failure = numbered(mumps.data.infog, 1);
    bool more = false;
    for (const int error : shortOfMemory)
      more = more || numbered(mumps.data.infog, 1) == error;
    if (!more || relaxation > mostRelaxation)
      return false;
  }
}

std::string DirectSolver::failure() const
{
  constexpr int ofMemory[] = {-8, -9, -11, -13, -14, -15, -17, -19, -20};
  const int code = instance_ ? instance_->failure : 0;
  if (std::find(std::begin(ofMemory), std::end(ofMemory), code) == std::end(ofMemory))
    return {};
  return "memory does not suffice to factorise its matrix (MUMPS error " + std::to_string(code) + ")";
}

int DirectSolver::negativeEigenvalues() const { return symmetric_ ? numbered(instance_->data.infog, 12) : 0; }

void DirectSolver::solve(const View<double*>& x)
{
  const auto host = onHost(x);
  Instance& mumps = *instance_;
  // Numbers of unknowns ascend with the ranks.
  std::vector<double> all = mumps.ranks.gather(std::vector<double>(host.data(), host.data() + mumps.rows));
  mumps.data.nrhs = 1;
  mumps.data.lrhs = static_cast<MUMPS_INT>(all.size());
  mumps.data.rhs = all.data();
  if (!mumps.call(Solve))
    throw std::runtime_error("MUMPS failed with " + std::to_string(numbered(mumps.data.infog, 1)));
  all = mumps.ranks.scatter(all, mumps.rows);
  std::copy(all.begin(), all.end(), host.data());
  Kokkos::deep_copy(x, host);
}

#else

struct DirectSolver::Instance
{
};

bool DirectSolver::available() { return false; }
DirectSolver::DirectSolver(bool symmetric) : symmetric_(symmetric) {}
DirectSolver::~DirectSolver() = default;
double DirectSolver::analyse(const SparseMatrix&) { return std::numeric_limits<double>::infinity(); }
bool DirectSolver::factorise(const SparseMatrix&) { return false; }
std::string DirectSolver::failure() const { return {}; }
int DirectSolver::negativeEigenvalues() const { return 0; }
void DirectSolver::solve(const View<double*>&) {}

#endif

} // namespace Rhegma
