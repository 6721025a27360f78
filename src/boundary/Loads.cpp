#include "boundary/Loads.hpp"

#include "base/SmallLoops.hpp"
#include "boundary/LoadVelocity.hpp"
#include "state/BodyGroup.hpp"
#include "transfer/PushNodes.hpp"
#include "transfer/Stencils.hpp"

#include <cmath>

namespace Rhegma
{

namespace
{

/// Positions of the load's points now. \param here becomes the fraction of points whose particle is on this
/// rank, and zero for others, which are put at some position of this rank's lattice
template <int D>
void updateParticles(const State<D>& state, const View<int*>& id, const View<double* [D]>& start,
                     const View<double*>& fraction, const View<double*>& here,
                     const ObservedPoints<D>& points)
{
  const Grid<D> grid = state.mesh.grid;
  const auto position = state.particles.template real<D>(fields::position);
  const auto deformation = state.particles.template real<gradientSize<D>>(fields::deformation);
  const auto reference = state.particles.template real<D>(fields::reference);
  const View<int*> indexOf = state.particles.indexOf;
  const bool undeformed = state.method.totalLagrangian;
  const ParticleSides sides(state.particles);
  parallelForSmall(
      "rhegma::placeLoad", points.count, KOKKOS_LAMBDA(const int k) {
        const int p = indexOf(id(k));
        here(k) = p < 0 ? 0.0 : fraction(k);
        if (p < 0)
        {
          for (int d = 0; d < D; ++d)
            points.position(k, d) = grid.origin[d] + gridMargin * grid.spacing;
          return;
        }
        sides.copy(p, points, k);
        for (int i = 0; i < D; ++i)
        {
          double x = position(p, i);
          for (int j = 0; j < D; ++j)
          {
            const double F = undeformed ? (i == j ? 1.0 : 0.0) : deformation(p, i * D + j);
            x += F * (start(k, j) - reference(p, j));
          }
          points.position(k, i) = x;
        }
      });
}

template <int D>
LoadForce<D> scaled(double factor, const LoadForce<D>& force)
{
  return {factor * force.even, factor * force.alongNormals};
}

/// Adds force times fraction to the nodes.
template <int D>
void addToNodes(const Nodes<D>& nodes, const StencilTable<D>& stencils, const View<double*>& fraction,
                const View<double* [D]>& normal, int count, const LoadForce<D>& force)
{
  forEachPushing(
      "rhegma::addLoad", count, KOKKOS_LAMBDA(const int k) {
        for (int e = 0; e < stencils.count(k); ++e)
          for (int d = 0; d < D; ++d)
            Kokkos::atomic_add(&nodes.sums(stencils.node(k, e), Nodes<D>::forceAt + d),
                               stencils.weight(k, e) * fraction(k) * force.at(normal, k, d));
      });
}

/// Sum of the fractions that reach no node.
template <int D>
double lostFraction(const StencilTable<D>& stencils, const View<double*>& fraction, int count)
{
  return parallelSumSmall<double>(
      "rhegma::lostFraction", count, KOKKOS_LAMBDA(const int k, double& sum) {
        sum += fraction(k);
        for (int e = 0; e < stencils.count(k); ++e)
          sum -= stencils.weight(k, e) * fraction(k);
      });
}

/// Number of sides of the piece that a point represents: none for a point load, one for a line.
template <int D>
int sidesOf(const LoadPoint<D>& point)
{
  int count = 0;
  while (count < D - 1 && norm(point.side[count]) > 0.0)
    ++count;
  return count;
}

} // namespace

template <int D>
Load<D>::Load(std::string name, const std::vector<LoadPoint<D>>& points, const std::vector<int>& ids,
              const std::vector<Vector<D>>& carriers, const LoadForce<D>& force, TimeFunction history)
    : whole_(points),
      carrier_(ids),
      carrierStart_(carriers),
      wholeId_("rhegma::loadWholeId", points.size()),
      level_("rhegma::loadLevel", points.size()),
      name_(std::move(name)),
      force_(force),
      resultant_(force.even),
      history_(std::move(history))
{
  const auto id = Kokkos::create_mirror_view(wholeId_);
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    id(k) = ids[k];
    resultant_ = resultant_ + force.alongNormals * points[k].fraction * points[k].normal;
  }
  Kokkos::deep_copy(wholeId_, id);
  makePoints(std::vector<int>(points.size(), 0));
}

template <int D>
void Load<D>::makePoints(const std::vector<int>& levels)
{
  const auto parts = [&](std::size_t k) { return 1 << (sidesOf(whole_[k]) * levels[k]); };
  int count = 0;
  for (std::size_t k = 0; k < whole_.size(); ++k)
    count += parts(k);
  id_ = View<int*>("rhegma::loadId", count);
  start_ = View<double* [D]>("rhegma::loadStart", count);
  normal_ = View<double* [D]>("rhegma::loadNormal", count);
  fraction_ = View<double*>("rhegma::loadFraction", count);
  here_ = View<double*>("rhegma::loadFractionHere", count);
  const auto id = Kokkos::create_mirror_view(id_);
  const auto start = Kokkos::create_mirror_view(start_);
  const auto normal = Kokkos::create_mirror_view(normal_);
  const auto fraction = Kokkos::create_mirror_view(fraction_);
  int at = 0;
  for (std::size_t k = 0; k < whole_.size(); ++k)
  {
    const int along = 1 << levels[k];
    for (int part = 0; part < parts(k); ++part, ++at)
    {
      id(at) = carrier_[k];
      fraction(at) = whole_[k].fraction / parts(k);
      Vector<D> x = carrierStart_[k] + whole_[k].offset;
      int rest = part;
      for (int s = 0; s < sidesOf(whole_[k]); ++s, rest /= along)
        x = x + ((rest % along + 0.5) / along - 0.5) * whole_[k].side[s];
      for (int d = 0; d < D; ++d)
      {
        start(at, d) = x[d];
        normal(at, d) = whole_[k].normal[d];
      }
    }
  }
  Kokkos::deep_copy(id_, id);
  Kokkos::deep_copy(start_, start);
  Kokkos::deep_copy(normal_, normal);
  Kokkos::deep_copy(fraction_, fraction);
  points_.count = count;
  points_.position = View<double* [D]>("rhegma::loadPosition", count);
  points_.half = View<double* [D]>("rhegma::loadHalf", count);
  points_.side = View<int*>("rhegma::loadSide", count);
  points_.group = View<int*>();
}

template <int D>
void Load<D>::updateLevels(const State<D>& state)
{
  if (!state.particles.has(fields::level))
    return;
  const auto level = state.particles.integer(fields::level);
  const View<int*> indexOf = state.particles.indexOf, id = wholeId_, last = level_;
  int changed = 0;
  Kokkos::parallel_reduce(
      "rhegma::levelsOfLoad", Kokkos::RangePolicy<ExecSpace>(0, id.extent(0)),
      KOKKOS_LAMBDA(const int k, int& sum) {
        const int p = indexOf(id(k)); // -1 where another rank has it
        const int now = p < 0 ? last(k) : level(p);
        sum += now != last(k) ? 1 : 0;
        last(k) = now;
      },
      changed);
  if (changed == 0)
    return;
  const auto host = onHost(level_);
  std::vector<int> levels(whole_.size());
  for (std::size_t k = 0; k < levels.size(); ++k)
    levels[k] = host(k);
  makePoints(levels);
}

template <int D>
void Load<D>::apply(State<D>& state)
{
  now_ = loadOverStep(state, history_);
  place(state);
  addToNodes(state.mesh.nodes, stencils_, here_, normal_, points_.count, scaled(now_.acts, force_));
}

template <int D>
void Load<D>::place(State<D>& state)
{
  updateLevels(state);
  ParticleSides(state.particles).reserve("rhegma::loadGroup", points_.count, points_);
  updateParticles(state, id_, start_, fraction_, here_, points_);
  // A light node at the rim bears its fraction of the stress next to it, so it must also get its fraction of
  // the load: otherwise the particles at the rim yield until their stress vanishes, and the load does work
  // without end.
  placeStencils(state, points_, massedStencils_);
  keepMassedNodes(state, points_.count, massedStencils_, stencils_, 0.0);
  keepMassedNodes(state, points_.count, massedStencils_, massedStencils_);
  const double lost = lostFraction(stencils_, here_, points_.count);
  if (std::abs(lost) > 1e-10 && state.failure.empty())
    state.failure = "the load Boundaries > " + name_ +
                    " no longer acts on its body: " + std::to_string(100.0 * lost) +
                    " % of it acts where there is no material";
}

template <int D>
void Load<D>::addWork(State<D>& state) const
{
  addWorkOfLoad(state, now_,
                [&](const auto& velocity, double value)
                { return workOf(state, velocity, scaled(value, force_)); });
}

template <int D>
double Load<D>::shift(const State<D>& state) const
{
  const double whole = norm(force_.even) + std::abs(force_.alongNormals);
  return whole > 0.0 ? workOf(state, LoadVelocity<D>(state), scaled(1.0 / whole, force_)) : 0.0;
}

template <int D>
template <class Velocity>
double Load<D>::workOf(const State<D>& state, const Velocity& velocity, const LoadForce<D>& force) const
{
  // No light node moves on its own in equilibrium: work is that of the forces as they act.
  const StencilTable<D> stencils = state.method.equilibrium() ? stencils_ : massedStencils_;
  const View<double*> fraction = here_;
  const View<double* [D]> normal = normal_;
  const double dt = state.clock.dt;
  return parallelSumSmall<double>(
      "rhegma::loadWork", points_.count, KOKKOS_LAMBDA(const int k, double& sum) {
        for (int e = 0; e < stencils.count(k); ++e)
        {
          const int n = stencils.node(k, e);
          for (int d = 0; d < D; ++d)
            sum += dt * stencils.weight(k, e) * fraction(k) * force.at(normal, k, d) * velocity(n, d);
        }
      });
}

template class Load<2>;
template class Load<3>;

} // namespace Rhegma
