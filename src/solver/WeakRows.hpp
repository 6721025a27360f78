#pragma once
/// Rows of a matrix that no multigrid can take.

#include "solver/SparseMatrix.hpp"

namespace Rhegma
{

/// The values of a matrix with weak rows reduced to their diagonals; its own values where no row is weak. A
/// node that hangs on a corner of a particle has 1e-13 of the stiffness of others: coarse levels of such rows
/// are singular to rounding, and the smoother treats them as well. Collective.
View<double*> withoutWeakRows(const SparseMatrix& matrix);

} // namespace Rhegma
