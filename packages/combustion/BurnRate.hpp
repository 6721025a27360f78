#pragma once
/// How fast a face recedes under a pressure.

#include "combustion/WardSonBrewster.hpp"

#include <string>
#include <utility>
#include <vector>

namespace Rhegma::combustion
{

/// r = a p^n (Vieille 1893); a table of pressure:rate with straight lines between its points, held constant
/// outside of them; or the model of Ward, Son and Brewster, tabulated from 1 Pa to 1 TPa with powers of p
/// between points a 64th of a decade apart, good to 1e-4.
class BurnRate
{
public:
  static BurnRate vieille(double coefficient, double exponent);
  /// \throws std::invalid_argument with the error in the text
  static BurnRate table(const std::string& text);
  static BurnRate wardSonBrewster(const WardSonBrewster& solid);

  /// \param pressure [Pa] \return rate [m/s]
  double operator()(double pressure) const;

private:
  double between(double p) const; ///< points
  double coefficient_ = 0.0, exponent_ = 0.0;
  std::vector<std::pair<double, double>> points_; ///< empty: Vieille's law
  bool logarithmic_ = false;                      ///< points are logarithms of both
};

} // namespace Rhegma::combustion
