#include "cracks/Ghosts.hpp"

#include "state/Subdomain.hpp"
#include "transfer/ParticleViews.hpp"

namespace Rhegma::cracks
{

namespace
{

/// Whether a node that lies behind a front is hidden from a side.
KOKKOS_INLINE_FUNCTION bool hidden(const View<int*>& nodeSide, int node, int side)
{
  return nodeSide(node) != 0 && nodeSide(node) == -side;
}

/// Points from a node to the side of a crack, along the axis closest to the crack's normal.
struct Towards
{
  Grid<2> grid;
  View<double* [2]> vertex;
  View<int* [2]> simplex;
  View<int*> crackOf;

  /// \param step one node on along that axis, and along the other one
  KOKKOS_INLINE_FUNCTION void steps(int node, int side, int (&step)[2]) const
  {
    const Vector<2> x = grid.nodePosition(node);
    const int crack = (side > 0 ? side : -side) - 1;
    double nearest = 1e300, normal[2] = {0.0, 1.0};
    for (int s = 0; s < static_cast<int>(simplex.extent(0)); ++s)
    {
      if (crackOf(s) != crack)
        continue;
      const int a = simplex(s, 0), b = simplex(s, 1);
      const double tx = vertex(b, 0) - vertex(a, 0), ty = vertex(b, 1) - vertex(a, 1);
      double at = ((x[0] - vertex(a, 0)) * tx + (x[1] - vertex(a, 1)) * ty) / (tx * tx + ty * ty);
      at = at < 0.0 ? 0.0 : (at > 1.0 ? 1.0 : at);
      const double dx = x[0] - vertex(a, 0) - at * tx, dy = x[1] - vertex(a, 1) - at * ty;
      if (dx * dx + dy * dy < nearest)
      {
        nearest = dx * dx + dy * dy;
        normal[0] = -ty;
        normal[1] = tx;
      }
    }
    const int first = std::abs(normal[0]) > std::abs(normal[1]) ? 0 : 1;
    for (int k = 0; k < 2; ++k)
    {
      const int axis = k == 0 ? first : 1 - first;
      step[k] = (normal[axis] > 0.0) == (side > 0) ? grid.stride[axis] : -grid.stride[axis];
    }
  }
};

/// Whether all nodes that may stand in for a node along an axis are on the lattice.
KOKKOS_INLINE_FUNCTION bool staysOnLattice(const Grid<2>& grid, int node, int step)
{
  int at[2];
  grid.nodeCoordinates(node, at);
  const int axis = step == grid.stride[0] || step == -grid.stride[0] ? 0 : 1;
  const int last = at[axis] + (step > 0 ? ghostReach + 1 : -ghostReach - 1);
  return last >= 0 && last <= grid.cells[axis];
}

void findStandIns(const State<2>& state, const Ghosts& ghosts)
{
  const Nodes<2> nodes = state.mesh.nodes;
  const View<int*> nodeSide = state.cracks.nodeSide;
  const Towards towards{state.mesh.grid, state.cracks.vertex, state.cracks.simplex, state.cracks.crackOf};
  Kokkos::parallel_for(
      "rhegma::cracks::findStandIns", Kokkos::RangePolicy<ExecSpace>(0, nodes.active.extent(0)),
      KOKKOS_LAMBDA(const int i) {
        const int n = nodes.active(i);
        ghosts.seen(n) = ghosts.unseen(n) = 0.0;
        const int from = -nodeSide(n);
        if (from == 0)
          return;
        int steps[2];
        towards.steps(n, from, steps);
        // Next to a kink the far node along one axis may be beyond the crack again.
        for (int pass = 0; pass < 2; ++pass)
          for (const int step : steps)
          {
            const bool both = pass == 0; // the far node, too, must be visible
            if (ghosts.step(n) != 0 || !staysOnLattice(towards.grid, n, step))
              continue;
            int k = 1;
            while (k <= ghostReach && hidden(nodeSide, n + k * step, from))
              ++k;
            if (k > ghostReach || (both && hidden(nodeSide, n + (k + 1) * step, from)))
              continue;
            ghosts.step(n) = step;
            ghosts.distance(n) = k;
            ghosts.linear(n) = both ? 1.0 : 0.0;
          }
      });
}

template <class Connect>
struct AddMass
{
  Connect connect;
  Ghosts ghosts;
  View<int*> row, nodeSide;
  BorrowedView<double*> mass;
  BorrowedView<int*> side;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    for (int p = begin; p < end; ++p)
      if (row(p) >= 0)
        connect.visit(p,
                      [&](int node, double weight, const double*)
                      {
                        const View<double*>& sum =
                            hidden(nodeSide, node, side(p)) ? ghosts.unseen : ghosts.seen;
                        sum(node) += weight * mass(p);
                      });
  }
};

template <ShapeKind S>
void addMass(const State<2>& state, const View<int*>& row, const Ghosts& ghosts)
{
  using Connect = Connectivity<2, S, false>;
  const AddMass<Connect> block{connectivity<2, S, false>(state),
                               ghosts,
                               row,
                               state.cracks.nodeSide,
                               state.particles.scalar(fields::mass),
                               state.particles.integer(fields::side)};
  forEachBlock("rhegma::cracks::massAround", state.mesh.blocks, block);
}

/// Mass that linear extrapolation to all ghosts would remove from a node.
KOKKOS_INLINE_FUNCTION double extrapolatedMass(const Grid<2>& grid, const Ghosts& ghosts, int far)
{
  double mass = 0.0;
  for (int axis = 0; axis < 2; ++axis)
    for (int sense = -1; sense <= 1; sense += 2)
      for (int k = 1; k <= ghostReach; ++k)
      {
        const int step = sense * grid.stride[axis];
        const int ghost = far - (k + 1) * step;
        if (ghost >= 0 && ghost < grid.numNodes && ghosts.step(ghost) == step && ghosts.distance(ghost) == k)
          mass += k * ghosts.unseen(ghost);
      }
  return mass;
}

void limitFractions(const State<2>& state, const Ghosts& ghosts)
{
  const Nodes<2> nodes = state.mesh.nodes;
  const Grid<2> grid = state.mesh.grid;
  Kokkos::parallel_for(
      "rhegma::cracks::limitFractions", Kokkos::RangePolicy<ExecSpace>(0, nodes.active.extent(0)),
      KOKKOS_LAMBDA(const int i) {
        const int n = nodes.active(i);
        if (ghosts.step(n) == 0)
          return;
        const int far = n + (ghosts.distance(n) + 1) * ghosts.step(n);
        const double mass = extrapolatedMass(grid, ghosts, far);
        const double allowed = largestExtrapolatedFraction * ghosts.seen(far);
        if (mass > allowed)
          ghosts.linear(n) *= allowed / mass;
      });
}

/// Copies the stand-ins of shared nodes from their owners, which know their surroundings.
void exchangeStandIns(const State<2>& state, const Ghosts& ghosts)
{
  constexpr int width = Ghosts::reportedWidth;
  const Nodes<2> nodes = state.mesh.nodes;
  const Grid<2> grid = state.mesh.grid;
  const View<double*> reported = ghosts.reported;
  Kokkos::parallel_for(
      "rhegma::cracks::packStandIns", Kokkos::RangePolicy<ExecSpace>(0, nodes.active.extent(0)),
      KOKKOS_LAMBDA(const int i) {
        const int n = nodes.active(i), step = ghosts.step(n);
        const bool reports = isOwnedByThisRank(nodes, n) && step != 0;
        // Node numbers differ between ranks: 1 and 2 are the axes.
        const double axis = step == grid.stride[0] || step == -grid.stride[0] ? 1.0 : 2.0;
        reported(width * n) = reports ? (step > 0 ? axis : -axis) : 0.0;
        reported(width * n + 1) = reports ? ghosts.distance(n) : 0.0;
        reported(width * n + 2) = reports ? ghosts.linear(n) : 0.0;
      });
  sumOverRanks(state, reported.data(), width, 0, width);
  Kokkos::parallel_for(
      "rhegma::cracks::unpackStandIns", Kokkos::RangePolicy<ExecSpace>(0, nodes.active.extent(0)),
      KOKKOS_LAMBDA(const int i) {
        const int n = nodes.active(i), axis = static_cast<int>(std::fabs(reported(width * n)));
        ghosts.step(n) = axis == 0 ? 0 : (reported(width * n) > 0.0 ? 1 : -1) * grid.stride[axis - 1];
        ghosts.distance(n) = static_cast<int>(reported(width * n + 1));
        ghosts.linear(n) = reported(width * n + 2);
      });
}

/// Fraction of the extrapolation to all of its ghosts for which the mass of a node suffices.
KOKKOS_INLINE_FUNCTION double allowedFraction(const Grid<2>& grid, const Ghosts& ghosts, int far)
{
  const double mass = extrapolatedMass(grid, ghosts, far),
               allowed = largestExtrapolatedFraction * ghosts.seen(far);
  return mass > allowed ? allowed / mass : 1.0;
}

/// limitFractions where the far node of a ghost may be on another rank.
void limitFractionsOnRanks(const State<2>& state, const Ghosts& ghosts)
{
  const Nodes<2> nodes = state.mesh.nodes;
  const Grid<2> grid = state.mesh.grid;
  const View<double*> fraction = ghosts.reported;
  Kokkos::parallel_for(
      "rhegma::cracks::findAllowed", Kokkos::RangePolicy<ExecSpace>(0, nodes.active.extent(0)),
      KOKKOS_LAMBDA(const int i) {
        const int n = nodes.active(i);
        fraction(n) = isOwnedByThisRank(nodes, n) ? allowedFraction(grid, ghosts, n) : 0.0;
      });
  sumOverRanks(state, fraction.data(), 1, 0, 1);
  Kokkos::parallel_for(
      "rhegma::cracks::limitFractionsOnRanks", Kokkos::RangePolicy<ExecSpace>(0, nodes.active.extent(0)),
      KOKKOS_LAMBDA(const int i) {
        const int n = nodes.active(i), step = ghosts.step(n);
        if (step == 0)
          return;
        int at[2];
        grid.nodeCoordinates(n, at);
        const int axis = step == grid.stride[0] || step == -grid.stride[0] ? 0 : 1;
        at[axis] += (step > 0 ? 1 : -1) * (ghosts.distance(n) + 1);
        // No particle of this rank sees a ghost whose stand-ins are so far away.
        if (at[axis] < 0 || at[axis] > grid.cells[axis])
          ghosts.step(n) = 0;
        else
          ghosts.linear(n) *= fraction(grid.nodeIndex(at));
      });
}

} // namespace

double largestCfl(const CrackSet<2>& cracks)
{
  const auto normal = cracks.normal;
  int diagonal = 0;
  Kokkos::parallel_reduce(
      "rhegma::cracks::diagonalSegments", Kokkos::RangePolicy<ExecSpace>(0, cracks.simplex.extent(0)),
      KOKKOS_LAMBDA(const int s, int& any) {
        const double nx = std::fabs(normal(s, 0)), ny = std::fabs(normal(s, 1));
        if (std::fmin(nx, ny) > diagonalSlope * std::fmax(nx, ny))
          any = 1;
      },
      Kokkos::Max<int>(diagonal));
  return diagonal > 0 ? largestCflOfDiagonalGhosts : largestCflOfGhosts;
}

void findGhosts(const State<2>& state, const View<int*>& row, Ghosts& ghosts)
{
  const int n = state.mesh.grid.numNodes;
  if (static_cast<int>(ghosts.step.extent(0)) != n)
  {
    ghosts.step = View<int*>("rhegma::cracks::ghostStep", n);
    ghosts.distance = View<int*>("rhegma::cracks::ghostDistance", n);
    ghosts.linear = View<double*>("rhegma::cracks::ghostFraction", n);
    ghosts.seen = View<double*>("rhegma::cracks::massSeen", n);
    ghosts.unseen = View<double*>("rhegma::cracks::massUnseen", n);
    if (state.mesh.subdomain)
      ghosts.reported = View<double*>("rhegma::cracks::reportedGhosts", Ghosts::reportedWidth * n);
  }
  Kokkos::deep_copy(ghosts.step, 0); // also at nodes that particles have left
  findStandIns(state, ghosts);
  if (state.mesh.subdomain)
    exchangeStandIns(state, ghosts);
  if (state.method.shape == ShapeKind::Linear)
    addMass<ShapeKind::Linear>(state, row, ghosts);
  else
    addMass<ShapeKind::Gimp>(state, row, ghosts);
  if (!state.mesh.subdomain)
    return limitFractions(state, ghosts);
  sumOverRanks(state, ghosts.seen);
  sumOverRanks(state, ghosts.unseen);
  limitFractionsOnRanks(state, ghosts);
}

} // namespace Rhegma::cracks
