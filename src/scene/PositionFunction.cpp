#include "scene/PositionFunction.hpp"

#include "base/Numbers.hpp"
#include "base/PairTable.hpp"

#include <muParser.h>

#include <deque>
#include <stdexcept>

namespace Rhegma
{

namespace
{

const std::string adviceOnPosition =
    " Write one expression of x, y, z for each axis, such as \"1e-3*x, -3e-4*y\".";

} // namespace

struct PositionFunction::Form
{
  /// A definition, or as the last piece the expressions; parsers store the addresses of coordinates and
  /// values.
  struct Piece
  {
    std::string name;
    mu::Parser parser;
    mutable double value = 0.0;
  };
  mutable double x[3] = {0.0, 0.0, 0.0};
  std::deque<Piece> pieces;

  bool knows(const std::string& name) const
  {
    for (const Piece& piece : pieces)
      if (piece.name == name)
        return true;
    return name == "x" || name == "y" || name == "z" || name == "pi";
  }

  void define(const std::string& text)
  {
    const std::size_t equals = text.find('=');
    const std::string name = trimmed(text.substr(0, equals));
    if (equals == std::string::npos || name.empty() || knows(name))
      throw std::invalid_argument("\"" + text +
                                  "\" defines no new name; write definitions as \"r = sqrt(x*x + y*y);\" "
                                  "before the expressions.");
    add(name, trimmed(text.substr(equals + 1)), 1);
  }

  void add(const std::string& name, const std::string& text, int values)
  {
    if (assigns(text))
      throw std::invalid_argument("\"" + text + "\" assigns with \"=\"; write \"==\" to compare.");
    pieces.emplace_back();
    mu::Parser& parser = pieces.back().parser;
    try
    {
      parser.DefineConst("pi", 3.14159265358979323846);
      const char* const axes[3] = {"x", "y", "z"};
      for (int d = 0; d < 3; ++d)
        parser.DefineVar(axes[d], &x[d]);
      for (std::size_t i = 0; i + 1 < pieces.size(); ++i)
        parser.DefineVar(pieces[i].name, &pieces[i].value);
      parser.SetExpr(text);
      int results = 0;
      parser.Eval(results);
      if (results != values)
        throw std::invalid_argument("\"" + text + "\" gives " + std::to_string(results) +
                                    (results == 1 ? " value" : " values") + " instead of " +
                                    std::to_string(values) + "." + (name.empty() ? adviceOnPosition : ""));
      if (!name.empty())
        mu::Parser().DefineVar(name, &pieces.back().value); // refuses invalid names
    }
    catch (const mu::Parser::exception_type& error)
    {
      throw std::invalid_argument("\"" + (name.empty() ? text : name + " = " + text) +
                                  "\" is not a function of position: " + withoutStop(error.GetMsg()) + "." +
                                  adviceOnPosition);
    }
    pieces.back().name = name;
  }
};

PositionFunction::PositionFunction(std::shared_ptr<const Form> form) : m_form(std::move(form)) {}

PositionFunction PositionFunction::parse(const std::string& text, int axes)
{
  const auto form = std::make_shared<Form>();
  std::size_t begin = 0;
  for (std::size_t end = text.find(';'); end != std::string::npos; end = text.find(';', begin))
  {
    form->define(trimmed(text.substr(begin, end - begin)));
    begin = end + 1;
  }
  const std::string last = trimmed(text.substr(begin));
  if (last.empty())
    throw std::invalid_argument("the function of position is empty." + adviceOnPosition);
  form->add("", last, axes);
  return PositionFunction(form);
}

void PositionFunction::evaluate(const double* x, int dimension, int axes, double* value) const
{
  for (int d = 0; d < dimension; ++d)
    m_form->x[d] = x[d];
  for (std::size_t i = 0; i + 1 < m_form->pieces.size(); ++i)
    m_form->pieces[i].value = m_form->pieces[i].parser.Eval();
  int results = 0;
  const double* values = m_form->pieces.back().parser.Eval(results);
  for (int d = 0; d < axes; ++d)
    value[d] = values[d];
}

} // namespace Rhegma
