#include "cracks/FrontTies.hpp"

#include "checkpoint/Archive.hpp"
#include "checkpoint/NodeNames.hpp"
#include "cracks/HoldingForce.hpp"
#include "cracks/SurfaceRelease.hpp"
#include "material/MaterialTable.hpp"
#include "parallel/Subdomain.hpp"
#include "state/FewItems.hpp"
#include "transfer/LocalSpacing.hpp"

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
constexpr double full = 0.9;    ///< share of a node's cells that counts as all: strain changes it by less

/// Force of a tie on its node's own field along an axis [N]. \param cohesive rows of cohesion, or none
/// \param sign of the node's side
template <int D>
KOKKOS_INLINE_FUNCTION double pullOf(const View<double * [D + 1]>& tie, const View<double* [D]>& jump,
                                     const View<double * [D + 4]>& cohesive, int own, int axis, double sign)
{
  const bool shifted = cohesive.extent(0) > 0 && cohesive(own, cohesion::peak) > 0.0;
  const double from = shifted ? cohesive(own, cohesion::shift + axis) : 0.0;
  return -sign * tie(own, D) * (jump(own, axis) + from);
}

/// The front of a crack that is nearest to a place, or -1 if that has not grown.
template <int D>
struct NearestFront
{
  View<double * [D + 1]> fronts;

  KOKKOS_INLINE_FUNCTION int operator()(const Vector<D>& x, int crack) const
  {
    int found = -1;
    double least = 1e300;
    for (int f = 0; f < static_cast<int>(fronts.extent(0)); ++f)
    {
      if (std::fabs(fronts(f, D)) != 1.0 + crack)
        continue;
      double square = 0.0;
      for (int d = 0; d < D; ++d)
        square += (x[d] - fronts(f, d)) * (x[d] - fronts(f, d));
      if (square < least)
      {
        least = square;
        found = f;
      }
    }
    return found >= 0 && fronts(found, D) > 0.0 ? found : -1;
  }
};

/// The forces on nodes and second fields, before the solve adds up those of shared nodes; nothing where there
/// is one rank. Collective.
template <int D>
View<double* [D]> forcesOfAllRanks(const State<D>& state)
{
  if (!state.subdomain)
    return {};
  View<double* [D]> whole("rhegma::cracks::forcesOfAllRanks", state.nodes.sums.extent(0));
  const auto sums = state.nodes.sums;
  Kokkos::parallel_for(
      "rhegma::cracks::forcesOfAllRanks", Kokkos::RangePolicy<ExecSpace>(0, whole.extent(0)),
      KOKKOS_LAMBDA(const int n) {
        for (int d = 0; d < D; ++d)
          whole(n, d) = sums(n, Nodes<D>::forceAt + d);
      });
  sumOverRanks(state, whole.data(), D, 0, D);
  return whole;
}

/// A tie with less stretch than this holds no energy to speak of and may stiffen [cells]. Beyond round-off,
/// so that ties are the same on any number of ranks.
constexpr double unstretched = 1e-6;

/// Whether a tie is stretched by more than round-off, beside cells of this size.
template <int D>
KOKKOS_INLINE_FUNCTION bool stretched(const View<double* [D]>& jump, int own, double cell)
{
  double square = 0.0;
  for (int d = 0; d < D; ++d)
    square += jump(own, d) * jump(own, d);
  return square > unstretched * unstretched * cell * cell;
}

/// Makes a cohesive force of a stretched tie: from its force at its stretch j it falls to zero over another
/// |j|. \return the energy that it holds, which no longer is elastic energy of ties [J]
template <int D>
KOKKOS_INLINE_FUNCTION double softenTie(const View<double * [D + 4]>& cohesive, const View<double* [D]>& jump,
                                        int own, double stiffness)
{
  double square = 0.0;
  for (int d = 0; d < D; ++d)
    square += jump(own, d) * jump(own, d);
  if (!(square > 0.0))
    return 0.0;
  const double size = std::sqrt(square);
  cohesive(own, cohesion::peak) = stiffness * size;
  cohesive(own, cohesion::range) = size;
  cohesive(own, cohesion::start) = cohesive(own, cohesion::reached) = size;
  for (int d = 0; d < D; ++d)
    cohesive(own, cohesion::shift + d) = 0.0;
  return 0.5 * stiffness * square;
}

} // namespace

template <int D>
void FrontTies<D>::makeRoom(State<D>& state)
{
  const int rows = state.nodes.numLattice;
  if (state.subdomain && (generation_ != state.tree.generation || grid_.numNodes == 0))
  {
    moveToNewNodes(state);
    generation_ = state.tree.generation;
  }
  if (static_cast<int>(jump_.extent(0)) < rows)
  {
    Kokkos::resize(jump_, rows);
    Kokkos::resize(step_, rows);
    Kokkos::resize(stiffness_, rows);
    if (grows_)
      Kokkos::resize(cohesion_, rows);
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
  {
    modulus_ = std::min(modulus_, elasticity(material).effectiveModulus);
    density_ = std::max(density_, material.density);
  }
}

template <int D>
void FrontTies<D>::moveToNewNodes(State<D>& state)
{
  const int width = D + 2 + D + (grows_ ? D + 4 : 0);
  std::vector<double> ties; // name of the node, step, stiffness, jump, cohesion; one after another
  {
    const auto host = [](const auto& view)
    { return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, view); };
    const auto jump = host(jump_);
    const auto step = host(step_);
    const auto stiffness = host(stiffness_);
    const auto cohesive = host(cohesion_);
    const auto foreign = host(foreign_);
    const NodeNames<D> names(grid_, finePlace_);
    double latest = 0.0;
    for (int n = 0; n < names.size(); ++n)
      latest = std::max(latest, static_cast<double>(step(n)));
    state.ranks.max(&latest, 1);
    for (int n = 0; n < names.size(); ++n)
    {
      if (step(n) == 0 || step(n) < latest || foreign(n) != 0)
        continue;
      for (const int place : names.of(n))
        ties.push_back(place);
      ties.insert(ties.end(), {double(step(n)), stiffness(n)});
      for (int d = 0; d < D; ++d)
        ties.push_back(jump(n, d));
      for (int i = 0; grows_ && i < D + 4; ++i)
        ties.push_back(cohesive(n, i));
    }
  }
  ties = state.ranks.gatherOnAll(ties);
  const int rows = state.nodes.numLattice;
  jump_ = View<double* [D]>("rhegma::tieJump", rows);
  step_ = View<int*>("rhegma::tieStep", rows);
  stiffness_ = View<double*>("rhegma::tieStiffness", rows);
  if (grows_)
    cohesion_ = View<double * [D + 4]>("rhegma::tieCohesion", rows);
  state.cracks.tie = View<double * [D + 1]>("rhegma::ties", rows);
  const auto jump = Kokkos::create_mirror_view(jump_);
  const auto step = Kokkos::create_mirror_view(step_);
  const auto stiffness = Kokkos::create_mirror_view(stiffness_);
  const auto cohesive = Kokkos::create_mirror_view(cohesion_);
  const NodeNames<D> names(state);
  std::vector<int> name(D);
  for (std::size_t k = 0; k < ties.size(); k += width)
  {
    std::copy_n(ties.begin() + k, D, name.begin());
    const int n = names.find(name, 0);
    if (n < 0)
      continue;
    const double* const tie = &ties[k + D];
    step(n) = static_cast<int>(tie[0]);
    stiffness(n) = tie[1];
    for (int d = 0; d < D; ++d)
      jump(n, d) = tie[2 + d];
    for (int i = 0; grows_ && i < D + 4; ++i)
      cohesive(n, i) = tie[2 + D + i];
  }
  Kokkos::deep_copy(jump_, jump);
  Kokkos::deep_copy(step_, step);
  Kokkos::deep_copy(stiffness_, stiffness);
  Kokkos::deep_copy(cohesion_, cohesive);
  grid_ = state.grid;
  foreign_ = state.nodes.foreign;
  finePlace_ = View<double* [D]>("rhegma::placesOfTies", state.tree.numFine);
  if (state.tree.numFine > 0)
    Kokkos::deep_copy(finePlace_, Kokkos::subview(state.tree.finePlace, std::make_pair(0, state.tree.numFine),
                                                  Kokkos::ALL));
}

template <int D>
void FrontTies<D>::carryOver(const State<D>& state)
{
  using Key = std::array<long, D>;
  const double unit = std::ldexp(state.grid.spacing, -deepestLevel); // the smallest cells that there can be
  const int lattice = state.grid.numNodes;
  const auto jump = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, jump_);
  const auto step = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, step_);
  const auto stiffness = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, stiffness_);
  const auto cohesion = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, cohesion_);
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
    double stiffness;
    double cohesion[D + 4];
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
    tie.stiffness = stiffness(n);
    for (int i = 0; grows_ && i < D + 4; ++i)
      tie.cohesion[i] = cohesion(n, i);
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
    stiffness(n) = 0.0;
    if (grows_)
      cohesion(n, cohesion::peak) = 0.0;
    if (n - lattice >= fine)
      continue;
    const auto found = ties.find(keyOf(after, n - lattice));
    if (found == ties.end())
      continue;
    step(n) = found->second.step;
    stiffness(n) = found->second.stiffness;
    for (int i = 0; grows_ && i < D + 4; ++i)
      cohesion(n, i) = found->second.cohesion[i];
    for (int d = 0; d < D; ++d)
      jump(n, d) = found->second.jump[d];
  }
  Kokkos::deep_copy(jump_, jump);
  Kokkos::deep_copy(step_, step);
  Kokkos::deep_copy(stiffness_, stiffness);
  Kokkos::deep_copy(cohesion_, cohesion);
}

template <int D>
void FrontTies<D>::placeFronts(const State<D>& state)
{
  const std::vector<CrackFront<D>>& fronts = state.cracks.fronts;
  if (fronts_.extent(0) != fronts.size())
    fronts_ = View<double * [D + 1]>("rhegma::cracks::fronts", fronts.size());
  const auto host = Kokkos::create_mirror_view(fronts_);
  for (std::size_t f = 0; f < fronts.size(); ++f)
  {
    for (int d = 0; d < D; ++d)
      host(f, d) = fronts[f].position[d];
    host(f, D) = (fronts[f].grown ? 1.0 : -1.0) * (1.0 + fronts[f].crack);
  }
  Kokkos::deep_copy(fronts_, host);
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
  [[maybe_unused]] const double density = density_;
  const double limit = stable / (state.dt * state.dt);
  const int step = surroundings.stamp;
  const View<double*> stiffness = stiffness_;
  const bool grows = grows_;
  const View<double * [D + 4]> cohesive = cohesion_;
  if (grows)
    placeFronts(state);
  const NearestFront<D> frontOf{fronts_};
  double converted = 0.0;
  sumFew(
      "rhegma::cracks::findTies", 0, nodes.numSecond,
      KOKKOS_LAMBDA(const int i, int& waiting, double& spent) {
        const int own = nodes.parent(i), other = nodes.numLattice + i;
        const bool fresh = last(own) != step - 1;
        if (fresh)
        {
          stiffness(own) = 0.0;
          for (int d = 0; d < D; ++d)
            jump(own, d) = 0.0;
          if (grows)
            cohesive(own, cohesion::peak) = 0.0;
        }
        last(own) = step;
        tie(own, D) = 0.0;
        const int s = simplexOf(nearest(own));
        const double a = nodes.sums(own, Nodes<D>::massAt), b = nodes.sums(other, Nodes<D>::massAt);
        const int halvings = refined && level(own) >= firstShort ? level(own) - firstShort + 1 : 0;
        const double most = a > 0.0 && b > 0.0 ? std::ldexp(limit, 2 * halvings) * a * b / (a + b) : 0.0;
        if (grows)
        {
          if (cohesive(own, cohesion::peak) > 0.0)
          {
            const double now = cohesion::secant(cohesive, own);
            tie(own, D) = now < most ? now : most;
            stiffness(own) = 0.0;
            return;
          }
          const int f = frontOf(places(own), sight.crackOf(s));
          if (f >= 0)
          {
            if (fresh && most > 0.0)
            {
              cohesive(own, cohesion::peak) = -1.0 - f;
              ++waiting;
            }
            else if (stiffness(own) > 0.0)
            {
              const double held = softenTie<D>(cohesive, jump, own, stiffness(own));
              spent += countsHere(nodes, own) ? held : 0.0;
            }
            const bool softened = cohesive(own, cohesion::peak) > 0.0;
            tie(own, D) = stiffness(own) < most ? stiffness(own) : most;
            stiffness(own) = softened ? -1.0 : 0.0; // seen by the sum below, once
            return;
          }
        }
        if (sight.nearFront(s) != nearFront::tied)
        {
          stiffness(own) = 0.0;
          return;
        }
        const Sight seen = sight.look(s, places(own));
        const double cell = refined ? spacing / (1 << level(own)) : spacing;
        double steepest = 0.0;
        for (int d = 0; d < D; ++d)
          steepest = std::fmax(steepest, std::fabs(sight.normal(s, d)));
        const double xi = seen.behind / cell * std::sqrt(steepest) + offset;
        const double away = std::fabs(seen.distance) / (cell * steepest);
        double wanted = 0.0, width = thickness;
        if constexpr (D == 3) // less at the surface, by what of the node's cells is filled
        {
          const double filled = (a + b) / (density * cell * cell * cell);
          width = cell * (filled > full ? 1.0 : filled);
        }
        if (xi < 1.0 && away < 1.0)
          wanted = modulus * width * (1.0 - xi) / xi * (1.0 - away);
        wanted = wanted < most ? wanted : most;
        // A stretched spring that stiffens would make energy.
        if (wanted > stiffness(own) && stretched<D>(jump, own, cell))
          wanted = stiffness(own);
        tie(own, D) = stiffness(own) = wanted;
      },
      waiting_, converted);
  state.energy.fracture += converted;
  if (!grows)
    return;
  sumParts(state, &converted, 1);
  if (!(converted > 0.0))
    return;
  // What these ties held and will take is part of the energy of new faces.
  debt_.resize(state.cracks.fronts.size(), 0.0);
  for (std::size_t f = 0; f < debt_.size(); ++f)
  {
    auto owed = sumFew<double>(
        "rhegma::cracks::energyOfTies", nodes.numSecond, KOKKOS_LAMBDA(const int i, double& sum) {
          const int own = nodes.parent(i);
          if (stiffness(own) < 0.0 && countsHere(nodes, own) &&
              frontOf(places(own), sight.crackOf(simplexOf(nearest(own)))) == static_cast<int>(f))
            sum += cohesive(own, cohesion::peak) * cohesive(own, cohesion::range);
        });
    sumParts(state, &owed, 1);
    if constexpr (D == 2)
      debt_[f] += owed;
    else
      state.cracks.fronts[f].unspent -= owed;
  }
}

template <int D>
void FrontTies<D>::addForces(State<D>& state) const
{
  const Nodes<D> nodes = state.nodes;
  const View<int*> side = state.cracks.nodeSide;
  const View<double* [D]> jump = jump_;
  const View<double * [D + 1]> tie = state.cracks.tie;
  const View<double * [D + 4]> cohesive = cohesion_;
  forFew(
      "rhegma::cracks::tie", nodes.numSecond, KOKKOS_LAMBDA(const int i) {
        const int own = nodes.parent(i), other = nodes.numLattice + i;
        for (int d = 0; d < D; ++d)
        {
          tie(own, d) = pullOf<D>(tie, jump, cohesive, own, d, signOf(side(own)));
          if (!countsHere(nodes, own))
            continue;
          nodes.sums(own, Nodes<D>::forceAt + d) += tie(own, d);
          nodes.sums(other, Nodes<D>::forceAt + d) -= tie(own, d);
        }
      });
}

template <int D>
FollowingForce<D> FrontTies<D>::following() const
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
          if (slots.moves(own) == slots.moves(other) || !countsHere(nodes, own))
            return;
          const int at = slots.of(slots.moves(own) ? own : other);
          for (int d = 0; d < D; ++d)
            force(at, d) += slots.moves(own) ? tie(own, d) : -tie(own, d);
        });
  };
  const auto change =
      [this](const State<D>& state, const NodeSlots& slots, const Values& displacement, const Values& force)
  {
    const Nodes<D> nodes = state.nodes;
    const View<double * [D + 1]> tie = state.cracks.tie;
    const View<int*> side = state.cracks.nodeSide;
    const View<double* [D]> jump = jump_;
    const View<double * [D + 4]> cohesive = cohesion_;
    const bool grows = grows_;
    Kokkos::parallel_for(
        "rhegma::cracks::followTies", Kokkos::RangePolicy<ExecSpace>(0, nodes.numSecond),
        KOKKOS_LAMBDA(const int i) {
          const int own = nodes.parent(i), other = nodes.numLattice + i;
          if (tie(own, D) == 0.0 || !slots.moves(own) || !slots.moves(other) || !countsHere(nodes, own))
            return;
          const int a = slots.of(own), b = slots.of(other);
          const double sign = signOf(side(own));
          const bool resists = grows && cohesive(own, cohesion::peak) > 0.0;
          double from[D], square = 0.0;
          for (int d = 0; d < D; ++d)
          {
            from[d] = jump(own, d) + sign * (displacement(a, d) - displacement(b, d)) +
                      (resists ? cohesive(own, cohesion::shift + d) : 0.0);
            square += from[d] * from[d];
          }
          double stiffness = tie(own, D);
          if (resists && square > cohesive(own, cohesion::reached) * cohesive(own, cohesion::reached))
            stiffness = std::fmin(stiffness, cohesion::secantAt(cohesive, own, std::sqrt(square)));
          for (int d = 0; d < D; ++d)
          {
            const double more = -sign * stiffness * from[d] - tie(own, d);
            force(a, d) += more;
            force(b, d) -= more;
          }
        });
  };
  return {frozen, change};
}

template <int D>
void FrontTies<D>::release(State<D>& state, const Surroundings& surroundings)
{
  double waiting = waiting_;
  maxParts(state, &waiting, 1);
  if (waiting == 0.0)
    return;
  const View<double* [D]> whole = forcesOfAllRanks(state);
  if constexpr (D == 3)
  {
    releaseBehind(*surface_, state, surroundings, whole, jump_, cohesion_);
    waiting_ = 0;
    return;
  }
  const Nodes<D> nodes = state.nodes;
  const View<int*> side = state.cracks.nodeSide;
  const View<double*[D]> jump = jump_, normal = state.cracks.normal;
  const View<std::uint64_t*> nearest = surroundings.nearest;
  const View<double * [D + 1]> tie = state.cracks.tie;
  const View<double * [D + 4]> cohesive = cohesion_;
  const HoldingForce<D> holding{nodes, side, normal, nearest, whole};
  const bool refined = state.tree.refined();
  const View<int*> level = state.tree.nodeLevel;
  const int firstShort = firstOfShortSteps(state);
  const double limit = stable / (state.dt * state.dt);
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    CrackFront<D>& front = state.cracks.fronts[f];
    const double name = -1.0 - static_cast<double>(f);
    auto sum = sumFew<double>(
        "rhegma::cracks::sumHoldingForces", nodes.numSecond, KOKKOS_LAMBDA(const int i, double& all) {
          const int own = nodes.parent(i);
          if (cohesive(own, cohesion::peak) == name && countsHere(nodes, own))
            all += norm(holding(i));
        });
    sumParts(state, &sum, 1);
    // A node that the front passes by drifting through the cells takes what a cell of new face would.
    const double energy = front.unspent > 0.0 ? front.unspent
                                              : std::max(0.0, front.driving.release) * state.thickness *
                                                    spacingAt(state, front.position);
    const double owed = f < debt_.size() ? std::min(debt_[f], cohesion::repayment * energy) : 0.0;
    const double range = sum > 0.0 ? 2.0 * (energy - owed) / (cohesion::strengthAtFirst * sum) : 0.0;
    if (range > 0.0)
      front.unspent = 0.0;
    if (range > 0.0 && owed > 0.0)
      debt_[f] -= owed;
    forFew(
        "rhegma::cracks::release", nodes.numSecond, KOKKOS_LAMBDA(const int i) {
          const int own = nodes.parent(i), other = nodes.numLattice + i;
          if (cohesive(own, cohesion::peak) != name)
            return;
          const Vector<D> force = cohesion::strengthAtFirst * holding(i);
          const double size = norm(force);
          const double a = nodes.sums(own, Nodes<D>::massAt), b = nodes.sums(other, Nodes<D>::massAt);
          const int halvings = refined && level(own) >= firstShort ? level(own) - firstShort + 1 : 0;
          const double stiffness = std::ldexp(limit, 2 * halvings) * a * b / (a + b);
          cohesive(own, cohesion::peak) = 0.0;
          if (!(size > 0.0) || !(range > 0.0))
            return;
          cohesive(own, cohesion::peak) = size;
          cohesive(own, cohesion::range) = range;
          cohesive(own, cohesion::start) = cohesive(own, cohesion::reached) = size / stiffness;
          tie(own, D) = stiffness;
          for (int d = 0; d < D; ++d)
          {
            cohesive(own, cohesion::shift + d) = force[d] / stiffness - jump(own, d);
            tie(own, d) = -signOf(side(own)) * force[d];
            if (!countsHere(nodes, own))
              continue;
            nodes.sums(own, Nodes<D>::forceAt + d) += tie(own, d);
            nodes.sums(other, Nodes<D>::forceAt + d) -= tie(own, d);
          }
        });
  }
  waiting_ = 0;
}

template <int D>
void FrontTies<D>::advance(State<D>& state)
{
  const Nodes<D> nodes = state.nodes;
  const View<int*> side = state.cracks.nodeSide;
  const View<double* [D]> jump = jump_;
  const View<double * [D + 1]> tie = state.cracks.tie;
  const View<double * [D + 4]> cohesive = cohesion_;
  const bool grows = grows_;
  const double dt = state.dt;
  const bool byMotion = state.scheme == UpdateScheme::Usl;
  double elastic = 0.0, spent = 0.0;
  sumFew(
      "rhegma::cracks::stretchTies", 0, nodes.numSecond,
      KOKKOS_LAMBDA(const int i, double& sum, double& work) {
        const int own = nodes.parent(i), other = nodes.numLattice + i;
        const double sign = signOf(side(own));
        // A field without mass moves nowhere: beside it the other's flight is no stretch.
        const bool both =
            nodes.sums(own, Nodes<D>::massAt) > 0.0 && nodes.sums(other, Nodes<D>::massAt) > 0.0;
        const bool resists = grows && cohesive(own, cohesion::peak) > 0.0;
        double square = 0.0, more[D];
        for (int d = 0; d < D; ++d)
        {
          const double moved = byMotion ? nodes.motion(own, d) - nodes.motion(other, d)
                                        : nodes.projection(own, d) - nodes.projection(other, d);
          more[d] = both ? sign * dt * moved : -jump(own, d);
          jump(own, d) += more[d];
          if (resists)
          {
            const double from = jump(own, d) + cohesive(own, cohesion::shift + d);
            square += from * from;
          }
          else if (countsHere(nodes, own))
            sum += 0.5 * tie(own, D) * jump(own, d) * jump(own, d);
        }
        if (resists && square > cohesive(own, cohesion::reached) * cohesive(own, cohesion::reached))
        {
          cohesive(own, cohesion::reached) = std::sqrt(square);
          const double now = cohesion::secant(cohesive, own);
          tie(own, D) = now < tie(own, D) ? now : tie(own, D);
        }
        for (int d = 0; d < D; ++d)
        {
          const double before = tie(own, d);
          tie(own, d) = pullOf<D>(tie, jump, cohesive, own, d, sign);
          if (resists && both && countsHere(nodes, own))
            work -= 0.5 * sign * (before + tie(own, d)) * more[d];
        }
      },
      elastic, spent);
  state.energy.ties = elastic;
  state.energy.fracture += spent;
}

template <int D>
double FrontTies<D>::energyInFlight(const State<D>& state, int step) const
{
  const Nodes<D> nodes = state.nodes;
  const View<double* [D]> jump = jump_;
  const View<int*> last = step_;
  const View<double * [D + 4]> cohesive = cohesion_;
  double sum = sumFew<double>(
      "rhegma::cracks::energyInFlight", static_cast<int>(cohesive.extent(0)),
      KOKKOS_LAMBDA(const int n, double& all) {
        if (last(n) != step || step == 0 || !(cohesive(n, cohesion::peak) > 0.0) || !countsHere(nodes, n))
          return;
        const double r = cohesive(n, cohesion::reached), force = cohesion::strength(cohesive, n);
        double square = 0.0;
        for (int d = 0; d < D; ++d)
        {
          const double from = jump(n, d) + cohesive(n, cohesion::shift + d);
          square += from * from;
        }
        const double end = cohesive(n, cohesion::start) + cohesive(n, cohesion::range);
        if (force > 0.0)
          all += 0.5 * force * (end - r) + 0.5 * force / r * (r * r - square);
      });
  sumParts(state, &sum, 1);
  for (const CrackFront<D>& front : state.cracks.fronts)
    sum += front.unspent;
  return sum;
}

template <int D>
void FrontTies<D>::keep(State<D>& state, int step, Archive& archive)
{
  makeRoom(state);
  const NodeNames<D> names(state);
  const auto jump = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, jump_);
  const auto last = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, step_);
  const auto stiffness = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, stiffness_);
  const auto cohesion = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, cohesion_);
  const auto foreign = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.nodes.foreign);
  const auto isOwn = [&](int n) { return foreign.extent(0) == 0 || foreign(n) == 0; };
  std::vector<int> nodes;
  std::vector<double> jumps, stiffnesses, cohesions;
  for (int n = 0; n < state.nodes.numLattice && !archive.loads(); ++n)
    if (step > 0 && last(n) == step && isOwn(n))
    {
      names.append(n, nodes);
      for (int d = 0; d < D; ++d)
        jumps.push_back(jump(n, d));
      stiffnesses.push_back(stiffness(n));
      for (int k = 0; grows_ && k < D + 4; ++k)
        cohesions.push_back(cohesion(n, k));
    }
  archive.together("nodes", nodes, D);
  archive.together("jumps", jumps, D);
  archive.together("stiffnesses", stiffnesses);
  archive("debts", debt_);
  if (grows_)
    archive.together("cohesions", cohesions, D + 4);
  if (!archive.loads())
    return;
  for (std::size_t k = 0; k < std::min(nodes.size(), jumps.size()); k += D)
  {
    const int n = names.find(nodes, k);
    if (n < 0 && state.ranks.many())
      continue; // another rank's
    if (n < 0)
      throw std::invalid_argument("\"nodes\" of ties names a node that is not there");
    last(n) = step;
    for (int d = 0; d < D; ++d)
      jump(n, d) = jumps[k + d];
    stiffness(n) = k / D < stiffnesses.size() ? stiffnesses[k / D] : 0.0;
    for (std::size_t i = 0; grows_ && i < D + 4 && (k / D + 1) * (D + 4) <= cohesions.size(); ++i)
      cohesion(n, i) = cohesions[k / D * (D + 4) + i];
  }
  Kokkos::deep_copy(stiffness_, stiffness);
  Kokkos::deep_copy(cohesion_, cohesion);
  Kokkos::deep_copy(jump_, jump);
  Kokkos::deep_copy(step_, last);
}

template class FrontTies<2>;
template class FrontTies<3>;

} // namespace Rhegma::cracks
