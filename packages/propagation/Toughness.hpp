#pragma once
/// Fracture toughness.

#include <memory>
#include <string>

namespace Rhegma::propagation
{

/// Energy that a running crack requires per area of new face [J/m2], as a function of its speed v [m/s]: a
/// number, an expression such as "100*(1 + v/500)", or a table "0:100, 500:200" of speed:energy pairs with
/// straight lines between them, held constant outside of them. Expressions are muParser's.
class Toughness
{
public:
  /// \param heated whether there is a temperature that it may name \throws std::invalid_argument with the
  /// error in the text
  static Toughness parse(const std::string& text, bool heated = false);
  /// Whether the text names the temperature T.
  static bool namesTemperature(const std::string& text);

  double operator()(double speed, double temperature = 0.0) const;

  /// Throws std::invalid_argument where it is not positive and finite at a speed from 0 to `fastest`.
  void refuseWeak(double fastest, double temperature = 0.0) const;

private:
  struct Form;
  explicit Toughness(std::shared_ptr<const Form> form);
  std::shared_ptr<const Form> form_;
};

} // namespace Rhegma::propagation
