#include "base/IntensityText.hpp"

#include "base/ShortNumber.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma
{

namespace
{

constexpr double least = 0.05;    ///< of K_I that is named
constexpr double counting = 0.10; ///< from which on the criterion is named

bool atLeast(double ratio, double limit) { return std::fabs(ratio) >= limit; } // false of what is no number

std::string percent(double ratio) { return formatShort(std::round(1000.0 * std::fabs(ratio)) / 10.0) + " %"; }

} // namespace

std::string inDigitsOf(double error, double value)
{
  if (!(error > 0.0))
    return formatShort(value);
  const double unit = std::pow(10.0, std::floor(std::log10(error)) - 1.0);
  return formatShort(std::round(value / unit) * unit + 0.0); // no negative zero
}

std::string withError(double value, double error)
{
  if (!std::isfinite(error))
    return formatShort(value);
  return (std::fabs(value) < error ? inDigitsOf(error, value) : formatShort(value)) + " +- " +
         inDigitsOf(error, error);
}

std::string intensityAsText(double value, double error)
{
  const double size = std::isfinite(error) ? std::max(std::fabs(value), error) : std::fabs(value);
  return size >= 1e6   ? withError(1e-6 * value, 1e-6 * error) + " MPa m^0.5"
         : size >= 1e3 ? withError(1e-3 * value, 1e-3 * error) + " kPa m^0.5"
                       : withError(value, error) + " Pa m^0.5";
}

std::string shearAsText(double two, double three)
{
  const bool second = atLeast(two, least), third = atLeast(three, least);
  return second && third ? "K_II is " + percent(two) + " and K_III " + percent(three) + " of K_I"
         : second        ? "K_II is " + percent(two) + " of K_I"
         : third         ? "K_III is " + percent(three) + " of K_I"
                         : std::string();
}

std::string shearOfComparison(double two, double three, int dimension)
{
  const std::string text = shearAsText(two, three);
  return dimension == 3 && (atLeast(two, counting) || atLeast(three, counting))
             ? text + ", but in 3D only G is compared"
             : text;
}

} // namespace Rhegma
