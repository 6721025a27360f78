#include "propagation/Toughness.hpp"

#include "base/Numbers.hpp"
#include "base/PairTable.hpp"

#include <muParser.h>

#include <cmath>
#include <stdexcept>

namespace Rhegma::propagation
{

struct Toughness::Form
{
  std::string text;
  PairTable table; ///< of speeds; empty for an expression
  mu::Parser parser;
  mutable double speed = 0.0, temperature = 0.0; ///< whose addresses the parser holds
};

namespace
{

const char* const advice = "; write a number, an expression of the speed v such as \"100*(1 + v/500)\", or a "
                           "table of speed:energy such as \"0:100, 500:200\"";

void refuseOtherNames(mu::Parser& parser, const std::string& text, bool heated)
{
  for (const auto& used : parser.GetUsedVar())
    if (used.first == "T" && heated)
      continue;
    else if (used.first == "T")
      throw std::invalid_argument(
          "\"" + text +
          "\" depends on the temperature T, but the scene has no section Thermal; add the "
          "section or write the toughness without T");
    else if (used.first != "v")
      throw std::invalid_argument("\"" + text + "\" names \"" + used.first + "\", which is not defined" +
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
  if (PairTable::isMeant(form->text))
  {
    form->table = PairTable(form->text, {"a speed and an energy", "speeds", " m/s", advice, ""});
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
    throw std::invalid_argument("\"" + form->text +
                                "\" is not a valid toughness: " + withoutStop(error.GetMsg()) + advice);
  }
  if (form->speed != 0.0 || form->temperature != 0.0)
    throw std::invalid_argument("\"" + form->text + "\" assigns with \"=\"; write \"==\" to compare");
  return Toughness(form);
}

bool Toughness::namesTemperature(const std::string& text)
{
  const auto parses = [&](bool heated)
  {
    try
    {
      return parse(text, heated), true;
    }
    catch (const std::invalid_argument&)
    {
      return false;
    }
  };
  return parses(true) && !parses(false);
}

double Toughness::operator()(double speed, double temperature) const
{
  const Form& form = *form_;
  if (!form.table.empty())
    return form.table(speed);
  form.speed = speed;
  form.temperature = temperature;
  return form.parser.Eval();
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
                                  " m/s; write a function that is positive up to the Rayleigh wave speed");
  }
}

} // namespace Rhegma::propagation
