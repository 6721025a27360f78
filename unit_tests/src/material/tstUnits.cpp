/// Warnings of constants in other than SI units.

#include "material/MaterialTable.hpp"
#include "material/Units.hpp"

#include <gtest/gtest.h>

namespace Rhegma
{
namespace Test
{

std::vector<std::string> warningsOf(double young, double density)
{
  Teuchos::ParameterList list;
  list.set("Model", "Linear Elastic");
  list.set("Density", density);
  list.set("Young Modulus", young);
  list.set("Poisson Ratio", 0.0);
  return warningsOfUnits({"Glass"}, {makeProperties(list, "Glass", Plane::Solid)});
}

TEST(Units, OfSolidsFromGelsToDiamondAreNotDoubted)
{
  for (const auto& [young, density] :
       {std::pair{70e9, 2500.0}, {1e6, 1000.0}, {1.1e12, 3500.0}, {1.01e5, 1000.0}})
    EXPECT_TRUE(warningsOf(young, density).empty()) << young << " Pa, " << density << " kg/m3";
}

TEST(Units, OfAModulusInGigapascalsAreDoubted)
{
  const auto warnings = warningsOf(70.0, 2800.0); // sqrt(70 / 2800) m/s
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("Materials > Glass: its wave speed is 0.1581 m/s, lower"), std::string::npos)
      << warnings[0];
}

TEST(Units, OfADensityInGramsAreDoubted)
{
  const auto warnings = warningsOf(70e9, 2.8); // sqrt(70e9 / 2.8) m/s
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("1.581e+05 m/s, higher than in diamond"), std::string::npos) << warnings[0];
}

} // namespace Test
} // namespace Rhegma
