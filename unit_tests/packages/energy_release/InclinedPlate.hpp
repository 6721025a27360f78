#pragma once
/// An infinite plate with an inclined crack, of which a square is cut out whose rim moves as the closed form
/// says.

#include "Pi.hpp"
#include "src/step/ElasticBox.hpp"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace Rhegma
{
namespace Test
{

/// A crack in an infinite plate in plane stress, the stress far away in its frame, and the pressure on its
/// faces.
struct InclinedCrack
{
  ElasticSolid solid;
  double halfLength;              ///< [m]
  double angle, x, y;             ///< of the crack and of its middle [m]
  double opening, sliding, along; ///< [Pa]
  double pressure = 0.0;          ///< [Pa]
  double modeI() const { return (opening + pressure) * std::sqrt(pi * halfLength); }
  double modeII() const { return sliding * std::sqrt(pi * halfLength); }
};

/// A crack at `angle`, pulled by `load` in a direction `turn` away from its normal. Without a turn the stress
/// along the crack is -load at its tip: it is stable.
inline InclinedCrack pulled(const ElasticSolid& solid, double halfLength, double load, double angle,
                            double turn, double x, double y)
{
  const double c = std::cos(turn), s = std::sin(turn);
  return {solid, halfLength, angle, x, y, load * c * c, -load * s * c, load * s * s};
}

/// The displacement by Westergaard's functions, that under pressure as under tension from all sides less the
/// tension of the plate without a crack (Westergaard, J. Appl. Mech. 6 (1939) A49; Sih, Int. J. Fract.
/// Mech. 2 (1966) 628) over the time of loading, as a scene takes it.
inline std::string displacement(const InclinedCrack& crack, double loading)
{
  const double poisson = crack.solid.poisson;
  const double shear = crack.solid.young / (2.0 * (1.0 + poisson)), k = (3.0 - poisson) / (1.0 + poisson);
  std::ostringstream text;
  text << std::setprecision(15) << "c = " << std::cos(crack.angle) << "; s = " << std::sin(crack.angle)
       << "; a = " << crack.halfLength << "; X = x - (" << crack.x << "); Y = y - (" << crack.y
       << "); p = c*X + s*Y; q = c*Y - s*X;"
       << "r = sqrt(sqrt(((p-a)^2 + q^2) * ((p+a)^2 + q^2))); h = (atan2(q, p-a) + atan2(q, p+a)) / 2;"
       << "f = r*cos(h); g = r*sin(h); m = (p*cos(h) + q*sin(h)) / r; n = (q*cos(h) - p*sin(h)) / r;"
       << "P = (" << crack.opening + crack.pressure << "); T = (" << crack.sliding << "); N = ("
       << crack.along - crack.opening << ");"
       << "D = (" << -0.5 * (k - 1.0) * crack.pressure << ");"
       << "u = (P*(" << 0.5 * (k - 1.0) << "*f - q*n) + D*p + T*(" << 0.5 * (k + 1.0) << "*g + q*m) + N*"
       << 0.25 * (k + 1.0) << "*p) / " << 2.0 * shear << ";"
       << "v = (P*(" << 0.5 * (k + 1.0) << "*g - q*m) + D*q - T*(" << 0.5 * (k - 1.0) << "*f + q*n) + N*("
       << 0.25 * (k - 3.0) << ")*q) / " << 2.0 * shear << ";"
       << "(c*u - s*v) / " << loading << ", (s*u + c*v) / " << loading;
  return text.str();
}

/// A square of twice `half` a side, loaded in 20 microseconds and damped; its crack's energy release is
/// measured. \param half [m]
inline Teuchos::ParameterList inclinedPlate(const InclinedCrack& crack, double half, double cell)
{
  Teuchos::ParameterList scene =
      elasticBox<2>(all<2>(-half), all<2>(half), cell, 2.0, crack.solid, "Plate", "Stress");
  Teuchos::ParameterList& rim = scene.sublist("Boundaries").sublist("Rim");
  rim.set("Type", "Velocity");
  rim.set("Nodes", "Outside");
  rim.set("Lower Corner", array(all<2>(-half)));
  rim.set("Upper Corner", array(all<2>(half)));
  rim.set("Field", displacement(crack, 2e-5));
  // Its sum over steps is 1 to the third order of the step.
  rim.set("History", "t < 2e-5 ? 1 - cos(2*pi*t/2e-5) : 0");
  const double c = crack.halfLength * std::cos(crack.angle), s = crack.halfLength * std::sin(crack.angle);
  scene.sublist("Cracks").sublist("Notch").set(
      "Points", Teuchos::Array<double>(Teuchos::tuple(crack.x - c, crack.y - s, crack.x + c, crack.y + s)));
  scene.sublist("Energy Release").set("Crack Closure", false);
  // 1.3 times the lowest frequency of a held square is close to critical.
  const double shearSpeed =
      std::sqrt(crack.solid.young / (2.0 * (1.0 + crack.solid.poisson)) / crack.solid.density);
  scene.sublist("Damping").set("Mass Rate", 1.3 * pi * shearSpeed / (std::sqrt(2.0) * half));
  return scene;
}

} // namespace Test
} // namespace Rhegma
