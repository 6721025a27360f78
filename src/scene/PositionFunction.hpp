#pragma once
/// A vector that the user gives as a function of position.

#include "base/Types.hpp"

#include <memory>
#include <string>

namespace Rhegma
{

/// One expression of x, y and z [m] for each axis, with commas between them: "1e-3 * x, -3e-4 * y". Common
/// names are defined before, each with a semicolon: "r = sqrt(x*x + y*y); x / r, y / r".
///
/// Copies use one parser: use a function from one thread at a time.
class PositionFunction
{
public:
  /// \param axes number of expressions
  /// \throws std::invalid_argument with the error in the text
  static PositionFunction parse(const std::string& text, int axes);

  /// In 2D z is 0.
  template <int D>
  Vector<D> operator()(const Vector<D>& x) const
  {
    Vector<D> value;
    evaluate(&x[0], D, D, &value[0]);
    return value;
  }

  /// The value of a function with one expression.
  template <int D>
  double scalar(const Vector<D>& x) const
  {
    double value = 0.0;
    evaluate(&x[0], D, 1, &value);
    return value;
  }

private:
  struct Form;
  explicit PositionFunction(std::shared_ptr<const Form> form);
  void evaluate(const double* x, int dimension, int axes, double* value) const;
  std::shared_ptr<const Form> m_form;
};

} // namespace Rhegma
