#include "cracks/FrontSprings.hpp"

#include "base/SmallLoops.hpp"
#include "cracks/HoldingForce.hpp"
#include "cracks/NearestFront.hpp"
#include "cracks/Release.hpp"
#include "cracks/SplitNode.hpp"
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
  SplitNodes<D> split;
  NodalSprings<D> springs;
  View<double * [D + 1]> spring; ///< CrackSet::spring
  View<double*> damping;         ///< [N s/m]
  View<double*> inertia;         ///< NodalMotion::relativeInertia; empty where springs are limited instead
  NearestFront<D> frontOf;
  View<double*> spent;    ///< of each front, the part of G that new faces dissipate
  View<double*> softened; ///< energy that springs dissipate which began to soften now [J]
  StableStiffness<D> stable;
  bool grows, moves;
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
    const int front = grownFrontAt(primary);
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
    if (!nearFront::mayHaveSprings(split.sight.nearFront(simplexOf(split.nearest(primary)))))
    {
      node.stiffness() = 0.0;
      return;
    }
    double stiffness = most > 0.0 ? split.stiffness(i) : 0.0;
    if (inertia.extent(0) == 0)
      stiffness = atMost(stiffness, most);
    if (stiffness > node.stiffness() &&
        isStretched(node, split.cellAt(primary))) // stiffening would add energy
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

  /// The nearest front of the crack of a node, if it has grown.
  KOKKOS_INLINE_FUNCTION int grownFrontAt(int primary) const
  {
    return grows ? frontOf(split.positions(primary), split.sight.crackOf(simplexOf(split.nearest(primary))))
                 : noFront;
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
    const CohesiveLaw law = softeningLaw(node.stiffness(), std::sqrt(stretch), split.slope(i), spent(front));
    node.release(law, Vector<D>{});
    springs.front(primary) = front;
    if (!isOwnedByThisRank(nodes, primary))
      return;
    softened(i) = softenedEnergy(law);
    converted += 0.5 * node.stiffness() * stretch;
  }
};

/// Of each front, the part of G that its new faces dissipate: in 2D less than one where it started under more
/// than their toughness; one in 3D.
template <int D>
View<double*> spentParts(const State<D>& state, bool grows)
{
  const std::vector<CrackFront<D>>& fronts = state.cracks.fronts;
  View<double*> spent("rhegma::cracks::spentParts", grows ? fronts.size() : 0);
  const auto host = Kokkos::create_mirror_view(spent);
  for (std::size_t f = 0; f < host.extent(0); ++f)
  {
    host(f) = 1.0;
    if constexpr (D == 2)
    {
      const double release = fronts[f].nodes[0].driving.release, toughness = fronts[f].budget.toughness;
      host(f) = release > toughness ? toughness / release : 1.0;
    }
  }
  Kokkos::deep_copy(spent, host);
  return spent;
}

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
                           SplitNodes<D>(state, surroundings.nearest, modulus_, density_, surroundings.law),
                           springs(state),
                           state.cracks.spring,
                           damping_,
                           state.motion.relativeInertia,
                           frontOf_,
                           spentParts(state, grows_),
                           softened,
                           StableStiffness<D>(state),
                           grows_,
                           !state.method.equilibrium(),
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
