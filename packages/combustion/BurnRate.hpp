#pragma once
/// How fast a face recedes under a pressure.

#include <string>
#include <utility>
#include <vector>

namespace Rhegma::combustion
{

/// r = a p^n (Vieille 1893), or a table of pressure:rate with straight lines between its points, held
/// constant outside of them.
class BurnRate
{
public:
  static BurnRate vieille(double coefficient, double exponent);
  /// \throws std::invalid_argument with the error in the text
  static BurnRate table(const std::string& text);

  /// \param pressure [Pa] \return rate [m/s]
  double operator()(double pressure) const;

private:
  double coefficient_ = 0.0, exponent_ = 0.0;
  std::vector<std::pair<double, double>> points_; ///< empty: Vieille's law
};

} // namespace Rhegma::combustion
