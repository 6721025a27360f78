#include "cracks/FrontTies.hpp"

#include "checkpoint/Archive.hpp"
#include "checkpoint/NodeNames.hpp"
#include "material/MaterialTable.hpp"
#include "state/FewItems.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace Rhegma::cracks
{

namespace
{

constexpr double factor = 0.1;  ///< of E'
constexpr double offset = 0.05; ///< [cells]

/// Share of mass / dt^2 that the stiffness may have: an explicit step of two masses on a spring is stable up
/// to 4, of which the material needs its part.
constexpr double stable = 1.0;

/// Sign of a node's own field.
KOKKOS_INLINE_FUNCTION double signOf(int side) { return side > 0 ? 1.0 : -1.0; }

/// The first level of cells whose nodes take steps of their own.
template <int D>
int firstOfShortSteps(const State<D>& state)
{
  return state.tree.deepest - std::min(state.subcycledLevels, state.tree.deepest) + 1;
}

/// Force of a tie on its node's own field along an axis [N]. \param sign of the node's side
template <int D>
KOKKOS_INLINE_FUNCTION double pullOf(const View<double * [D + 1]>& tie, const View<double* [D]>& jump,
                                     int own, int axis, double sign)
{
  return -sign * tie(own, D) * jump(own, axis);
}

} // namespace

template <int D>
void FrontTies<D>::makeRoom(State<D>& state)
{
  const int rows = state.nodes.numLattice;
  if (static_cast<int>(jump_.extent(0)) < rows)
  {
    Kokkos::resize(jump_, rows);
    Kokkos::resize(step_, rows);
    state.cracks.tie = View<double * [D + 1]>("rhegma::ties", rows);
  }
  if (generation_ != state.tree.generation)
  {
    carryOver(state);
    generation_ = state.tree.generation;
  }
  if (modulus_ > 0.0)
    return;
  modulus_ = std::numeric_limits<double>::infinity();
  for (const Properties& material : state.materialList)
    modulus_ = std::min(modulus_, elasticity(material).effectiveModulus);
}

template <int D>
void FrontTies<D>::carryOver(const State<D>& state)
{
  using Key = std::array<long, D>;
  const double unit = std::ldexp(state.grid.spacing, -deepestLevel); // the smallest cells that there can be
  const int lattice = state.grid.numNodes;
  const auto jump = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, jump_);
  const auto step = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, step_);
  const auto keyOf = [&](const auto& place, int k)
  {
    Key key;
    for (int d = 0; d < D; ++d)
      key[d] = std::lround((place(k, d) - state.grid.origin[d]) / unit);
    return key;
  };
  struct Tie
  {
    Vector<D> jump;
    int step;
  };
  std::map<Key, Tie> ties;
  const auto before = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, finePlace_);
  for (int k = 0; k < static_cast<int>(before.extent(0)); ++k)
  {
    const int n = lattice + k;
    if (step(n) == 0)
      continue;
    Tie& tie = ties[keyOf(before, k)];
    tie.step = step(n);
    for (int d = 0; d < D; ++d)
      tie.jump[d] = jump(n, d);
  }
  const int fine = state.tree.numFine;
  finePlace_ = View<double* [D]>("rhegma::placesOfTies", fine);
  if (fine > 0)
    Kokkos::deep_copy(finePlace_,
                      Kokkos::subview(state.tree.finePlace, std::make_pair(0, fine), Kokkos::ALL));
  const auto after = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, finePlace_);
  for (int n = lattice; n < static_cast<int>(step.extent(0)); ++n)
  {
    step(n) = 0;
    if (n - lattice >= fine)
      continue;
    const auto found = ties.find(keyOf(after, n - lattice));
    if (found == ties.end())
      continue;
    step(n) = found->second.step;
    for (int d = 0; d < D; ++d)
      jump(n, d) = found->second.jump[d];
  }
  Kokkos::deep_copy(jump_, jump);
  Kokkos::deep_copy(step_, step);
}

template <int D>
void FrontTies<D>::prepare(State<D>& state, const Surroundings& surroundings)
{
  makeRoom(state);
  const Nodes<D> nodes = state.nodes;
  const double spacing = state.grid.spacing;
  const NodePlaces<D> places = nodePlaces(state);
  const bool refined = state.tree.refined();
  const View<int*> level = state.tree.nodeLevel;
  const int firstShort = firstOfShortSteps(state);
  const CrackSight<D> sight(state.cracks, spacing);
  const View<std::uint64_t*> nearest = surroundings.nearest;
  const View<int*> last = step_;
  const View<double* [D]> jump = jump_;
  const View<double * [D + 1]> tie = state.cracks.tie;
  const double modulus = factor * modulus_, thickness = state.thickness;
  const double limit = stable / (state.dt * state.dt);
  const int step = surroundings.stamp;
  forFew(
      "rhegma::cracks::findTies", nodes.numSecond, KOKKOS_LAMBDA(const int i) {
        const int own = nodes.parent(i), other = nodes.numLattice + i;
        if (last(own) != step - 1)
          for (int d = 0; d < D; ++d)
            jump(own, d) = 0.0;
        last(own) = step;
        tie(own, D) = 0.0;
        const int s = simplexOf(nearest(own));
        if (sight.nearFront(s) == 0)
          return;
        const Sight seen = sight.look(s, places(own));
        const double cell = refined ? spacing / (1 << level(own)) : spacing;
        double steepest = 0.0;
        for (int d = 0; d < D; ++d)
          steepest = std::fmax(steepest, std::fabs(sight.normal(s, d)));
        const double xi = seen.behind / cell * std::sqrt(steepest) + offset;
        const double away = std::fabs(seen.distance) / (cell * steepest);
        const double a = nodes.sums(own, Nodes<D>::massAt), b = nodes.sums(other, Nodes<D>::massAt);
        if (xi < 1.0 && away < 1.0 && a > 0.0 && b > 0.0)
        {
          const int halvings = refined && level(own) >= firstShort ? level(own) - firstShort + 1 : 0;
          const double wanted = modulus * (D == 2 ? thickness : cell) * (1.0 - xi) / xi * (1.0 - away),
                       most = std::ldexp(limit, 2 * halvings) * a * b / (a + b);
          tie(own, D) = wanted < most ? wanted : most;
        }
      });
}

template <int D>
void FrontTies<D>::addForces(State<D>& state) const
{
  const Nodes<D> nodes = state.nodes;
  const View<int*> side = state.cracks.nodeSide;
  const View<double* [D]> jump = jump_;
  const View<double * [D + 1]> tie = state.cracks.tie;
  forFew(
      "rhegma::cracks::tie", nodes.numSecond, KOKKOS_LAMBDA(const int i) {
        const int own = nodes.parent(i), other = nodes.numLattice + i;
        for (int d = 0; d < D; ++d)
        {
          tie(own, d) = pullOf<D>(tie, jump, own, d, signOf(side(own)));
          nodes.sums(own, Nodes<D>::forceAt + d) += tie(own, d);
          nodes.sums(other, Nodes<D>::forceAt + d) -= tie(own, d);
        }
      });
}

template <int D>
FollowingForce<D> FrontTies<D>::following()
{
  using Values = View<double* [D]>;
  const auto frozen = [](const State<D>& state, const NodeSlots& slots, const Values& force)
  {
    const Nodes<D> nodes = state.nodes;
    const View<double * [D + 1]> tie = state.cracks.tie;
    Kokkos::parallel_for(
        "rhegma::cracks::frozenTies", Kokkos::RangePolicy<ExecSpace>(0, nodes.numSecond),
        KOKKOS_LAMBDA(const int i) {
          const int own = nodes.parent(i), other = nodes.numLattice + i;
          if (slots.moves(own) == slots.moves(other))
            return;
          const int at = slots.of(slots.moves(own) ? own : other);
          for (int d = 0; d < D; ++d)
            force(at, d) += slots.moves(own) ? tie(own, d) : -tie(own, d);
        });
  };
  const auto change =
      [](const State<D>& state, const NodeSlots& slots, const Values& displacement, const Values& force)
  {
    const Nodes<D> nodes = state.nodes;
    const View<double * [D + 1]> tie = state.cracks.tie;
    Kokkos::parallel_for(
        "rhegma::cracks::followTies", Kokkos::RangePolicy<ExecSpace>(0, nodes.numSecond),
        KOKKOS_LAMBDA(const int i) {
          const int own = nodes.parent(i), other = nodes.numLattice + i;
          if (tie(own, D) == 0.0 || !slots.moves(own) || !slots.moves(other))
            return;
          const int a = slots.of(own), b = slots.of(other);
          for (int d = 0; d < D; ++d)
          {
            const double more = tie(own, D) * (displacement(a, d) - displacement(b, d));
            force(a, d) -= more;
            force(b, d) += more;
          }
        });
  };
  return {frozen, change};
}

template <int D>
void FrontTies<D>::advance(State<D>& state) const
{
  const Nodes<D> nodes = state.nodes;
  const View<int*> side = state.cracks.nodeSide;
  const View<double* [D]> jump = jump_;
  const View<double * [D + 1]> tie = state.cracks.tie;
  const double dt = state.dt;
  const bool byMotion = state.scheme == UpdateScheme::Usl;
  state.energy.ties = sumFew<double>(
      "rhegma::cracks::stretchTies", nodes.numSecond, KOKKOS_LAMBDA(const int i, double& sum) {
        const int own = nodes.parent(i), other = nodes.numLattice + i;
        const double sign = signOf(side(own));
        // A field without mass moves nowhere: beside it the other's flight is no stretch.
        const bool both =
            nodes.sums(own, Nodes<D>::massAt) > 0.0 && nodes.sums(other, Nodes<D>::massAt) > 0.0;
        for (int d = 0; d < D; ++d)
        {
          const double moved = byMotion ? nodes.motion(own, d) - nodes.motion(other, d)
                                        : nodes.projection(own, d) - nodes.projection(other, d);
          jump(own, d) = both ? jump(own, d) + sign * dt * moved : 0.0;
          tie(own, d) = pullOf<D>(tie, jump, own, d, sign);
          sum += 0.5 * tie(own, D) * jump(own, d) * jump(own, d);
        }
      });
}

template <int D>
void FrontTies<D>::keep(State<D>& state, int step, Archive& archive)
{
  makeRoom(state);
  const NodeNames<D> names(state);
  const auto jump = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, jump_);
  const auto last = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, step_);
  std::vector<int> nodes;
  std::vector<double> jumps;
  for (int n = 0; n < state.nodes.numLattice && !archive.loads(); ++n)
    if (step > 0 && last(n) == step)
    {
      names.append(n, nodes);
      for (int d = 0; d < D; ++d)
        jumps.push_back(jump(n, d));
    }
  archive("nodes", nodes, D);
  archive("jumps", jumps, D);
  if (!archive.loads())
    return;
  for (std::size_t k = 0; k < std::min(nodes.size(), jumps.size()); k += D)
  {
    const int n = names.find(nodes, k);
    if (n < 0)
      throw std::invalid_argument("\"nodes\" of ties names a node that is not there");
    last(n) = step;
    for (int d = 0; d < D; ++d)
      jump(n, d) = jumps[k + d];
  }
  Kokkos::deep_copy(jump_, jump);
  Kokkos::deep_copy(step_, last);
}

template class FrontTies<2>;
template class FrontTies<3>;

} // namespace Rhegma::cracks
