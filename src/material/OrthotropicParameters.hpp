#pragma once
/// Parameters of orthotropic materials: their description in a scene, and their reading. Templates of a
/// Section (scene/Schema.hpp) and of a MaterialReader, so that kernels include neither.

#include "material/LawParameters.hpp"
#include "material/OrthotropicStiffness.hpp"

#include <cmath>
#include <vector>

namespace Rhegma
{

template <class Section>
void describeOrthotropic(Section& s)
{
  describeDensity(s);
  s.realArray("Young Moduli")
      .unit("Pa")
      .length(3)
      .positive()
      .meaning("Young's moduli {E1, E2, E3} along the material's axes.");
  s.realArray("Poisson Ratios")
      .length(3)
      .meaning("Poisson's ratios {nu12, nu23, nu13}: nu12 is minus the strain along axis 2 over that along "
               "axis 1 under a stress along axis 1.");
  s.realArray("Shear Moduli")
      .unit("Pa")
      .length(3)
      .positive()
      .meaning("Shear moduli {G12, G23, G13} between the material's axes. 2D scenes use G12 only.");
  s.realArray("Fibre Direction")
      .perAxis()
      .optional("x")
      .meaning("Direction of axis 1, such as that of fibres, in the undeformed body; of any length. In 2D "
               "axis 2 is across it in the plane and axis 3 is z: for fibres along z, give the constants in "
               "another order.");
  s.realArray("Second Direction")
      .perAxis()
      .onlyIn(3)
      .optional("y")
      .meaning("Direction of axis 2 in the undeformed body; its part along Fibre Direction does not count.");
}

namespace detail
{

template <class Reader>
std::array<double, 3> readThree(const Reader& reader, const char* parameter, const char* meaning,
                                bool positive)
{
  const std::vector<double> values = reader.numbers(parameter);
  if (values.size() != 3)
    reader.refuse(parameter, std::string("has ") + std::to_string(values.size()) +
                                 " numbers; give three: " + meaning + ".");
  for (const double value : values)
    if (positive && !(value > 0.0))
      reader.refuse(parameter,
                    "has " + Reader::text(value) + "; give three positive numbers: " + meaning + ".");
  return {values[0], values[1], values[2]};
}

/// A direction of a scene, of length one.
template <class Reader>
Vector<3> readAxis(const Reader& reader, const char* parameter, int dimension, const Vector<3>& byDefault)
{
  const std::vector<double> values = reader.numbers(parameter);
  if (values.empty())
    return byDefault;
  if (static_cast<int>(values.size()) != dimension)
    reader.refuse(parameter, "has " + std::to_string(values.size()) + " numbers; give " +
                                 std::to_string(dimension) + ", one an axis.");
  Vector<3> axis{{values[0], values[1], dimension == 3 ? values[2] : 0.0}};
  const double length = norm(axis);
  if (!(length > 0.0))
    reader.refuse(parameter,
                  "is zero; give a direction, such as {1, 0" + std::string(dimension == 3 ? ", 0}." : "}."));
  return (1.0 / length) * axis;
}

} // namespace detail

/// Refuses constants without a positive energy.
template <class Reader>
OrthotropicConstants readOrthotropicConstants(const Reader& reader)
{
  const OrthotropicConstants constants{
      detail::readThree(reader, "Young Moduli", "E1, E2 and E3 [Pa]", true),
      detail::readThree(reader, "Poisson Ratios", "nu12, nu23 and nu13", false),
      detail::readThree(reader, "Shear Moduli", "G12, G23 and G13 [Pa]", true)};
  if (const std::string failed = failedInequality(constants); !failed.empty())
    reader.refuse("Poisson Ratios",
                  "no material has these with Young Moduli, its energy would be negative: " + failed +
                      " (nu12 is -(strain along 2)/(strain along 1) under a stress "
                      "along 1; nu21 = nu12 E2/E1).");
  return constants;
}

/// The material's axes in the undeformed body, of length one and at right angles.
template <class Reader>
std::array<Vector<3>, 3> readOrthotropicAxes(const Reader& reader, int dimension)
{
  const Vector<3> first = detail::readAxis(reader, "Fibre Direction", dimension, {{1.0, 0.0, 0.0}});
  Vector<3> second{{-first[1], first[0], 0.0}};
  if (dimension == 3)
  {
    second = detail::readAxis(reader, "Second Direction", 3, {{0.0, 1.0, 0.0}});
    second = second - dot(first, second) * first;
    const double length = norm(second);
    constexpr double least = 1e-3; // sine of the angle between both
    if (!(length > least))
      reader.refuse("Second Direction", "is parallel to Fibre Direction (without it, it is y); give a "
                                        "direction across the fibres.");
    second = (1.0 / length) * second;
  }
  const Vector<3> third{{first[1] * second[2] - first[2] * second[1],
                         first[2] * second[0] - first[0] * second[2],
                         first[0] * second[1] - first[1] * second[0]}};
  return {first, second, third};
}

} // namespace Rhegma
