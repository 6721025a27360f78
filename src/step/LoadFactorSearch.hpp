#pragma once
/// The factor of the loads with which a front is about to advance.

#include <algorithm>
#include <cmath>

namespace Rhegma
{

/// Finds the factor with which G/Gc is one. Its root s is in proportion to the factor in a linear body, so
/// that the second equilibrium is the answer; others take a few more by secants.
class LoadFactorSearch
{
public:
  /// Of s. It doubles with each equilibrium beyond the usual ones, up to the loosest: where particles cross
  /// cells, G jumps by more than the tolerance.
  static constexpr double tolerance = 1e-5, loosest = 1e-3;
  static constexpr int usual = 6;
  /// Largest change of the factor at a time: beyond it no straight line is trusted.
  static constexpr double most = 20.0;

  /// An equilibrium. \param factor of the loads, positive \param drive G/Gc, not negative
  void record(double factor, double drive)
  {
    before_ = last_;
    last_ = {factor, std::sqrt(drive)};
    ++count_;
  }

  bool found() const
  {
    const double now = std::ldexp(tolerance, std::max(0, count_ - usual));
    return count_ > 0 && std::fabs(last_.s - 1.0) <= std::min(now, loosest);
  }

  /// The factor with which G/Gc is one where bodies are linear; infinite where there is no G. Call after
  /// `record`.
  double proportional() const { return last_.factor / last_.s; }

  /// The factor to try next. Call after `record`.
  double next() const
  {
    const double largest = most * last_.factor, smallest = last_.factor / most;
    if (!(last_.s > 0.0))
      return largest;
    const double rise = last_.s - before_.s, run = last_.factor - before_.factor;
    // Where two equilibria lie so close together that their difference is rounding, or G falls with the load,
    // their secant says nothing.
    const bool straight = count_ > 1 && std::fabs(run) > 1e-6 * last_.factor && rise * run > 0.0;
    const double next = straight ? last_.factor + (1.0 - last_.s) * run / rise : proportional();
    return std::clamp(next, smallest, largest);
  }

private:
  struct Point
  {
    double factor = 0.0, s = 0.0;
  };
  Point before_, last_;
  int count_ = 0;
};

} // namespace Rhegma
