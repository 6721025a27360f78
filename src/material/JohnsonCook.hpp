#pragma once
/// Flow stress that depends on plastic strain, its rate and temperature.

#include "material/HighRateNumbers.hpp"
#include "material/J2Return.hpp"

namespace Rhegma
{

/// Fraction of the cold yield stress that molten metal keeps, so that its deviator has a direction.
constexpr double moltenStrength = 1.0e-6;

/// sigma_y = (A + B alpha^n + Q (1 - exp(-b alpha))) (1 + C ln(rate / reference)) (1 - T*^m),
/// T* = (T - T_0) / (T_melt - T_0), without the factor of the rate below the reference rate.
/// Source: Johnson and Cook, 7th International Symposium on Ballistics (1983) 541; the term of Voce in
/// addition.
///
/// One step from a plastic strain alpha at a temperature.
struct JohnsonCook
{
  /// The return of a step.
  struct Flow
  {
    Return back;
    double work; ///< of the flow stress, trapezoidal in the plastic strain [J/m3]
  };

  const Properties& m;
  double alpha;   ///< equivalent plastic strain at the start
  double dt;      ///< [s]
  double thermal; ///< 1 - T*^m at the temperature of the step

  KOKKOS_INLINE_FUNCTION JohnsonCook(const Properties& properties, double strain, double temperature,
                                     double duration)
      : m(properties), alpha(strain), dt(duration), thermal(1.0)
  {
    using namespace HighRateNumber;
    const double* const own = m.own;
    if (!(own[softening] > 0.0) || !(temperature > own[transition]))
      return;
    const double above = (temperature - own[transition]) / (own[meltTemperature] - own[transition]);
    thermal = above < 1.0 ? 1.0 - std::pow(above, own[softening]) : 0.0;
    thermal = thermal > moltenStrength ? thermal : moltenStrength;
  }

  /// Whether a trial deviator of this norm [Pa] flows. Only if it is above the yield stress of the unused
  /// metal is the hardening so far computed.
  KOKKOS_INLINE_FUNCTION bool flows(double trial)
  {
    using namespace HighRateNumber;
    if (!canFlow() || !(trial > std::sqrt(2.0 / 3.0) * thermal * m.own[yield]))
      return false;
    harden();
    return trial > norm();
  }

  /// Whether the material flows at all in this step: where the rate counts, a step needs a duration.
  KOKKOS_INLINE_FUNCTION bool canFlow() const
  {
    using namespace HighRateNumber;
    return m.own[yield] > 0.0 && (!(m.own[rate] > 0.0) || dt > 0.0);
  }

  /// Computes the hardening so far. Call before `norm` and `solve`.
  KOKKOS_INLINE_FUNCTION void harden()
  {
    using namespace HighRateNumber;
    const double* const own = m.own;
    power_ = own[hardening] > 0.0 && alpha > 0.0 ? own[hardening] * std::pow(alpha, own[exponent]) : 0.0;
    rest_ = own[saturation] > 0.0 ? own[saturation] * std::exp(-own[saturationRate] * alpha) : 0.0;
    start_ = own[yield] + power_ + own[saturation] - rest_;
  }

  /// Least norm of the deviator at which the material flows [Pa].
  KOKKOS_INLINE_FUNCTION double norm() const { return std::sqrt(2.0 / 3.0) * thermal * start_; }

  /// Solves q - 3 shear x = sigma_y(alpha + x, x / dt) for the increment x of plastic strain, q the
  /// equivalent trial stress. Both sides are monotonic, so that the root is between 0 and that of the stress
  /// at the start. Where the rate counts, Newton's variable is ln x, in which that factor is a straight line;
  /// a step that leaves the bracket is replaced by bisection.
  /// \param trial norm of the trial deviator, which flows [Pa] \param shear mu tr be / 3 [Pa]
  /// \param logRate ln(rate / reference) of the last step that flowed, where the search begins; out: of this
  /// one
  KOKKOS_INLINE_FUNCTION Flow solve(double trial, double shear, double& logRate) const
  {
    using namespace HighRateNumber;
    constexpr double relative = 1.0e-8; // the error left by a Newton step is the square of it
    const double C = m.own[rate], unit = m.own[referenceRate] * dt, q = std::sqrt(1.5) * trial;
    double low = 0.0, high = (q - thermal * start_) / (3.0 * shear);
    double x = high, y = 0.0, stress = 0.0, slope = 0.0, factor = 1.0, fall = 1.0;
    if (C > 0.0)
    {
      x = unit * std::exp(logRate);
      y = logRate;
      if (!(x > 0.0 && x < high))
      {
        x = high;
        y = std::log(x / unit);
      }
    }
    for (int i = 0; i < 100; ++i)
    {
      const bool counts = C > 0.0 && y > 0.0;
      stress = quasiStatic(x, slope);
      factor = counts ? 1.0 + C * y : 1.0;
      const double excess = q - 3.0 * shear * x - thermal * stress * factor;
      (excess > 0.0 ? low : high) = x;
      fall = 3.0 * shear + thermal * (slope * factor + (counts ? stress * C / x : 0.0));
      const double step = excess / fall;
      double next = counts ? x * std::exp(step / x) : x + step;
      const bool inside = next >= low && next <= high;
      next = inside ? next : 0.5 * (low + high);
      const bool settled = std::fabs(next - x) <= relative * x;
      if (C > 0.0)
        y = inside && counts ? y + step / x : std::log(next / unit);
      x = next;
      if (settled)
        break;
    }
    logRate = y;
    const double rise = 2.0 / 3.0 * (fall - 3.0 * shear); // of the norm with the multiplier
    return {{std::sqrt(1.5) * x, x, trial - 2.0 * shear * std::sqrt(1.5) * x, rise / (2.0 * shear + rise)},
            0.5 * thermal * (start_ + stress) * factor * x};
  }

private:
  double power_ = 0.0; ///< B alpha^n at the start [Pa]
  double rest_ = 0.0;  ///< Q exp(-b alpha) at the start [Pa]
  double start_ = 0.0; ///< flow stress at the start, below the reference rate and when cold [Pa]

  /// Flow stress below the reference rate and when cold, after an increment x of plastic strain [Pa]. \param
  /// slope out: by plastic strain
  KOKKOS_INLINE_FUNCTION double quasiStatic(double x, double& slope) const
  {
    using namespace HighRateNumber;
    const double* const own = m.own;
    double stress = own[yield] + own[saturation];
    slope = 0.0;
    if (own[hardening] > 0.0)
    {
      const double n = own[exponent];
      const double part =
          x < seriesLimit * alpha ? power_ * grown(x / alpha, n) : own[hardening] * std::pow(alpha + x, n);
      stress += part;
      slope += n * part / (alpha + x);
    }
    if (own[saturation] > 0.0)
    {
      const double rest = rest_ * std::exp(-own[saturationRate] * x);
      stress -= rest;
      slope += own[saturationRate] * rest;
    }
    return stress;
  }

  static constexpr double seriesLimit = 0.01;

  /// (1 + u)^n for n of order one; the first term left out is 1e-14 at the limit.
  KOKKOS_INLINE_FUNCTION static double grown(double u, double n)
  {
    const double second = n - 1.0, third = n - 2.0, fourth = n - 3.0, fifth = n - 4.0, sixth = n - 5.0;
    return 1.0 + n * u *
                     (1.0 + 0.5 * second * u *
                                (1.0 + third / 3.0 * u *
                                           (1.0 + 0.25 * fourth * u *
                                                      (1.0 + 0.2 * fifth * u * (1.0 + sixth / 6.0 * u)))));
  }
};

} // namespace Rhegma
