#include "sub_cycling/FineParticles.hpp"

#include "transfer/ParticleViews.hpp"

namespace Rhegma::sub_cycling
{

namespace
{

using Range = Kokkos::RangePolicy<ExecSpace>;

} // namespace

template <int D>
void FineParticles<D>::list(const State<D>& state, int first)
{
  first_ = first;
  classifyNodes(state);
  listParticles(state);
  numInner_ = numSlots_ = numListed_ = 0;
  if (numParticles() == 0)
    return;
  markNodes(state, 0, numParticles());
  numberSlots(state, 0);
  listNeighbours(state);
  markNodes(state, numParticles(), numListed_);
  numberSlots(state, numInner_);
  packStencils(state);
  holdNodes(state);
  weighNodes(state);
}

template <int D>
void FineParticles<D>::classifyNodes(const State<D>& state)
{
  const Nodes<D> nodes = state.nodes;
  fit(nodeClass_, "rhegma::subcycling::nodeClass", nodes.numLattice + nodes.numSecond);
  fit(slotOf_, "rhegma::subcycling::slot", nodes.numLattice + nodes.numSecond);
  fit(nodeOf_, "rhegma::subcycling::nodeOf", nodes.numActive());
  const View<int*> nodeClass = nodeClass_, slotOf = slotOf_, nodeLevel = state.tree.nodeLevel;
  const StencilTable<D> table = state.stored;
  const int first = first_;
  Kokkos::parallel_for(
      "rhegma::subcycling::clearNodes", Range(0, nodes.numActive()), KOKKOS_LAMBDA(const int i) {
        nodeClass(activeNode(nodes, i)) = -1;
        slotOf(activeNode(nodes, i)) = -1;
      });
  // Particles without stored stencils touch no node of small cells.
  Kokkos::parallel_for(
      "rhegma::subcycling::classifyNodes", Range(0, state.numStored), KOKKOS_LAMBDA(const int r) {
        int deepest = 0;
        for (int k = 0; k < table.count(r); ++k)
        {
          const int of = nodeLevel(latticeNode(nodes, table.node(r, k)));
          deepest = of > deepest ? of : deepest;
        }
        if (deepest >= first)
          for (int k = 0; k < table.count(r); ++k)
            Kokkos::atomic_fetch_max(&nodeClass(table.node(r, k)), deepest);
      });
}

template <int D>
void FineParticles<D>::listParticles(const State<D>& state)
{
  const int particles = state.particles.size(), first = first_;
  fit(class_, "rhegma::subcycling::class", particles);
  fit(particle_, "rhegma::subcycling::particle", particles);
  if (classCount_.extent(0) == 0)
    classCount_ = View<int*>("rhegma::subcycling::classCount", deepestLevel + 1);
  Kokkos::deep_copy(classCount_, 0);
  const View<int*> classOf = class_, particle = particle_, classCount = classCount_, nodeClass = nodeClass_;
  withConnectivity(state,
                   [&](const auto& connect)
                   {
                     const auto see = connect;
                     Kokkos::parallel_for(
                         "rhegma::subcycling::classifyParticles", Range(0, particles),
                         KOKKOS_LAMBDA(const int p) {
                           int deepest = 0;
                           see.visit(p, [&](int node, double, const double*)
                                     { deepest = nodeClass(node) > deepest ? nodeClass(node) : deepest; });
                           classOf(p) = deepest;
                           if (deepest >= first)
                             Kokkos::atomic_add(&classCount(deepest), 1);
                         });
                   });
  const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, classCount_);
  particlesFrom_[deepestLevel + 1] = 0;
  for (int l = deepestLevel; l >= 0; --l)
  {
    const int before = particlesFrom_[l + 1];
    particlesFrom_[l] = before + host(l);
    if (host(l) > 0)
      Kokkos::parallel_scan(
          "rhegma::subcycling::listParticles", Range(0, particles),
          KOKKOS_LAMBDA(const int p, int& at, const bool final) {
            if (classOf(p) != l)
              return;
            if (final)
              particle(before + at) = p;
            ++at;
          });
  }
}

template <int D>
void FineParticles<D>::markNodes(const State<D>& state, int begin, int end)
{
  const View<int*> nodeClass = nodeClass_, particle = particle_, classOf = class_;
  withConnectivity(state,
                   [&](const auto& connect)
                   {
                     const auto see = connect;
                     Kokkos::parallel_for(
                         "rhegma::subcycling::markNodes", Range(begin, end), KOKKOS_LAMBDA(const int i) {
                           const int p = particle(i);
                           const int own = classOf(p);
                           see.visit(p, [&](int node, double, const double*)
                                     { Kokkos::atomic_fetch_max(&nodeClass(node), own); });
                         });
                   });
}

template <int D>
void FineParticles<D>::numberSlots(const State<D>& state, int from)
{
  const Nodes<D> nodes = state.nodes;
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
void FineParticles<D>::listNeighbours(const State<D>& state)
{
  const int first = first_, before = numParticles();
  const View<int*> particle = particle_, classOf = class_, slotOf = slotOf_;
  int more = 0;
  withConnectivity(state,
                   [&](const auto& connect)
                   {
                     const auto see = connect;
                     Kokkos::parallel_scan(
                         "rhegma::subcycling::listNeighbours", Range(0, state.particles.size()),
                         KOKKOS_LAMBDA(const int p, int& at, const bool final) {
                           if (classOf(p) >= first)
                             return;
                           bool touches = false;
                           see.visit(p, [&](int node, double, const double*)
                                     { touches = touches || slotOf(node) >= 0; });
                           if (!touches)
                             return;
                           if (final)
                             particle(before + at) = p;
                           ++at;
                         },
                         more);
                   });
  numListed_ = before + more;
}

template <int D>
void FineParticles<D>::packStencils(const State<D>& state)
{
  if (static_cast<int>(count_.extent(0)) < numListed_)
  {
    const int rows = numListed_ + numListed_ / 4;
    count_ = View<int*>("rhegma::subcycling::count", rows);
    reach_ = View<int*>("rhegma::subcycling::reach", rows);
    slot_ = View<int**>("rhegma::subcycling::slots", rows, stencilCapacity<D>);
    weight_ = View<double**>("rhegma::subcycling::weights", rows, stencilCapacity<D>);
    slope_ = View<double** [D]>("rhegma::subcycling::slopes", rows, stencilCapacity<D>);
  }
  const View<int*> count = count_, reach = reach_, particle = particle_, slotOf = slotOf_,
                   nodeClass = nodeClass_;
  const View<int**> slot = slot_;
  const View<double**> weight = weight_;
  const View<double** [D]> slope = slope_;
  withConnectivity(state,
                   [&](const auto& connect)
                   {
                     const auto see = connect;
                     Kokkos::parallel_for(
                         "rhegma::subcycling::packStencils", Range(0, numListed_),
                         KOKKOS_LAMBDA(const int i) {
                           int k = 0, deepest = 0;
                           see.visit(particle(i),
                                     [&](int node, double w, const double* gradient)
                                     {
                                       slot(i, k) = slotOf(node);
                                       deepest = nodeClass(node) > deepest ? nodeClass(node) : deepest;
                                       weight(i, k) = w;
                                       for (int d = 0; d < D; ++d)
                                         slope(i, k, d) = gradient[d];
                                       ++k;
                                     });
                           count(i) = k;
                           reach(i) = deepest;
                         });
                   });
}

template <int D>
void FineParticles<D>::holdNodes(const State<D>& state)
{
  fit(held_, "rhegma::subcycling::held", numSlots_);
  fit(heldVelocity_, "rhegma::subcycling::heldVelocity", numSlots_);
  const NodePlaces<D> places = nodePlaces(state);
  const Nodes<D> nodes = state.nodes;
  const View<int*> nodeOf = nodeOf_;
  const View<int* [D]> held = held_;
  const View<double* [D]> velocity = heldVelocity_;
  Kokkos::deep_copy(held_, 0);
  for (const NodeConstraint<D>& constraint : state.constraints)
  {
    const NodeConstraint<D> c = constraint;
    Kokkos::parallel_for(
        "rhegma::subcycling::hold", Range(0, numSlots_), KOKKOS_LAMBDA(const int i) {
          const int n = latticeNode(nodes, nodeOf(i));
          if (!c.appliesAt(places(n)))
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
void FineParticles<D>::weighNodes(const State<D>& state)
{
  fit(mass_, "rhegma::subcycling::mass", numSlots_);
  const View<double*> mass = mass_;
  const View<int*> nodeOf = nodeOf_;
  const auto sums = state.nodes.sums;
  Kokkos::parallel_for(
      "rhegma::subcycling::massOfNodes", Range(0, numSlots_),
      KOKKOS_LAMBDA(const int i) { mass(i) = sums(nodeOf(i), Nodes<D>::massAt); });
}

template void FineParticles<2>::list(const State<2>&, int);
template void FineParticles<3>::list(const State<3>&, int);

} // namespace Rhegma::sub_cycling
