#pragma once
/// The mass matrix that couples nodes: which nodes have a row, and what the rows hold.

#include "base/Pack.hpp"
#include "state/State.hpp"

namespace Rhegma::mass_matrix
{

/// The particles whose mass is consistent, and its fraction.
struct Unlumping
{
  bool everywhere = true; ///< all particles; else only those around crack fronts
  double radius = 0.0;    ///< of the unlumped zone around each front [m]
  double edge = 0.0;      ///< width over which the fraction falls from 1 to 0 beyond the radius [m]
  /// Whether radius and edge are those in cells of the lattice: they shrink with the cells at a front.
  bool radiusShrinks = false, edgeShrinks = false;
  double lumpedFraction = 0.1; ///< eps of M_eps = (1 - eps) M + eps lumped(M)
  double smallestNode =
      0.1; ///< a particle that touches a lighter node, in fractions of its mass in a full body, stays lumped
};

/// M = L + (1 - eps) sum_p theta_p m_p (N_p N_p^T - diag(N_p)) over the nodes of the rows, L the lumped mass.
///
/// Rows and columns add up to L: the total momentum of M x is that of L x. The entries from particles with
/// tensor-product functions are in the band of a row: lines of nodes along the lattice's fastest axis, whose
/// rows follow one another, so that a line is one start and a run of numbers. Particles with a stored stencil
/// (next to cracks and in refined cells) give to rows that also have a list of single entries. Next to cracks
/// in equal cells the position of an entry in the list follows from its node; in refined cells, where nodes
/// of several sizes of cells meet, by hashing. Rows that only such particles touch there are bare: they have
/// a diagonal and a list.
///
/// Where there are several ranks, each has what its own particles give, and the lumped mass on the diagonal
/// of the nodes that it owns: sums of the products of all ranks are those of the whole matrix. Vectors have
/// the same numbers on all ranks that share a row.
///
/// Vectors have `width` numbers a row and `rowCapacity` rows; rows outside of first .. last - 1 are zero in
/// them, and the first lines of a band may read them.
template <int D>
struct MassSystem
{
  static constexpr int width = D == 2 ? 2 : 4; ///< numbers of a row of vectors: one an axis, then zero

  int reach = 1;          ///< neighbours along an axis on each side: 1 linear, 2 GIMP
  int lines = 0;          ///< of a band: (2 reach + 1)^(D - 1)
  int slots = 0;          ///< of a band: (2 reach + 1)^D
  int stride = 0;         ///< numbers of a row's band, a few unused ones at its end included
  int first = 0;          ///< first row
  int last = 0;           ///< one beyond the last row
  int rowCapacity = 0;    ///< rows of vectors
  int numExtra = 0;       ///< rows that have a list
  int listCapacity = 0;   ///< entries that a list can have; a power of two where hashed
  bool hashed = false;    ///< whether lists find their columns by hashing: cells are refined
  int numCoupled = 0;     ///< rows with entries next to their diagonal, of all ranks
  double coupledMass = 0; ///< sum of L over them [kg]

  View<int*> rowOf;        ///< row of each node (enriched fields included), or -1 where it is coupled to none
  View<int*> nodeOf;       ///< node of each row
  View<double*> lumped;    ///< L [kg]
  View<double*> band;      ///< M, `stride` numbers a row [kg]
  View<int*> lineStart;    ///< first row of each line of a row's band; -1 at the first where the row is bare
  View<double*> adjacent;  ///< sum of the sizes of a row's entries next to its diagonal, of all ranks [kg]
  View<char*> coupled;     ///< whether a row has entries next to its diagonal
  View<double*> rowWeight; ///< 1 / number of ranks that have the row; empty where there is one rank
  View<int*> extraOf;      ///< list of each row, or -1
  View<int*> extraCount;   ///< entries of each list
  View<double**> extra;    ///< M beyond the band [kg]
  View<int**> extraColumn; ///< row of each entry

  // For building the lists.
  View<int*> step;           ///< distance of a slot's node from the row's, slots by axes in their order
  int strideOfNodes[D] = {}; ///< with which these were found
  View<double* [D]> front;   ///< positions around which Partial unlumps [m]
  View<double* [2]> zone;    ///< radius and edge of each of them [m]
  View<double*> touched;     ///< by ranks that choose a node, where there are several and cells are refined
  View<int> overflow;        ///< not 0 where a hashed list was full
  int numFronts = 0;

  /// Weight of a row in sums over the rows of all ranks.
  KOKKOS_INLINE_FUNCTION double weightOf(int row) const
  {
    return rowWeight.extent(0) > 0 ? rowWeight(row) : 1.0;
  }
};

/// Values of a row of a MassSystem.
template <int D>
constexpr int width = MassSystem<D>::width;

/// Makes the rows and fills the matrix for the particles as they lie now. Needs the nodal mass.
template <int D>
void assemble(const State<D>& state, const Unlumping& unlumping, MassSystem<D>& system);

/// Bytes of each node that may have a row, vectors of the solves included. \param list whether the row has a
/// list next to its band \param refined whether cells are refined
template <int D>
double bytesPerRow(ShapeKind shape, bool list, bool refined = false);

/// The numbers of row `row` of M x. \param x `width` numbers a row
template <int D, int Reach>
KOKKOS_FORCEINLINE_FUNCTION Pack<MassSystem<D>::width> rowTimes(const MassSystem<D>& s, int row,
                                                                const double* x)
{
  constexpr int W = MassSystem<D>::width, span = 2 * Reach + 1, lines = D == 2 ? span : span * span;
  // A sum for each position along the lines, as a single sum could not be vectorised.
  Pack<W> sums[span];
  for (int k = 0; k < span; ++k)
    sums[k] = Pack<W>::zero();
  const double* const values = s.band.data() + static_cast<std::size_t>(row) * s.stride;
  const int* const starts = s.lineStart.data() + row * lines;
  if (starts[0] < 0)
    sums[0].add(values[lines * span / 2], Pack<W>::load(x + W * row));
  else
    for (int line = 0; line < lines; ++line)
    {
      const double* const from = x + W * starts[line];
      for (int k = 0; k < span; ++k)
        sums[k].add(values[line * span + k], Pack<W>::load(from + W * k));
    }
  const int list = s.extraOf(row);
  if (list >= 0)
    for (int k = 0; k < s.extraCount(list); ++k)
      sums[k % 2].add(s.extra(list, k), Pack<W>::load(x + W * s.extraColumn(list, k)));
  Pack<W> sum = sums[0];
  for (int k = 1; k < span; ++k)
    sum.add(1.0, sums[k]);
  return sum;
}

/// Calls work(std::integral_constant<int, reach>) with the reach of the system.
template <int D, class Work>
void withReach(const MassSystem<D>& system, const Work& work)
{
  if (system.reach == 1)
    work(std::integral_constant<int, 1>{});
  else
    work(std::integral_constant<int, 2>{});
}

/// y = M x, of rowCapacity * width numbers each, M the part of this rank. \param weight null, or where a
/// number of it is zero so is y's
template <int D>
void multiply(const MassSystem<D>& system, const double* x, double* y, const double* weight = nullptr);

/// The same with the whole matrix. Collective.
template <int D>
void multiplyWhole(const State<D>& state, const MassSystem<D>& system, const double* x, double* y,
                   const double* weight = nullptr);

} // namespace Rhegma::mass_matrix
