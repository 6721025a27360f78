#pragma once
/// Relaxation times that depend on temperature.

#include "base/Types.hpp"

namespace Rhegma
{

/// Kinds of shift; a number of Properties::own.
namespace ShiftKind
{
constexpr double none = 0.0;
constexpr double williamsLandelFerry = 1.0;
constexpr double arrhenius = 2.0;
} // namespace ShiftKind

/// Numbers of a shift; they lie together in Properties::own.
namespace ShiftNumber
{
enum
{
  shift = 0, ///< ShiftKind
  first,     ///< C1 of Williams, Landel, Ferry, or the activation temperature [K]
  second,    ///< C2 of Williams, Landel, Ferry [K]
  reference, ///< temperature of the relaxation times [K]
  size
};
} // namespace ShiftNumber

/// 1 / a_T, by which relaxation is faster at a temperature [K].
/// Williams, Landel, Ferry (J. Am. Chem. Soc. 77 (1955) 3701): log10 a_T = -c1 (T - T0) / (c2 + T - T0).
/// Arrhenius: ln a_T = c1 (1/T - 1/T0), c1 the activation energy over the gas constant [K].
/// log10 a_T stays within 30, so that the law of Williams, Landel and Ferry has a value at and below T0 - c2.
KOKKOS_INLINE_FUNCTION double inverseTimeShift(double kind, double c1, double c2, double reference,
                                               double temperature)
{
  constexpr double most = 30.0, ten = 2.302585092994046;
  if (kind == ShiftKind::none)
    return 1.0;
  const double above = temperature - reference;
  if (kind == ShiftKind::arrhenius)
  {
    const double power = -c1 * (1.0 / temperature - 1.0 / reference);
    return std::exp(std::fmin(std::fmax(power, -most * ten), most * ten));
  }
  const double decades = c2 + above > 0.0 ? c1 * above / (c2 + above) : -most;
  return std::exp(ten * std::fmin(std::fmax(decades, -most), most));
}

/// What a step of `ratio` relaxation times does to a Maxwell element at a constant rate of strain.
struct MaxwellStep
{
  double loss;  ///< 1 - exp(-ratio)
  double gain;  ///< mean of exp(-s) for s from 0 to ratio; factor of the strain increment
  double delay; ///< (1 - gain) / ratio; factor of the strain increment in the mean over the step

  /// Integral of |e|^2 over the step times 2 / time, from e at its start and the strain increment.
  KOKKOS_INLINE_FUNCTION double dissipated(double start, double mixed, double increment) const
  {
    return loss * (2.0 - loss) * start + 2.0 * gain * loss * mixed + (2.0 * delay - gain * gain) * increment;
  }
};

KOKKOS_INLINE_FUNCTION MaxwellStep maxwellStep(double ratio)
{
  if (ratio > 0.1)
  {
    const double loss = -std::expm1(-ratio), gain = loss / ratio;
    return {loss, gain, (1.0 - gain) / ratio};
  }
  // The series of (exp(-x) - 1 + x) / x^2; the first term left out is 3e-15 of the sum.
  const double x = ratio;
  const double delay =
      0.5 - x * (1.0 / 6.0 -
                 x * (1.0 / 24.0 -
                      x * (1.0 / 120.0 -
                           x * (1.0 / 720.0 -
                                x * (1.0 / 5040.0 -
                                     x * (1.0 / 40320.0 - x * (1.0 / 362880.0 - x * (1.0 / 3628800.0))))))));
  const double gain = 1.0 - x * delay;
  return {x * gain, gain, delay};
}

/// Maxwell elements over a step of a material without heat, or of one particle.
template <int Most>
struct MaxwellSteps
{
  int count;
  MaxwellStep step[Most];

  /// \param times relaxation times, `count` of them [s] \param shift ShiftNumber of them
  KOKKOS_INLINE_FUNCTION MaxwellSteps(double elements, const double* times, const double* shift, double dt,
                                      double temperature)
      : count(static_cast<int>(std::lround(elements)))
  {
    using namespace ShiftNumber;
    const double faster =
        inverseTimeShift(shift[0], shift[first], shift[second], shift[reference], temperature);
    for (int i = 0; i < count; ++i)
      step[i] = maxwellStep(dt * faster / times[i]);
  }
};

} // namespace Rhegma
