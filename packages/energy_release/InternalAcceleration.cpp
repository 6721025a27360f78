#include "energy_release/InternalAcceleration.hpp"

#include "energy_release/ForceOfPressure.hpp"
#include "state/CellFrame.hpp"
#include "state/NodalValues.hpp"
#include "state/Subdomain.hpp"
#include "transfer/Motion.hpp"
#include "transfer/NearNodes.hpp"
#include "transfer/ParticleViews.hpp"

#include <algorithm>

namespace Rhegma::energy_release
{

namespace
{

Region<2> boxOf(const Disk& disk) { return boxAround(disk.centre, disk.radius); }
const Region<3>& boxOf(const Region<3>& box) { return box; }

bool contains(const Disk& all, const Disk& part)
{
  return norm(part.centre - all.centre) + part.radius <= all.radius;
}
bool contains(const Region<3>& all, const Region<3>& part)
{
  return all.holds(part.lower) && all.holds(part.upper);
}

/// Adds the forces of a block of particles to the nodes, and their mass.
template <int D, class Range, class Connect>
struct ForceBlock
{
  static constexpr int width = D + 1, forceWidth = D == 2 ? 2 : 4;
  Connect connect;
  Range range; ///< of particles that count
  bool all;    ///< those out of the range count too
  NodalAcceleration<D> force;
  BorrowedView<double* [D]> position;
  BorrowedView<double*> mass, volume;
  BorrowedView<double * [symmetricSize<D>]> stress;
  CellFrame<D> frame;

  KOKKOS_INLINE_FUNCTION void operator()(int begin, int end) const
  {
    double* const rows = force.data();
    for (int first = begin; first < end; first += lanes)
    {
      const int last = end - first < lanes ? end : first + lanes;
      // What a few particles too many add is complete at no node that counts.
      if (all || isAnyIn(first, last))
        connect.forEachParticle(first, last, [&](int p, const auto& stencil) { add(p, stencil, rows); });
    }
  }

private:
  KOKKOS_INLINE_FUNCTION bool isAnyIn(int begin, int end) const
  {
    int in = 0;
    for (int p = begin; p < end; ++p)
    {
      Vector<D> x;
      for (int d = 0; d < D; ++d)
        x[d] = position(p, d);
      in += range.holds(x) ? 1 : 0;
    }
    return in > 0;
  }

  template <class Stencil>
  KOKKOS_INLINE_FUNCTION void add(int p, const Stencil& stencil, double* rows) const
  {
    const double v = -volume(p);
    double T[D * D];
    frame.stress(p, &stress(p, 0), T);
    Pack<forceWidth> flux[D];
    if constexpr (D == 2)
    {
      for (int j = 0; j < D; ++j)
        flux[j] = pack(v * T[j], v * T[D + j]);
      stencil.template addValue<width>(rows + D, Pack<1>{{mass(p)}});
    }
    else
    {
      for (int j = 0; j < D; ++j)
        flux[j] = pack(v * T[j], v * T[D + j], v * T[2 * D + j], 0.0);
      stencil.template addValue<width>(rows, pack(0.0, 0.0, 0.0, mass(p)));
    }
    stencil.template addFlux<width>(rows, flux);
    if constexpr (Stencil::mayHaveHoop)
      if (stencil.hasHoop())
        stencil.template addHoop<width>(rows, v * stress(p, normalIndex<D>(2)) * frame.hoopFactor(p));
  }
};

template <int D>
void clearRows(const State<D>& state, const Region<D>& box, const NodalAcceleration<D>& rows)
{
  forEachNodeIn(
      "rhegma::clearInternalForce", state, box, KOKKOS_LAMBDA(const int n, const Vector<D>&) {
        for (int i = 0; i <= D; ++i)
          rows(n, i) = 0.0;
      });
}

/// One box around all, if it has fewer nodes than they have together: rows of other nodes are not used.
template <int D>
std::vector<Region<D>> fewerBoxes(const State<D>& state, const std::vector<Region<D>>& boxes)
{
  Region<D> all = boxes.front();
  long together = 0;
  for (const Region<D>& box : boxes)
  {
    together += BoxNodes<D>(state, box).count();
    for (int d = 0; d < D; ++d)
    {
      all.lower[d] = std::min(all.lower[d], box.lower[d]);
      all.upper[d] = std::max(all.upper[d], box.upper[d]);
    }
  }
  return BoxNodes<D>(state, all).count() < together ? std::vector<Region<D>>{all} : boxes;
}

/// Springs are internal forces, as those of the material.
template <int D>
void addSprings(const State<D>& state, const NodalAcceleration<D>& force)
{
  const View<double * [D + 1]> spring = state.cracks.spring;
  if (spring.extent(0) == 0)
    return;
  const Nodes<D> nodes = state.mesh.nodes;
  Kokkos::parallel_for(
      "rhegma::internalSprings", Kokkos::RangePolicy<ExecSpace>(0, nodes.numOfCracks),
      KOKKOS_LAMBDA(const int i) {
        const int n = nodes.parent(i), m = nodes.numLattice + i;
        for (int d = 0; d < D; ++d)
        {
          force(n, d) += spring(n, d);
          force(m, d) -= spring(n, d);
        }
      });
}

} // namespace

template <int D>
void InternalAcceleration<D>::renew()
{
  isPressureKnown_ = false;
  ranges_.clear();
}

/// Sums over particles, springs and tractions, in the rows of nodes in the boxes.
template <int D>
void InternalAcceleration<D>::sumForces(const State<D>& state, const std::vector<Region<D>>& boxes)
{
  const NodalAcceleration<D> force = force_;
  if (state.mesh.subdomain) // ranks sum all shared rows
    Kokkos::deep_copy(force, 0.0);
  else
    for (const Region<D>& box : boxes)
      clearRows(state, box, force);
  // Each particle of a block is near some range if there are many.
  constexpr std::size_t few = 1;
  blocks_.find(state, boxes);
  withStraining(state,
                [&](const auto& connect)
                {
                  using Connect = std::decay_t<decltype(connect)>;
                  const ForceBlock<D, Range, Connect> block{
                      connect,
                      ranges_.front(),
                      ranges_.size() > few,
                      force,
                      state.particles.template real<D>(fields::position),
                      state.particles.scalar(fields::mass),
                      state.particles.scalar(fields::volume),
                      state.particles.template real<symmetricSize<D>>(fields::stress),
                      CellFrame<D>(state)};
                  blocks_.forEach("rhegma::internalForce", block);
                });
  // In 3D their work belongs to the integrals, as the work of all loads does.
  if (D == 2 && state.cracks.addTractions)
    state.cracks.addTractions(state, force);
  sumOverRanks(state, force.data(), D + 1, 0, D + 1);
  addSprings(state, force);
}

template <int D>
const NodalAcceleration<D>& InternalAcceleration<D>::around(const State<D>& state,
                                                            const std::vector<Range>& ranges)
{
  const std::size_t rows = state.mesh.nodes.sums.extent(0);
  if (rows_.extent(0) != rows)
  {
    rows_ = NodalAcceleration<D>("rhegma::internalAcceleration", rows);
    force_ = NodalAcceleration<D>("rhegma::internalForce", rows);
  }
  ranges_ = ranges;
  if (!haveNodalValues(state) || rows == 0 || ranges.empty())
    return rows_;
  std::vector<Region<D>> boxes; // of nodes that particles in the ranges touch
  for (const Range& range : ranges)
    boxes.push_back(nodesOf(state, boxOf(range)));
  boxes = fewerBoxes(state, boxes);
  sumForces(state, boxes);
  if (!isPressureKnown_)
    pressure_ = forceOfPressure(state);
  isPressureKnown_ = true;
  const NodalAcceleration<D> force = force_, acceleration = rows_;
  const View<double* [D]> pressure = pressure_;
  const bool pressed = pressure.extent(0) > 0;
  const Nodes<D> nodes = state.mesh.nodes;
  const View<double*> added = state.motion.relativeInertia;
  const View<int*> enriched = state.cracks.enrichedField;
  const bool slowed = added.extent(0) > 0 && enriched.extent(0) > 0;
  for (const Region<D>& box : boxes)
    forEachNodeIn(
        "rhegma::internalAcceleration", state, box, KOKKOS_LAMBDA(const int n, const Vector<D>&) {
          const double mass = force(n, D);
          const int primary = n < nodes.numLattice ? n : nodes.parent(n - nodes.numLattice);
          const bool ofCrack = slowed && n < nodes.numLattice + nodes.numOfCracks;
          const int other = !ofCrack ? -1 : n < nodes.numLattice ? enriched(n) : primary;
          const bool pair = other >= 0 && added(primary) > 0.0 && mass > 0.0 && force(other, D) > 0.0;
          for (int i = 0; i < D; ++i)
          {
            double all = force(n, i) + (pressed ? pressure(n, i) : 0.0);
            if (pair) // as in the step: slowRelativeMotion
              all -= takenByInertia(mass, force(other, D), all,
                                    force(other, i) + (pressed ? pressure(other, i) : 0.0), added(primary));
            acceleration(n, i) = mass > 0.0 ? all / mass : 0.0;
          }
          acceleration(n, D) = mass;
        });
  return rows_;
}

template <int D>
const NodalAcceleration<D>& InternalAcceleration<D>::around(const State<D>& state, const Range& range)
{
  const bool known =
      std::any_of(ranges_.begin(), ranges_.end(), [&](const Range& all) { return contains(all, range); });
  return known ? rows_ : around(state, std::vector<Range>{range});
}

template class InternalAcceleration<2>;
template class InternalAcceleration<3>;

} // namespace Rhegma::energy_release
