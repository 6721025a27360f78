#include "propagation/Toughness.hpp"

#include "scene/Numbers.hpp"

#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace Rhegma::propagation
{

struct Toughness::Form
{
  std::string text;
  std::vector<double> speeds, values; ///< of a table; empty for an expression
  mu::Parser parser;
  mutable double speed = 0.0, temperature = 0.0; ///< whose addresses the parser holds
};

namespace
{

const char* const advice = "; write a number, an expression of the speed v such as \"100*(1 + v/500)\", or a "
                           "table of speed:energy such as \"0:100, 500:200\"";

void readTable(const std::string& text, std::vector<double>& speeds, std::vector<double>& values)
{
  std::size_t begin = 0;
  while (begin <= text.size())
  {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string pair = trimmed(text.substr(begin, end - begin));
    begin = end + 1;
    const std::size_t colon = pair.find(':');
    const auto speed = parseReal(pair.substr(0, colon));
    const auto value = colon == std::string::npos ? std::nullopt : parseReal(pair.substr(colon + 1));
    if (!speed || !value || !std::isfinite(*speed) || !std::isfinite(*value))
      throw std::invalid_argument("\"" + pair + "\" is not a pair of a speed and an energy" + advice);
    if (!speeds.empty() && *speed <= speeds.back())
      throw std::invalid_argument("the speeds of the table must increase, but " + formatReal(*speed) +
                                  " m/s follows " + formatReal(speeds.back()) + " m/s");
    speeds.push_back(*speed);
    values.push_back(*value);
  }
}

void refuseOtherNames(mu::Parser& parser, const std::string& text, bool heated)
{
  for (const auto& used : parser.GetUsedVar())
    if (used.first == "T" && heated)
      continue;
    else if (used.first == "T")
      throw std::invalid_argument("\"" + text +
                                  "\" names the temperature T, and there is no heat in this scene; add a "
                                  "section Thermal or write it without T");
    else if (used.first != "v")
      throw std::invalid_argument("\"" + text + "\" names \"" + used.first + "\", which nothing defines" +
                                  advice);
}

} // namespace

Toughness::Toughness(std::shared_ptr<const Form> form) : form_(std::move(form)) {}

Toughness Toughness::parse(const std::string& text, bool heated)
{
  const auto form = std::make_shared<Form>();
  form->text = trimmed(text);
  if (form->text.empty())
    throw std::invalid_argument(std::string("it is empty") + advice);
  if (form->text.find(':') != std::string::npos && form->text.find('?') == std::string::npos)
  {
    readTable(form->text, form->speeds, form->values);
    return Toughness(form);
  }
  try
  {
    form->parser.DefineConst("pi", 3.14159265358979323846);
    form->parser.DefineVar("v", &form->speed);
    if (heated)
      form->parser.DefineVar("T", &form->temperature);
    form->parser.SetExpr(form->text);
    refuseOtherNames(form->parser, form->text, heated);
    int results = 0;
    form->parser.Eval(results);
    if (results != 1)
      throw std::invalid_argument("\"" + form->text + "\" gives " + std::to_string(results) +
                                  " values instead of one" + advice);
  }
  catch (const mu::Parser::exception_type& error)
  {
    std::string reason = error.GetMsg();
    while (!reason.empty() && (reason.back() == '.' || reason.back() == ' '))
      reason.pop_back();
    throw std::invalid_argument("\"" + form->text + "\" is no toughness: " + reason + advice);
  }
  if (form->speed != 0.0 || form->temperature != 0.0)
    throw std::invalid_argument("\"" + form->text + "\" assigns with \"=\"; write \"==\" to compare");
  return Toughness(form);
}

double Toughness::operator()(double speed, double temperature) const
{
  const Form& form = *form_;
  if (form.speeds.empty())
  {
    form.speed = speed;
    form.temperature = temperature;
    return form.parser.Eval();
  }
  const auto after = std::upper_bound(form.speeds.begin(), form.speeds.end(), speed);
  if (after == form.speeds.begin())
    return form.values.front();
  if (after == form.speeds.end())
    return form.values.back();
  const auto i = static_cast<std::size_t>(after - form.speeds.begin());
  const double share = (speed - form.speeds[i - 1]) / (form.speeds[i] - form.speeds[i - 1]);
  return form.values[i - 1] + share * (form.values[i] - form.values[i - 1]);
}

void Toughness::refuseWeak(double fastest, double temperature) const
{
  constexpr int samples = 200;
  for (int i = 0; i <= samples; ++i)
  {
    const double speed = fastest * i / samples, value = (*this)(speed, temperature);
    if (!(value > 0.0) || !std::isfinite(value))
      throw std::invalid_argument("\"" + form_->text + "\" is " + formatReal(value) +
                                  " J/m2 at v = " + formatReal(speed) +
                                  " m/s; write what is positive at every speed up to that of Rayleigh waves");
  }
}

} // namespace Rhegma::propagation
