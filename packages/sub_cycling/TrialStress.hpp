#pragma once
/// Stress of particles that substeps have strained, while their fields are still those of the step's
/// start.

#include "state/State.hpp"
#include "transfer/LaneHeat.hpp"
#include "transfer/ParticleViews.hpp"

namespace Rhegma::sub_cycling
{

/// (1 + G)^-1.
template <int D>
KOKKOS_FORCEINLINE_FUNCTION void inverseOfMotion(const double (&G)[D][D], double (&result)[D][D])
{
  if constexpr (D == 2)
  {
    const double scale = 1.0 / ((1.0 + G[0][0]) * (1.0 + G[1][1]) - G[0][1] * G[1][0]);
    result[0][0] = scale * (1.0 + G[1][1]);
    result[0][1] = -scale * G[0][1];
    result[1][0] = -scale * G[1][0];
    result[1][1] = scale * (1.0 + G[0][0]);
  }
  else
  {
    double F[9], inverted[9];
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b)
        F[a * 3 + b] = G[a][b] + (a == b ? 1.0 : 0.0);
    inverse<3>(F, determinant<3>(F), inverted);
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b)
        result[a][b] = inverted[a * 3 + b];
  }
}

/// Stress by the law alone.
template <int D>
class LawStress
{
public:
  /// \param duration of the motion since the start [s]
  LawStress(const State<D>& state, double duration)
      : duration_(duration),
        materials_(state.materials.device),
        deformation_(state.particles.template real<gradientSize<D>>(fields::deformation)),
        material_(state.particles.integer(fields::material))
  {
    if (state.particles.has(fields::history))
      history_ = state.particles.table(fields::history);
  }

  /// \param gradient of the displacement since the start, G: F becomes (1 + G) F
  /// \param tau out: Kirchhoff's stress [Pa]
  KOKKOS_INLINE_FUNCTION void operator()(int p, const double (&gradient)[D][D], double* tau) const
  {
    double F[gradientSize<D>], before[gradientSize<D>], memory[historyCapacity];
    for (int k = 0; k < gradientSize<D>; ++k)
      F[k] = before[k] = deformation_(p, k);
    for (int a = 0; a < D; ++a)
      for (int b = 0; b < D; ++b)
        for (int c = 0; c < D; ++c)
          F[a * D + b] += gradient[a][c] * deformation_(p, c * D + b);
    for (int k = 0; k < static_cast<int>(history_.extent(1)); ++k)
      memory[k] = history_(p, k);
    const Properties& law = materials_(material_(p));
    updateStress<D>({before, duration_, law.temperature}, law, F, tau, memory);
  }

protected:
  double duration_;
  View<Properties*> materials_;
  BorrowedView<double * [gradientSize<D>]> deformation_;
  BorrowedView<int*> material_;
  BorrowedView<double**> history_;
};

/// Stress at the temperature after straining, as in the step: with the isothermal stiffness k' motions of
/// fine cells would gain the fraction (k - k') / m times the square of a substep in every step.
template <int D>
class HeatedStress : private LawStress<D>
{
public:
  HeatedStress(const State<D>& state, double duration)
      : LawStress<D>(state, duration),
        tables_(state.materials.thermo),
        temperature_(state.particles.scalar(fields::temperature)),
        internal_(state.particles.scalar(fields::internalEnergy)),
        stress_(state.particles.template real<symmetricSize<D>>(fields::stress))
  {
  }

  KOKKOS_INLINE_FUNCTION void operator()(int p, const double (&gradient)[D][D], double* tau) const
  {
    detail::StrainLanes<D> at;
    detail::HeatLanes<D> heat;
    for (int a = 0; a < D; ++a)
      for (int b = 0; b < D; ++b)
        at.gradient[a * D + b][0] = gradient[a][b];
    if constexpr (D == 2)
      at.gradient[4][0] = 0.0; // axisymmetric scenes have no sub-cycling
    for (int k = 0; k < gradientSize<D>; ++k)
      at.F[k][0] = this->deformation_(p, k);
    for (int k = 0; k < symmetricSize<D>; ++k)
      at.tau[k][0] = stress_(p, k);
    at.speed[0] = 0.0;
    heat.temperature[0] = temperature_(p);
    heat.internal[0] = internal_(p);
    heat.firstFraction[0] = 0.0;
    double memory[historyCapacity];
    const int width = static_cast<int>(this->history_.extent(1));
    for (int k = 0; k < width; ++k)
      memory[k] = this->history_(p, k);
    const int kind = this->material_(p);
    const Properties& law = this->materials_(kind);
    const ThermoMaterial& thermal = tables_.material(kind);
    if (thermal.count == 1)
      withLaw<D>(law.law, law.plane,
                 detail::HeatOfLanes<D>{law, thermal, tables_.knot(thermal.first), at, heat, memory, width,
                                        1.0, this->duration_, 0, 1});
    else
      detail::HeatByTables<D>{law, tables_, kind, at, heat, memory, width, 1.0, this->duration_, 0, 1}.run();
    for (int k = 0; k < symmetricSize<D>; ++k)
      tau[k] = at.tau[k][0];
  }

private:
  ThermoTables tables_;
  BorrowedView<double*> temperature_, internal_;
  BorrowedView<double * [symmetricSize<D>]> stress_;
};

} // namespace Rhegma::sub_cycling
