#include "propagation/ToughnessRatio.hpp"

#include "base/Numbers.hpp"

#include <muParser.h>

#include <cmath>
#include <stdexcept>

namespace Rhegma::propagation
{

struct ToughnessRatio::Form
{
  mu::Parser parser;
  mutable double angle = 0.0; ///< whose address the parser holds
};

namespace
{

const char* const ratioAdvice = "; write an expression of the angle a [rad] from the x axis, such as \"1 + "
                                "0.5*sin(a - 30*pi/180)^2\"";

} // namespace

ToughnessRatio::ToughnessRatio(std::shared_ptr<const Form> form) : form_(std::move(form)) {}

ToughnessRatio ToughnessRatio::parse(const std::string& text)
{
  constexpr double pi = 3.14159265358979323846;
  const auto form = std::make_shared<Form>();
  const std::string expression = trimmed(text);
  try
  {
    form->parser.DefineConst("pi", pi);
    form->parser.DefineVar("a", &form->angle);
    form->parser.SetExpr(expression);
    for (const auto& used : form->parser.GetUsedVar())
      if (used.first != "a")
        throw std::invalid_argument("\"" + expression + "\" names \"" + used.first +
                                    "\", which is not defined" + ratioAdvice);
    int results = 0;
    form->parser.Eval(results);
    if (results != 1)
      throw std::invalid_argument("\"" + expression + "\" gives " + std::to_string(results) +
                                  " values instead of one" + ratioAdvice);
  }
  catch (const mu::Parser::exception_type& error)
  {
    throw std::invalid_argument("\"" + expression +
                                "\" is not a valid expression: " + withoutStop(error.GetMsg()) + ratioAdvice);
  }
  if (form->angle != 0.0)
    throw std::invalid_argument("\"" + expression + "\" assigns with \"=\"; write \"==\" to compare");
  const ToughnessRatio ratio(form);
  for (int degrees = -180; degrees <= 180; ++degrees)
    if (const double value = ratio(degrees * pi / 180.0); !(value > 0.0) || !std::isfinite(value))
      throw std::invalid_argument(
          "\"" + expression + "\" " +
          (std::isfinite(value) ? "is " + formatReal(value) : std::string("has no value")) +
          " at an angle of " + std::to_string(degrees) +
          " degrees; write a function that is positive at all angles");
  // On two sides of the direction against the x axis: which one it has is a matter of rounding.
  constexpr double near = 1e-6;
  if (const double above = ratio(pi * (1.0 - near)), below = ratio(-pi * (1.0 - near));
      !(std::fabs(above - below) <= 1e-3 * std::fmax(std::fabs(above), std::fabs(below))))
    throw std::invalid_argument(
        "\"" + expression + "\" is " + formatReal(above) + " at 180 degrees and " + formatReal(below) +
        " at -180 degrees, which are one direction; write a periodic function, such as of sin(a)");
  return ratio;
}

double ToughnessRatio::operator()(double angle) const
{
  constexpr double turn = 2.0 * 3.14159265358979323846;
  form_->angle = std::remainder(angle, turn);
  return form_->parser.Eval();
}

} // namespace Rhegma::propagation
