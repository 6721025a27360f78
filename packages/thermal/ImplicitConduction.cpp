/// Backward Euler steps of conduction.

#include "base/Numbers.hpp"
#include "state/Subdomain.hpp"
#include "thermal/ConductionIntegrator.hpp"

#include <cmath>

namespace Rhegma::thermal
{

namespace
{

/// Nodes with a smaller fraction of the mean heat capacity of a node are touched by round-off alone: the
/// weight of a box of particles that ends on their cell's edge. Their equations would be round-off over
/// round-off.
constexpr double roundOff = 1e-10;

/// Mean heat capacity of the nodes that have any [J/K].
template <int D>
double meanCapacity(const State<D>& state, const HeatNodes<D>& heat)
{
  const Nodes<D> nodes = state.mesh.nodes;
  double sum = 0.0, count = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::thermal::meanCapacity", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i, double& capacities, double& number) {
        const int n = activeNode(nodes, i);
        const double capacity = isOwnedByThisRank(nodes, n) ? heat.sums(n, HeatNodes<D>::capacityAt) : 0.0;
        capacities += capacity;
        number += capacity > 0.0 ? 1.0 : 0.0;
      },
      sum, count);
  count = state.ranks.sum(count);
  return count > 0.0 ? state.ranks.sum(sum) / count : 0.0;
}

/// Columns of a pair of fields.
constexpr int onOne = 0, onTwo = 1, jumpAt = 2, passesAt = 3, unknownAt = 4;

/// Where a pair has its unknown jump: in the row of its enriched field unless that is held.
template <int D>
struct PairRows
{
  Nodes<D> nodes;
  View<char*> held;
  int one, two;
  KOKKOS_INLINE_FUNCTION PairRows(const Nodes<D>& n, const View<char*>& h, int pair)
      : nodes(n), held(h), one(n.parent(pair)), two(n.numLattice + pair)
  {
  }
  KOKKOS_INLINE_FUNCTION bool bothFree() const { return held(one) == 0 && held(two) == 0; }
  KOKKOS_INLINE_FUNCTION int jumpRow() const { return held(two) == 0 ? two : one; }
};

} // namespace

template <int D>
void ConductionIntegrator<D>::numberUnknowns(const State<D>& state, const HeatNodes<D>& heat)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const View<char*> unknown = unknown_;
  const double least = roundOff * meanCapacity(state, heat);
  Kokkos::parallel_for(
      "rhegma::thermal::findUnknowns", Kokkos::RangePolicy<ExecSpace>(0, nodes.numActive()),
      KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(nodes, i);
        unknown(n) =
            heat.held(n) == 0 && heat.sums(n, HeatNodes<D>::capacityAt) > least && isOwnedByThisRank(nodes, n)
                ? 1
                : 0;
      });
  // The number of nodes changes as bodies move and cracks grow: a reserve avoids a new solver.
  if (capacity_ < nodes.numActive())
    capacity_ = nodes.numActive() + nodes.numActive() / 8 + 64;
  gradients().resize(capacity_, state.mesh.subdomain ? state.ranks : Ranks());
}

template <int D>
void ConductionIntegrator<D>::findPairs(const State<D>& state, const HeatNodes<D>& heat,
                                        const CrackConduction<D>& faces, double dt)
{
  numPairs_ = faces.active(state) ? state.mesh.nodes.numOfCracks : 0;
  const Nodes<D> nodes = state.mesh.nodes;
  const View<double*>& conductance = faces.conductance();
  const View<double* [pairWidth]> pairs = pairs_;
  Kokkos::parallel_for(
      "rhegma::thermal::findPairs", Kokkos::RangePolicy<ExecSpace>(0, numPairs_), KOKKOS_LAMBDA(const int i) {
        const PairRows<D> rows(nodes, heat.held, i);
        const double C1 = heat.sums(rows.one, HeatNodes<D>::capacityAt);
        const double C2 = heat.sums(rows.two, HeatNodes<D>::capacityAt);
        const bool passes = conductance(rows.one) > 0.0 && C1 > 0.0 && C2 > 0.0 &&
                            !heat.insulates(rows.one) && !heat.insulates(rows.two);
        const bool held1 = heat.held(rows.one) != 0, held2 = heat.held(rows.two) != 0;
        pairs(i, passesAt) = passes ? dt * conductance(rows.one) : 0.0;
        pairs(i, onOne) = !passes || held1 ? 0.0 : held2 ? 1.0 : C2 / (C1 + C2);
        pairs(i, onTwo) = !passes || held2 ? 0.0 : held1 ? 1.0 : C1 / (C1 + C2);
        pairs(i, jumpAt) = heat.value(rows.one, 0) - heat.value(rows.two, 0);
        pairs(i, unknownAt) = 0.0;
      });
}

/// Converts the unknowns of the solver to changes of temperature: those of the nodes of this rank go to all
/// ranks, and means and jumps of pairs to their fields. \param jump fraction of the jump at the beginning
/// that is subtracted from that at the end
template <int D>
void ConductionIntegrator<D>::spread(const State<D>& state, double jump)
{
  sumOverRanks(state, change_.data(), 2, 0, 1);
  const Nodes<D> nodes = state.mesh.nodes;
  const View<char*> held = held_;
  const View<double* [2]> change = change_;
  const View<double* [pairWidth]> pairs = pairs_;
  Kokkos::parallel_for(
      "rhegma::thermal::spreadJumps", Kokkos::RangePolicy<ExecSpace>(0, numPairs_),
      KOKKOS_LAMBDA(const int i) {
        const double a = pairs(i, onOne), b = pairs(i, onTwo);
        if (!(a + b > 0.0))
          return;
        const PairRows<D> rows(nodes, held, i);
        const double mean = rows.bothFree() ? change(rows.one, 0) : 0.0;
        pairs(i, unknownAt) = change(rows.jumpRow(), 0);
        const double differs = pairs(i, unknownAt) - jump * pairs(i, jumpAt);
        change(rows.one, 0) = mean + a * differs;
        change(rows.two, 0) = mean - b * differs;
      });
}

/// (C + dt K) change and the jumps' own part, in the rows of the unknowns.
template <int D>
void ConductionIntegrator<D>::residual(const State<D>& state, const HeatNodes<D>& heat, double dt,
                                       const BorrowedView<double*>& to)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const View<char*> unknown = unknown_;
  const View<double*[2]> change = change_, flow = flow_;
  const View<double* [pairWidth]> pairs = pairs_;
  const int active = nodes.numActive();
  Kokkos::parallel_for(
      "rhegma::thermal::implicitRows", Kokkos::RangePolicy<ExecSpace>(0, active), KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(nodes, i);
        flow(n, 1) = heat.sums(n, HeatNodes<D>::capacityAt) * change(n, 0) - dt * flow(n, 0);
      });
  Kokkos::parallel_for(
      "rhegma::thermal::implicitJumps", Kokkos::RangePolicy<ExecSpace>(0, numPairs_),
      KOKKOS_LAMBDA(const int i) {
        const double a = pairs(i, onOne), b = pairs(i, onTwo);
        if (!(a + b > 0.0))
          return;
        const PairRows<D> rows(nodes, heat.held, i);
        const double one = flow(rows.one, 1), two = flow(rows.two, 1);
        if (rows.bothFree())
          flow(rows.one, 1) = one + two;
        flow(rows.jumpRow(), 1) = a * one - b * two + pairs(i, passesAt) * pairs(i, unknownAt);
      });
  Kokkos::parallel_for(
      "rhegma::thermal::implicitProduct", Kokkos::RangePolicy<ExecSpace>(0, to.extent(0)),
      KOKKOS_LAMBDA(const int i) {
        const int n = i < active ? activeNode(nodes, i) : -1;
        to(i) = n >= 0 && unknown(n) != 0 ? flow(n, 1) : 0.0;
      });
}

/// Preconditions by the diagonal.
template <int D>
void ConductionIntegrator<D>::precondition(const State<D>& state, const HeatNodes<D>& heat, double dt,
                                           const BorrowedView<const double*>& from,
                                           const BorrowedView<double*>& to)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const View<char*> unknown = unknown_;
  const View<double*> diagonal = diagonal_;
  const View<double* [2]> flow = flow_;
  const View<double* [pairWidth]> pairs = pairs_;
  const int active = nodes.numActive();
  Kokkos::parallel_for(
      "rhegma::thermal::implicitDiagonal", Kokkos::RangePolicy<ExecSpace>(0, active),
      KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(nodes, i);
        flow(n, 1) = heat.sums(n, HeatNodes<D>::capacityAt) + dt * diagonal(n);
      });
  Kokkos::parallel_for(
      "rhegma::thermal::diagonalOfJumps", Kokkos::RangePolicy<ExecSpace>(0, numPairs_),
      KOKKOS_LAMBDA(const int i) {
        const double a = pairs(i, onOne), b = pairs(i, onTwo);
        if (!(a + b > 0.0))
          return;
        const PairRows<D> rows(nodes, heat.held, i);
        const double one = flow(rows.one, 1), two = flow(rows.two, 1);
        if (rows.bothFree())
          flow(rows.one, 1) = one + two;
        flow(rows.jumpRow(), 1) = a * a * one + b * b * two + pairs(i, passesAt);
      });
  Kokkos::parallel_for(
      "rhegma::thermal::precondition", Kokkos::RangePolicy<ExecSpace>(0, to.extent(0)),
      KOKKOS_LAMBDA(const int i) {
        const int n = i < active ? activeNode(nodes, i) : -1;
        to(i) = n >= 0 && unknown(n) != 0 ? from(i) / flow(n, 1) : 0.0;
      });
}

/// Adds what pairs pass at the end of the step to the nodes' rate.
template <int D>
void ConductionIntegrator<D>::passThroughFaces(const State<D>& state, const HeatNodes<D>& heat, double dt)
{
  const Nodes<D> nodes = state.mesh.nodes;
  const View<double* [pairWidth]> pairs = pairs_;
  Kokkos::parallel_for(
      "rhegma::thermal::passThroughFaces", Kokkos::RangePolicy<ExecSpace>(0, numPairs_),
      KOKKOS_LAMBDA(const int i) {
        const PairRows<D> rows(nodes, heat.held, i);
        const bool bothHeld = heat.held(rows.one) != 0 && heat.held(rows.two) != 0;
        const double passed = pairs(i, passesAt) / dt * pairs(i, bothHeld ? jumpAt : unknownAt);
        heat.rate(rows.one, 0) -= passed;
        heat.rate(rows.two, 0) += passed;
      });
}

namespace
{

/// Scales a vector to unit length and reverses its sign. \return its length; 1 where it is zero
double normalise(const Ranks& ranks, const BorrowedView<double*>& right)
{
  double size = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::thermal::sizeOfRight", Kokkos::RangePolicy<ExecSpace>(0, right.extent(0)),
      KOKKOS_LAMBDA(const int i, double& sum) { sum += right(i) * right(i); }, size);
  size = std::sqrt(ranks.sum(size));
  const double scale = size > 0.0 ? size : 1.0;
  Kokkos::parallel_for(
      "rhegma::thermal::scaleRight", Kokkos::RangePolicy<ExecSpace>(0, right.extent(0)),
      KOKKOS_LAMBDA(const int i) { right(i) /= -scale; });
  return scale;
}

} // namespace

template <int D>
double ConductionIntegrator<D>::implicitStep(State<D>& state, const HeatNodes<D>& heat,
                                             const HeatBoundaries<D>& boundaries,
                                             const CrackConduction<D>& faces, double dt)
{
  numberUnknowns(state, heat);
  findPairs(state, heat, faces, dt);
  held_ = heat.held;
  const Nodes<D> nodes = state.mesh.nodes;
  const View<char*> unknown = unknown_;
  const View<double*[2]> change = change_, flow = flow_;
  const int active = nodes.numActive();
  const auto setFields = [&](const BorrowedView<const double*>& from, double scale)
  {
    Kokkos::parallel_for(
        "rhegma::thermal::takeChange", Kokkos::RangePolicy<ExecSpace>(0, active), KOKKOS_LAMBDA(const int i) {
          const int n = activeNode(nodes, i);
          change(n, 0) = unknown(n) != 0 ? scale * from(i) : 0.0;
        });
  };
  const BorrowedView<double*> right = gradients().right();
  // The change of the fields for vanishing jumps belongs to the right side.
  Kokkos::parallel_for(
      "rhegma::thermal::clearChange", Kokkos::RangePolicy<ExecSpace>(0, active), KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(nodes, i);
        change(n, 0) = flow(n, 0) = 0.0;
      });
  if (faces.active(state))
  {
    spread(state, 1.0);
    findFlow(state, boundaries);
  }
  Kokkos::parallel_for(
      "rhegma::thermal::addFlow", Kokkos::RangePolicy<ExecSpace>(0, active), KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(nodes, i);
        flow(n, 0) += heat.rate(n, 0);
      });
  residual(state, heat, dt, right);
  const double scale = normalise(state.ranks, right);
  const SolveResult result = gradients().solve(
      [&](const BorrowedView<const double*>& x, const BorrowedView<double*>& y)
      {
        setFields(x, 1.0);
        spread(state, 0.0);
        findFlow(state, boundaries);
        residual(state, heat, dt, y);
      },
      [&](const BorrowedView<const double*>& x, const BorrowedView<double*>& y)
      { precondition(state, heat, dt, x, y); });
  if (!result.converged)
    state.failure = method == Method::Steady ? "steady conduction did not converge"
                                             : "implicit conduction did not converge in a step of " +
                                                   formatReal(dt) + " s; take a smaller Thermal > Step Ratio";
  setFields(gradients().solution(), scale);
  spread(state, 1.0);
  const double power = findFlow(state, boundaries);
  Kokkos::parallel_for(
      "rhegma::thermal::implicitRate", Kokkos::RangePolicy<ExecSpace>(0, active), KOKKOS_LAMBDA(const int i) {
        const int n = activeNode(nodes, i);
        heat.rate(n, 0) += flow(n, 0);
      });
  passThroughFaces(state, heat, dt);
  addGradient(state, heat);
  return dt * power;
}

template void ConductionIntegrator<2>::numberUnknowns(const State<2>&, const HeatNodes<2>&);
template void ConductionIntegrator<2>::findPairs(const State<2>&, const HeatNodes<2>&,
                                                 const CrackConduction<2>&, double);
template void ConductionIntegrator<2>::spread(const State<2>&, double);
template void ConductionIntegrator<2>::residual(const State<2>&, const HeatNodes<2>&, double,
                                                const BorrowedView<double*>&);
template void ConductionIntegrator<2>::passThroughFaces(const State<2>&, const HeatNodes<2>&, double);
template void ConductionIntegrator<2>::precondition(const State<2>&, const HeatNodes<2>&, double,
                                                    const BorrowedView<const double*>&,
                                                    const BorrowedView<double*>&);
template double ConductionIntegrator<2>::implicitStep(State<2>&, const HeatNodes<2>&,
                                                      const HeatBoundaries<2>&, const CrackConduction<2>&,
                                                      double);
template void ConductionIntegrator<3>::numberUnknowns(const State<3>&, const HeatNodes<3>&);
template void ConductionIntegrator<3>::findPairs(const State<3>&, const HeatNodes<3>&,
                                                 const CrackConduction<3>&, double);
template void ConductionIntegrator<3>::spread(const State<3>&, double);
template void ConductionIntegrator<3>::residual(const State<3>&, const HeatNodes<3>&, double,
                                                const BorrowedView<double*>&);
template void ConductionIntegrator<3>::passThroughFaces(const State<3>&, const HeatNodes<3>&, double);
template void ConductionIntegrator<3>::precondition(const State<3>&, const HeatNodes<3>&, double,
                                                    const BorrowedView<const double*>&,
                                                    const BorrowedView<double*>&);
template double ConductionIntegrator<3>::implicitStep(State<3>&, const HeatNodes<3>&,
                                                      const HeatBoundaries<3>&, const CrackConduction<3>&,
                                                      double);

} // namespace Rhegma::thermal
