#pragma once
/// The coupled mass of nodes that move in substeps.

#include "mass_matrix/Chebyshev.hpp"
#include "mass_matrix/MassSystem.hpp"

namespace Rhegma::mass_matrix
{

/// Solves M x = b for the coupled nodes with an inner slot; x is given on others.
///
/// The inverse is a polynomial in M of a fixed degree, so that it is a symmetric function of b: substeps
/// stay symplectic. A submatrix has no eigenvalue beyond those of M (Cauchy's interlacing), for which the
/// polynomial is made.
template <int D>
class SlotSolve
{
public:
  using Values = View<double* [D]>;

  /// \param least eigenvalue of the lumped mass' inverse times M, at least `leastFraction` \param tolerance
  /// of the error relative to the solution, in the norm of the lumped mass
  SlotSolve(double least, double tolerance);

  /// Smallest fraction of lumped mass for which the polynomial is good.
  static constexpr double leastFraction = 0.05;

  /// Prepares for the present rows. `state` and `system` must stay where they are.
  void begin(const State<D>& state, const MassSystem<D>& system, const NodeSlots& slots,
             const View<int* [D]>& held);

  /// Finds x of these nodes. \param x given on other slots, and where supports hold if `supports` is set;
  /// the same for slots of shared nodes on all ranks. Collective.
  void solve(const Values& right, const Values& x, bool supports);

  // Public because compilers for devices want kernels in public functions.
  void findFree();

private:
  const State<D>* state_ = nullptr;
  const MassSystem<D>* system_ = nullptr;
  Chebyshev<D> chebyshev_;
  NodeSlots slots_;
  View<int* [D]> held_;
  View<double*> inverse_;  ///< 1/L of inner coupled rows, else 0
  View<double*> freeOnly_; ///< the same, 0 where a support holds
  View<double*> given_, image_, residual_, solution_;
};

} // namespace Rhegma::mass_matrix
