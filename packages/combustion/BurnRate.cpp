#include "combustion/BurnRate.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace Rhegma::combustion
{

BurnRate BurnRate::vieille(double coefficient, double exponent)
{
  BurnRate law;
  law.coefficient_ = coefficient;
  law.exponent_ = exponent;
  return law;
}

BurnRate BurnRate::table(const std::string& text)
{
  BurnRate law;
  std::stringstream pairs(text);
  for (std::string pair; std::getline(pairs, pair, ',');)
  {
    double pressure = 0.0, rate = 0.0;
    char colon = 0;
    std::string rest;
    std::stringstream numbers(pair);
    if (!(numbers >> pressure >> colon >> rate) || colon != ':' || (numbers >> rest))
      throw std::invalid_argument("\"" + pair + "\" is not pressure:rate, such as \"1e5:1e-3, 1e6:5e-3\"");
    if (!(pressure >= 0.0) || !(rate >= 0.0) || !std::isfinite(pressure) || !std::isfinite(rate))
      throw std::invalid_argument("\"" + pair + "\": pressures and rates must not be negative");
    if (!law.points_.empty() && !(pressure > law.points_.back().first))
      throw std::invalid_argument("pressures must rise from point to point");
    law.points_.emplace_back(pressure, rate);
  }
  if (law.points_.empty())
    throw std::invalid_argument(
        "the table has no point; write pressure:rate, such as \"1e5:1e-3, 1e6:5e-3\"");
  return law;
}

BurnRate BurnRate::wardSonBrewster(const WardSonBrewster& solid)
{
  constexpr int perDecade = 64, decades = 12;
  constexpr double leastRate = 1e-300; // of a surface too cold to burn, whose logarithm is to be finite
  BurnRate law;
  law.logarithmic_ = true;
  for (int k = 0; k <= perDecade * decades; ++k)
  {
    const double at = std::log(10.0) * k / perDecade;
    law.points_.emplace_back(at, std::log(std::max(burningSurface(solid, std::exp(at)).rate, leastRate)));
  }
  return law;
}

double BurnRate::operator()(double pressure) const
{
  if (logarithmic_)
    return std::exp(between(std::log(std::max(pressure, 1.0))));
  const double p = std::max(pressure, 0.0);
  if (points_.empty())
    return exponent_ == 0.0 ? coefficient_ : coefficient_ * std::pow(p, exponent_);
  return between(p);
}

double BurnRate::between(double p) const
{
  const auto above = std::upper_bound(points_.begin(), points_.end(), p,
                                      [](double x, const auto& point) { return x < point.first; });
  if (above == points_.begin())
    return points_.front().second;
  if (above == points_.end())
    return points_.back().second;
  const auto below = above - 1;
  const double fraction = (p - below->first) / (above->first - below->first);
  return below->second + fraction * (above->second - below->second);
}

} // namespace Rhegma::combustion
