#pragma once
/// Toughness that depends on the direction of growth.

#include <memory>
#include <string>

namespace Rhegma::propagation
{

/// Ratio of the toughness in a direction to `Toughness`, as a function of the angle a [rad] of the direction
/// of growth from the x axis towards the y axis: an expression of muParser.
class ToughnessRatio
{
public:
  /// \throws std::invalid_argument with the error in the text, also where it is not positive at an angle
  static ToughnessRatio parse(const std::string& text);

  double operator()(double angle) const;

private:
  struct Form;
  explicit ToughnessRatio(std::shared_ptr<const Form> form);
  std::shared_ptr<const Form> form_;
};

} // namespace Rhegma::propagation
