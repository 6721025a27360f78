#include "adaptivity/Splitting.hpp"

#include "adaptivity/Ids.hpp"
#include "state/Ancestry.hpp"
#include "state/Subdomain.hpp"
#include "transfer/Box.hpp"

namespace Rhegma::adaptivity
{

namespace
{

/// The particles that are too large, in their order. \param some, first the particles that may be:
/// those of a list in their order
/// and all from row `first` on
template <int D>
View<int*> tooLarge(const State<D>& state, const View<int*>& some, int first)
{
  const int given = static_cast<int>(some.extent(0)), n = given + state.particles.size() - first;
  const TreeSight<D> sight(state.mesh.grid, state.mesh.tree);
  const auto position = state.particles.template real<D>(fields::position);
  const auto level = state.particles.integer(fields::level);
  BorrowedView<double* [D]> box;
  const bool boxes = state.method.shape == ShapeKind::Gimp;
  if (boxes)
    box = state.particles.template real<D>(fields::box);
  const View<int*> all(Kokkos::view_alloc("rhegma::large", Kokkos::WithoutInitializing), n);
  const View<char*> mark("rhegma::tooLarge", n);
  const int deepestOfAll = state.mesh.tree.deepest;
  Kokkos::parallel_for(
      "rhegma::adaptivity::markLarge", Kokkos::RangePolicy<ExecSpace>(0, n), KOKKOS_LAMBDA(const int i) {
        const int p = i < given ? some(i) : first + i - given;
        if (level(p) >= deepestOfAll)
          return;
        int cell[D];
        for (int d = 0; d < D; ++d)
          cell[d] = static_cast<int>(sight.grid.inCells(position(p, d), d));
        if (sight.nearRefined(sight.grid.nodeIndex(cell)) == 0)
          return;
        double low[D], high[D];
        const double slack = std::ldexp(mayReach, -level(p) - 1);
        for (int d = 0; d < D; ++d)
        {
          const double at = sight.grid.inCells(position(p, d), d);
          const double half = boxes ? box(p, d) * sight.grid.inverse - slack : 0.0;
          low[d] = at - half;
          high[d] = at + half;
        }
        int deepest = 0;
        sight.forEachLeaf(low, high,
                          [&](const auto& leaf) { deepest = leaf.level > deepest ? leaf.level : deepest; });
        mark(i) = deepest > level(p) ? 1 : 0;
      });
  int count = 0;
  Kokkos::parallel_scan(
      "rhegma::adaptivity::listLarge", Kokkos::RangePolicy<ExecSpace>(0, n),
      KOKKOS_LAMBDA(const int i, int& at, const bool final) {
        if (mark(i) == 0)
          return;
        if (final)
          all(at) = i < given ? some(i) : first + i - given;
        ++at;
      },
      count);
  View<int*> list("rhegma::large", count);
  Kokkos::deep_copy(list, Kokkos::subview(all, std::make_pair(0, count)));
  return list;
}

/// Appends copies of the particles of a list, 2^D - 1 of each, one after another.
template <int D>
void copyParticles(State<D>& state, const View<int*>& list)
{
  constexpr int more = (1 << D) - 1;
  const int count = static_cast<int>(list.extent(0));
  const View<int*> rows(Kokkos::view_alloc("rhegma::splitRows", Kokkos::WithoutInitializing), more * count);
  Kokkos::parallel_for(
      "rhegma::adaptivity::listCopies", Kokkos::RangePolicy<ExecSpace>(0, more * count),
      KOKKOS_LAMBDA(const int i) { rows(i) = list(i / more); });
  state.particles.append(rows);
}

/// Makes the copies parts of the whole.
template <int D>
struct MakeParts
{
  static constexpr int parts = 1 << D;
  View<int*> list;
  int first; ///< row of the first copy
  View<double* [D][D]> axes;
  BorrowedView<double*[D]> position, reference, edge, box;
  BorrowedView<double* [D]> displacement; ///< where the cells lie in the undeformed body
  BorrowedView<double*> mass, volume;
  BorrowedView<double * [gradientSize<D>]> deformation;
  BorrowedView<int*> body, level, lineage, id;
  double largestBox;
  bool boxes;

  KOKKOS_INLINE_FUNCTION void operator()(int i) const
  {
    const int whole = list(i);
    const bool undeformed = displacement.extent(0) > 0;
    double F[gradientSize<D>], edges[D], at[D], start[D], moved[D];
    for (int k = 0; k < gradientSize<D>; ++k)
      F[k] = deformation(whole, k);
    for (int d = 0; d < D; ++d)
    {
      edges[d] = 0.5 * edge(whole, d);
      at[d] = position(whole, d);
      start[d] = reference(whole, d);
      moved[d] = undeformed ? displacement(whole, d) : 0.0;
    }
    const double m = mass(whole) / parts, v = volume(whole) / parts;
    const int depth = level(whole) + 1, code = lineage(whole) << D;
    for (int k = 0; k < parts; ++k)
    {
      const int p = k == 0 ? whole : first + i * (parts - 1) + k - 1;
      Vector<D> shift{};
      for (int e = 0; e < D; ++e)
        for (int d = 0; d < D; ++d)
          shift[d] += (((k >> e) & 1) != 0 ? 0.5 : -0.5) * edges[e] * axes(body(whole), e, d);
      for (int d = 0; d < D; ++d)
      {
        edge(p, d) = edges[d];
        reference(p, d) = start[d] + shift[d];
        double turned = 0.0;
        for (int j = 0; j < D; ++j)
          turned += F[d * D + j] * shift[j];
        position(p, d) = at[d] + (undeformed ? shift[d] : turned);
        if (undeformed)
          displacement(p, d) = moved[d] + turned - shift[d];
      }
      mass(p) = m;
      volume(p) = v;
      level(p) = depth;
      lineage(p) = code | k;
      if (k > 0)
        id(p) = -1;
      if (boxes)
        updateBox<D>(axes, body(p), edges, undeformed ? nullptr : F, std::ldexp(largestBox, -depth),
                     &box(p, 0));
    }
  }
};

template <int D>
void makeParts(State<D>& state, const View<int*>& list, int first)
{
  FieldTable& table = state.particles;
  MakeParts<D> make;
  make.list = list;
  make.first = first;
  make.axes = state.bodies.axes;
  make.position = table.real<D>(fields::position);
  make.reference = table.real<D>(fields::reference);
  if (table.has(fields::displacement))
    make.displacement = table.real<D>(fields::displacement);
  make.edge = table.real<D>(fields::edge);
  make.mass = table.scalar(fields::mass);
  make.volume = table.scalar(fields::volume);
  make.deformation = table.real<gradientSize<D>>(fields::deformation);
  make.body = table.integer(fields::body);
  make.level = table.integer(fields::level);
  make.lineage = table.integer(fields::lineage);
  make.id = table.integer(fields::id);
  make.largestBox = 0.5 * state.mesh.grid.spacing;
  make.boxes = state.method.shape == ShapeKind::Gimp;
  if (make.boxes)
    make.box = table.real<D>(fields::box);
  Kokkos::parallel_for("rhegma::adaptivity::makeParts", Kokkos::RangePolicy<ExecSpace>(0, list.extent(0)),
                       make);
}

} // namespace

template <int D>
int splitParticles(State<D>& state)
{
  if (!state.mesh.tree.refined())
    return 0;
  const int before = state.particles.size();
  View<int*> list;
  int first = 0;
  for (;;)
  {
    list = tooLarge(state, list, first); // after the first time, of the parts just made
    if (list.extent(0) == 0)
      break;
    first = state.particles.size();
    copyParticles(state, list);
    makeParts(state, list, first);
    for (const auto& hook : state.particles.afterSplit)
      hook(state, {list, first});
  }
  const int added = static_cast<int>(ranksOf(state).sum(state.particles.size() - before));
  if (added > 0)
  {
    nameParticles(state);
    state.particles.sorted = false;
  }
  return added;
}

template int splitParticles(State<2>&);
template int splitParticles(State<3>&);

} // namespace Rhegma::adaptivity
