#include "mass_matrix/MassSystem.hpp"

#include "mass_matrix/Fronts.hpp"
#include "transfer/ParticleViews.hpp"

#include <algorithm>

namespace Rhegma::mass_matrix
{

namespace
{

/// Weight up to which a box does not count as touching a light node: boxes that end on nodes would else be
/// coupled in one step and lumped in the next, as rounding has it, which feeds a vibration. A box that ends
/// in a free face's node reaches a thousandth of a cell beyond at this weight.
constexpr double barelyTouched = 1e-6;

template <int D>
KOKKOS_INLINE_FUNCTION int slotAxisProduct(int span)
{
  return D == 2 ? span * span : span * span * span;
}

Kokkos::RangePolicy<ExecSpace> range(int begin, int end)
{
  return Kokkos::RangePolicy<ExecSpace>(begin, end);
}

/// Adds what the particles of blocks give.
template <int D, ShapeKind S, bool Stored>
struct AssembleBlock
{
  static constexpr int N = nodesPerAxis<S>;
  static constexpr int reach = N - 1, span = 2 * reach + 1;
  static constexpr int numLines = D == 2 ? N : N * N; ///< of a particle's stencil
  static constexpr int packed = N == 2 ? 2 : 4;

  Connectivity<D, S, Stored> connect;
  MassSystem<D> system;
  View<int*> parent;
  View<int*> first;
  View<int * [Blocks<D>::axes]> corner;
  BorrowedView<double*> mass, volume;
  ConsistentShare<D> share;
  int numLattice;
  double smallest;        ///< lightest node that may be coupled, over the density [m^D times thickness]
  double consistentShare; ///< 1 - eps

  KOKKOS_INLINE_FUNCTION void operator()(const int block) const
  {
    const Grid<D>& grid = connect.grid;
    if (!share.reaches(grid, &corner(block, 0)))
      return;
    LaneStencils<D, S> stencils;
    const int end = first(block + 1);
    for (int begin = first(block); begin < end; begin += lanes)
    {
      const int count = end - begin < lanes ? end - begin : lanes;
      double theta[lanes];
      bool any = false;
      for (int l = 0; l < count; ++l)
      {
        theta[l] = share(&connect.position(begin + l, 0));
        any = any || theta[l] > 0.0;
      }
      if (!any)
        continue;
      stencils.fill(grid, &connect.position(begin, 0),
                    S == ShapeKind::Gimp ? &connect.box(begin, 0) : nullptr, count);
      for (int l = 0; l < count; ++l)
      {
        const int p = begin + l;
        if (theta[l] == 0.0)
          continue;
        const double m = consistentShare * theta[l] * mass(p), lightest = smallest * mass(p) / volume(p);
        if constexpr (Stored)
        {
          const int r = connect.row(p);
          if (r >= 0)
          {
            addToLists(r, m, lightest);
            continue;
          }
        }
        addToBands(stencils, l, m, lightest);
      }
    }
  }

  /// The band of a line that is `from` of the particle's stencil, for the line `to` of it.
  KOKKOS_FORCEINLINE_FUNCTION static constexpr int lineOf(int from, int to)
  {
    return D == 2 ? to - from + reach : (to / N - from / N + reach) * span + to % N - from % N + reach;
  }

  KOKKOS_FORCEINLINE_FUNCTION void addToBands(const LaneStencils<D, S>& stencils, int l, double m,
                                              double lightest) const
  {
    const Grid<D>& grid = connect.grid;
    const int outer = grid.axisOrder[0], fast = grid.axisOrder[D - 1];
    double lineWeight[numLines], along[packed] = {};
    int lineRow[numLines] = {};
    for (int k = 0; k < N; ++k)
      along[k] = stencils.weight[fast][k][l];
    for (int s = 0; s < numLines; ++s)
    {
      int node = stencils.base[l];
      if constexpr (D == 2)
      {
        lineWeight[s] = stencils.weight[outer][s][l];
        node += s * grid.stride[outer];
      }
      else
      {
        const int middle = grid.axisOrder[1];
        lineWeight[s] = stencils.weight[outer][s / N][l] * stencils.weight[middle][s % N][l];
        node += s / N * grid.stride[outer] + s % N * grid.stride[middle];
      }
      if (lineWeight[s] == 0.0)
        continue;
      lineRow[s] = system.rowOf(node);
      if (lineRow[s] < 0)
        return;
      for (int k = 0; k < N; ++k)
        if (lineWeight[s] * along[k] > barelyTouched && system.lumped(lineRow[s] + k) < lightest)
          return;
    }
    const Pack<packed> line = Pack<packed>::load(along);
    for (int s = 0; s < numLines; ++s)
    {
      if (lineWeight[s] == 0.0)
        continue;
      double* values = system.band.data() + static_cast<std::size_t>(lineRow[s]) * system.stride;
      for (int k = 0; k < N; ++k, values += system.stride)
      {
        // A node without weight may have no row: the next row is then another node's.
        if (along[k] == 0.0)
          continue;
        const double mk = m * lineWeight[s] * along[k];
        for (int t = 0; t < numLines; ++t)
        {
          double* const to = values + lineOf(s, t) * span + reach - k;
          Pack<packed> sum = Pack<packed>::load(to);
          sum.add(mk * lineWeight[t], line);
          sum.store(to);
        }
      }
    }
  }

  KOKKOS_INLINE_FUNCTION void addToLists(int r, double m, double lightest) const
  {
    const StencilTable<D>& table = connect.table;
    int row[stencilCapacity<D>], place[stencilCapacity<D>], at[stencilCapacity<D>][D],
        field[stencilCapacity<D>];
    double weight[stencilCapacity<D>];
    int low[D], high[D], n = 0;
    for (int k = 0; k < table.count(r); ++k)
    {
      if (table.weight(r, k) == 0.0)
        continue;
      const int node = table.node(r, k);
      row[n] = system.rowOf(node);
      if (row[n] < 0)
        continue; // a ghost's node far from the zone
      if (table.weight(r, k) > barelyTouched && system.lumped(row[n]) < lightest)
        return;
      field[n] = node < numLattice ? 0 : system.slots;
      connect.grid.nodeCoordinates(node < numLattice ? node : parent(node - numLattice), at[n]);
      place[n] = 0;
      for (int d = 0; d < D; ++d)
      {
        place[n] = place[n] * span + at[n][d];
        low[d] = n == 0 || at[n][d] < low[d] ? at[n][d] : low[d];
        high[d] = n == 0 || at[n][d] > high[d] ? at[n][d] : high[d];
      }
      weight[n++] = table.weight(r, k);
    }
    bool near = true;
    for (int d = 0; d < D; ++d)
      near = near && (n == 0 || high[d] - low[d] <= reach);
    const int centre = slotAxisProduct<D>(span) / 2;
    for (int k = 0; k < n; ++k)
    {
      const int list = system.extraOf(row[k]);
      double* const values = &system.extra(list, 0);
      const double mk = m * weight[k];
      for (int l = 0; l < n; ++l)
      {
        // A ghost's far node is not coupled: both rows keep that share on their diagonals.
        bool both = near;
        if (!near)
        {
          both = true;
          for (int d = 0; d < D; ++d)
            both = both && at[l][d] - at[k][d] <= reach && at[k][d] - at[l][d] <= reach;
        }
        if (both)
          values[field[l] + centre + place[l] - place[k]] += mk * weight[l];
      }
    }
  }
};

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
  system.reach = state.shape == ShapeKind::Linear ? 1 : 2;
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
  Kokkos::parallel_for(
      "rhegma::mass::clearRows", range(system.first, system.last),
      KOKKOS_LAMBDA(const int row) { rowOf(nodeOf(row)) = -1; });
}

constexpr int chosen = -2; ///< in rowOf: a node that shall have a row

/// Marks the nodes that particles in the zone around fronts can touch.
template <int D>
void chooseAroundFronts(const State<D>& state, const Unlumping& unlumping, const MassSystem<D>& system)
{
  const Grid<D> grid = state.grid;
  const double zone = unlumping.radius + unlumping.edge;
  const double furthest = zone + std::sqrt(double(D)) * 0.5 * (system.reach + 1) * grid.spacing;
  const int half = static_cast<int>(std::ceil(furthest * grid.inverse)), side = 2 * half + 1;
  const int all = D == 2 ? side * side : side * side * side;
  const View<double* [D]> front = system.front;
  const View<int*> rowOf = system.rowOf, second = state.cracks.second;
  const auto sums = state.nodes.sums;
  const bool seconds = state.nodes.numSecond > 0;
  Kokkos::parallel_for(
      "rhegma::mass::chooseAroundFronts", range(0, system.numFronts * all), KOKKOS_LAMBDA(const int i) {
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
        if (!in || square > furthest * furthest)
          return;
        const int node = grid.nodeIndex(at);
        if (sums(node, Nodes<D>::massAt) > 0.0)
          rowOf(node) = chosen;
        const int other = seconds ? second(node) : -1;
        if (other >= 0 && sums(other, Nodes<D>::massAt) > 0.0)
          rowOf(other) = chosen;
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
  Kokkos::parallel_scan(
      "rhegma::mass::numberRows", range(0, active),
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

/// Lumped mass and lines of each row; clears its band.
template <int D>
void startRows(const State<D>& state, MassSystem<D>& system)
{
  const auto sums = state.nodes.sums;
  const Nodes<D> nodes = state.nodes;
  const MassSystem<D> s = system;
  const Grid<D> grid = state.grid;
  Kokkos::parallel_for(
      "rhegma::mass::startRows", range(s.first, s.last), KOKKOS_LAMBDA(const int row) {
        const int node = s.nodeOf(row), lattice = latticeNode(nodes, node), span = 2 * s.reach + 1;
        s.lumped(row) = sums(node, Nodes<D>::massAt);
        s.extraOf(row) = -1;
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
  Kokkos::parallel_for(
      "rhegma::mass::chooseLists", range(0, state.numStored), KOKKOS_LAMBDA(const int r) {
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
  Kokkos::parallel_scan(
      "rhegma::mass::numberLists", range(system.first, system.last),
      KOKKOS_LAMBDA(const int row, int& at, const bool final) {
        if (extraOf(row) == -1)
          return;
        if (final)
          extraOf(row) = at;
        ++at;
      },
      count);
  system.numExtra = count;
  const int wide = 2 * system.slots;
  if (static_cast<int>(system.extraCount.extent(0)) < count)
  {
    const int room = count + count / 4 + 16;
    system.extraCount = View<int*>("rhegma::massExtraCount", room);
    system.extra = View<double**>("rhegma::massExtra", room, wide);
    system.extraColumn = View<int**>("rhegma::massExtraColumn", room, wide);
  }
  const auto values = system.extra;
  Kokkos::parallel_for(
      "rhegma::mass::clearLists", range(0, count), KOKKOS_LAMBDA(const int list) {
        for (int k = 0; k < wide; ++k)
          values(list, k) = 0.0;
      });
}

/// Diagonals, so that rows add up to the lumped mass, and lists without their empty entries. Nodes that are
/// not coupled to others lose their rows.
template <int D>
void finishRows(const State<D>& state, MassSystem<D>& system)
{
  const MassSystem<D> s = system;
  const Nodes<D> nodes = state.nodes;
  const View<int*> second = state.cracks.second;
  double mass = 0.0;
  int coupled = 0;
  Kokkos::parallel_reduce(
      "rhegma::mass::finishRows", range(s.first, s.last),
      KOKKOS_LAMBDA(const int row, double& sum, int& count) {
        const int centre = s.slots / 2;
        double* const values = s.band.data() + static_cast<std::size_t>(row) * s.stride;
        double others = -values[centre];
        for (int k = 0; k < s.slots; ++k)
          others += values[k];
        const int list = s.extraOf(row);
        if (list >= 0)
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
}

template <int D, ShapeKind S, bool Stored>
void addParticles(const State<D>& state, const Unlumping& unlumping, const ConsistentShare<D>& share,
                  const MassSystem<D>& system)
{
  AssembleBlock<D, S, Stored> add;
  add.connect = connectivity<D, S, Stored>(state);
  add.system = system;
  add.parent = state.nodes.parent;
  add.first = state.blocks.first;
  add.corner = state.blocks.corner;
  add.mass = state.particles.scalar(fields::mass);
  add.volume = state.particles.scalar(fields::volume);
  add.share = share;
  add.numLattice = state.nodes.numLattice;
  double cell = D == 2 ? state.thickness : 1.0;
  for (int d = 0; d < D; ++d)
    cell *= state.grid.spacing;
  add.smallest = unlumping.smallestNode * cell;
  add.consistentShare = 1.0 - unlumping.lumpedShare;
  // Blocks of one colour share no node.
  for (int colour = 0; colour < Blocks<D>::colours; ++colour)
    Kokkos::parallel_for(
        "rhegma::mass::assemble",
        Kokkos::RangePolicy<ExecSpace, Kokkos::Schedule<Kokkos::Dynamic>>(
            state.blocks.colourStart[colour], state.blocks.colourStart[colour + 1], Kokkos::ChunkSize(1)),
        add);
}

} // namespace

template <int D>
void assemble(const State<D>& state, const Unlumping& unlumping, MassSystem<D>& system)
{
  reserveNodes(state, system);
  clearRows(system);
  if (!unlumping.everywhere)
  {
    listFronts(state, system.front, system.numFronts);
    chooseAroundFronts(state, unlumping, system);
  }
  numberRows(state, unlumping.everywhere, system);
  reserveRows(system);
  startRows(state, system);
  const ConsistentShare<D> share{system.front, system.numFronts, unlumping.everywhere, unlumping.radius,
                                 unlumping.edge};
  startLists(state, share, system);
  const bool stored = state.numStored > 0;
  if (state.shape == ShapeKind::Linear)
    stored ? addParticles<D, ShapeKind::Linear, true>(state, unlumping, share, system)
           : addParticles<D, ShapeKind::Linear, false>(state, unlumping, share, system);
  else
    stored ? addParticles<D, ShapeKind::Gimp, true>(state, unlumping, share, system)
           : addParticles<D, ShapeKind::Gimp, false>(state, unlumping, share, system);
  finishRows(state, system);
}

template <int D>
void multiply(const MassSystem<D>& system, const double* x, double* y, const double* weight)
{
  withReach(system,
            [&](auto reach)
            {
              constexpr int W = MassSystem<D>::width;
              const MassSystem<D> s = system;
              Kokkos::parallel_for(
                  "rhegma::mass::multiply", range(0, s.room), KOKKOS_LAMBDA(const int row) {
                    const bool inside = row >= s.first && row < s.last;
                    const Pack<W> sum =
                        inside ? rowTimes<D, decltype(reach)::value>(s, row, x) : Pack<W>::zero();
                    double* const to = y + W * row;
                    sum.store(to);
                    if (weight != nullptr)
                      for (int d = 0; d < W; ++d)
                        to[d] = weight[W * row + d] == 0.0 ? 0.0 : to[d];
                  });
            });
}

template <int D>
double bytesPerRow(ShapeKind shape)
{
  const int span = shape == ShapeKind::Linear ? 3 : 5;
  const int lines = D == 2 ? span : span * span;
  // The band and its lines; the lumped mass and marks; and vectors: nine of the solves, seven of Belos.
  return lines * span * sizeof(double) + lines * sizeof(int) + sizeof(double) + 3 * sizeof(int) +
         16.0 * MassSystem<D>::width * sizeof(double);
}

template void assemble(const State<2>&, const Unlumping&, MassSystem<2>&);
template void assemble(const State<3>&, const Unlumping&, MassSystem<3>&);
template void multiply(const MassSystem<2>&, const double*, double*, const double*);
template void multiply(const MassSystem<3>&, const double*, double*, const double*);
template double bytesPerRow<2>(ShapeKind);
template double bytesPerRow<3>(ShapeKind);

} // namespace Rhegma::mass_matrix
