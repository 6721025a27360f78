#pragma once
/// The mass matrix that couples nodes, stored as its difference from the lumped one.

#include "state/State.hpp"

namespace Rhegma::mass_matrix
{

/// Where particles give the nodes a consistent mass, and how much of it.
struct Unlumping
{
  bool everywhere = true;   ///< all particles; else only those around crack fronts
  double radius = 0.0;      ///< of the unlumped zone around each front [m]
  double edge = 0.0;        ///< width over which the share falls from 1 to 0 beyond the radius [m]
  double lumpedShare = 0.1; ///< eps of M_eps = (1 - eps) M + eps lumped(M)
  double smallestNode =
      0.1; ///< a particle that touches a lighter node, in shares of a full cell's mass, stays lumped
};

/// M = L + A over the nodes that are coupled, L the lumped mass and
///
///     A = (1 - eps) sum_p theta_p m_p (N_p N_p^T - diag(N_p)).
///
/// Rows and columns of A sum to zero, so that L + A has the row sums of L: the total momentum of L x is that
/// of (L + A) x. Each row holds the nodes around its own: a band for lattice nodes and, beside a crack,
/// another for second fields.
template <int D>
struct MassSystem
{
  int reach = 1;        ///< neighbours along an axis on each side: 1 linear, 2 GIMP
  int slots = 0;        ///< (2 reach + 1)^D
  int numRows = 0;      ///< coupled nodes
  bool crossed = false; ///< whether the band of second fields is in use

  View<int*> rowOf;       ///< row of each node (second fields included), or -1 where the mass stays lumped
  View<int*> nodeOf;      ///< node of each row
  View<int*> step;        ///< distance of each slot's node from the row's in the lattice's numbering
  View<double*> lumped;   ///< L [kg]
  View<double**> lattice; ///< A, columns at lattice nodes [kg]
  View<double**> second;  ///< A, columns at second fields of lattice nodes [kg]
};

/// Makes the rows and fills the matrix for the particles as they lie now. Needs the nodal mass.
template <int D>
void assemble(const State<D>& state, const Unlumping& unlumping, MassSystem<D>& system);

/// y = A x for `Width` values a row, x and y of numRows * Width values.
template <int D, int Width>
void multiply(const State<D>& state, const MassSystem<D>& system, const BorrowedView<const double*>& x,
              const BorrowedView<double*>& y);

} // namespace Rhegma::mass_matrix
