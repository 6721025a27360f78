#include "transfer/Stencils.hpp"

#include "base/SmallLoops.hpp"
#include "state/BodyGroup.hpp"
#include "state/Subdomain.hpp"
#include "transfer/TreeStencil.hpp"

namespace Rhegma
{

namespace
{

/// The cells of this rank that points may have stencils in.
template <int D>
OwnCells<D> cellsOfPoints(const State<D>& state, const ObservedPoints<D>& points)
{
  return points.onAllRanks && state.mesh.subdomain ? state.mesh.subdomain->own : OwnCells<D>();
}

/// Stencils where cells are refined. \return the number of points that touch more nodes than a row holds
template <int D, ShapeKind S>
int writeTreeStencils(const State<D>& state, const ObservedPoints<D>& points, const StencilTable<D>& table)
{
  const TreeStencils<D, S> stencils(state.mesh.grid, state.mesh.tree, table);
  const OwnCells<D> own = cellsOfPoints(state, points);
  return parallelSumSmall<int>(
      "rhegma::writeTreeStencils", points.count, KOKKOS_LAMBDA(const int r, int& number) {
        Vector<D> x, half;
        for (int d = 0; d < D; ++d)
        {
          x[d] = points.position(r, d);
          half[d] = S == ShapeKind::Gimp ? points.half(r, d) : 0.0;
        }
        if (!own.hold(x))
        {
          table.count(r) = 0;
          return;
        }
        number += stencils.write(r, x, half) ? 0 : 1;
      });
}

template <int D, ShapeKind S>
void writeStencils(const State<D>& state, const ObservedPoints<D>& points, const StencilTable<D>& table)
{
  const Grid<D> grid = state.mesh.grid;
  const OwnCells<D> own = cellsOfPoints(state, points);
  parallelForSmall(
      "rhegma::writeStencils", points.count, KOKKOS_LAMBDA(const int r) {
        Vector<D> x, half;
        for (int d = 0; d < D; ++d)
        {
          x[d] = points.position(r, d);
          half[d] = points.half(r, d);
        }
        if (own.hold(x))
          writeStencil<D, S>(grid, table, r, x, half);
        else
          table.count(r) = 0;
      });
}

/// Writes unbroken stencils into rows 0 .. points.count - 1. \return the number of points that touch more
/// nodes than a row holds
template <int D>
int writeUnbroken(const State<D>& state, ShapeKind shape, const ObservedPoints<D>& points,
                  const StencilTable<D>& table)
{
  if (state.mesh.tree.refined())
    return shape == ShapeKind::Linear ? writeTreeStencils<D, ShapeKind::Linear>(state, points, table)
                                      : writeTreeStencils<D, ShapeKind::Gimp>(state, points, table);
  if (shape == ShapeKind::Linear)
    writeStencils<D, ShapeKind::Linear>(state, points, table);
  else
    writeStencils<D, ShapeKind::Gimp>(state, points, table);
  return 0;
}

/// Marks the particles whose boxes touch refined cells or those next to them: all that touch a node of
/// theirs.
template <int D>
void markRefined(const State<D>& state, const View<int*>& row)
{
  const Grid<D> grid = state.mesh.grid;
  const View<char*> near = state.mesh.tree.nearRefined, some = state.mesh.blocks.refined;
  const View<int*> first = state.mesh.blocks.first;
  const auto position = state.particles.template real<D>(fields::position);
  const bool boxes = state.method.shape == ShapeKind::Gimp;
  BorrowedView<double* [D]> box;
  if (boxes)
    box = state.particles.template real<D>(fields::box);
  Kokkos::parallel_for(
      "rhegma::markRefined", Kokkos::RangePolicy<ExecSpace>(0, state.mesh.blocks.numBlocks),
      KOKKOS_LAMBDA(const int b) {
        for (int p = first(b); p < first(b + 1); ++p)
        {
          row(p) = -1;
          for (int k = 0; some(b) != 0 && row(p) < 0 && k < (1 << D); ++k)
          {
            int cell[D];
            for (int d = 0; d < D; ++d)
            {
              const double half = boxes ? box(p, d) * grid.inverse : 0.0;
              cell[d] =
                  static_cast<int>(grid.inCells(position(p, d), d) + (((k >> d) & 1) != 0 ? half : -half));
            }
            if (near(grid.nodeIndex(cell)) != 0)
              row(p) = 0;
          }
        }
      });
}

/// Numbers the marked particles in their order and lists them.
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

/// The stored particles as points, with some spare capacity.
template <int D>
void gatherPoints(State<D>& state)
{
  const int count = state.stored.count;
  state.stored.points.count = count;
  if (static_cast<int>(state.stored.points.side.extent(0)) < count)
  {
    const int capacity = count + count / 4 + 16;
    state.stored.points.position = View<double* [D]>("rhegma::storedPosition", capacity);
    state.stored.points.half = View<double* [D]>("rhegma::storedHalf", capacity);
    state.stored.points.side = View<int*>("rhegma::storedSide", capacity);
  }
  const ParticleSides sides(state.particles);
  sides.reserve("rhegma::storedGroup", static_cast<int>(state.stored.points.side.extent(0)),
                state.stored.points);
  const ObservedPoints<D> points = state.stored.points;
  const auto position = state.particles.template real<D>(fields::position);
  BorrowedView<double* [D]> box;
  const bool boxes = state.method.shape == ShapeKind::Gimp, around = state.method.axisymmetric;
  if (boxes)
    box = state.particles.template real<D>(fields::box);
  const View<int*> particle = state.stored.particle;
  Kokkos::parallel_for(
      "rhegma::gatherStored", Kokkos::RangePolicy<ExecSpace>(0, count), KOKKOS_LAMBDA(const int r) {
        const int p = particle(r);
        sides.copy(p, points, r);
        for (int d = 0; d < D; ++d)
        {
          points.position(r, d) = position(p, d);
          if (boxes)
            points.half(r, d) = box(p, d);
        }
        // A particle's box ends at the axis.
        if (around && boxes && points.half(r, 0) > points.position(r, 0))
          points.half(r, 0) = points.position(r, 0);
      });
}

/// Edits stencils of points, one effect after the other.
template <int D>
void edit(const State<D>& state, const ObservedPoints<D>& points, const StencilTable<D>& table)
{
  for (const StencilEditor<D>& editor : state.stored.editors)
    if (editor.edit)
      editor.edit(state, points, table);
}

} // namespace

template <int D>
void storeStencils(State<D>& state)
{
  bool edits = false, mayKeep = state.method.totalLagrangian;
  for (const StencilEditor<D>& editor : state.stored.editors)
  {
    edits = edits || editor.prepare;
    mayKeep = mayKeep && (!editor.prepare || editor.keep);
  }
  const StencilSource source{state.particles.sorts, state.mesh.tree.generation, state.cracks.changes};
  if (mayKeep && source == state.stored.source)
  {
    for (const StencilEditor<D>& editor : state.stored.editors)
      if (editor.prepare)
        editor.keep(state);
    return;
  }
  state.mesh.nodes.releaseEnriched();
  state.stored.source = mayKeep ? source : StencilSource{};
  state.stored.count = 0;
  const bool around = state.method.axisymmetric;
  if (!edits && !state.mesh.tree.refined() && !around)
    return;
  const int n = state.particles.size();
  if (static_cast<int>(state.stored.row.extent(0)) != n)
    state.stored.row = View<int*>("rhegma::storedRow", n);
  if (state.mesh.tree.refined())
    markRefined(state, state.stored.row);
  else
    Kokkos::deep_copy(state.stored.row, around ? 0 : -1);
  for (const StencilEditor<D>& editor : state.stored.editors)
    if (editor.prepare)
      editor.prepare(state, state.stored.row);
  state.stored.count = numberRows(state.mesh.blocks, state.stored.row, state.stored.particle);
  if (state.stored.count == 0)
    return;
  state.stored.table.reserve(state.stored.count, state.method.shear == ShearStrain::AtCellCentres, around);
  gatherPoints(state);
  const ObservedPoints<D>& points = state.stored.points;
  if (writeUnbroken(state, state.method.shape, points, state.stored.table) > 0)
    state.failure =
        "a particle overlaps more nodes than its stencil can hold: it is far larger than the cells around it";
  edit(state, points, state.stored.table);
}

template <int D>
void placeStencils(const State<D>& state, const ObservedPoints<D>& points, StencilTable<D>& table)
{
  table.reserve(points.count);
  writeUnbroken(state, ShapeKind::Linear, points, table);
  edit(state, points, table);
}

template <int D>
int keepMassedNodes(const State<D>& state, int count, const StencilTable<D>& from, StencilTable<D>& to,
                    double lightest)
{
  to.reserve(count);
  const StencilTable<D> all = from, t = to;
  const auto sums = state.mesh.nodes.sums;
  return parallelSumSmall<int>(
      "rhegma::keepMassedNodes", count, KOKKOS_LAMBDA(const int r, int& missing) {
        const int entries = all.count(r);
        int kept = 0;
        double sum = 0.0, heaviest = 0.0;
        for (int k = 0; k < entries; ++k)
          heaviest = std::fmax(heaviest, sums(all.node(r, k), Nodes<D>::massAt));
        for (int k = 0; k < entries; ++k)
          if (sums(all.node(r, k), Nodes<D>::massAt) > lightest * heaviest && all.weight(r, k) != 0.0)
          {
            t.node(r, kept) = all.node(r, k);
            t.weight(r, kept) = all.weight(r, k);
            for (int d = 0; d < D; ++d)
              t.slope(r, kept, d) = all.slope(r, k, d);
            sum += t.weight(r, kept++);
          }
        t.count(r) = sum > 0.0 ? kept : 0;
        for (int k = 0; k < t.count(r); ++k)
          t.weight(r, k) /= sum;
        missing += sum > 0.0 ? 0 : 1;
      });
}

template <int D>
int pointStencils(const State<D>& state, const ObservedPoints<D>& points, StencilTable<D>& table, bool massed,
                  double lightest)
{
  placeStencils(state, points, table);
  return massed ? keepMassedNodes(state, points.count, table, table, lightest) : 0;
}

template void storeStencils(State<2>&);
template void storeStencils(State<3>&);
template void placeStencils(const State<2>&, const ObservedPoints<2>&, StencilTable<2>&);
template void placeStencils(const State<3>&, const ObservedPoints<3>&, StencilTable<3>&);
template int keepMassedNodes(const State<2>&, int, const StencilTable<2>&, StencilTable<2>&, double);
template int keepMassedNodes(const State<3>&, int, const StencilTable<3>&, StencilTable<3>&, double);
template int pointStencils(const State<2>&, const ObservedPoints<2>&, StencilTable<2>&, bool, double);
template int pointStencils(const State<3>&, const ObservedPoints<3>&, StencilTable<3>&, bool, double);

} // namespace Rhegma
