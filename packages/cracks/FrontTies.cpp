#include "cracks/FrontTies.hpp"

#include "material/MaterialTable.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

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

} // namespace

template <int D>
void FrontTies<D>::prepare(State<D>& state)
{
  const int rows = state.nodes.numLattice, lattice = state.grid.numNodes;
  if (static_cast<int>(jump_.extent(0)) < rows)
  {
    Kokkos::resize(jump_, rows);
    Kokkos::resize(step_, rows);
    stiffness_ = View<double*>("rhegma::tieStiffness", rows);
    state.cracks.tieForce = View<double* [D]>("rhegma::tieForce", rows);
  }
  if (generation_ != state.tree.generation)
  {
    const View<int*> last = step_; // nodes of refined cells have new numbers
    Kokkos::parallel_for(
        "rhegma::cracks::forgetTies", Kokkos::RangePolicy<ExecSpace>(lattice, last.extent(0)),
        KOKKOS_LAMBDA(const int n) { last(n) = 0; });
    generation_ = state.tree.generation;
  }
  if (modulus_ > 0.0)
    return;
  modulus_ = std::numeric_limits<double>::infinity();
  for (const Properties& material : state.materialList)
    modulus_ = std::min(modulus_, elasticity(material).effectiveModulus);
}

template <int D>
void FrontTies<D>::addForces(State<D>& state, const Surroundings& surroundings)
{
  prepare(state);
  const Nodes<D> nodes = state.nodes;
  const double spacing = state.grid.spacing;
  const NodePlaces<D> places = nodePlaces(state);
  const bool refined = state.tree.refined();
  const View<int*> level = state.tree.nodeLevel;
  const CrackSight<D> sight(state.cracks, spacing);
  const View<std::uint64_t*> nearest = surroundings.nearest;
  const View<int*> side = state.cracks.nodeSide, last = step_;
  const View<double*[D]> jump = jump_, force = state.cracks.tieForce;
  const View<double*> stiffness = stiffness_;
  const double modulus = factor * modulus_, thickness = state.thickness;
  const double limit = stable / (state.dt * state.dt);
  const int step = surroundings.stamp;
  Kokkos::parallel_for(
      "rhegma::cracks::tie", Kokkos::RangePolicy<ExecSpace>(0, nodes.numSecond), KOKKOS_LAMBDA(const int i) {
        const int own = nodes.parent(i), other = nodes.numLattice + i;
        if (last(own) != step - 1)
          for (int d = 0; d < D; ++d)
            jump(own, d) = 0.0;
        last(own) = step;
        const int s = simplexOf(nearest(own));
        const Sight seen = sight.look(s, places(own));
        const double cell = refined ? std::ldexp(spacing, -level(own)) : spacing;
        double steepest = 0.0;
        for (int d = 0; d < D; ++d)
          steepest = std::fmax(steepest, std::fabs(sight.normal(s, d)));
        const double xi = seen.behind / cell * std::sqrt(steepest) + offset;
        const double away = std::fabs(seen.distance) / (cell * steepest);
        const double a = nodes.sums(own, Nodes<D>::massAt), b = nodes.sums(other, Nodes<D>::massAt);
        stiffness(own) = 0.0;
        if (xi < 1.0 && away < 1.0 && a > 0.0 && b > 0.0)
        {
          const double wanted = modulus * (D == 2 ? thickness : cell) * (1.0 - xi) / xi * (1.0 - away),
                       most = limit * a * b / (a + b);
          stiffness(own) = wanted < most ? wanted : most;
        }
        for (int d = 0; d < D; ++d)
        {
          force(own, d) = -signOf(side(own)) * stiffness(own) * jump(own, d);
          nodes.sums(own, Nodes<D>::forceAt + d) += force(own, d);
          nodes.sums(other, Nodes<D>::forceAt + d) -= force(own, d);
        }
      });
}

template <int D>
void FrontTies<D>::advance(State<D>& state) const
{
  const Nodes<D> nodes = state.nodes;
  const View<int*> side = state.cracks.nodeSide;
  const View<double*[D]> jump = jump_, force = state.cracks.tieForce;
  const View<double*> stiffness = stiffness_;
  const double dt = state.dt;
  const bool byMotion = state.scheme == UpdateScheme::Usl;
  double energy = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::cracks::stretchTies", Kokkos::RangePolicy<ExecSpace>(0, nodes.numSecond),
      KOKKOS_LAMBDA(const int i, double& sum) {
        const int own = nodes.parent(i), other = nodes.numLattice + i;
        const double sign = signOf(side(own));
        for (int d = 0; d < D; ++d)
        {
          const double moved = byMotion ? nodes.motion(own, d) - nodes.motion(other, d)
                                        : nodes.projection(own, d) - nodes.projection(other, d);
          jump(own, d) += sign * dt * moved;
          force(own, d) = -sign * stiffness(own) * jump(own, d);
          sum += 0.5 * stiffness(own) * jump(own, d) * jump(own, d);
        }
      },
      energy);
  state.energy.ties = energy;
}

template class FrontTies<2>;
template class FrontTies<3>;

} // namespace Rhegma::cracks
