#pragma once
/// Flow stress that depends on plastic strain, its rate and temperature.

#include "material/HighRateNumbers.hpp"
#include "material/J2Return.hpp"

namespace Rhegma
{

/// Fraction of the cold yield stress that molten metal keeps, so that its deviator has a direction.
constexpr double moltenStrength = 1.0e-6;

/// sigma_y = (A + B alpha^n + Q (1 - exp(-b alpha))) (1 + C ln(rate / reference)) (1 - T*^m),
/// T* = (T - T_room) / (T_melt - T_room), without the factor of the rate below the reference rate.
/// Source: Johnson and Cook, 7th International Symposium on Ballistics (1983) 541; the term of Voce in
/// addition.
struct JohnsonCook
{
  const Properties& m;
  double thermal; ///< 1 - T*^m at the temperature of the step
  double dt;      ///< [s]

  KOKKOS_INLINE_FUNCTION JohnsonCook(const Properties& properties, double temperature, double duration)
      : m(properties), thermal(1.0), dt(duration)
  {
    using namespace HighRateNumber;
    const double* const own = m.own;
    if (!(own[softening] > 0.0) || !(temperature > own[roomTemperature]))
      return;
    const double above = (temperature - own[roomTemperature]) / (own[meltTemperature] - own[roomTemperature]);
    thermal = above < 1.0 ? 1.0 - std::pow(above, own[softening]) : 0.0;
    thermal = thermal > moltenStrength ? thermal : moltenStrength;
  }

  /// Flow stress below the reference rate and at room temperature [Pa]. \param slope out: by plastic strain
  KOKKOS_INLINE_FUNCTION double quasiStatic(double alpha, double& slope) const
  {
    using namespace HighRateNumber;
    const double* const own = m.own;
    double stress = own[yield];
    slope = 0.0;
    if (own[hardening] > 0.0 && alpha > 0.0)
    {
      const double part = own[hardening] * std::pow(alpha, own[exponent]);
      stress += part;
      slope += own[exponent] * part / alpha;
    }
    if (own[saturation] > 0.0)
    {
      const double rest = own[saturation] * std::exp(-own[saturationRate] * alpha);
      stress += own[saturation] - rest;
      slope += own[saturationRate] * rest;
    }
    return stress;
  }

  /// Least norm of the deviator at which the material flows [Pa].
  KOKKOS_INLINE_FUNCTION double norm(double alpha) const
  {
    double slope = 0.0;
    return std::sqrt(2.0 / 3.0) * thermal * quasiStatic(alpha, slope);
  }

  /// Whether a trial deviator flows; without a power where it is below the yield stress of the unused metal.
  KOKKOS_INLINE_FUNCTION bool flows(double trial, double alpha) const
  {
    using namespace HighRateNumber;
    if (!(m.own[yield] > 0.0) || (m.own[rate] > 0.0 && !(dt > 0.0)))
      return false;
    return trial > std::sqrt(2.0 / 3.0) * thermal * m.own[yield] && trial > norm(alpha);
  }

  /// 1 + C ln(rate / reference), at least 1. \param slope out: by the logarithm of the increment
  KOKKOS_INLINE_FUNCTION double rateFactor(double increment, double& slope) const
  {
    using namespace HighRateNumber;
    slope = 0.0;
    if (!(m.own[rate] > 0.0))
      return 1.0;
    const double ratio = increment / (m.own[referenceRate] * dt);
    if (!(ratio > 1.0))
      return 1.0;
    slope = m.own[rate];
    return 1.0 + m.own[rate] * std::log(ratio);
  }

  /// Solves q - 3 shear x = sigma_y(alpha + x, x / dt) for the increment x of plastic strain, q the
  /// equivalent trial stress. Both sides are monotonic, so that the root is between 0 and that of the stress
  /// at the start. Where the rate counts, Newton's variable is ln x, in which that factor is a straight line;
  /// a step that leaves the bracket is replaced by bisection.
  /// \param trial norm of the trial deviator, which flows [Pa] \param shear mu tr be / 3 [Pa]
  KOKKOS_INLINE_FUNCTION Return solve(double trial, double shear, double alpha) const
  {
    constexpr double relative = 1.0e-8; // the error left by a Newton step is the square of it
    const double q = std::sqrt(1.5) * trial;
    double slope = 0.0, rise = 0.0;
    double low = 0.0, high = (q - thermal * quasiStatic(alpha, slope)) / (3.0 * shear);
    double x = high;
    for (int i = 0; i < 100; ++i)
    {
      const double stress = quasiStatic(alpha + x, slope), factor = rateFactor(x, rise);
      const double excess = q - 3.0 * shear * x - thermal * stress * factor;
      (excess > 0.0 ? low : high) = x;
      const double fall = 3.0 * shear + thermal * (slope * factor + stress * rise / x);
      double next = rise > 0.0 ? x * std::exp(excess / (fall * x)) : x + excess / fall;
      if (!(next >= low && next <= high))
        next = 0.5 * (low + high);
      const bool settled = std::fabs(next - x) <= relative * x;
      x = next;
      if (settled)
        break;
    }
    const double stress = quasiStatic(alpha + x, slope);
    const double hardening =
        2.0 / 3.0 * thermal * (slope * rateFactor(x, rise) + (x > 0.0 ? stress * rise / x : 0.0));
    return {std::sqrt(1.5) * x, x, trial - 2.0 * shear * std::sqrt(1.5) * x,
            hardening / (2.0 * shear + hardening)};
  }

  /// Work of the flow stress over an increment, trapezoidal in the plastic strain [J/m3].
  KOKKOS_INLINE_FUNCTION double work(double alpha, double increment) const
  {
    double slope = 0.0;
    const double sum = quasiStatic(alpha, slope) + quasiStatic(alpha + increment, slope);
    return 0.5 * thermal * sum * rateFactor(increment, slope) * increment;
  }
};

} // namespace Rhegma
