#include "program/Retries.hpp"

#include "base/Numbers.hpp"

#include <cmath>

namespace Rhegma::program
{

namespace
{

/// Fraction of the time from the state in memory to the failure; failures closer than this are at the same
/// time.
constexpr double sameTime = 0.01;

} // namespace

bool Retries::mayHelp(const std::string& failure, double from, double at)
{
  const bool again = at_ >= 0.0 && std::fabs(at - at_) <= sameTime * (at_ - from_);
  unchanged_ = again ? unchanged_ + 1 : 0;
  if (attempts_ >= most_ || unchanged_ >= 2)
    return false;
  ++attempts_;
  failure_ = failure;
  from_ = from;
  at_ = at;
  return true;
}

std::string Retries::asText() const
{
  return failure_ + "; the run returned to t = " + readableTime(from_) +
         " and continues with time steps of " + formatReal(fraction_) + " of the stable length";
}

std::string Retries::inVain() const
{
  return attempts_ == 0 ? std::string()
                        : "; time steps of " + formatReal(fraction_) +
                              " of the stable length from t = " + readableTime(from_) + " did not help";
}

} // namespace Rhegma::program
