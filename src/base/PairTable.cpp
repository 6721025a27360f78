#include "base/PairTable.hpp"

#include "base/Numbers.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace Rhegma
{

bool PairTable::isMeant(const std::string& text)
{
  return text.find(':') != std::string::npos && text.find('?') == std::string::npos;
}

PairTable::PairTable(const std::string& text, const Labels& labels)
{
  std::size_t begin = 0;
  while (begin <= text.size())
  {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string pair = trimmed(text.substr(begin, end - begin));
    begin = end + 1;
    const std::size_t colon = pair.find(':');
    const auto at = parseReal(pair.substr(0, colon));
    const auto value = colon == std::string::npos ? std::nullopt : parseReal(pair.substr(colon + 1));
    if (!at || !value)
      throw std::invalid_argument("\"" + pair + "\" is not a pair of " + labels.pair + labels.advice);
    if (!std::isfinite(*at) || !std::isfinite(*value))
      throw std::invalid_argument("\"" + pair + "\" is not finite; write finite numbers" + labels.stop);
    if (!at_.empty() && *at <= at_.back())
      throw std::invalid_argument(std::string("the ") + labels.first + " of the table must increase, but " +
                                  formatReal(*at) + labels.unit + " follows " + formatReal(at_.back()) +
                                  labels.unit + labels.stop);
    at_.push_back(*at);
    values_.push_back(*value);
  }
}

double PairTable::operator()(double x) const
{
  const auto after = std::upper_bound(at_.begin(), at_.end(), x);
  if (after == at_.begin())
    return values_.front();
  if (after == at_.end())
    return values_.back();
  const auto i = static_cast<std::size_t>(after - at_.begin());
  const double fraction = (x - at_[i - 1]) / (at_[i] - at_[i - 1]);
  return values_[i - 1] + fraction * (values_[i] - values_[i - 1]);
}

double PairTable::mean(double from, double to) const
{
  double sum = 0.0, last = from;
  const auto add = [&](double next)
  {
    sum += 0.5 * ((*this)(last) + (*this)(next)) * (next - last);
    last = next;
  };
  const auto first = std::upper_bound(at_.begin(), at_.end(), from);
  const auto end = std::lower_bound(first, at_.end(), to);
  if (first == end) // straight
    return (*this)(0.5 * (from + to));
  std::for_each(first, end, add);
  add(to);
  return sum / (to - from);
}

bool assigns(const std::string& expression)
{
  for (std::size_t i = 0; i < expression.size(); ++i)
    if (expression[i] == '=' &&
        !(i > 0 && std::string("=<>!").find(expression[i - 1]) != std::string::npos) &&
        !(i + 1 < expression.size() && expression[i + 1] == '='))
      return true;
  return false;
}

std::string withoutStop(std::string reason)
{
  while (!reason.empty() && (reason.back() == '.' || reason.back() == ' '))
    reason.pop_back();
  return reason;
}

} // namespace Rhegma
