#include "program/GrowthInHistory.hpp"

#include <algorithm>
#include <limits>

namespace Rhegma::program
{

namespace
{

bool endsIn(const std::string& name, const std::string& suffix)
{
  return name.size() > suffix.size() && name.compare(name.size() - suffix.size(), suffix.size(), suffix) == 0;
}

} // namespace

bool growsByArea(const HistoryColumns& history)
{
  return std::any_of(history.begin(), history.end(),
                     [](const auto& column) { return endsIn(column.first, ".area"); });
}

std::vector<double> growthOf(const HistoryColumns& history)
{
  const std::string suffix =
      growsByArea(history) ? ".area" : ".length"; // in 3D the length is that of the front
  std::vector<double> growth;
  for (const auto& [name, values] : history)
    if (endsIn(name, suffix) && !values.empty())
    {
      growth.resize(values.size(), 0.0);
      for (std::size_t k = 0; k < values.size(); ++k)
        growth[k] += values[k] - values.front();
    }
  return growth;
}

double factorAt(const HistoryColumns& history, double growth)
{
  const std::vector<double> grown = growthOf(history);
  const auto factor = history.find("load_factor");
  if (factor == history.end())
    return std::numeric_limits<double>::quiet_NaN();
  const std::size_t rows = std::min(grown.size(), factor->second.size());
  for (std::size_t k = 1; k < rows; ++k)
    if (grown[k] >= growth && grown[k] > grown[k - 1])
    {
      const double part = std::max(0.0, growth - grown[k - 1]) / (grown[k] - grown[k - 1]);
      return factor->second[k - 1] + part * (factor->second[k] - factor->second[k - 1]);
    }
  return std::numeric_limits<double>::quiet_NaN();
}

} // namespace Rhegma::program
