#include "mass_matrix/MassRows.hpp"

#include "mass_matrix/HashedLists.hpp"
#include "state/FewItems.hpp"

#include <algorithm>

namespace Rhegma::mass_matrix
{

namespace
{

int reachOf(ShapeKind shape) { return shape == ShapeKind::Linear ? 1 : 2; }

template <int D>
void reserveNodes(const State<D>& state, MassSystem<D>& system)
{
  const int nodes = static_cast<int>(state.nodes.sums.extent(0));
  if (static_cast<int>(system.rowOf.extent(0)) < nodes)
  {
    system.rowOf = View<int*>("rhegma::massRowOf", nodes);
    Kokkos::deep_copy(system.rowOf, -1);
    system.last = system.first;
  }
  if (system.slots > 0)
    return;
  system.reach = reachOf(state.shape);
  const int span = 2 * system.reach + 1;
  system.lines = D == 2 ? span : span * span;
  system.slots = system.lines * span;
  system.stride = system.slots + (system.reach == 1 ? 0 : 1); // four numbers are added where a line has three
  system.first = system.last = system.reach;
  system.step = View<int*>("rhegma::massStep", system.slots);
  const auto host = Kokkos::create_mirror_view(system.step);
  for (int s = 0; s < system.slots; ++s)
  {
    int rest = s, step = 0;
    for (int d = D - 1; d >= 0; --d)
    {
      step += (rest % span - system.reach) * state.grid.stride[d];
      rest /= span;
    }
    host(s) = step;
  }
  Kokkos::deep_copy(system.step, host);
}

/// Forgets the rows of the last step.
template <int D>
void clearRows(const MassSystem<D>& system)
{
  const View<int*> rowOf = system.rowOf, nodeOf = system.nodeOf;
  forFew(
      "rhegma::mass::clearRows", system.first, system.last,
      KOKKOS_LAMBDA(const int row) { rowOf(nodeOf(row)) = -1; });
}

constexpr int chosen = -2; ///< in rowOf: a node that shall have a row

/// The nodes of the lattice around fronts that particles in their zones can touch, some of them more than
/// once.
template <int D>
struct AroundFronts
{
  Grid<D> grid;
  View<double* [D]> front;
  View<double* [2]> zone;
  double beyond; ///< how far particles reach beyond their zone [m]
  int half, side, all, size;

  AroundFronts(const State<D>& state, const Unlumping& unlumping, const View<double* [D]>& places,
               const View<double* [2]>& zones, int fronts)
      : grid(state.grid),
        front(places),
        zone(zones),
        beyond(std::sqrt(double(D)) * 0.5 * (reachOf(state.shape) + 1) * grid.spacing),
        half(std::min(
            *std::max_element(grid.cells, grid.cells + D),
            static_cast<int>(std::ceil((unlumping.radius + unlumping.edge + beyond) * grid.inverse)))),
        side(2 * half + 1),
        all(D == 2 ? side * side : side * side * side),
        size(fronts * all)
  {
  }

  /// Number i of them, below size; or -1 where there is none.
  KOKKOS_INLINE_FUNCTION int operator()(const int i) const
  {
    const int f = i / all;
    int rest = i % all, at[D];
    double square = 0.0;
    bool in = true;
    for (int d = 0; d < D; ++d)
    {
      at[d] = static_cast<int>(grid.inCells(front(f, d), d)) + rest % side - half;
      rest /= side;
      in = in && at[d] >= 0 && at[d] <= grid.cells[d];
      const double apart = grid.origin[d] + at[d] * grid.spacing - front(f, d);
      square += apart * apart;
    }
    return in && square <= furthest(f) * furthest(f) ? grid.nodeIndex(at) : -1;
  }

  KOKKOS_INLINE_FUNCTION double furthest(int f) const { return zone(f, 0) + zone(f, 1) + beyond; }

  /// Whether a place is so near to a front.
  KOKKOS_INLINE_FUNCTION bool holds(const Vector<D>& x) const
  {
    bool any = false;
    for (int f = 0; f < size / all; ++f)
    {
      double square = 0.0;
      for (int d = 0; d < D; ++d)
        square += (x[d] - front(f, d)) * (x[d] - front(f, d));
      any = any || square <= furthest(f) * furthest(f);
    }
    return any;
  }
};

/// Marks the nodes that particles in the zone around fronts can touch.
template <int D>
void chooseAroundFronts(const State<D>& state, const Unlumping& unlumping, const MassSystem<D>& system)
{
  const AroundFronts<D> around(state, unlumping, system.front, system.zone, system.numFronts);
  const View<int*> rowOf = system.rowOf, second = state.cracks.second;
  const auto sums = state.nodes.sums;
  const bool seconds = state.nodes.numSecond > 0;
  forFew(
      "rhegma::mass::chooseAroundFronts", 0, around.size, KOKKOS_LAMBDA(const int i) {
        const int node = around(i);
        if (node < 0)
          return;
        if (sums(node, Nodes<D>::massAt) > 0.0)
          rowOf(node) = chosen;
        const int other = seconds ? second(node) : -1;
        if (other >= 0 && sums(other, Nodes<D>::massAt) > 0.0)
          rowOf(other) = chosen;
      });
}

/// Marks the nodes that particles with a stored stencil touch, where cells are refined.
template <int D>
void chooseTouched(const State<D>& state, const ConsistentShare<D>& share, const MassSystem<D>& system)
{
  const View<int*> rowOf = system.rowOf, particle = state.storedParticle;
  const StencilTable<D> table = state.stored;
  const auto sums = state.nodes.sums;
  const auto position = state.particles.template real<D>(fields::position);
  forFew(
      "rhegma::mass::chooseTouched", 0, state.numStored, KOKKOS_LAMBDA(const int r) {
        if (share(&position(particle(r), 0)) == 0.0)
          return;
        for (int k = 0; k < table.count(r); ++k)
          if (sums(table.node(r, k), Nodes<D>::massAt) > 0.0)
            rowOf(table.node(r, k)) = chosen;
      });
}

/// Gives the nodes their rows, in the order of the active nodes.
template <int D>
void numberRows(const State<D>& state, bool everywhere, MassSystem<D>& system)
{
  const int active = state.nodes.numActive();
  if (static_cast<int>(system.nodeOf.extent(0)) < active + 2 * system.reach)
    system.nodeOf = View<int*>("rhegma::massNodeOf", active + active / 8 + 2 * system.reach);
  const Nodes<D> nodes = state.nodes;
  const View<int*> rowOf = system.rowOf, nodeOf = system.nodeOf;
  const int first = system.first;
  int count = 0;
  scanFew(
      "rhegma::mass::numberRows", 0, active,
      KOKKOS_LAMBDA(const int i, int& at, const bool final) {
        const int n = activeNode(nodes, i);
        if (!(everywhere ? nodes.sums(n, Nodes<D>::massAt) > 0.0 : rowOf(n) != -1))
          return;
        if (final)
        {
          rowOf(n) = first + at;
          nodeOf(first + at) = n;
        }
        ++at;
      },
      count);
  system.last = first + count;
}

/// Makes room for the rows; more than there are, so that solvers last.
template <int D>
void reserveRows(MassSystem<D>& system)
{
  const int rows = system.last + system.reach;
  if (system.room >= rows && system.room <= 2 * rows + 64)
    return;
  const int room = rows + rows / 16 + 8;
  system.room = room;
  system.lumped = View<double*>("rhegma::massLumped", room);
  system.band = View<double*>("rhegma::massBand", static_cast<std::size_t>(room) * system.stride);
  system.lineStart = View<int*>("rhegma::massLineStart", static_cast<std::size_t>(room) * system.lines);
  system.extraOf = View<int*>("rhegma::massExtraOf", room);
  system.coupled = View<char*>("rhegma::massCoupled", room);
}

/// Which nodes only particles with a stored stencil touch: those of refined cells, and those of the lattice
/// all of whose cells are refined or beside such.
template <int D>
struct OnlyStored
{
  Grid<D> grid;
  View<char*> near; ///< empty where no cell is refined

  explicit OnlyStored(const State<D>& state) : grid(state.grid)
  {
    if (state.tree.refined())
      near = state.tree.nearRefined;
  }

  KOKKOS_INLINE_FUNCTION bool operator()(int place) const
  {
    if (near.extent(0) == 0 || place >= grid.numNodes)
      return near.extent(0) > 0;
    bool inside = true;
    for (int k = 0; k < (1 << D); ++k)
    {
      int cell = place;
      for (int d = 0; d < D; ++d)
        cell -= ((k >> d) & 1) * grid.stride[d];
      inside = inside && cell >= 0 && near(cell) != 0;
    }
    return inside;
  }
};

/// Lumped mass and lines of each row; clears its band.
template <int D>
void startRows(const State<D>& state, MassSystem<D>& system)
{
  const auto sums = state.nodes.sums;
  const Nodes<D> nodes = state.nodes;
  const MassSystem<D> s = system;
  const Grid<D> grid = state.grid;
  const OnlyStored<D> onlyStored(state);
  forFew(
      "rhegma::mass::startRows", s.first, s.last, KOKKOS_LAMBDA(const int row) {
        const int node = s.nodeOf(row), lattice = latticeNode(nodes, node), span = 2 * s.reach + 1;
        s.lumped(row) = sums(node, Nodes<D>::massAt);
        s.extraOf(row) = -1;
        if (onlyStored(lattice))
        {
          s.lineStart(row * s.lines) = -1;
          return;
        }
        double* const values = s.band.data() + static_cast<std::size_t>(row) * s.stride;
        for (int k = 0; k < s.stride; ++k)
          values[k] = 0.0;
        for (int line = 0; line < s.lines; ++line)
        {
          int to = lattice;
          if (D == 2)
            to += (line - s.reach) * grid.stride[grid.axisOrder[0]];
          else
            to += (line / span - s.reach) * grid.stride[grid.axisOrder[0]] +
                  (line % span - s.reach) * grid.stride[grid.axisOrder[1]];
          // The band of a second field holds its diagonal alone: who touches it has a stored stencil.
          const int middle = to == lattice ? row : s.rowOf(to);
          // A line whose middle has no mass holds nothing: no particle touches both.
          s.lineStart(row * s.lines + line) = middle < 0 ? 0 : middle - s.reach;
        }
      });
}

/// Gives lists to the rows of nodes that stored stencils touch, and clears them.
template <int D>
void startLists(const State<D>& state, const ConsistentShare<D>& share, MassSystem<D>& system)
{
  system.numExtra = 0;
  if (state.numStored == 0)
    return;
  const View<int*> extraOf = system.extraOf, rowOf = system.rowOf, particle = state.storedParticle;
  const StencilTable<D> table = state.stored;
  const auto position = state.particles.template real<D>(fields::position);
  forFew(
      "rhegma::mass::chooseLists", 0, state.numStored, KOKKOS_LAMBDA(const int r) {
        if (share(&position(particle(r), 0)) == 0.0)
          return;
        for (int k = 0; k < table.count(r); ++k)
        {
          const int row = rowOf(table.node(r, k));
          if (row >= 0)
            extraOf(row) = chosen;
        }
      });
  int count = 0;
  scanFew(
      "rhegma::mass::numberLists", system.first, system.last,
      KOKKOS_LAMBDA(const int row, int& at, const bool final) {
        if (extraOf(row) == -1)
          return;
        if (final)
          extraOf(row) = at;
        ++at;
      },
      count);
  system.numExtra = count;
  const int wide = system.listRoom;
  if (static_cast<int>(system.extraCount.extent(0)) < count ||
      static_cast<int>(system.extra.extent(1)) != wide)
  {
    const int room = count + count / 4 + 16;
    system.extraCount = View<int*>("rhegma::massExtraCount", room);
    system.extra = View<double**>("rhegma::massExtra", room, wide);
    system.extraColumn = View<int**>("rhegma::massExtraColumn", room, wide);
  }
  const auto values = system.extra;
  const auto columns = system.extraColumn;
  const bool hashed = system.hashed;
  forFew(
      "rhegma::mass::clearLists", 0, count, KOKKOS_LAMBDA(const int list) {
        for (int k = 0; k < wide && hashed; ++k)
          columns(list, k) = -1;
        for (int k = 0; k < wide && !hashed; ++k)
          values(list, k) = 0.0;
      });
}

/// Most entries of a list.
template <int D>
int fullestListOf(const MassSystem<D>& system)
{
  const View<int*> number = system.extraCount;
  int most = 0;
  Kokkos::parallel_reduce(
      "rhegma::mass::fullestList", Kokkos::RangePolicy<ExecSpace>(0, system.numExtra),
      KOKKOS_LAMBDA(const int list, int& largest) {
        largest = number(list) > largest ? number(list) : largest;
      },
      Kokkos::Max<int>(most));
  return most;
}

/// The kind of the lists.
template <int D>
void chooseLists(bool refined, MassSystem<D>& system)
{
  if (system.listRoom == 0 || system.hashed != refined)
    system.listRoom = listRoomOf<D>(system.slots, refined);
  system.hashed = refined;
  if (refined && system.overflow.data() == nullptr)
    system.overflow = View<int>("rhegma::massOverflow");
}

} // namespace

template <int D>
void beginRows(const State<D>& state, const Unlumping& unlumping, MassSystem<D>& system)
{
  reserveNodes(state, system);
  clearRows(system);
  chooseLists(state.tree.refined(), system);
  if (!unlumping.everywhere)
  {
    listFronts(state, unlumping, system.front, system.zone, system.numFronts);
    chooseAroundFronts(state, unlumping, system);
    if (system.hashed)
      chooseTouched(state, consistentShare(unlumping, system), system);
  }
  numberRows(state, unlumping.everywhere, system);
  reserveRows(system);
  startRows(state, system);
  startLists(state, consistentShare(unlumping, system), system);
}

template <int D>
void finishRows(const State<D>& state, MassSystem<D>& system)
{
  const MassSystem<D> s = system;
  const Nodes<D> nodes = state.nodes;
  const View<int*> second = state.cracks.second;
  double mass = 0.0;
  int coupled = 0;
  sumFew(
      "rhegma::mass::finishRows", s.first, s.last,
      KOKKOS_LAMBDA(const int row, double& sum, int& count) {
        const int centre = s.slots / 2;
        double* const values = s.band.data() + static_cast<std::size_t>(row) * s.stride;
        double others = 0.0;
        if (s.lineStart(row * s.lines) >= 0)
        {
          others = -values[centre];
          for (int k = 0; k < s.slots; ++k)
            others += values[k];
        }
        const int list = s.extraOf(row);
        if (list >= 0 && s.hashed)
          s.extraCount(list) = packHashed(&s.extra(list, 0), &s.extraColumn(list, 0), s.listRoom, others);
        else if (list >= 0)
        {
          const int node = s.nodeOf(row), lattice = latticeNode(nodes, node);
          int kept = 0;
          for (int k = 0; k < 2 * s.slots; ++k)
          {
            const double value = s.extra(list, k);
            if (value == 0.0)
              continue;
            const int to = lattice + s.step(k % s.slots), other = k < s.slots ? to : second(to);
            if (other == node)
              continue;
            s.extra(list, kept) = value;
            s.extraColumn(list, kept++) = s.rowOf(other);
            others += value;
          }
          s.extraCount(list) = kept;
        }
        values[centre] = s.lumped(row) - others;
        s.coupled(row) = others > 0.0;
        if (s.coupled(row))
        {
          sum += s.lumped(row);
          ++count;
        }
        else
          s.rowOf(s.nodeOf(row)) = -1;
      },
      mass, coupled);
  system.coupledMass = mass;
  system.numCoupled = coupled;
  if (system.hashed && fullestListOf(system) > fullestList * system.listRoom)
    system.listRoom *= 2; // from the next step on
}

template <int D>
double largestRows(const State<D>& state, const Unlumping& unlumping)
{
  const double most =
      std::min<double>(state.grid.numNodes + state.tree.numFine, 1.5 * state.particles.size());
  if (unlumping.everywhere)
    return most;
  View<double* [D]> front;
  View<double* [2]> zone;
  int numFronts = 0;
  listFronts(state, unlumping, front, zone, numFronts);
  const AroundFronts<D> around(state, unlumping, front, zone, numFronts);
  const View<char*> near("rhegma::massNearFronts", state.grid.numNodes);
  forFew(
      "rhegma::mass::nearFronts", 0, around.size, KOKKOS_LAMBDA(const int i) {
        const int node = around(i);
        if (node >= 0)
          near(node) = 1;
      });
  int count = 0;
  sumFew(
      "rhegma::mass::countNearFronts", 0, state.grid.numNodes,
      KOKKOS_LAMBDA(const int node, int& sum) { sum += near(node); }, count);
  const NodePlaces<D> places = nodePlaces(state);
  int fine = 0;
  sumFew(
      "rhegma::mass::countFineNearFronts", state.grid.numNodes, state.grid.numNodes + state.tree.numFine,
      KOKKOS_LAMBDA(const int node, int& sum) { sum += around.holds(places(node)) ? 1 : 0; }, fine);
  count += fine;
  return std::min(most, 2.0 * count);
}

template <int D>
int listRoomOf(int slots, bool refined)
{
  // On a lattice each slot in either of two fields.
  return refined ? (D == 2 ? 64 : 256) : 2 * slots;
}

template <int D>
bool growLists(MassSystem<D>& system)
{
  if (!system.hashed)
    return false;
  int full = 0;
  Kokkos::deep_copy(full, system.overflow);
  if (full == 0)
    return false;
  system.listRoom *= 2;
  Kokkos::deep_copy(system.overflow, 0);
  return true;
}

template int listRoomOf<2>(int, bool);
template int listRoomOf<3>(int, bool);
template bool growLists(MassSystem<2>&);
template bool growLists(MassSystem<3>&);
template void beginRows(const State<2>&, const Unlumping&, MassSystem<2>&);
template void beginRows(const State<3>&, const Unlumping&, MassSystem<3>&);
template void finishRows(const State<2>&, MassSystem<2>&);
template void finishRows(const State<3>&, MassSystem<3>&);
template double largestRows(const State<2>&, const Unlumping&);
template double largestRows(const State<3>&, const Unlumping&);

} // namespace Rhegma::mass_matrix
