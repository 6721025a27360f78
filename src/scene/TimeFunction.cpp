#include "scene/TimeFunction.hpp"

#include "base/AdaptiveMean.hpp"
#include "base/Numbers.hpp"
#include "base/PairTable.hpp"

#include <muParser.h>

#include <cmath>
#include <stdexcept>

namespace Rhegma
{

struct TimeFunction::Form
{
  std::string text;
  PairTable table; // empty for an expression
  // An expression of `t`, whose address the parser stores.
  mu::Parser parser;
  mutable double t = 0.0;
};

namespace
{

std::string adviceOnTime()
{
  return " Write an expression of t such as \"sin(2*pi*50*t)\" or a table such as \"0:0, 1e-3:5\".";
}

} // namespace

TimeFunction::TimeFunction(std::shared_ptr<const Form> form) : m_form(std::move(form)) {}

TimeFunction TimeFunction::parse(const std::string& text)
{
  const auto form = std::make_shared<Form>();
  form->text = trimmed(text);
  if (trimmed(text).empty())
    throw std::invalid_argument("the function of time is empty." + adviceOnTime());
  if (PairTable::isMeant(text))
  {
    form->table =
        PairTable(text, {"a time and a value", "times", " s", "; write a table as \"0:0, 1e-3:5\".", "."});
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
                                  " values instead of one." + adviceOnTime());
  }
  catch (const mu::Parser::exception_type& error)
  {
    throw std::invalid_argument("\"" + text + "\" is not a function of time: " + withoutStop(error.GetMsg()) +
                                "." + adviceOnTime());
  }
  return TimeFunction(form);
}

double TimeFunction::operator()(double t) const
{
  const Form& form = *m_form;
  if (!form.table.empty())
    return form.table(t);
  form.t = t;
  return form.parser.Eval();
}

bool TimeFunction::isSameAs(const TimeFunction& other) const { return m_form->text == other.m_form->text; }

const std::vector<double>& TimeFunction::corners() const { return m_form->table.corners(); }

double TimeFunction::overStep(double from, double to) const
{
  return m_form->table.empty() || !(to > from) ? (*this)(0.5 * (from + to)) : m_form->table.mean(from, to);
}

double TimeFunction::mean(double from, double to) const
{
  if (!(to > from))
    return (*this)(from);
  return m_form->table.empty() ? adaptiveMean(*this, from, to) : m_form->table.mean(from, to);
}

std::optional<std::string> messageIfNotFinite(const std::string& given, double end)
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
