#include "output/SampleFigures.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma
{

namespace
{

bool endsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

} // namespace

std::optional<double> largestRelease(const std::vector<std::pair<std::string, double>>& row)
{
  std::optional<double> along, mean;
  for (const auto& [name, value] : row)
  {
    const bool ofNodes = endsWith(name, ".G_J_max");
    if (!std::isfinite(value) || !(ofNodes || endsWith(name, ".G_J")))
      continue;
    std::optional<double>& largest = ofNodes ? along : mean;
    largest = std::max(largest.value_or(value), value);
  }
  return along ? along : mean;
}

std::optional<double> residualFraction(const std::vector<std::pair<std::string, double>>& row)
{
  const std::vector<std::string>& names = energyNames();
  double largest = 0.0;
  std::optional<double> residual;
  for (const auto& [name, value] : row)
    if (name == "residual")
      residual = value;
    else if (std::find(names.begin(), names.end(), name) != names.end())
      largest = std::max(largest, std::fabs(value));
  if (!residual || !std::isfinite(*residual) || !(largest > 0.0))
    return std::nullopt;
  return *residual / largest;
}

const std::vector<std::string>& energyNames()
{
  static const std::vector<std::string> names = {
      "external_work", "strain",  "kinetic", "fracture",   "damped",     "contact", "plastic",
      "heat",          "thermal", "merged",  "stabilised", "combustion", "tools"};
  return names;
}

} // namespace Rhegma
