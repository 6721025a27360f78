#include "sub_cycling/FineParticles.hpp"

#include "parallel/NeighbourSums.hpp"
#include "state/Subdomain.hpp"
#include "transfer/ParticleViews.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace Rhegma::sub_cycling
{

namespace
{

using Range = Kokkos::RangePolicy<ExecSpace>;

/// Weight up to which a particle does not touch a node. Where the edge of its box lies on a node, as in
/// bodies at the start, it reaches into the next cell by round-off e, with a weight of order e^2 and a slope
/// of order e; the choice of subcycled nodes must not depend on it.
constexpr double noWeight = 1e-20;

/// Extrapolated weights may be negative.
KOKKOS_INLINE_FUNCTION bool isTouched(double weight) { return weight > noWeight || weight < -noWeight; }

/// Code of a class, such that the sum over ranks shows the deepest: sums of up to 127 ranks stay below the
/// code of the next class, with round-off.
KOKKOS_INLINE_FUNCTION double codeOf(int own) { return static_cast<double>(1LL << 7 * own); }
static_assert(7 * deepestLevel < 63);

/// Calls visit(node, weight, slopes) for each node that a particle touches.
template <class Connect, class Visit>
KOKKOS_INLINE_FUNCTION void visitTouched(const Connect& connect, int p, const Visit& visit)
{
  connect.visitStraining(p,
                         [&](int node, double weight, const typename Connect::Slopes& slopes)
                         {
                           if (isTouched(weight))
                             visit(node, weight, slopes);
                         });
}

// Kernels over particles and the nodes that they touch; functions of their own, as compilers for devices want
// no kernel in a generic lambda.

/// Lists the nodes that each candidate touches.
template <int D, class Connect>
void listTouched(const Connect& connect, int count, const View<int*>& candidate, const View<int*>& numTouched,
                 const View<int * [stencilCapacity<D>]>& touched)
{
  Kokkos::parallel_for(
      "rhegma::subcycling::listTouched", Range(0, count), KOKKOS_LAMBDA(const int i) {
        int* const to = &touched(i, 0);
        int k = 0;
        visitTouched(connect, candidate(i), [&](int node, double, const auto&) { to[k++] = node; });
        numTouched(i) = k;
      });
}

/// Stencils by slot, and the class of each particle's deepest node.
template <int D>
struct Packed
{
  View<int*> count, reach;
  View<int * [stencilCapacity<D>]> slot;
  View<double * [stencilCapacity<D>]> weight;
  View<double***> slope;
};

template <int D, class Connect>
void pack(const Connect& connect, int number, const View<int*>& particle, const View<int*>& slotOf,
          const View<int*>& nodeClass, const Packed<D>& to)
{
  Kokkos::parallel_for(
      "rhegma::subcycling::packStencils", Range(0, number), KOKKOS_LAMBDA(const int i) {
        int k = 0, deepest = 0;
        int* const slot = &to.slot(i, 0);
        double* const weight = &to.weight(i, 0);
        double* const slope = &to.slope(i, 0, 0);
        visitTouched(connect, particle(i),
                     [&](int node, double w, const typename Connect::Slopes& slopes)
                     {
                       slot[k] = slotOf(node);
                       deepest = nodeClass(node) > deepest ? nodeClass(node) : deepest;
                       weight[k] = w;
                       for (int c = 0; c < slopes.size; ++c)
                         slope[k * slopes.size + c] = slopes.of[c];
                       ++k;
                     });
        to.count(i) = k;
        to.reach(i) = deepest;
      });
}

} // namespace

template <int D>
void FineParticles<D>::select(const State<D>& state, int first)
{
  const StencilSource& source = state.stored.source;
  if (source.isKnown() && source == madeOf_ && first == first_)
  {
    if (numParticles() > 0.0)
    {
      holdNodes(state);
      weighNodes(state);
    }
    return;
  }
  madeOf_ = source;
  first_ = first;
  candidates_.find(state);
  findTouched(state);
  classifyNodes(state);
  listParticles(state);
  numInner_ = numSlots_ = numListed_ = 0;
  std::copy(std::begin(particlesFrom_), std::end(particlesFrom_), std::begin(onAllRanks_));
  sumParts(state, onAllRanks_, deepestLevel + 2);
  if (numParticles() == 0.0)
    return;
  // Coarse classes first, so that the deepest class of a node remains.
  for (int l = first; l <= state.mesh.tree.deepest; ++l)
    markNodes(particlesFrom_[l + 1], particlesFrom_[l], l, false);
  fractionClasses(state);
  numberSlots(state, 0);
  listNeighbours();
  markNodes(particlesFrom_[first_], numListed_, 0, true);
  fractionClasses(state);
  numberSlots(state, numInner_);
  packStencils(state);
  holdNodes(state);
  weighNodes(state);
}

template <int D>
void FineParticles<D>::findTouched(const State<D>& state)
{
  const int count = candidates_.count();
  fit(numTouched_, "rhegma::subcycling::numTouched", count);
  fit(touched_, "rhegma::subcycling::touched", count);
  withConnectivity(state, [&](const auto& connect)
                   { listTouched<D>(connect, count, candidates_.particles(), numTouched_, touched_); });
}

template <int D>
void FineParticles<D>::classifyNodes(const State<D>& state)
{
  const Nodes<D> nodes = state.mesh.nodes;
  fit(nodeClass_, "rhegma::subcycling::nodeClass", nodes.numLattice + nodes.numEnriched);
  fit(slotOf_, "rhegma::subcycling::slot", nodes.numLattice + nodes.numEnriched);
  fit(nodeOf_, "rhegma::subcycling::nodeOf", nodes.numActive());
  fit(class_, "rhegma::subcycling::class", candidates_.count());
  const View<int*> nodeClass = nodeClass_, slotOf = slotOf_, nodeLevel = state.mesh.tree.nodeLevel,
                   classOf = class_, numTouched = numTouched_;
  const View<int * [stencilCapacity<D>]> touched = touched_;
  Kokkos::parallel_for(
      "rhegma::subcycling::clearNodes", Range(0, nodes.numActive()), KOKKOS_LAMBDA(const int i) {
        nodeClass(activeNode(nodes, i)) = -1;
        slotOf(activeNode(nodes, i)) = -1;
      });
  Kokkos::parallel_for(
      "rhegma::subcycling::levelOfParticles", Range(0, candidates_.count()), KOKKOS_LAMBDA(const int i) {
        int deepest = 0;
        for (int k = 0; k < numTouched(i); ++k)
        {
          const int of = nodeLevel(latticeNode(nodes, touched(i, k)));
          deepest = of > deepest ? of : deepest;
        }
        classOf(i) = deepest;
      });
  // One class after the other, so that concurrent writes are equal.
  for (int l = first_; l <= state.mesh.tree.deepest; ++l)
    Kokkos::parallel_for(
        "rhegma::subcycling::classifyNodes", Range(0, candidates_.count()), KOKKOS_LAMBDA(const int i) {
          for (int k = 0; classOf(i) == l && k < numTouched(i); ++k)
            nodeClass(touched(i, k)) = l;
        });
  fractionClasses(state);
}

template <int D>
void FineParticles<D>::fractionClasses(const State<D>& state)
{
  if (!state.mesh.subdomain)
    return;
  const Nodes<D> nodes = state.mesh.nodes;
  fit(reported_, "rhegma::subcycling::classesOfRanks", nodes.numLattice + nodes.numEnriched);
  const View<double*> reported = reported_;
  const View<int*> nodeClass = nodeClass_, shared = state.mesh.subdomain->halo.nodes();
  const SharedRows rows = sharedRows(state);
  const int number = static_cast<int>(shared.extent(0)), fields = rows.enrichedField.extent(0) > 0 ? 2 : 1;
  Kokkos::parallel_for(
      "rhegma::subcycling::reportClasses", Range(0, number), KOKKOS_LAMBDA(const int i) {
        for (int f = 0; f < fields; ++f)
        {
          const int n = rows(shared(i), f);
          if (n >= 0)
            reported(n) = nodeClass(n) < 0 ? 0.0 : codeOf(nodeClass(n));
        }
      });
  sumOverRanks(state, reported.data(), 1, 0, 1);
  Kokkos::parallel_for(
      "rhegma::subcycling::hearClasses", Range(0, number), KOKKOS_LAMBDA(const int i) {
        for (int f = 0; f < fields; ++f)
        {
          const int n = rows(shared(i), f);
          for (int l = deepestLevel; n >= 0 && l > nodeClass(n); --l)
            if (reported(n) >= codeOf(l))
              nodeClass(n) = l;
        }
      });
}

template <int D>
int FineParticles<D>::listClass(int own, int before)
{
  const View<int*> classOf = class_, candidate = candidates_.particles(), particle = particle_,
                   listed = listed_;
  int more = 0;
  Kokkos::parallel_scan(
      "rhegma::subcycling::listParticles", Range(0, candidates_.count()),
      KOKKOS_LAMBDA(const int i, int& at, const bool final) {
        if (classOf(i) != own)
          return;
        if (final)
        {
          particle(before + at) = candidate(i);
          listed(before + at) = i;
        }
        ++at;
      },
      more);
  return before + more;
}

template <int D>
void FineParticles<D>::listParticles(const State<D>& state)
{
  fit(particle_, "rhegma::subcycling::particle", candidates_.count());
  fit(listed_, "rhegma::subcycling::listed", candidates_.count());
  const View<int*> classOf = class_, numTouched = numTouched_, nodeClass = nodeClass_;
  const View<int * [stencilCapacity<D>]> touched = touched_;
  Kokkos::parallel_for(
      "rhegma::subcycling::classifyParticles", Range(0, candidates_.count()), KOKKOS_LAMBDA(const int i) {
        int deepest = 0;
        for (int k = 0; k < numTouched(i); ++k)
        {
          const int of = nodeClass(touched(i, k));
          deepest = of > deepest ? of : deepest;
        }
        classOf(i) = deepest;
      });
  for (int& number : particlesFrom_)
    number = 0;
  for (int l = state.mesh.tree.deepest; l >= first_; --l)
    particlesFrom_[l] = listClass(l, particlesFrom_[l + 1]);
}

template <int D>
void FineParticles<D>::markNodes(int begin, int end, int own, bool onlyNew)
{
  const View<int*> listed = listed_, numTouched = numTouched_, nodeClass = nodeClass_;
  const View<int * [stencilCapacity<D>]> touched = touched_;
  Kokkos::parallel_for(
      "rhegma::subcycling::markNodes", Range(begin, end), KOKKOS_LAMBDA(const int i) {
        const int from = listed(i);
        for (int k = 0; k < numTouched(from); ++k)
          if (!onlyNew || nodeClass(touched(from, k)) < 0)
            nodeClass(touched(from, k)) = own;
      });
}

template <int D>
void FineParticles<D>::numberSlots(const State<D>& state, int from)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const View<int*> nodeOf = nodeOf_, nodeClass = nodeClass_, slotOf = slotOf_;
  int more = 0;
  Kokkos::parallel_scan(
      "rhegma::subcycling::numberSlots", Range(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i, int& at, const bool final) {
        const int n = activeNode(nodes, i);
        if (nodeClass(n) < 0 || (slotOf(n) >= 0 && slotOf(n) < from))
          return;
        if (final)
        {
          nodeOf(from + at) = n;
          slotOf(n) = from + at;
        }
        ++at;
      },
      more);
  numSlots_ = from + more;
  if (from == 0)
    numInner_ = numSlots_;
}

template <int D>
void FineParticles<D>::listNeighbours()
{
  const View<int*> classOf = class_, numTouched = numTouched_, slotOf = slotOf_;
  const View<int * [stencilCapacity<D>]> touched = touched_;
  const int first = first_;
  // Of candidates of classes before the first: class 0 for those that touch a node with a slot, else -1.
  Kokkos::parallel_for(
      "rhegma::subcycling::findNeighbours", Range(0, candidates_.count()), KOKKOS_LAMBDA(const int i) {
        if (classOf(i) >= first)
          return;
        bool touches = false;
        for (int k = 0; !touches && k < numTouched(i); ++k)
          touches = slotOf(touched(i, k)) >= 0;
        classOf(i) = touches ? 0 : -1;
      });
  numListed_ = listClass(0, particlesFrom_[first_]);
}

template <int D>
void FineParticles<D>::packStencils(const State<D>& state)
{
  if (static_cast<int>(count_.extent(0)) < numListed_)
  {
    const int rows = numListed_ + numListed_ / 4;
    count_ = View<int*>("rhegma::subcycling::count", rows);
    reach_ = View<int*>("rhegma::subcycling::reach", rows);
    slot_ = View<int * [stencilCapacity<D>]>("rhegma::subcycling::slots", rows);
    weight_ = View<double * [stencilCapacity<D>]>("rhegma::subcycling::weights", rows);
    const int slopes = state.method.shear == ShearStrain::AtCellCentres ? D * D : D;
    slope_ = View<double***>("rhegma::subcycling::slopes", rows, stencilCapacity<D>, slopes);
  }
  const Packed<D> to{count_, reach_, slot_, weight_, slope_};
  withStraining(state, [&](const auto& connect)
                { pack<D>(connect, numListed_, particle_, slotOf_, nodeClass_, to); });
}

template <int D>
void FineParticles<D>::holdNodes(const State<D>& state)
{
  fit(held_, "rhegma::subcycling::held", numSlots_);
  fit(heldVelocity_, "rhegma::subcycling::heldVelocity", numSlots_);
  const NodePositions<D> positions = nodePositions(state);
  const Nodes<D> nodes = state.mesh.nodes;
  const View<int*> nodeOf = nodeOf_;
  const View<int* [D]> held = held_;
  const View<double* [D]> velocity = heldVelocity_;
  Kokkos::deep_copy(held_, 0);
  for (const NodeConstraint<D>& constraint : state.motion.constraints)
  {
    const NodeConstraint<D> c = constraint;
    Kokkos::parallel_for(
        "rhegma::subcycling::hold", Range(0, numSlots_), KOKKOS_LAMBDA(const int i) {
          const int n = latticeNode(nodes, nodeOf(i));
          if (!c.appliesAt(positions(n)))
            return;
          for (int d = 0; d < D; ++d)
            if (c.holds[d])
            {
              held(i, d) = 1;
              velocity(i, d) = c.at(n, d);
            }
        });
  }
}

template <int D>
void FineParticles<D>::writeFirstFractions(const State<D>& state, const BorrowedView<double*>& fraction) const
{
  const View<int*> particle = particle_;
  for (int l = first_; l <= state.mesh.tree.deepest; ++l)
  {
    const double own = std::ldexp(1.0, first_ - 1 - l);
    Kokkos::parallel_for(
        "rhegma::subcycling::firstFractions", Range(particlesFrom_[l + 1], particlesFrom_[l]),
        KOKKOS_LAMBDA(const int i) { fraction(particle(i)) = own; });
  }
}

template <int D>
void FineParticles<D>::weighNodes(const State<D>& state)
{
  fit(mass_, "rhegma::subcycling::mass", numSlots_);
  const View<double*> mass = mass_;
  const View<int*> nodeOf = nodeOf_;
  const auto sums = state.mesh.nodes.sums;
  Kokkos::parallel_for(
      "rhegma::subcycling::massOfNodes", Range(0, numSlots_),
      KOKKOS_LAMBDA(const int i) { mass(i) = sums(nodeOf(i), Nodes<D>::massAt); });
}

template void FineParticles<2>::select(const State<2>&, int);
template void FineParticles<3>::select(const State<3>&, int);
template void FineParticles<2>::writeFirstFractions(const State<2>&, const BorrowedView<double*>&) const;
template void FineParticles<3>::writeFirstFractions(const State<3>&, const BorrowedView<double*>&) const;

} // namespace Rhegma::sub_cycling
