#include "scene/TimeFunction.hpp"

#include "scene/Numbers.hpp"

#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace Rhegma
{

struct TimeFunction::Form
{
  // A table; empty for an expression.
  std::vector<double> times;
  std::vector<double> values;
  // An expression of `t`, whose address the parser holds.
  mu::Parser parser;
  mutable double t = 0.0;
};

namespace
{

bool isTable(const std::string& text)
{
  return text.find(':') != std::string::npos && text.find('?') == std::string::npos;
}

void readTable(const std::string& text, std::vector<double>& times, std::vector<double>& values)
{
  std::size_t begin = 0;
  while (begin <= text.size())
  {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string pair = trimmed(text.substr(begin, end - begin));
    begin = end + 1;
    const std::size_t colon = pair.find(':');
    const auto time = parseReal(pair.substr(0, colon));
    const auto value = colon == std::string::npos ? std::nullopt : parseReal(pair.substr(colon + 1));
    if (!time || !value)
      throw std::invalid_argument(
          "\"" + pair + "\" is not a pair of a time and a value; write a table as \"0:0, 1e-3:5\".");
    if (!std::isfinite(*time) || !std::isfinite(*value))
      throw std::invalid_argument("\"" + pair + "\" is not finite; write finite times and values.");
    if (!times.empty() && *time <= times.back())
      throw std::invalid_argument("the times of the table must increase, but " + formatReal(*time) +
                                  " s follows " + formatReal(times.back()) + " s.");
    times.push_back(*time);
    values.push_back(*value);
  }
}

/// The parser would let "t = 1" overwrite t.
bool assigns(const std::string& text)
{
  for (std::size_t i = 0; i < text.size(); ++i)
  {
    if (text[i] != '=')
      continue;
    const bool comparesBefore = i > 0 && std::string("=<>!").find(text[i - 1]) != std::string::npos;
    const bool comparesAfter = i + 1 < text.size() && text[i + 1] == '=';
    if (!comparesBefore && !comparesAfter)
      return true;
  }
  return false;
}

std::string advice()
{
  return " Write an expression of t such as \"sin(2*pi*50*t)\" or a table such as \"0:0, 1e-3:5\".";
}

} // namespace

TimeFunction::TimeFunction(std::shared_ptr<const Form> form) : m_form(std::move(form)) {}

TimeFunction TimeFunction::parse(const std::string& text)
{
  const auto form = std::make_shared<Form>();
  if (trimmed(text).empty())
    throw std::invalid_argument("the function of time is empty." + advice());
  if (isTable(text))
  {
    readTable(text, form->times, form->values);
    return TimeFunction(form);
  }
  if (assigns(text))
    throw std::invalid_argument("\"" + text + "\" assigns with \"=\"; write \"==\" to compare.");
  try
  {
    form->parser.DefineConst("pi", 3.14159265358979323846);
    form->parser.DefineVar("t", &form->t);
    form->parser.SetExpr(text);
    int results = 0;
    form->parser.Eval(results);
    if (results != 1)
      throw std::invalid_argument("\"" + text + "\" gives " + std::to_string(results) +
                                  " values instead of one." + advice());
  }
  catch (const mu::Parser::exception_type& error)
  {
    std::string reason = error.GetMsg();
    while (!reason.empty() && (reason.back() == '.' || reason.back() == ' '))
      reason.pop_back();
    throw std::invalid_argument("\"" + text + "\" is not a function of time: " + reason + "." + advice());
  }
  return TimeFunction(form);
}

double TimeFunction::operator()(double t) const
{
  const Form& form = *m_form;
  if (form.times.empty())
  {
    form.t = t;
    return form.parser.Eval();
  }
  const auto after = std::upper_bound(form.times.begin(), form.times.end(), t);
  if (after == form.times.begin())
    return form.values.front();
  if (after == form.times.end())
    return form.values.back();
  const auto i = static_cast<std::size_t>(after - form.times.begin());
  const double share = (t - form.times[i - 1]) / (form.times[i] - form.times[i - 1]);
  return form.values[i - 1] + share * (form.values[i] - form.values[i - 1]);
}

std::optional<std::string> complaintIfNotFinite(const std::string& given, double end)
{
  const auto function = TimeFunction::parse(given);
  const int samples = 200;
  for (int i = 0; i <= samples; ++i)
  {
    const double t = end * i / samples;
    if (!std::isfinite(function(t)))
      return "\"" + given + "\" is not finite at t = " + formatReal(t) +
             " s; write a function that is finite from 0 to Final Time.";
  }
  return std::nullopt;
}

} // namespace Rhegma
