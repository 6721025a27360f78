#pragma once
/// Multiplicative split of the deformation into an elastic and a plastic part, for all laws that flow: be =
/// J^(-2/3) F Cp^-1 F^T, with Cp^-1 - 1 first in the history.

#include "material/J2Return.hpp"
#include "material/Tensors.hpp"
#include "material/ThicknessRoot.hpp"

namespace Rhegma
{

/// J^(-2/3).
KOKKOS_INLINE_FUNCTION double isochoricScale(double J)
{
  const double root = std::cbrt(J);
  return 1.0 / (root * root);
}

/// Splits be = J^(-2/3) F Cp^-1 F^T. \param scale J^(-2/3) \param deviator out: dev be. \return tr be / 3 - 1
template <int D>
KOKKOS_INLINE_FUNCTION double elasticStrain(const double* F, double scale, const double* history,
                                            double* deviator)
{
  double g[symmetricSize<D>];
  leftStrain<D>(F, g);
  pushForward<D>(F, history, deviator);
  for (int i = 0; i < symmetricSize<D>; ++i)
    deviator[i] = scale * (deviator[i] + g[i]);
  const double mean = trace<D>(deviator) / 3.0;
  for (int i = 0; i < 3; ++i)
    deviator[normalIndex<D>(i)] -= mean;
  return mean + scale - 1.0;
}

/// Moves Cp^-1 along a return that shrinks the trial deviator of be by `shrink`.
/// \param excess tr be / 3 - 1 of the trial; out: after the return
/// \return what the work sigma_y Delta alpha is to be multiplied with
template <int D>
KOKKOS_INLINE_FUNCTION double flowBack(const double* F, double J, double scale, const double* deviator,
                                       double shrink, double& excess, double* history)
{
  const double half = 0.5 * shrink * shrink * squaredNorm<D>(deviator);
  const double cube = shrink * shrink * shrink * symmetricDeterminant<D>(deviator);
  const double relaxed = unimodularExcess(half, cube, excess);

  // Cp^-1 = J^(2/3) F^-1 be F^-T, by the change of be so that it keeps its digits.
  double change[symmetricSize<D>];
  for (int i = 0; i < symmetricSize<D>; ++i)
    change[i] = -(1.0 - shrink) / scale * deviator[i];
  for (int i = 0; i < 3; ++i)
    change[normalIndex<D>(i)] += (relaxed - excess) / scale;
  double back[gradientSize<D>];
  inverse<D>(F, J, back);
  double plastic[symmetricSize<D>];
  pushForward<D>(back, change, plastic);
  for (int i = 0; i < symmetricSize<D>; ++i)
    history[i] += plastic[i];
  excess = relaxed;
  return workFactor(half, cube, 1.0 + relaxed);
}

/// tau_zz after the return as a function of the thickness stretch s. The return only shrinks the deviator, so
/// that the zero is between the s of no volume change and the s of no trial deviator in zz.
/// \tparam Flow has norm(), of the deviator at yield, and solve(trial, shear), a Return
template <class Flow>
struct PlasticThickness
{
  const Flow& flow;
  double shear, bulk;
  double area;   ///< of the plane, j
  double xx, yy; ///< of F Cp^-1 F^T, less 1
  double xy;
  double zz; ///< of Cp^-1, less 1

  KOKKOS_INLINE_FUNCTION double operator()(double s, double& slope) const
  {
    const double J = area * s;
    const double root = std::cbrt(J);
    const double mu = shear / (root * root);
    const double thickness = (s - 1.0) * (s + 1.0) + s * s * zz;
    const double mean = (xx + yy + thickness) / 3.0;
    const double sx = mu * (xx - mean), sy = mu * (yy - mean), sz = mu * (thickness - mean), sxy = mu * xy;
    const double pull = 2.0 * mu * (1.0 + thickness); // d dev tau / d ln s = pull dev(zz) - 2/3 dev tau
    double value = sz;
    double rise = 2.0 / 3.0 * (pull - sz);

    const double trial = std::sqrt(sx * sx + sy * sy + sz * sz + 2.0 * sxy * sxy);
    if (trial > flow.norm())
    {
      const double current = mu * (1.0 + mean);
      const Return back = flow.solve(trial, current);
      const double trialRise = pull * sz / trial - 2.0 / 3.0 * trial;
      const double shearRise = (pull - 2.0 * current) / 3.0;
      const double normRise = back.slope * (trialRise - 2.0 * shearRise * back.multiplier);
      value = sz * back.norm / trial;
      rise = (rise * back.norm + sz * normRise - value * trialRise) / trial;
    }
    slope = rise + bulk * J * J;
    return value + 0.5 * bulk * (J - 1.0) * (J + 1.0);
  }
};

/// Thickness stretch of plane stress, for K/2 ((J^2 - 1)/2 - ln J) as energy of the volume.
template <class Flow>
KOKKOS_INLINE_FUNCTION double plasticThickness(const Flow& flow, const Properties& m, const double* F,
                                               const double* history)
{
  double g[4];
  leftStrain<2>(F, g);
  double plastic[4];
  pushForward<2>(F, history, plastic);
  const PlasticThickness<Flow> residual{
      flow,      m.mu, m.bulk, planeDeterminant(F), g[0] + plastic[0], g[1] + plastic[1], g[2] + plastic[2],
      history[3]};
  const double isochoric = 1.0 / residual.area;
  const double even = std::sqrt((1.0 + 0.5 * (residual.xx + residual.yy)) / (1.0 + residual.zz));
  return thicknessRoot(residual, std::fmin(isochoric, even), std::fmax(isochoric, even), F[4]);
}

} // namespace Rhegma
