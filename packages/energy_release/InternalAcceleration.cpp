#include "energy_release/InternalAcceleration.hpp"

#include "energy_release/ForceOfPressure.hpp"
#include "state/NodalValues.hpp"
#include "state/Subdomain.hpp"
#include "transfer/ParticleViews.hpp"

namespace Rhegma::energy_release
{

namespace
{

/// Adds the forces of a block of particles to the nodes.
template <int D, class Range, class Connect>
struct ForceBlock
{
  Connect connect;
  Range range;
  NodalAcceleration<D> force;
  BorrowedView<double* [D]> position;
  BorrowedView<double*> mass, volume;
  BorrowedView<double * [symmetricSize<D>]> stress;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    for (int p = begin; p < end; ++p)
    {
      Vector<D> x;
      for (int d = 0; d < D; ++d)
        x[d] = position(p, d);
      if (!range.holds(x))
        continue;
      connect.visitStraining(p,
                             [&](int node, double fraction, const typename Connect::Slopes& slopes)
                             {
                               force(node, D) += fraction * mass(p);
                               for (int i = 0; i < D; ++i)
                                 for (int j = 0; j < D; ++j)
                                   force(node, i) -=
                                       volume(p) * stress(p, symmetricIndex<D>(i, j)) * slopes(i, j);
                             });
    }
  }
};

/// Springs are internal forces, as those of the material.
template <int D>
void addSprings(const State<D>& state, const NodalAcceleration<D>& force)
{
  const View<double * [D + 1]> spring = state.cracks.spring;
  if (spring.extent(0) == 0)
    return;
  const Nodes<D> nodes = state.mesh.nodes;
  Kokkos::parallel_for(
      "rhegma::internalSprings", Kokkos::RangePolicy<ExecSpace>(0, nodes.numEnriched),
      KOKKOS_LAMBDA(const int i) {
        const int n = nodes.parent(i), m = nodes.numLattice + i;
        for (int d = 0; d < D; ++d)
        {
          force(n, d) += spring(n, d);
          force(m, d) -= spring(n, d);
        }
      });
}

/// Adds forces on nodes [N].
template <int D>
void addForces(const View<double* [D]>& added, const NodalAcceleration<D>& force)
{
  Kokkos::parallel_for(
      "rhegma::addNodalForces", Kokkos::RangePolicy<ExecSpace>(0, added.extent(0)),
      KOKKOS_LAMBDA(const int n) {
        for (int d = 0; d < D; ++d)
          force(n, d) += added(n, d);
      });
}

template <int D>
void divideByMass(const NodalAcceleration<D>& force)
{
  Kokkos::parallel_for(
      "rhegma::internalAcceleration", Kokkos::RangePolicy<ExecSpace>(0, force.extent(0)),
      KOKKOS_LAMBDA(const int n) {
        const double mass = force(n, D);
        for (int i = 0; i < D; ++i)
          force(n, i) = mass > 0.0 ? force(n, i) / mass : 0.0;
      });
}

} // namespace

template <int D>
const NodalAcceleration<D>& InternalAcceleration<D>::around(const State<D>& state, const Range& range)
{
  if (rows_.extent(0) != state.mesh.nodes.sums.extent(0))
    rows_ = NodalAcceleration<D>("rhegma::internalForce", state.mesh.nodes.sums.extent(0));
  else
    Kokkos::deep_copy(rows_, 0.0);
  if (!haveNodalValues(state) || rows_.extent(0) == 0)
    return rows_;
  withStraining(state,
                [&](const auto& connect)
                {
                  using Connect = std::decay_t<decltype(connect)>;
                  const ForceBlock<D, Range, Connect> block{
                      connect,
                      range,
                      rows_,
                      state.particles.template real<D>(fields::position),
                      state.particles.scalar(fields::mass),
                      state.particles.scalar(fields::volume),
                      state.particles.template real<symmetricSize<D>>(fields::stress)};
                  forEachBlock("rhegma::internalForce", state.mesh.blocks, block);
                });
  // In 3D their work belongs to the integrals, as the work of all loads does.
  if (D == 2 && state.cracks.addTractions)
    state.cracks.addTractions(state, rows_);
  sumOverRanks(state, rows_.data(), D + 1, 0, D + 1);
  addSprings(state, rows_);
  if (!isPressureKnown_)
    pressure_ = forceOfPressure(state);
  isPressureKnown_ = true;
  addForces<D>(pressure_, rows_);
  divideByMass<D>(rows_);
  return rows_;
}

template class InternalAcceleration<2>;
template class InternalAcceleration<3>;

} // namespace Rhegma::energy_release
