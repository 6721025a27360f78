#include "transfer/Stencils.hpp"

#include "transfer/TreeStencil.hpp"

namespace Rhegma
{

namespace
{

/// Stencils where cells are refined.
template <int D>
void writeTreeStencils(const State<D>& state, ShapeKind shape, const ObservedPoints<D>& points,
                       const StencilTable<D>& table, int& crowded)
{
  const TreeSight<D> sight(state.grid, state.tree);
  const bool boxes = shape == ShapeKind::Gimp;
  Kokkos::parallel_reduce(
      "rhegma::writeTreeStencils", Kokkos::RangePolicy<ExecSpace>(0, points.count),
      KOKKOS_LAMBDA(const int r, int& number) {
        Vector<D> x, half;
        for (int d = 0; d < D; ++d)
        {
          x[d] = points.position(r, d);
          half[d] = boxes ? points.half(r, d) : 0.0;
        }
        number += writeTreeStencil(sight, table, r, x, half) ? 0 : 1;
      },
      crowded);
}

template <int D, ShapeKind S>
void writeStencils(const Grid<D>& grid, const ObservedPoints<D>& points, const StencilTable<D>& table)
{
  Kokkos::parallel_for(
      "rhegma::writeStencils", Kokkos::RangePolicy<ExecSpace>(0, points.count), KOKKOS_LAMBDA(const int r) {
        Vector<D> x, half;
        for (int d = 0; d < D; ++d)
        {
          x[d] = points.position(r, d);
          half[d] = points.half(r, d);
        }
        writeStencil<D, S>(grid, table, r, x, half);
      });
}

/// Writes unbroken stencils into rows 0 .. points.count - 1. \return the number of points that touch more
/// nodes than a row holds
template <int D>
int writeUnbroken(const State<D>& state, ShapeKind shape, const ObservedPoints<D>& points,
                  const StencilTable<D>& table)
{
  int crowded = 0;
  if (state.tree.refined())
    writeTreeStencils(state, shape, points, table, crowded);
  else if (shape == ShapeKind::Linear)
    writeStencils<D, ShapeKind::Linear>(state.grid, points, table);
  else
    writeStencils<D, ShapeKind::Gimp>(state.grid, points, table);
  return crowded;
}

/// Marks the particles whose boxes touch refined cells or those beside them: all that touch a node of theirs.
template <int D>
void markRefined(const State<D>& state, const View<int*>& row)
{
  const Grid<D> grid = state.grid;
  const View<char*> near = state.tree.nearRefined;
  const auto position = state.particles.template real<D>(fields::position);
  const bool boxes = state.shape == ShapeKind::Gimp;
  BorrowedView<double* [D]> box;
  if (boxes)
    box = state.particles.template real<D>(fields::box);
  Kokkos::parallel_for(
      "rhegma::markRefined", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p) {
        for (int k = 0; k < (1 << D); ++k)
        {
          int cell[D];
          for (int d = 0; d < D; ++d)
          {
            const double half = boxes ? box(p, d) * grid.inverse : 0.0;
            cell[d] =
                static_cast<int>(grid.inCells(position(p, d), d) + (((k >> d) & 1) != 0 ? half : -half));
          }
          if (near(grid.nodeIndex(cell)) == 0)
            continue;
          row(p) = 0;
          return;
        }
      });
}

/// Numbers the marked particles in their order and lists them. Blocks without any cost one look at their
/// marks.
template <int D>
int numberRows(const Blocks<D>& blocks, const View<int*>& row, View<int*>& particles)
{
  const int n = static_cast<int>(row.extent(0));
  if (static_cast<int>(particles.extent(0)) < n)
    particles = View<int*>("rhegma::storedParticle", n);
  const View<int*> list = particles;
  const View<int*> first = blocks.first;
  int count = 0;
  Kokkos::parallel_scan(
      "rhegma::numberStored", Kokkos::RangePolicy<ExecSpace>(0, blocks.numBlocks),
      KOKKOS_LAMBDA(const int b, int& at, const bool final) {
        const int begin = first(b), end = first(b + 1);
        int marked = 0;
        for (int p = begin; p < end; ++p)
          marked += row(p) >= 0 ? 1 : 0;
        if (final && marked > 0)
          for (int p = begin, next = at; p < end; ++p)
            if (row(p) >= 0)
            {
              row(p) = next;
              list(next++) = p;
            }
        at += marked;
      },
      count);
  return count;
}

/// The stored particles as points, with room for some more.
template <int D>
void gatherPoints(State<D>& state)
{
  const int count = state.numStored;
  state.storedPoints.count = count;
  if (static_cast<int>(state.storedPoints.side.extent(0)) < count)
  {
    const int room = count + count / 4 + 16;
    state.storedPoints.position = View<double* [D]>("rhegma::storedPosition", room);
    state.storedPoints.half = View<double* [D]>("rhegma::storedHalf", room);
    state.storedPoints.side = View<int*>("rhegma::storedSide", room);
  }
  const ObservedPoints<D> points = state.storedPoints;
  const auto position = state.particles.template real<D>(fields::position);
  BorrowedView<double* [D]> box;
  const bool boxes = state.shape == ShapeKind::Gimp;
  if (boxes)
    box = state.particles.template real<D>(fields::box);
  BorrowedView<int*> side;
  const bool sides = state.particles.has(fields::side);
  if (sides)
    side = state.particles.integer(fields::side);
  const View<int*> particle = state.storedParticle;
  Kokkos::parallel_for(
      "rhegma::gatherStored", Kokkos::RangePolicy<ExecSpace>(0, count), KOKKOS_LAMBDA(const int r) {
        const int p = particle(r);
        if (sides)
          points.side(r) = side(p);
        for (int d = 0; d < D; ++d)
        {
          points.position(r, d) = position(p, d);
          if (boxes)
            points.half(r, d) = box(p, d);
        }
      });
}

} // namespace

template <int D>
void storeStencils(State<D>& state)
{
  state.numStored = 0;
  if (!state.editor.prepare && !state.tree.refined())
    return;
  const int n = state.particles.size();
  if (static_cast<int>(state.storedRow.extent(0)) != n)
    state.storedRow = View<int*>("rhegma::storedRow", n);
  Kokkos::deep_copy(state.storedRow, -1);
  if (state.tree.refined())
    markRefined(state, state.storedRow);
  if (state.editor.prepare)
    state.editor.prepare(state, state.storedRow);
  state.numStored = numberRows(state.blocks, state.storedRow, state.storedParticle);
  if (state.numStored == 0)
    return;
  state.stored.reserve(state.numStored);
  gatherPoints(state);
  const ObservedPoints<D>& points = state.storedPoints;
  if (writeUnbroken(state, state.shape, points, state.stored) > 0)
    state.trouble =
        "a particle touches more nodes than its stencil can hold: it is far larger than the cells "
        "around it";
  if (state.editor.edit)
    state.editor.edit(state, points, state.stored);
}

template <int D>
int pointStencils(const State<D>& state, const ObservedPoints<D>& points, StencilTable<D>& table, bool massed,
                  double lightest)
{
  table.reserve(points.count);
  writeUnbroken(state, ShapeKind::Linear, points, table);
  if (state.editor.edit)
    state.editor.edit(state, points, table);
  if (!massed)
    return 0;
  const StencilTable<D> t = table;
  const auto sums = state.nodes.sums;
  int lost = 0;
  Kokkos::parallel_reduce(
      "rhegma::keepMassedNodes", Kokkos::RangePolicy<ExecSpace>(0, points.count),
      KOKKOS_LAMBDA(const int r, int& missing) {
        int kept = 0;
        double sum = 0.0, heaviest = 0.0;
        for (int k = 0; k < t.count(r); ++k)
          heaviest = std::fmax(heaviest, sums(t.node(r, k), Nodes<D>::massAt));
        for (int k = 0; k < t.count(r); ++k)
          if (sums(t.node(r, k), Nodes<D>::massAt) > lightest * heaviest && t.weight(r, k) != 0.0)
          {
            t.node(r, kept) = t.node(r, k);
            t.weight(r, kept) = t.weight(r, k);
            for (int d = 0; d < D; ++d)
              t.slope(r, kept, d) = t.slope(r, k, d);
            sum += t.weight(r, kept++);
          }
        t.count(r) = sum > 0.0 ? kept : 0;
        for (int k = 0; k < t.count(r); ++k)
          t.weight(r, k) /= sum;
        missing += sum > 0.0 ? 0 : 1;
      },
      lost);
  return lost;
}

template void storeStencils(State<2>&);
template void storeStencils(State<3>&);
template int pointStencils(const State<2>&, const ObservedPoints<2>&, StencilTable<2>&, bool, double);
template int pointStencils(const State<3>&, const ObservedPoints<3>&, StencilTable<3>&, bool, double);

} // namespace Rhegma
