#include "sub_cycling/FineParticles.hpp"

#include "material/Materials.hpp"

#include <string>

namespace Rhegma::sub_cycling
{

namespace
{

/// Particles of a part of a sum; parts are no more than these many.
constexpr int particlesPerPart = 256, mostParts = 32;

using Range = Kokkos::RangePolicy<ExecSpace>;

/// Room for some more than asked for; values are lost when a view grows.
template <class AnyView>
void fit(AnyView& view, const std::string& label, int size)
{
  if (static_cast<int>(view.extent(0)) < size)
    view = AnyView(label, size + size / 4);
}

constexpr int historyRoom = historySize(LawKind::J2Plastic, 3);

} // namespace

template <int D>
void FineParticles<D>::update(const State<D>& state, int first)
{
  listParticles(state, first);
  if (numParticles_ == 0)
    return;
  listNodes(state);
  holdNodes(state);
  gatherParticles(state);
}

template <int D>
void FineParticles<D>::listParticles(const State<D>& state, int first)
{
  const int stored = state.numStored;
  fit(rowLevel_, "rhegma::subcycling::rowLevel", stored);
  fit(row_, "rhegma::subcycling::row", stored);
  fit(level_, "rhegma::subcycling::level", stored);
  if (count_.extent(0) == 0)
    count_ = View<int*>("rhegma::subcycling::count", deepestLevel + 1);
  Kokkos::deep_copy(count_, 0);
  const View<int*> rowLevel = rowLevel_, row = row_, level = level_, count = count_;
  const View<int*> nodeLevel = state.tree.nodeLevel;
  const StencilTable<D> table = state.stored;
  const Nodes<D> nodes = state.nodes;
  Kokkos::parallel_for(
      "rhegma::subcycling::levelOfParticles", Range(0, stored), KOKKOS_LAMBDA(const int r) {
        int deepest = 0;
        for (int k = 0; k < table.count(r); ++k)
        {
          const int of = nodeLevel(latticeNode(nodes, table.node(r, k)));
          deepest = of > deepest ? of : deepest;
        }
        rowLevel(r) = deepest;
        Kokkos::atomic_add(&count(deepest), 1);
      });
  Kokkos::parallel_scan(
      "rhegma::subcycling::listParticles", Range(0, stored),
      KOKKOS_LAMBDA(const int r, int& at, const bool final) {
        if (rowLevel(r) < first)
          return;
        if (final)
        {
          row(at) = r;
          level(at) = rowLevel(r);
        }
        ++at;
      },
      numParticles_);
  const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, count_);
  for (int l = deepestLevel, sum = 0; l >= 0; --l)
    countOf_[l] = sum += host(l);
}

template <int D>
int FineParticles<D>::particlesOf(int level) const
{
  return countOf_[level];
}

template <int D>
void FineParticles<D>::listNodes(const State<D>& state)
{
  const Nodes<D> nodes = state.nodes;
  const int rows = nodes.numLattice + nodes.numSecond;
  fit(slotOf_, "rhegma::subcycling::slot", rows);
  const View<int*> slotOf = slotOf_, row = row_, level = state.tree.nodeLevel;
  const StencilTable<D> table = state.stored;
  const int active = nodes.numActive();
  Kokkos::parallel_for(
      "rhegma::subcycling::clearSlots", Range(0, active),
      KOKKOS_LAMBDA(const int i) { slotOf(activeNode(nodes, i)) = -1; });
  // Whoever writes, writes the same.
  Kokkos::parallel_for(
      "rhegma::subcycling::markNodes", Range(0, numParticles_), KOKKOS_LAMBDA(const int i) {
        for (int k = 0; k < table.count(row(i)); ++k)
          slotOf(table.node(row(i), k)) = 0;
      });
  fit(nodeOf_, "rhegma::subcycling::nodeOf", active);
  fit(nodeLevel_, "rhegma::subcycling::nodeLevel", active);
  fit(mass_, "rhegma::subcycling::mass", active);
  fit(held_, "rhegma::subcycling::held", active);
  const View<int*> nodeOf = nodeOf_, nodeLevel = nodeLevel_;
  const View<double*> mass = mass_;
  const View<int* [D]> held = held_;
  Kokkos::parallel_scan(
      "rhegma::subcycling::listNodes", Range(0, active),
      KOKKOS_LAMBDA(const int i, int& at, const bool final) {
        const int n = activeNode(nodes, i);
        if (slotOf(n) < 0)
          return;
        if (final)
        {
          slotOf(n) = at;
          nodeOf(at) = n;
          nodeLevel(at) = level(latticeNode(nodes, n));
          mass(at) = nodes.sums(n, Nodes<D>::massAt);
          for (int d = 0; d < D; ++d)
            held(at, d) = 0;
        }
        ++at;
      },
      numSlots_);
  const int parts = (numParticles_ + particlesPerPart - 1) / particlesPerPart;
  numParts_ = parts < mostParts ? parts : mostParts;
  if (static_cast<int>(parts_.extent(0)) < numParts_ || static_cast<int>(parts_.extent(1)) < numSlots_)
    parts_ = View<double** [D]>("rhegma::subcycling::parts", numParts_, numSlots_ + numSlots_ / 4);
}

template <int D>
void FineParticles<D>::holdNodes(const State<D>& state)
{
  const NodePlaces<D> places = nodePlaces(state);
  const Nodes<D> nodes = state.nodes;
  const View<int*> nodeOf = nodeOf_;
  const View<int* [D]> held = held_;
  for (const NodeConstraint<D>& constraint : state.constraints)
  {
    const NodeConstraint<D> c = constraint;
    Kokkos::parallel_for(
        "rhegma::subcycling::hold", Range(0, numSlots_), KOKKOS_LAMBDA(const int i) {
          if (!c.appliesAt(places(latticeNode(nodes, nodeOf(i)))))
            return;
          for (int d = 0; d < D; ++d)
            held(i, d) = c.holds[d] ? 1 : held(i, d);
        });
  }
}

template <int D>
void FineParticles<D>::gatherParticles(const State<D>& state)
{
  fit(stress_, "rhegma::subcycling::stress", numParticles_);
  const View<double * [symmetricSize<D>]> stress = stress_;
  const View<int*> row = row_, particle = state.storedParticle;
  const auto deformation = state.particles.template real<gradientSize<D>>(fields::deformation);
  const auto material = state.particles.integer(fields::material);
  const auto materials = state.materials;
  BorrowedView<double**> history;
  if (state.particles.has(fields::history))
    history = state.particles.table(fields::history);
  Kokkos::parallel_for(
      "rhegma::subcycling::stressNow", Range(0, numParticles_), KOKKOS_LAMBDA(const int i) {
        const int p = particle(row(i));
        double F[gradientSize<D>], memory[historyRoom];
        for (int k = 0; k < gradientSize<D>; ++k)
          F[k] = deformation(p, k);
        for (int k = 0; k < static_cast<int>(history.extent(1)); ++k)
          memory[k] = history(p, k);
        updateStress<D>(materials(material(p)), F, &stress(i, 0), memory);
      });
}

template <int D>
void FineParticles<D>::load(const State<D>& state, const Values& force) const
{
  const auto sums = state.nodes.sums;
  const View<int*> nodeOf = nodeOf_;
  Kokkos::parallel_for(
      "rhegma::subcycling::load", Range(0, numSlots_), KOKKOS_LAMBDA(const int i) {
        for (int d = 0; d < D; ++d)
          force(i, d) = sums(nodeOf(i), Nodes<D>::forceAt + d);
      });
}

template <int D>
void FineParticles<D>::store(const State<D>& state, const Values& force) const
{
  const auto sums = state.nodes.sums;
  const View<int*> nodeOf = nodeOf_;
  Kokkos::parallel_for(
      "rhegma::subcycling::store", Range(0, numSlots_), KOKKOS_LAMBDA(const int i) {
        for (int d = 0; d < D; ++d)
          sums(nodeOf(i), Nodes<D>::forceAt + d) = force(i, d);
      });
}

template <int D>
template <class Add>
void FineParticles<D>::sumInParts(const char* label, int level, const Add& add)
{
  const View<int*> levels = level_;
  const View<double** [D]> parts = parts_;
  const int particles = numParticles_, slots = numSlots_, number = numParts_;
  Kokkos::parallel_for(
      label,
      Kokkos::RangePolicy<ExecSpace, Kokkos::Schedule<Kokkos::Dynamic>>(0, number, Kokkos::ChunkSize(1)),
      KOKKOS_LAMBDA(const int part) {
        double* const to = &parts(part, 0, 0);
        for (int i = 0; i < slots * D; ++i)
          to[i] = 0.0;
        const int begin = static_cast<int>(static_cast<long>(particles) * part / number);
        const int end = static_cast<int>(static_cast<long>(particles) * (part + 1) / number);
        for (int i = begin; i < end; ++i)
          if (levels(i) >= level)
            add(i, to);
      });
}

template <int D>
void FineParticles<D>::displace(const State<D>& state, int level, double factor, const Values& force,
                                const Values& displacement)
{
  const View<int*> row = row_, slotOf = slotOf_, nodeLevel = nodeLevel_, particle = state.storedParticle;
  const View<int* [D]> held = held_;
  const View<double*> nodal = mass_;
  const auto mass = state.particles.scalar(fields::mass);
  const StencilTable<D> table = state.stored;
  const Values acceleration = displacement;
  Kokkos::parallel_for(
      "rhegma::subcycling::accelerate", Range(0, numSlots_), KOKKOS_LAMBDA(const int i) {
        const double inverse = nodeLevel(i) >= level && nodal(i) > 0.0 ? 1.0 / nodal(i) : 0.0;
        for (int d = 0; d < D; ++d)
          acceleration(i, d) = held(i, d) != 0 ? 0.0 : inverse * force(i, d);
      });
  sumInParts(
      "rhegma::subcycling::roundTrip", level, KOKKOS_LAMBDA(const int i, double* to) {
        const int r = row(i);
        const int count = table.count(r);
        double own[D] = {};
        for (int k = 0; k < count; ++k)
        {
          const int slot = slotOf(table.node(r, k));
          for (int d = 0; d < D; ++d)
            own[d] += table.weight(r, k) * acceleration(slot, d);
        }
        const double m = mass(particle(r));
        for (int k = 0; k < count; ++k)
        {
          const int slot = slotOf(table.node(r, k));
          for (int d = 0; d < D; ++d)
            to[slot * D + d] += m * table.weight(r, k) * own[d];
        }
      });
  const View<double** [D]> parts = parts_;
  const int number = numParts_;
  Kokkos::parallel_for(
      "rhegma::subcycling::displace", Range(0, numSlots_), KOKKOS_LAMBDA(const int i) {
        const double inverse = nodeLevel(i) >= level && nodal(i) > 0.0 ? factor / nodal(i) : 0.0;
        for (int d = 0; d < D; ++d)
        {
          double sum = 0.0;
          for (int part = 0; part < number; ++part)
            sum += parts(part, i, d);
          displacement(i, d) = held(i, d) != 0 ? 0.0 : inverse * sum;
        }
      });
}

template <int D>
void FineParticles<D>::relax(const State<D>& state, int level, const Values& displacement, const Values& from,
                             const Values& to)
{
  const View<int*> row = row_, slotOf = slotOf_, particle = state.storedParticle;
  const StencilTable<D> table = state.stored;
  const View<double * [symmetricSize<D>]> stress = stress_;
  const auto deformation = state.particles.template real<gradientSize<D>>(fields::deformation);
  const auto volume = state.particles.scalar(fields::volume);
  const auto material = state.particles.integer(fields::material);
  const auto materials = state.materials;
  BorrowedView<double**> history;
  if (state.particles.has(fields::history))
    history = state.particles.table(fields::history);
  sumInParts(
      "rhegma::subcycling::relax", level, KOKKOS_LAMBDA(const int i, double* sums) {
        const int r = row(i), p = particle(r);
        const int count = table.count(r);
        double gradient[D][D] = {};
        for (int k = 0; k < count; ++k)
        {
          const int slot = slotOf(table.node(r, k));
          for (int a = 0; a < D; ++a)
            for (int b = 0; b < D; ++b)
              gradient[a][b] += table.slope(r, k, b) * displacement(slot, a);
        }
        double F[gradientSize<D>], tau[symmetricSize<D>], memory[historyRoom];
        for (int k = 0; k < gradientSize<D>; ++k)
          F[k] = deformation(p, k);
        for (int a = 0; a < D; ++a)
          for (int b = 0; b < D; ++b)
            for (int c = 0; c < D; ++c)
              F[a * D + b] += gradient[a][c] * deformation(p, c * D + b);
        for (int k = 0; k < static_cast<int>(history.extent(1)); ++k)
          memory[k] = history(p, k);
        updateStress<D>(materials(material(p)), F, tau, memory);
        for (int k = 0; k < symmetricSize<D>; ++k)
          tau[k] = volume(p) * (tau[k] - stress(i, k));
        for (int k = 0; k < count; ++k)
        {
          const int slot = slotOf(table.node(r, k));
          for (int a = 0; a < D; ++a)
            for (int b = 0; b < D; ++b)
              sums[slot * D + a] += tau[symmetricIndex<D>(a, b)] * table.slope(r, k, b);
        }
      });
  const View<double** [D]> parts = parts_;
  const int number = numParts_;
  Kokkos::parallel_for(
      "rhegma::subcycling::addForces", Range(0, numSlots_), KOKKOS_LAMBDA(const int i) {
        for (int d = 0; d < D; ++d)
        {
          double sum = 0.0;
          for (int part = 0; part < number; ++part)
            sum += parts(part, i, d);
          to(i, d) = from(i, d) - sum;
        }
      });
  relaxTies(state, displacement, to);
}

template <int D>
void FineParticles<D>::relaxTies(const State<D>& state, const Values& displacement, const Values& to) const
{
  const View<double * [D + 1]> tie = state.cracks.tie;
  if (tie.extent(0) == 0)
    return;
  const Nodes<D> nodes = state.nodes;
  const View<int*> slotOf = slotOf_;
  Kokkos::parallel_for(
      "rhegma::subcycling::relaxTies", Range(0, nodes.numSecond), KOKKOS_LAMBDA(const int i) {
        const int own = nodes.parent(i), a = slotOf(own), b = slotOf(nodes.numLattice + i);
        if (a < 0 || b < 0)
          return;
        for (int d = 0; d < D; ++d)
        {
          const double more = tie(own, D) * (displacement(a, d) - displacement(b, d));
          to(a, d) -= more;
          to(b, d) += more;
        }
      });
}

template class FineParticles<2>;
template class FineParticles<3>;

} // namespace Rhegma::sub_cycling
