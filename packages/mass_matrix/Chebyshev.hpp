#pragma once
/// A polynomial in the mass matrix that stands for its inverse.

#include "mass_matrix/MassSystem.hpp"

namespace Rhegma::mass_matrix
{

/// z = p(D^-1 M) D^-1 r, D the lumped mass and p the polynomial for which the worst |1 - x p(x)| over the
/// eigenvalues is least.
///
/// The eigenvalues of D^-1 M lie between the fraction of lumped mass and 1: the row sums of M are D, and what
/// is subtracted from D has no negative eigenvalue. p is positive there, so z is a symmetric positive
/// definite function of r and may precondition conjugate gradients; a constant times L is mapped to a
/// constant. Source: Saad, Iterative Methods for Sparse Linear Systems, 2nd ed., algorithm 12.1.
template <int D>
class Chebyshev
{
public:
  /// \param least eigenvalue \param number of matrix-vector products of one application; even, so that the
  /// last iterate is in z
  Chebyshev(double least, int products);

  /// \param state null where the system is this rank's alone; else collective \param r, z rowCapacity * width
  /// numbers \param inverse 1/D, or 0 where an unknown is given: z is 0 there \param enough where the 2-norm
  /// of r is not above this, only D^-1 r is formed
  void apply(const State<D>* state, const MassSystem<D>& system, const View<double*>& inverse,
             const double* r, double* z, double enough);

private:
  double least_;
  int products_;
  View<double*> other_; ///< the iterates are here and in z in turn
  View<double*> image_; ///< products, where there are several ranks
};

} // namespace Rhegma::mass_matrix
