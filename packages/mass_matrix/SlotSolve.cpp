#include "mass_matrix/SlotSolve.hpp"

#include "base/SmallLoops.hpp"
#include "state/Subdomain.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::mass_matrix
{

namespace
{

/// Even degree at which the polynomial's error 2 ((1 - sqrt(e)) / (1 + sqrt(e)))^(k + 1) is below a
/// tolerance. Source: Saad, Iterative Methods for Sparse Linear Systems, 2nd ed., section 12.3.
int productsFor(double least, double tolerance)
{
  const double root = std::sqrt(least), ratio = (1.0 - root) / (1.0 + root);
  const int degree = static_cast<int>(std::ceil(std::log(0.5 * tolerance) / std::log(ratio)));
  return 2 * ((degree + 1) / 2);
}

} // namespace

template <int D>
SlotSolve<D>::SlotSolve(double least, double tolerance)
    : chebyshev_(least, productsFor(std::max(least, leastFraction), tolerance))
{
}

template <int D>
void SlotSolve<D>::begin(const State<D>& state, const MassSystem<D>& system, const NodeSlots& slots,
                         const View<int* [D]>& held)
{
  state_ = &state;
  system_ = &system;
  slots_ = slots;
  held_ = held;
  const std::size_t unknowns = static_cast<std::size_t>(system.rowCapacity) * MassSystem<D>::width;
  if (inverse_.extent(0) != unknowns)
  {
    inverse_ = View<double*>("rhegma::slotInverse", unknowns);
    freeOnly_ = View<double*>("rhegma::slotFree", unknowns);
    given_ = View<double*>("rhegma::slotGiven", unknowns);
    image_ = View<double*>("rhegma::slotImage", unknowns);
    residual_ = View<double*>("rhegma::slotResidual", unknowns);
    solution_ = View<double*>("rhegma::slotSolution", unknowns);
  }
  findFree();
}

template <int D>
void SlotSolve<D>::findFree()
{
  constexpr int W = MassSystem<D>::width;
  const MassSystem<D> s = *system_;
  const NodeSlots slots = slots_;
  const View<int* [D]> held = held_;
  const View<double*> inverse = inverse_, free = freeOnly_, given = given_, residual = residual_;
  parallelForSmall(
      "rhegma::mass::slots", 0, s.rowCapacity, KOKKOS_LAMBDA(const int row) {
        const bool inside = row >= s.first && row < s.last && s.coupled(row);
        const int slot = inside && slots.moves(s.nodeOf(row)) ? slots.of(s.nodeOf(row)) : -1;
        for (int d = 0; d < W; ++d)
        {
          const int i = W * row + d;
          inverse(i) = slot >= 0 && d < D ? 1.0 / s.lumped(row) : 0.0;
          free(i) = slot >= 0 && d < D && held(slot, d) == 0 ? inverse(i) : 0.0;
          given(i) = residual(i) = 0.0;
        }
      });
}

template <int D>
void SlotSolve<D>::solve(const Values& right, const Values& x, bool supports)
{
  constexpr int W = MassSystem<D>::width;
  const MassSystem<D> s = *system_;
  const NodeSlots slots = slots_;
  const View<double*> inverse = supports ? freeOnly_ : inverse_, given = given_, residual = residual_,
                      image = image_, solution = solution_;
  double largest = 0.0;
  parallelSumSmall(
      "rhegma::mass::givenMotion", s.first, s.last,
      KOKKOS_LAMBDA(const int row, double& most) {
        const int slot = slots.of(s.nodeOf(row));
        for (int d = 0; d < D; ++d)
        {
          const int i = W * row + d;
          given(i) = slot >= 0 && inverse(i) == 0.0 ? x(slot, d) : 0.0;
          const double size = given(i) < 0.0 ? -given(i) : given(i);
          most = size > most ? size : most;
        }
      },
      Kokkos::Max<double>(largest));
  maxParts(*state_, &largest, 1);
  const bool moved = largest > 0.0;
  if (moved)
    multiplyWhole<D>(*state_, s, given.data(), image.data());
  parallelForSmall(
      "rhegma::mass::slotResidual", s.first, s.last, KOKKOS_LAMBDA(const int row) {
        for (int d = 0; d < D; ++d)
        {
          const int i = W * row + d;
          residual(i) =
              inverse(i) == 0.0 ? 0.0 : right(slots.of(s.nodeOf(row)), d) - (moved ? image(i) : 0.0);
        }
      });
  chebyshev_.apply(state_, s, inverse, residual.data(), solution.data(), 0.0);
  parallelForSmall(
      "rhegma::mass::slotSolution", s.first, s.last, KOKKOS_LAMBDA(const int row) {
        for (int d = 0; d < D; ++d)
          if (inverse(W * row + d) != 0.0)
            x(slots.of(s.nodeOf(row)), d) = solution(W * row + d);
      });
}

template class SlotSolve<2>;
template class SlotSolve<3>;

} // namespace Rhegma::mass_matrix
