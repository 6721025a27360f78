#pragma once
/// Stress intensities as text.

#include <limits>
#include <string>

namespace Rhegma
{

/// A value in the digits that two digits of its error have. \param error not positive: in four digits
std::string inDigitsOf(double error, double value);

/// A value as text with its error, where that is a number: "2 +- 0.01", "0 +- 0.01".
std::string withError(double value, double error);

/// A stress intensity [Pa m^0.5] with a unit prefix: "1.31 +- 0.02 MPa m^0.5". \param error [Pa m^0.5]; not a
/// number: it is not known
std::string intensityAsText(double value, double error = std::numeric_limits<double>::quiet_NaN());

/// The modes of shear that are noticeable next to the opening mode: "K_II is 23 % and K_III 7 % of K_I";
/// empty where both are below 5 % or not numbers. \param two, three K_II and K_III over K_I
std::string shearAsText(double two, double three);

/// The same for a front that a toughness is compared with. In 3D, from 10 % on, it says that G alone counts:
/// only in 2D the largest hoop stress is compared, too. \param dimension of the scene
std::string shearOfComparison(double two, double three, int dimension);

} // namespace Rhegma
