#include "boundary/Loads.hpp"

#include "state/FewItems.hpp"
#include "transfer/PushNodes.hpp"
#include "transfer/Stencils.hpp"

#include <cmath>

namespace Rhegma
{

namespace
{

/// Places of the load's points now.
template <int D>
void followParticles(const State<D>& state, const View<int*>& id, const View<double* [D]>& start,
                     const ObservedPoints<D>& points)
{
  const auto position = state.particles.template real<D>(fields::position);
  const auto deformation = state.particles.template real<gradientSize<D>>(fields::deformation);
  const auto reference = state.particles.template real<D>(fields::reference);
  const View<int*> indexOf = state.indexOf;
  BorrowedView<int*> side;
  const bool sides = state.particles.has(fields::side);
  if (sides)
    side = state.particles.integer(fields::side);
  forFew(
      "rhegma::placeLoad", points.count, KOKKOS_LAMBDA(const int k) {
        const int p = indexOf(id(k));
        if (sides)
          points.side(k) = side(p);
        for (int i = 0; i < D; ++i)
        {
          double x = position(p, i);
          for (int j = 0; j < D; ++j)
            x += deformation(p, i * D + j) * (start(k, j) - reference(p, j));
          points.position(k, i) = x;
        }
      });
}

/// Adds force times share to the nodes.
template <int D>
void addToNodes(const Nodes<D>& nodes, const StencilTable<D>& stencils, const View<double*>& share, int count,
                const Vector<D>& force)
{
  forEachPushing(
      "rhegma::addLoad", count, KOKKOS_LAMBDA(const int k) {
        for (int e = 0; e < stencils.count(k); ++e)
          for (int d = 0; d < D; ++d)
            Kokkos::atomic_add(&nodes.sums(stencils.node(k, e), Nodes<D>::forceAt + d),
                               stencils.weight(k, e) * share(k) * force[d]);
      });
}

/// Sum of the shares that reach nodes: 1 where none is lost.
template <int D>
double arrivedShare(const StencilTable<D>& stencils, const View<double*>& share, int count)
{
  return sumFew<double>(
      "rhegma::arrivedShare", count, KOKKOS_LAMBDA(const int k, double& sum) {
        for (int e = 0; e < stencils.count(k); ++e)
          sum += stencils.weight(k, e) * share(k);
      });
}

} // namespace

template <int D>
Load<D>::Load(std::string name, const std::vector<LoadPoint<D>>& points, const std::vector<int>& ids,
              const std::vector<Vector<D>>& carriers, const Vector<D>& force, TimeFunction history)
    : name_(std::move(name)), force_(force), history_(std::move(history))
{
  const int count = static_cast<int>(points.size());
  id_ = View<int*>("rhegma::loadId", count);
  start_ = View<double* [D]>("rhegma::loadStart", count);
  share_ = View<double*>("rhegma::loadShare", count);
  const auto id = Kokkos::create_mirror_view(id_);
  const auto start = Kokkos::create_mirror_view(start_);
  const auto share = Kokkos::create_mirror_view(share_);
  for (int k = 0; k < count; ++k)
  {
    id(k) = ids[k];
    share(k) = points[k].share;
    for (int d = 0; d < D; ++d)
      start(k, d) = carriers[k][d] + points[k].offset[d];
  }
  Kokkos::deep_copy(id_, id);
  Kokkos::deep_copy(start_, start);
  Kokkos::deep_copy(share_, share);
  points_.count = count;
  points_.position = View<double* [D]>("rhegma::loadPosition", count);
  points_.half = View<double* [D]>("rhegma::loadHalf", count);
  points_.side = View<int*>("rhegma::loadSide", count);
}

template <int D>
void Load<D>::apply(State<D>& state)
{
  now_ = history_(state.time + 0.5 * state.dt);
  followParticles(state, id_, start_, points_);
  // A light node at the rim carries its share of the stress beside it, so it must get its share of the load
  // too: else the rim's particles give way until their stress is gone, and the load works for ever.
  placeStencils(state, points_, followed_);
  const int lost = keepMassedNodes(state, points_.count, followed_, stencils_, 0.0);
  keepMassedNodes(state, points_.count, followed_, followed_);
  addToNodes(state.nodes, stencils_, share_, points_.count, now_ * force_);
  const double arrived = arrivedShare(stencils_, share_, points_.count);
  if ((lost > 0 || std::abs(arrived - 1.0) > 1e-10) && state.trouble.empty())
    state.trouble = "the load Boundaries > " + name_ +
                    " no longer reaches its body: " + std::to_string(100.0 * (1.0 - arrived)) +
                    " % of it acts where there is no material";
}

template <int D>
double Load<D>::work(const State<D>& state) const
{
  const Nodes<D> nodes = state.nodes;
  const StencilTable<D> stencils = followed_;
  const View<double*> share = share_;
  const Vector<D> force = now_ * force_;
  const double dt = state.dt;
  return sumFew<double>(
      "rhegma::loadWork", points_.count, KOKKOS_LAMBDA(const int k, double& sum) {
        for (int e = 0; e < stencils.count(k); ++e)
        {
          const int n = stencils.node(k, e);
          for (int d = 0; d < D; ++d)
          {
            const double mean = nodes.motion(n, d) - 0.5 * dt * nodes.motion(n, Nodes<D>::accelerationAt + d);
            sum += dt * stencils.weight(k, e) * share(k) * force[d] * mean;
          }
        }
      });
}

template class Load<2>;
template class Load<3>;

} // namespace Rhegma
