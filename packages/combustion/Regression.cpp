#include "combustion/Regression.hpp"

#include "state/ParticleEnergy.hpp"
#include "state/Subdomain.hpp"
#include "transfer/PushNodes.hpp"

namespace Rhegma::combustion
{

template <int D>
double Regression<D>::computeLoss(const State<D>& state, const FacePoints<D>& points, int crack,
                                  const View<double*>& depth)
{
  const std::size_t nodes = state.mesh.nodes.sums.extent(0), rows = state.stored.count;
  if (demand_.extent(0) < nodes)
  {
    demand_ = View<double*>("rhegma::combustion::demand", nodes);
    present_ = View<double*>("rhegma::combustion::present", nodes);
  }
  if (loss_.extent(0) < rows)
  {
    loss_ = View<double*>("rhegma::combustion::loss", rows + rows / 4);
    giver_ = View<int*>("rhegma::combustion::giver", rows + rows / 4);
  }
  if (state.ranks.many()) // contributions of other ranks may lie on nodes that no particle here touches
    clear(state);
  demand(state, points, crack, depth);
  sumOverRanks(state, demand_.data(), 1, 0, 1);
  findGivers(state);
  weighNodes(state);
  sumOverRanks(state, present_.data(), 1, 0, 1);
  const double given = fraction(state);
  if (!state.ranks.many())
    clearTouched(state, points);
  return given;
}

template <int D>
void Regression<D>::clear(const State<D>& state)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const View<double*> demand = demand_, present = present_;
  Kokkos::parallel_for(
      "rhegma::combustion::clear", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i) { demand(activeNode(nodes, i)) = present(activeNode(nodes, i)) = 0.0; });
}

template <int D>
void Regression<D>::clearTouched(const State<D>& state, const FacePoints<D>& points)
{
  const View<double*> demand = demand_, present = present_;
  const StencilTable<D> table = state.stored.table, above = points.above, below = points.below;
  const View<int*> giver = giver_;
  const int givers = givers_;
  forEachPushing(
      "rhegma::combustion::clearTouched", givers + points.count(), KOKKOS_LAMBDA(const int i) {
        for (int k = i - givers, e = 0; k >= 0 && e < above.count(k); ++e)
          demand(above.node(k, e)) = 0.0;
        for (int k = i - givers, e = 0; k >= 0 && e < below.count(k); ++e)
          demand(below.node(k, e)) = 0.0;
        for (int e = 0; i < givers && e < table.count(giver(i)); ++e)
          present(table.node(giver(i), e)) = 0.0;
      });
}

template <int D>
void Regression<D>::demand(const State<D>& state, const FacePoints<D>& points, int crack,
                           const View<double*>& depth)
{
  const View<int*> of = points.crack;
  const View<double*> size = points.currentSize;
  const StencilTable<D> above = points.above, below = points.below;
  const View<double*> demand = demand_;
  const double thickness = state.method.thickness;
  forEachPushing(
      "rhegma::combustion::demand", points.count(), KOKKOS_LAMBDA(const int k) {
        if (of(k) != crack || !(depth(k) > 0.0))
          return;
        const double mass = depth(k) * size(k) * thickness;
        for (int e = 0; e < above.count(k); ++e)
          Kokkos::atomic_add(&demand(above.node(k, e)), mass * above.weight(k, e));
        for (int e = 0; e < below.count(k); ++e)
          Kokkos::atomic_add(&demand(below.node(k, e)), mass * below.weight(k, e));
      });
}

template <int D>
void Regression<D>::findGivers(const State<D>& state)
{
  const StencilTable<D> table = state.stored.table;
  const View<double*> demand = demand_;
  const View<int*> giver = giver_;
  Kokkos::parallel_scan(
      "rhegma::combustion::findGivers", Kokkos::RangePolicy<ExecSpace>(0, state.stored.count),
      KOKKOS_LAMBDA(const int r, int& at, const bool final) {
        bool burns = false;
        for (int e = 0; e < table.count(r) && !burns; ++e)
          burns = demand(table.node(r, e)) > 0.0;
        if (burns && final)
          giver(at) = r;
        at += burns ? 1 : 0;
      },
      givers_);
}

template <int D>
void Regression<D>::weighNodes(const State<D>& state)
{
  const StencilTable<D> table = state.stored.table;
  const View<int*> particle = state.stored.particle;
  const View<int*> giver = giver_;
  const View<double*> present = present_;
  const auto mass = state.particles.scalar(fields::mass);
  forEachPushing(
      "rhegma::combustion::weighNodes", givers_, KOKKOS_LAMBDA(const int g) {
        const int r = giver(g);
        const double m = mass(particle(r));
        for (int e = 0; e < table.count(r); ++e)
          Kokkos::atomic_add(&present(table.node(r, e)), m * table.weight(r, e));
      });
}

template <int D>
double Regression<D>::fraction(const State<D>& state)
{
  const StencilTable<D> table = state.stored.table;
  const View<int*> particle = state.stored.particle;
  const View<int*> giver = giver_;
  const View<double*> present = present_, demand = demand_, loss = loss_;
  const auto burnt = state.particles.scalar(burntOverLeft);
  const auto mass = state.particles.scalar(fields::mass);
  double given = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::combustion::distribute", Kokkos::RangePolicy<ExecSpace>(0, givers_),
      KOKKOS_LAMBDA(const int g, double& sum) {
        const int r = giver(g), p = particle(r);
        double wanted = 0.0;
        for (int e = 0; e < table.count(r); ++e)
        {
          const int n = table.node(r, e);
          wanted += present(n) > 0.0 ? table.weight(r, e) * demand(n) / present(n) : 0.0;
        }
        // Relative to the remaining mass, which is 1 / (1 + burnt) of that at the start.
        const double ever = 1.0 - (1.0 - mostBurnt) * (1.0 + burnt(p));
        const double most = ever > 0.0 ? ever : 0.0;
        loss(g) = wanted < 0.0 ? 0.0 : wanted < most ? wanted : most;
        sum += loss(g) * mass(p);
      },
      given);
  return given;
}

template <int D>
typename Regression<D>::Loss Regression<D>::apply(State<D>& state, double coldest)
{
  Loss lost;
  const View<int*> particle = state.stored.particle;
  const View<int*> giver = giver_;
  const View<double*> loss = loss_;
  const auto burnt = state.particles.scalar(burntOverLeft);
  const ParticleEnergy<D> energy(state);
  const bool heated = !state.materials.thermo.empty();
  BorrowedView<double*> internal;
  if (heated)
    internal = state.particles.scalar(fields::internalEnergy);
  Kokkos::parallel_reduce(
      "rhegma::combustion::regress", Kokkos::RangePolicy<ExecSpace>(0, givers_),
      KOKKOS_LAMBDA(const int g, double& mass, double& with, double& warmth) {
        const int p = particle(giver(g));
        const double part = loss(g);
        if (part == 0.0)
          return;
        mass += part * energy.mass(p);
        if (heated)
        {
          const int m = energy.material(p);
          with += part * (energy.kinetic(p) + energy.volume(p) * internal(p));
          warmth += part * energy.volume(p) *
                    (ThermoPoint(energy.thermo, m, energy.temperature(p)).heat() -
                     ThermoPoint(energy.thermo, m, coldest).heat());
        }
        else
          with += part * (energy.kinetic(p) + energy.strain(p) + energy.dissipated(p));
        energy.mass(p) *= 1.0 - part;
        energy.volume(p) *= 1.0 - part;
        burnt(p) = (burnt(p) + part) / (1.0 - part);
      },
      lost.mass, lost.energy, lost.heat);
  return lost;
}

template class Regression<2>;
template class Regression<3>;

} // namespace Rhegma::combustion
