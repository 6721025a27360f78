#pragma once
/// The particles in and around some boxes, by blocks of cells.

#include "state/BodyGroup.hpp"

#include <algorithm>
#include <vector>

namespace Rhegma
{

/// A box with its faces along the axes.
template <int D>
struct AxisBox
{
  Vector<D> lower, upper; ///< corners [m]

  KOKKOS_INLINE_FUNCTION bool holds(const Vector<D>& x) const
  {
    bool in = true;
    for (int d = 0; d < D; ++d)
      in = in && x[d] >= lower[d] && x[d] <= upper[d];
    return in;
  }

  /// The box with this much more on all sides.
  AxisBox widened(double more) const
  {
    AxisBox box = *this;
    for (int d = 0; d < D; ++d)
    {
      box.lower[d] -= more;
      box.upper[d] += more;
    }
    return box;
  }
};

/// The cube of half width `reach` around a position.
template <int D>
AxisBox<D> boxAround(const Vector<D>& x, double reach)
{
  return AxisBox<D>{x, x}.widened(reach);
}

/// The blocks of cells whose particles may lie in some boxes: loops over them cost what lies around the boxes
/// and not what the body is large. The list is kept until particles are sorted anew or a box has moved by a
/// cell. Where particles are not in the order of blocks, as before the first step or in a step after which
/// they are sorted, all of them are in reach, as one block. Where a state is loaded, begin with a new object.
template <int D>
class BlocksInReach
{
public:
  /// Most numbers that sum() adds at a time.
  static constexpr int mostSums = 16;

  /// Lists the blocks. Call it before the loops whenever particles or boxes may have changed. \param own only
  /// these particles are listed; a block may then be several ranges, which share nodes: not for forEach
  void find(const State<D>& state, const std::vector<AxisBox<D>>& boxes, const ParticlesOfGroup& own = {});

  /// Calls body(begin, end) with the particles of each block, colour by colour: blocks of one colour share no
  /// node.
  template <class Body>
  void forEach(const char* label, const Body& body) const
  {
    const View<int* [2]> range = range_;
    for (int colour = 0; colour < Blocks<D>::colours; ++colour)
      if (colourStart_[colour + 1] > colourStart_[colour])
        Kokkos::parallel_for(
            label,
            Kokkos::RangePolicy<ExecSpace, Kokkos::Schedule<Kokkos::Dynamic>>(
                colourStart_[colour], colourStart_[colour + 1], Kokkos::ChunkSize(1)),
            KOKKOS_LAMBDA(const int k) { body(range(k, 0), range(k, 1)); });
  }

  /// Calls body(p) with each particle.
  template <class Body>
  void forEachParticle(const char* label, const Body& body) const
  {
    const View<int* [2]> range = range_;
    Kokkos::parallel_for(
        label, Kokkos::RangePolicy<ExecSpace>(0, count()), KOKKOS_LAMBDA(const int k) {
          for (int p = range(k, 0); p < range(k, 1); ++p)
            body(p);
        });
  }

  /// Sums of this rank: body(begin, end, sums) adds those of a block to N numbers, which are zero before. The
  /// order of the additions does not depend on the number of threads, nor on blocks that add zeros.
  template <int N, class Body>
  void sum(const char* label, const Body& body, double (&sums)[N]) const
  {
    static_assert(N <= mostSums, "a block sums fewer numbers");
    const View<int* [2]> range = range_;
    const View<double* [mostSums]> parts = parts_;
    Kokkos::parallel_for(
        label,
        Kokkos::RangePolicy<ExecSpace, Kokkos::Schedule<Kokkos::Dynamic>>(0, count(), Kokkos::ChunkSize(1)),
        KOKKOS_LAMBDA(const int k) {
          double own[N] = {};
          body(range(k, 0), range(k, 1), own);
          for (int i = 0; i < N; ++i)
            parts(k, i) = own[i];
        });
    const auto host = onHost(parts_);
    std::fill(sums, sums + N, 0.0);
    for (int k = 0; k < count(); ++k)
      for (int i = 0; i < N; ++i)
        sums[i] += host(k, i);
  }

  /// The same with body(p, sums) of each particle.
  template <int N, class Body>
  void sumOverParticles(const char* label, const Body& body, double (&sums)[N]) const
  {
    sum(
        label,
        KOKKOS_LAMBDA(const int begin, const int end, double(&own)[N]) {
          for (int p = begin; p < end; ++p)
            body(p, own);
        },
        sums);
  }

  /// First particle of each block and the one after its last; there may be more rows than blocks.
  View<int* [2]> ranges() const { return range_; }

  /// Number of blocks.
  int count() const
  {
    return colourStart_[Blocks<D>::colours];
  }

private:
  bool isKept(const State<D>& state, const std::vector<AxisBox<D>>& boxes) const;

  View<int* [2]> range_;
  View<double* [mostSums]> parts_;
  int colourStart_[Blocks<D>::colours + 1] = {};
  std::vector<AxisBox<D>> found_; ///< the boxes, larger by a cell
  int group_ = 0;                 ///< ParticlesOfGroup::group
  Vector<D> node0_{};             ///< position of the first node of the lattice then [m]
  View<int*> sorted_;             ///< Blocks::first of the sort; held, so that no other has its address
};

} // namespace Rhegma
