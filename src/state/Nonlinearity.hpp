#pragma once
/// How far bodies are from linear elasticity.

#include "material/Tensors.hpp"
#include "state/ParticleEnergy.hpp"
#include "state/State.hpp"

#include <cmath>

namespace Rhegma
{

namespace detail
{

/// Sums over particles: strain energy, the same times the strain, dissipated energy.
template <int D>
struct NonlinearitySums
{
  using value_type = double[];       ///< of Kokkos: an array
  using size_type = int;             ///< of Kokkos
  using execution_space = ExecSpace; ///< of Kokkos

  static constexpr int size = 3; ///< numbers that are summed
  int value_count = size;        ///< of Kokkos
  ParticleEnergy<D> energy;      ///< of a particle

  /// \param state whose particles are read
  explicit NonlinearitySums(const State<D>& state) : energy(state) {}

  /// Adds those of a particle. \param p its row \param sum [J]
  KOKKOS_INLINE_FUNCTION void operator()(const int p, double* sum) const
  {
    double g[symmetricSize<D>];
    leftStrain<D>(&energy.deformation(p, 0), g);
    double square = 0.0;
    for (int k = 0; k < symmetricSize<D>; ++k)
      square += g[k] * g[k];
    for (int k = shearBegin<D>; k < shearEnd<D>; ++k)
      square += g[k] * g[k];
    const double stored = energy.strain(p);
    sum[0] += stored;
    sum[1] += stored * 0.5 * std::sqrt(square);
    sum[2] += energy.volume(p) * dissipatedEnergy<D>(energy.materials(energy.material(p)), energy.memory(p));
  }
};

} // namespace detail

/// Mean of the norm of (F F^T - 1)/2, weighted with the strain energy; 0 without any. Collective. \param
/// state of the run
template <int D>
double meanStrain(const State<D>& state)
{
  using detail::NonlinearitySums;
  double sum[NonlinearitySums<D>::size] = {};
  Kokkos::parallel_reduce("rhegma::mean_strain", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
                          NonlinearitySums<D>(state), sum);
  state.ranks.sum(sum, NonlinearitySums<D>::size);
  return sum[0] > 0.0 ? sum[1] / sum[0] : 0.0;
}

/// Whether bodies have flowed plastically, or the mean of the norm of (F F^T - 1)/2, weighted with the strain
/// energy, is above 5 %: the error of a load step in which forces are taken to rise in proportion to
/// displacements is about this fraction of its work. Collective. \param state of the run
template <int D>
bool isNonlinear(const State<D>& state)
{
  constexpr double largeStrain = 0.05;
  using detail::NonlinearitySums;
  double sum[NonlinearitySums<D>::size] = {};
  Kokkos::parallel_reduce("rhegma::nonlinearity", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
                          NonlinearitySums<D>(state), sum);
  state.ranks.sum(sum, NonlinearitySums<D>::size);
  return sum[2] > 0.0 || sum[1] > largeStrain * sum[0];
}

} // namespace Rhegma
