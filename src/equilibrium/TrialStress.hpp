#pragma once
/// Stress of a particle for a trial displacement, and its tangent.

#include "base/Types.hpp"
#include "material/ThermoLaw.hpp"

namespace Rhegma::equilibrium
{

/// A particle at the start of a step of equilibrium.
template <int D>
struct ParticleBefore
{
  const Properties& properties;
  const double* F;       ///< deformation gradient then, gradientSize<D>
  const double* history; ///< of its law, or null
  int historyWidth;
  double dt; ///< length of the step [s]
  const ThermoTables& heat;
  int material;
  double temperature; ///< of the step; unused where `heat` is empty [K]
};

/// Kirchhoff stress of a law at a deformation gradient.
struct StressOfParticle
{
  const LawStep& step;
  const Properties& properties;
  double* F;
  double* tau;
  double* history;

  template <class Law, int D, Plane P>
  KOKKOS_INLINE_FUNCTION bool run() const
  {
    return stressOfLaw<Law, D, P>(step, properties, F, tau, history);
  }
};

/// Stress tau and new history at a deformation gradient, at the particle's temperature if the scene has heat.
/// \return false where it does not exist
template <int D>
KOKKOS_INLINE_FUNCTION bool stressAt(const ParticleBefore<D>& before, double* F, double* tau, double* history)
{
  double* const memory = before.historyWidth > 0 ? history : nullptr;
  for (int k = 0; k < before.historyWidth; ++k)
    history[k] = before.history[k];
  const Properties& law = before.properties;
  if (before.heat.empty())
    return withLaw<D>(law.law, law.plane,
                      StressOfParticle{{before.F, before.dt, law.temperature}, law, F, tau, memory});
  const ThermoPoint at(before.heat, before.material, before.temperature);
  double start[gradientSize<D>]; // without thermal strain
  for (int k = 0; k < gradientSize<D>; ++k)
    start[k] = before.F[k] / at.stretch();
  ThermoState result;
  return withLaw<D>(
      law.law, law.plane,
      ThermoStress{{start, before.dt, before.temperature}, at, before.temperature, F, tau, memory, result});
}

/// \return false where the matrix has no positive determinant
KOKKOS_INLINE_FUNCTION bool invert(const double (&B)[4], double (&inverse)[4])
{
  const double J = B[0] * B[3] - B[1] * B[2];
  inverse[0] = B[3] / J;
  inverse[1] = -B[1] / J;
  inverse[2] = -B[2] / J;
  inverse[3] = B[0] / J;
  return J > 0.0;
}

KOKKOS_INLINE_FUNCTION bool invert(const double (&B)[9], double (&inverse)[9])
{
  double J = 0.0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
    {
      const int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
      const double minor = B[3 * i1 + j1] * B[3 * i2 + j2] - B[3 * i1 + j2] * B[3 * i2 + j1];
      inverse[3 * j + i] = minor;
      J += i == 0 ? B[j] * minor : 0.0;
    }
  for (double& entry : inverse)
    entry /= J;
  return J > 0.0;
}

/// The history variables that change where a law flows: first and one past the last. A law with a plastic
/// strain flows where that grows, whatever else it stores.
struct FlowVariables
{
  int first, end;
};

struct FlowVariablesCall
{
  int width;

  template <class Law, int D, Plane>
  KOKKOS_INLINE_FUNCTION FlowVariables run() const
  {
    return of<Law, D>(0);
  }

private:
  template <class Law, int D>
  KOKKOS_INLINE_FUNCTION auto of(int /*preferred*/) const
      -> decltype(Law::template plasticStrainIndex<D>, FlowVariables())
  {
    return {Law::template plasticStrainIndex<D>, Law::template plasticStrainIndex<D> + 1};
  }
  template <class, int>
  KOKKOS_INLINE_FUNCTION FlowVariables of(long /*otherwise*/) const
  {
    return {0, width};
  }
};

/// Whether a law's history changes by more than rounding, as in plastic flow. A particle that lies on the
/// yield surface at the start of a step does not flow yet.
template <int D>
KOKKOS_INLINE_FUNCTION bool historyChanges(const ParticleBefore<D>& before, const double* history)
{
  constexpr double relative = 1e-10, absolute = 1e-13;
  const Properties& law = before.properties;
  const FlowVariables at = withLaw<D>(law.law, law.plane, FlowVariablesCall{before.historyWidth});
  bool changes = false;
  for (int k = at.first; k < at.end && k < before.historyWidth; ++k)
    changes = changes || !(std::fabs(history[k] - before.history[k]) <=
                           relative * std::fabs(before.history[k]) + absolute);
  return changes;
}

/// First Piola-Kirchhoff stress per volume at F = 1, relative to the configuration before the step: the power
/// of the particle is V0 P : dG/dt, G the gradient of the displacement over the step with respect to that
/// configuration. P = tau (1 + G)^-T. In 2D both have the component of the third direction at the end: that
/// of the hoop in axisymmetric scenes, where G is zero otherwise. \param flows becomes whether the history
/// changes \return false where the particle is inverted or not finite
template <int D>
KOKKOS_INLINE_FUNCTION bool trialStress(const ParticleBefore<D>& before, const double (&G)[gradientSize<D>],
                                        double (&P)[gradientSize<D>], bool& flows)
{
  double B[D * D], inverse[D * D], F[gradientSize<D>], tau[symmetricSize<D>], history[historyCapacity];
  for (int k = 0; k < D * D; ++k)
    B[k] = G[k] + (k % (D + 1) == 0 ? 1.0 : 0.0);
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j)
    {
      F[i * D + j] = 0.0;
      for (int k = 0; k < D; ++k)
        F[i * D + j] += B[i * D + k] * before.F[k * D + j];
    }
  if constexpr (D == 2)
    F[4] = before.F[4] + before.F[4] * G[4];
  if (!invert(B, inverse) || !stressAt<D>(before, F, tau, history))
    return false;
  flows = historyChanges<D>(before, history);
  double sum = 0.0;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j)
    {
      double& p = P[i * D + j];
      p = 0.0;
      for (int k = 0; k < D; ++k)
        p += tau[symmetricIndex<D>(i, k)] * inverse[j * D + k];
      sum += std::fabs(p);
    }
  if constexpr (D == 2)
    P[4] = tau[3] / (1.0 + G[4]);
  return std::isfinite(sum);
}

template <int D>
KOKKOS_INLINE_FUNCTION bool trialStress(const ParticleBefore<D>& before, const double (&G)[gradientSize<D>],
                                        double (&P)[gradientSize<D>])
{
  bool flows = false;
  return trialStress<D>(before, G, P, flows);
}

/// Change of a gradient for central differences. The error of the tangent, h^2 times the third derivative and
/// the rounding of the stress over h, is below 1e-9 of it for strains of order one.
constexpr double differenceStep = 1e-5;

/// Consistent tangent A = dP / dG at G, of (D * i + j) and (D * k + l), by central differences of the law as
/// it is, history included; symmetric, as the tangents of laws with a potential are. Next to the yield
/// surface, where the difference would mix the elastic with the plastic tangent, it is taken to the side that
/// flows if the particle flows at G, else to the one that does not: with a mean of both, a body that has
/// yielded is not brought back to equilibrium. \param count of the components of G that A has: D * D, or
/// gradientSize<D> in axisymmetric scenes \return false where a stress does not exist
template <int D>
KOKKOS_INLINE_FUNCTION bool trialTangent(const ParticleBefore<D>& before, const double (&G)[gradientSize<D>],
                                         double (&A)[gradientSize<D>][gradientSize<D>], int count)
{
  bool good = true, flows = false;
  double here[gradientSize<D>] = {};
  if (before.historyWidth > 0)
    good = trialStress<D>(before, G, here, flows);
  for (int c = 0; c < count; ++c)
  {
    double at[gradientSize<D>], high[gradientSize<D>] = {}, low[gradientSize<D>] = {};
    bool above = false, below = false; // whether it flows there
    for (int k = 0; k < gradientSize<D>; ++k)
      at[k] = G[k];
    at[c] = G[c] + differenceStep;
    const double up = at[c];
    good = trialStress<D>(before, at, high, above) && good;
    at[c] = G[c] - differenceStep;
    good = trialStress<D>(before, at, low, below) && good;
    const bool upwards = above != below && above == flows, downwards = above != below && below == flows;
    const double from = upwards ? G[c] : at[c], to = downwards ? G[c] : up;
    for (int r = 0; r < count; ++r)
      A[r][c] = ((downwards ? here[r] : high[r]) - (upwards ? here[r] : low[r])) / (to - from);
  }
  for (int r = 0; r < count; ++r)
    for (int c = 0; c < r; ++c)
      A[r][c] = A[c][r] = 0.5 * (A[r][c] + A[c][r]);
  return good;
}

} // namespace Rhegma::equilibrium
