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

std::vector<double> releasesOf(const std::vector<std::pair<std::string, double>>& row)
{
  std::vector<double> along, mean;
  for (const auto& [name, value] : row)
    if (const bool ofNodes = endsWith(name, ".G_J_max");
        std::isfinite(value) && (ofNodes || endsWith(name, ".G_J")))
      (ofNodes ? along : mean).push_back(value);
  return along.empty() ? mean : along;
}

CrackExtents extentsOf(const std::vector<std::pair<std::string, double>>& row)
{
  CrackExtents lengths, areas;
  areas.areAreas = true;
  for (const auto& [name, value] : row)
    if (std::isfinite(value) && endsWith(name, ".area"))
      areas.sizes.push_back(value);
    else if (std::isfinite(value) && endsWith(name, ".length"))
      lengths.sizes.push_back(value); // in 3D that of the front
  return areas.sizes.empty() ? lengths : areas;
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
