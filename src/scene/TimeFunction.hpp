#pragma once
/// A quantity that the user gives as a function of time.

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace Rhegma
{

/// Either an expression of t [s], such as "sin(2*pi*50*t)" or "t < 1e-3 ? 1 : 0", or a table "0:0, 1e-3:5" of
/// time:value pairs with straight lines between them, held constant outside of them.
///
/// Copies use one parser: use a function from one thread at a time.
class TimeFunction
{
public:
  /// \throws std::invalid_argument with the error in the text
  static TimeFunction parse(const std::string& text);

  /// \param t  time [s]
  double operator()(double t) const;

  /// Whether both were made of the same text.
  bool isSameAs(const TimeFunction& other) const;

  /// Times of a table [s], in order; empty for an expression.
  const std::vector<double>& corners() const;

  /// Mean over a step, so that a table loses nothing between steps: exact for a table; for an expression the
  /// value in the middle. \param from \param to begin and end of the step [s]
  double overStep(double from, double to) const;

  /// Mean over a time in which an expression changes much: exact for a table, and as exact as
  /// AdaptiveMean.hpp says for an expression. \param from \param to begin and end [s]
  double mean(double from, double to) const;

private:
  struct Form;
  explicit TimeFunction(std::shared_ptr<const Form> form);
  std::shared_ptr<const Form> m_form;
};

/// Message on a function that is not finite at one of 200 times from 0 to the end of a run; none otherwise.
/// \param given the text of the function
/// \param end   of the run [s]
std::optional<std::string> messageIfNotFinite(const std::string& given, double end);

} // namespace Rhegma
