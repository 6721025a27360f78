#include "mass_matrix/MassSystem.hpp"

#include "transfer/ParticleViews.hpp"

#include <algorithm>

namespace Rhegma::mass_matrix
{

namespace
{

/// Fronts of all cracks on the device.
template <int D>
View<double* [D]> frontPlaces(const State<D>& state)
{
  const int n = static_cast<int>(state.cracks.fronts.size());
  View<double* [D]> places(Kokkos::view_alloc("rhegma::massFronts", Kokkos::WithoutInitializing), n);
  const auto host = Kokkos::create_mirror_view(places);
  for (int f = 0; f < n; ++f)
    for (int d = 0; d < D; ++d)
      host(f, d) = state.cracks.fronts[f].position[d];
  Kokkos::deep_copy(places, host);
  return places;
}

/// theta: 1 inside the radius around a front, 0 beyond its edge, a cubic between with flat ends.
template <int D>
struct ConsistentShare
{
  View<double* [D]> front;
  bool everywhere;
  double radius, edge;

  KOKKOS_INLINE_FUNCTION double operator()(const double* x) const
  {
    if (everywhere)
      return 1.0;
    double nearest = 1e300;
    for (int f = 0; f < static_cast<int>(front.extent(0)); ++f)
    {
      double square = 0.0;
      for (int d = 0; d < D; ++d)
        square += (x[d] - front(f, d)) * (x[d] - front(f, d));
      nearest = square < nearest ? square : nearest;
    }
    const double beyond = std::sqrt(nearest) - radius;
    if (beyond <= 0.0)
      return 1.0;
    if (!(beyond < edge))
      return 0.0;
    const double s = beyond / edge;
    return 1.0 - s * s * (3.0 - 2.0 * s);
  }
};

/// What the two passes over the particles share: the nodes that one couples, or none.
template <int D, class Connect>
struct Couples
{
  static constexpr int capacity = stencilCapacity<D>;
  Connect connect;
  Grid<D> grid;
  View<double * [Nodes<D>::sumWidth]> sums;
  BorrowedView<double* [D]> position;
  BorrowedView<double*> mass, volume;
  ConsistentShare<D> share;
  double smallest; ///< lightest node that may be coupled, over the density [m^D times thickness]

  /// The nodes with weight of a particle. \return theta, 0 where the particle stays lumped
  KOKKOS_INLINE_FUNCTION double nodesOf(int p, int* node, double* weight, int& count) const
  {
    count = 0;
    const double theta = share(&position(p, 0));
    if (theta == 0.0)
      return 0.0;
    const double lightest = smallest * mass(p) / volume(p);
    bool tiny = false;
    int n = 0;
    connect.visit(p,
                  [&](int at, double w, const double*)
                  {
                    if (w == 0.0)
                      return;
                    tiny = tiny || sums(at, Nodes<D>::massAt) < lightest;
                    node[n] = at;
                    weight[n++] = w;
                  });
    count = n;
    return tiny ? 0.0 : theta;
  }
};

template <int D, class Connect>
struct MarkBlock
{
  Couples<D, Connect> couples;
  View<int*> rowOf;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    int node[Couples<D, Connect>::capacity];
    double weight[Couples<D, Connect>::capacity];
    for (int p = begin; p < end; ++p)
    {
      int count;
      if (couples.nodesOf(p, node, weight, count) == 0.0)
        continue;
      for (int k = 0; k < count; ++k)
        rowOf(node[k]) = 0;
    }
  }
};

template <int D, class Connect>
struct AssembleBlock
{
  static constexpr int capacity = Couples<D, Connect>::capacity;
  Couples<D, Connect> couples;
  MassSystem<D> system;
  View<int*> parent;
  int numLattice;
  double consistentShare;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    int node[capacity], at[capacity][D];
    double weight[capacity];
    const int width = 2 * system.reach + 1;
    for (int p = begin; p < end; ++p)
    {
      int count;
      const double theta = couples.nodesOf(p, node, weight, count);
      if (theta == 0.0)
        continue;
      for (int k = 0; k < count; ++k)
        couples.grid.nodeCoordinates(node[k] < numLattice ? node[k] : parent(node[k] - numLattice), at[k]);
      const double m = consistentShare * theta * couples.mass(p);
      for (int k = 0; k < count; ++k)
      {
        const int row = system.rowOf(node[k]);
        const double mk = m * weight[k];
        double given = 0.0;
        for (int l = 0; l < count; ++l)
        {
          if (l == k)
            continue;
          int slot = 0;
          bool near = true;
          for (int d = 0; d < D; ++d)
          {
            const int offset = at[l][d] - at[k][d] + system.reach;
            near = near && offset >= 0 && offset < width;
            slot = slot * width + offset;
          }
          // A ghost's far node is not coupled: both rows keep that share on their diagonals.
          if (!near)
            continue;
          const double value = mk * weight[l];
          (node[l] < numLattice ? system.lattice(row, slot) : system.second(row, slot)) += value;
          given += value;
        }
        // m N_k (N_k - 1) is minus the sum of m N_k N_l over all others, as the weights add up to one.
        const int centre = system.slots / 2;
        (node[k] < numLattice ? system.lattice(row, centre) : system.second(row, centre)) -= given;
      }
    }
  }
};

template <int D, class Connect>
Couples<D, Connect> makeCouples(const State<D>& state, const Unlumping& unlumping, const Connect& connect)
{
  Couples<D, Connect> c;
  c.connect = connect;
  c.grid = state.grid;
  c.sums = state.nodes.sums;
  c.position = state.particles.template real<D>(fields::position);
  c.mass = state.particles.scalar(fields::mass);
  c.volume = state.particles.scalar(fields::volume);
  c.share = {frontPlaces(state), unlumping.everywhere, unlumping.radius, unlumping.edge};
  double cell = D == 2 ? state.thickness : 1.0;
  for (int d = 0; d < D; ++d)
    cell *= state.grid.spacing;
  c.smallest = unlumping.smallestNode * cell;
  return c;
}

/// Rows of the nodes marked with 0, numbered in the order of the active nodes.
template <int D>
void numberRows(const State<D>& state, MassSystem<D>& system)
{
  const Nodes<D> nodes = state.nodes;
  const View<int*> rowOf = system.rowOf, nodeOf = system.nodeOf;
  int count = 0;
  Kokkos::parallel_scan(
      "rhegma::mass::numberRows", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i, int& at, const bool final) {
        const int n = activeNode(nodes, i);
        if (rowOf(n) < 0)
          return;
        if (final)
        {
          rowOf(n) = at;
          nodeOf(at) = n;
        }
        ++at;
      },
      count);
  system.numRows = count;
}

template <int D>
void reserve(const State<D>& state, MassSystem<D>& system)
{
  const int nodes = static_cast<int>(state.nodes.sums.extent(0));
  if (static_cast<int>(system.rowOf.extent(0)) < nodes)
    system.rowOf = View<int*>("rhegma::massRowOf", nodes);
  if (static_cast<int>(system.nodeOf.extent(0)) < state.nodes.numActive())
    system.nodeOf = View<int*>("rhegma::massNodeOf", state.nodes.numActive() + state.nodes.numActive() / 4);
  if (system.slots == 0)
  {
    system.reach = state.shape == ShapeKind::Linear ? 1 : 2;
    const int width = 2 * system.reach + 1;
    system.slots = D == 2 ? width * width : width * width * width;
    system.step = View<int*>("rhegma::massStep", system.slots);
    const auto host = Kokkos::create_mirror_view(system.step);
    for (int s = 0; s < system.slots; ++s)
    {
      int rest = s, step = 0;
      for (int d = D - 1; d >= 0; --d)
      {
        step += (rest % width - system.reach) * state.grid.stride[d];
        rest /= width;
      }
      host(s) = step;
    }
    Kokkos::deep_copy(system.step, host);
  }
}

/// Makes room for the rows, and clears them.
template <int D>
void clearRows(const State<D>& state, MassSystem<D>& system)
{
  const int rows = system.numRows;
  system.crossed = state.nodes.numSecond > 0;
  if (static_cast<int>(system.lumped.extent(0)) < rows)
  {
    const int room = rows + rows / 4 + 16;
    system.lumped = View<double*>("rhegma::massLumped", room);
    system.lattice = View<double**>("rhegma::massLattice", room, system.slots);
  }
  if (system.crossed && system.second.extent(0) < system.lattice.extent(0))
    system.second = View<double**>("rhegma::massSecond", system.lattice.extent(0), system.slots);
  const auto sums = state.nodes.sums;
  const MassSystem<D> s = system;
  Kokkos::parallel_for(
      "rhegma::mass::clear", Kokkos::RangePolicy<ExecSpace>(0, rows), KOKKOS_LAMBDA(const int row) {
        s.lumped(row) = sums(s.nodeOf(row), Nodes<D>::massAt);
        for (int k = 0; k < s.slots; ++k)
          s.lattice(row, k) = 0.0;
        if (s.crossed)
          for (int k = 0; k < s.slots; ++k)
            s.second(row, k) = 0.0;
      });
}

} // namespace

template <int D>
void assemble(const State<D>& state, const Unlumping& unlumping, MassSystem<D>& system)
{
  reserve(state, system);
  Kokkos::deep_copy(system.rowOf, -1);
  withConnectivity(state,
                   [&](const auto& connect)
                   {
                     using Connect = std::decay_t<decltype(connect)>;
                     const auto couples = makeCouples(state, unlumping, connect);
                     const MarkBlock<D, Connect> mark{couples, system.rowOf};
                     forEachBlock("rhegma::mass::mark", state.blocks, mark);
                     numberRows(state, system);
                     clearRows(state, system);
                     const AssembleBlock<D, Connect> add{couples, system, state.nodes.parent,
                                                         state.nodes.numLattice, 1.0 - unlumping.lumpedShare};
                     forEachBlock("rhegma::mass::assemble", state.blocks, add);
                   });
}

template <int D, int Width>
void multiply(const State<D>& state, const MassSystem<D>& system, const BorrowedView<const double*>& x,
              const BorrowedView<double*>& y)
{
  const Nodes<D> nodes = state.nodes;
  const View<int*> secondOf = state.cracks.second;
  const MassSystem<D> s = system;
  Kokkos::parallel_for(
      "rhegma::mass::multiply", Kokkos::RangePolicy<ExecSpace>(0, system.numRows),
      KOKKOS_LAMBDA(const int row) {
        double sum[Width] = {};
        const int node = latticeNode(nodes, s.nodeOf(row));
        for (int k = 0; k < s.slots; ++k)
        {
          const int column = s.rowOf(node + s.step(k));
          if (column < 0)
            continue;
          const double value = s.lattice(row, k);
          for (int d = 0; d < Width; ++d)
            sum[d] += value * x(column * Width + d);
        }
        if (s.crossed)
          for (int k = 0; k < s.slots; ++k)
          {
            const int other = secondOf(node + s.step(k));
            const int column = other < 0 ? -1 : s.rowOf(other);
            if (column < 0)
              continue;
            const double value = s.second(row, k);
            for (int d = 0; d < Width; ++d)
              sum[d] += value * x(column * Width + d);
          }
        for (int d = 0; d < Width; ++d)
          y(row * Width + d) = sum[d];
      });
}

template void assemble(const State<2>&, const Unlumping&, MassSystem<2>&);
template void assemble(const State<3>&, const Unlumping&, MassSystem<3>&);
template void multiply<2, 2>(const State<2>&, const MassSystem<2>&, const BorrowedView<const double*>&,
                             const BorrowedView<double*>&);
template void multiply<3, 3>(const State<3>&, const MassSystem<3>&, const BorrowedView<const double*>&,
                             const BorrowedView<double*>&);

} // namespace Rhegma::mass_matrix
