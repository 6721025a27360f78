#include "material/RayleighSpeed.hpp"

#include "material/LawStiffness.hpp"

#include <cmath>

namespace Rhegma
{

double rayleighSpeed(const Properties& material)
{
  if (isAnisotropic(material))
    return std::sqrt(surfaceWaveModulus(material) / material.density);
  const Elasticity e = elasticity(material);
  const double shear = e.shear / material.density;     // c_s^2
  const double ratio = e.shear / e.constrainedModulus; // c_s^2 / c_d^2
  // x = v^2 / c_s^2; the function is negative below the root and positive above it, and zero at x = 0.
  const auto excess = [&](double x)
  { return (2.0 - x) * (2.0 - x) - 4.0 * std::sqrt((1.0 - ratio * x) * (1.0 - x)); };
  double low = 0.1, high = 1.0;
  for (int i = 0; i < 60; ++i)
  {
    const double middle = 0.5 * (low + high);
    (excess(middle) < 0.0 ? low : high) = middle;
  }
  return std::sqrt(0.5 * (low + high) * shear);
}

} // namespace Rhegma
