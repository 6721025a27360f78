#include "cracks/FrontSprings.hpp"

#include "base/SmallLoops.hpp"
#include "cracks/HoldingForce.hpp"
#include "cracks/NearestFront.hpp"
#include "cracks/Release.hpp"
#include "material/MaterialTable.hpp"
#include "state/Subdomain.hpp"
#include "transfer/Motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Rhegma::cracks
{

namespace
{

/// Finds the spring of the i-th node with two fields.
template <int D>
struct FindSpring
{
  Nodes<D> nodes;
  NodePositions<D> positions;
  CrackSight<D> sight;
  View<std::uint64_t*> nearest;
  NodalSprings<D> springs;
  View<double * [D + 1]> spring; ///< CrackSet::spring
  View<double*> damping;         ///< [N s/m]
  View<double*> inertia;         ///< NodalMotion::relativeInertia; empty where springs are limited instead
  NearestFront<D> frontOf;
  View<double*> softened; ///< energy that springs dissipate which began to soften now [J]
  StableStiffness<D> stable;
  bool refined, grows, moves;
  FrontLaw frontLaw;
  View<int*> level;
  double spacing, thickness, modulus, density;
  int step;

  KOKKOS_INLINE_FUNCTION void operator()(int i, int& passed, double& converted) const
  {
    const int primary = nodes.parent(i);
    const NodalSpring<D> node = springs(primary);
    const bool fresh = static_cast<int>(node.step()) != step - 1;
    for (int k = 0; k < NodalSpring<D>::size && fresh;
         ++k) // the row may hold values of an earlier node of this number
      node.row[k] = 0.0;
    node.step() = step;
    springs.front(primary) = noFront;
    spring(primary, D) = damping(primary) = 0.0;
    if (inertia.extent(0) > 0)
      inertia(primary) = 0.0;
    const double most = stable(i);
    if (node.isReleased())
    {
      node.stiffness() = 0.0;
      if (node.state() == SpringState::Releasing)
        spring(primary, D) = atMost(node.law().secant(node.largest()), most);
      return;
    }
    const int s = simplexOf(nearest(primary));
    const int front = grows ? frontOf(positions(primary), sight.crackOf(s)) : noFront;
    if (front != noFront)
    {
      spring(primary, D) = atMost(node.stiffness(), most);
      if (fresh && most > 0.0)
      {
        springs.front(primary) = front;
        ++passed;
      }
      else if (node.stiffness() > 0.0)
        soften(i, front, converted);
      node.stiffness() = 0.0;
      return;
    }
    if (sight.nearFront(s) != nearFront::hasSprings)
    {
      node.stiffness() = 0.0;
      return;
    }
    double stiffness = most > 0.0 ? wanted(i, s) : 0.0;
    if (inertia.extent(0) == 0)
      stiffness = atMost(stiffness, most);
    if (stiffness > node.stiffness() && isStretched(node, cellAt(primary))) // stiffening would add energy
      stiffness = node.stiffness();
    spring(primary, D) = node.stiffness() = stiffness;
    if (moves)
      stabilise(i, stiffness);
  }

private:
  static KOKKOS_INLINE_FUNCTION double atMost(double value, double limit)
  {
    return value < limit ? value : limit;
  }

  static KOKKOS_INLINE_FUNCTION double square(const NodalSpring<D>& node)
  {
    double sum = 0.0;
    for (int d = 0; d < D; ++d)
      sum += node.jump(d) * node.jump(d);
    return sum;
  }

  /// Finds damping and added inertia of a spring.
  KOKKOS_INLINE_FUNCTION void stabilise(int i, double stiffness) const
  {
    const int primary = nodes.parent(i);
    const double a = nodes.sums(primary, Nodes<D>::massAt),
                 b = nodes.sums(nodes.numLattice + i, Nodes<D>::massAt), dt = stable.stepOf(primary);
    double added = 0.0;
    if (inertia.extent(0) > 0)
      added = inertia(primary) = springs::addedInertia * stiffness * dt * dt;
    damping(primary) = stableDamping(stiffness, a * b / (a + b) + added, dt);
  }

  KOKKOS_INLINE_FUNCTION double cellAt(int primary) const
  {
    return refined ? spacing / (1 << level(primary)) : spacing;
  }

  static KOKKOS_INLINE_FUNCTION bool isStretched(const NodalSpring<D>& node, double cell)
  {
    return square(node) > springs::unstretched * springs::unstretched * cell * cell;
  }

  /// Makes a cohesive traction of a stretched spring. \param converted gets what it stores, which no longer
  /// is elastic energy of springs [J]
  KOKKOS_INLINE_FUNCTION void soften(int i, int front, double& converted) const
  {
    const int primary = nodes.parent(i);
    const NodalSpring<D> node = springs(primary);
    const double stretch = square(node);
    if (!(stretch > 0.0))
      return;
    const CohesiveLaw law = softeningLaw(node.stiffness(), std::sqrt(stretch));
    node.release(law, Vector<D>{});
    springs.front(primary) = front;
    if (!isOwnedByThisRank(nodes, primary))
      return;
    softened(i) = softenedEnergy(law);
    converted += 0.5 * node.stiffness() * stretch;
  }

  /// Stiffness by the law of front springs [N/m].
  KOKKOS_INLINE_FUNCTION double wanted(int i, int s) const
  {
    const int primary = nodes.parent(i);
    const double cell = cellAt(primary);
    const Sight seen = sight.locate(s, positions(primary));
    double steepest = 0.0;
    for (int d = 0; d < D; ++d)
      steepest = std::fmax(steepest, std::fabs(sight.normal(s, d)));
    const double a = nodes.sums(primary, Nodes<D>::massAt),
                 b = nodes.sums(nodes.numLattice + i, Nodes<D>::massAt);
    double width = 0.0;
    if constexpr (D == 3) // less at the surface, by the filled fraction of the cells of the node
    {
      const double filled = (a + b) / (density * cell * cell * cell);
      width = cell * (filled > springs::fullCells ? 1.0 : filled) *
              (hasFrontCell<D>(steepest, frontLaw) ? openingFraction(a, b) : 1.0);
    }
    else
      width = thickness * (hasFrontCell<D>(steepest, frontLaw) ? openingFraction(a, b) : 1.0);
    return frontSpringStiffness<D>(modulus, width, seen.behind / cell,
                                   std::fabs(seen.distance) / (cell * steepest), steepest, frontLaw);
  }
};

} // namespace

template <int D>
std::vector<double> sumByFront(const State<D>& state, const NodalSprings<D>& springs,
                               const View<double*>& energyOfNode)
{
  const Nodes<D> nodes = state.mesh.nodes;
  std::vector<double> sums(state.cracks.fronts.size(), 0.0);
  for (std::size_t f = 0; f < sums.size(); ++f)
    sums[f] = parallelSumSmall<double>(
        "rhegma::cracks::sumByFront", nodes.numOfCracks, KOKKOS_LAMBDA(const int i, double& sum) {
          if (energyOfNode(i) > 0.0 && springs.front(nodes.parent(i)) == static_cast<int>(f))
            sum += energyOfNode(i);
        });
  sumParts(state, sums.data(), static_cast<int>(sums.size()));
  return sums;
}

template <int D>
void FrontSprings<D>::readMaterials(const State<D>& state)
{
  if (modulus_ > 0.0)
    return;
  modulus_ = std::numeric_limits<double>::infinity();
  for (const Properties& material : state.materials.properties)
  {
    modulus_ = std::min(modulus_, elasticity(material).effectiveModulus);
    density_ = std::max(density_, material.density);
  }
}

template <int D>
void FrontSprings<D>::fitToNodes(State<D>& state)
{
  const int count = state.mesh.nodes.numLattice;
  if (static_cast<int>(front_.extent(0)) >= count && state.cracks.spring.extent(0) > 0)
    return;
  front_ = View<int*>("rhegma::springFronts", count);
  damping_ = View<double*>("rhegma::springDamping", count);
  dampingForce_ = View<double* [D]>("rhegma::springDampingForce", count);
  dampedInSubsteps_ = View<double*>("rhegma::dampedInSubsteps", count);
  state.cracks.spring = View<double * [D + 1]>("rhegma::springs", count);
  state.cracks.springEnergy = View<double*>("rhegma::springEnergy", count);
  if (!limited_)
    state.motion.relativeInertia = View<double*>("rhegma::relativeInertia", count);
}

template <int D>
void FrontSprings<D>::prepare(State<D>& state, const Surroundings& surroundings)
{
  fitToNodes(state);
  if (!state.method.mechanics) // nothing stretches
    return;
  readMaterials(state);
  const Nodes<D> nodes = state.mesh.nodes;
  if (grows_)
    frontOf_.update(state.cracks);
  const View<double*> softened("rhegma::cracks::softened", grows_ ? nodes.numOfCracks : 0);
  const FindSpring<D> find{nodes,
                           nodePositions(state),
                           CrackSight<D>(state.cracks, state.mesh.grid.spacing),
                           surroundings.nearest,
                           springs(state),
                           state.cracks.spring,
                           damping_,
                           state.motion.relativeInertia,
                           frontOf_,
                           softened,
                           StableStiffness<D>(state),
                           state.mesh.tree.refined(),
                           grows_,
                           !state.method.equilibrium(),
                           surroundings.law,
                           state.mesh.tree.nodeLevel,
                           state.mesh.grid.spacing,
                           state.method.thickness,
                           modulus_,
                           density_,
                           surroundings.stamp};
  double converted = 0.0;
  parallelSumSmall("rhegma::cracks::findSprings", 0, nodes.numOfCracks, find, passed_, converted);
  state.energy.fracture += converted;
  slowRelativeMotion(state, RelativePart::Momentum);
  if (state.method.scheme == UpdateScheme::Usf || state.method.scheme == UpdateScheme::Usavg)
    slowRelativeMotion(state, RelativePart::Projection); // these have projected before
  if (!grows_)
    return;
  returnPendingOfLostNodes(state, surroundings.stamp);
  if constexpr (D == 3)
    returnPendingEnergy(state, springs(state), frontOf_, surroundings.stamp);
  sumParts(state, &converted, 1);
  if (!(converted > 0.0))
    return;
  // The energy that these springs store and will dissipate is part of that of new faces.
  const std::vector<double> energy = sumByFront(state, springs(state), softened);
  for (std::size_t f = 0; f < energy.size(); ++f)
    state.cracks.fronts[f].budget.carryOver(energy[f]);
}

template class FrontSprings<2>;
template class FrontSprings<3>;
template std::vector<double> sumByFront(const State<2>&, const NodalSprings<2>&, const View<double*>&);
template std::vector<double> sumByFront(const State<3>&, const NodalSprings<3>&, const View<double*>&);

} // namespace Rhegma::cracks
