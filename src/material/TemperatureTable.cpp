#include "material/TemperatureTable.hpp"

#include "base/Numbers.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace Rhegma
{

double TemperatureTable::operator()(double T) const
{
  const auto above = std::upper_bound(temperature.begin(), temperature.end(), T);
  if (above == temperature.begin())
    return value.front();
  if (above == temperature.end())
    return value.back();
  const std::size_t k = above - temperature.begin();
  const double fraction = (T - temperature[k - 1]) / (temperature[k] - temperature[k - 1]);
  return value[k - 1] + fraction * (value[k] - value[k - 1]);
}

TemperatureTable TemperatureTable::parse(const std::string& text)
{
  if (const auto number = parseReal(text))
    return {{1.0}, {*number}};
  TemperatureTable table;
  for (std::size_t begin = 0; begin <= text.size();)
  {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string pair = trimmed(text.substr(begin, end - begin));
    begin = end + 1;
    const std::size_t colon = pair.find(':');
    const auto T = parseReal(pair.substr(0, colon));
    const auto value = colon == std::string::npos ? std::nullopt : parseReal(pair.substr(colon + 1));
    if (!T || !value)
      throw std::invalid_argument("\"" + pair +
                                  "\" is not a pair of a temperature and a value; write a number or a table "
                                  "as \"293:3e9, 400:2e9\".");
    if (!std::isfinite(*T) || !std::isfinite(*value))
      throw std::invalid_argument("\"" + pair + "\" is not finite; write finite temperatures and values.");
    if (!(*T > 0.0))
      throw std::invalid_argument("the temperatures of the table are absolute, and " + formatReal(*T) +
                                  " K is not above zero.");
    if (!table.temperature.empty() && *T <= table.temperature.back())
      throw std::invalid_argument("the temperatures of the table must increase, but " + formatReal(*T) +
                                  " K follows " + formatReal(table.temperature.back()) + " K.");
    table.temperature.push_back(*T);
    table.value.push_back(*value);
  }
  return table;
}

} // namespace Rhegma
