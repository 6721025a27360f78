#include "base/Numbers.hpp"
#include "plan/EffectSchema.hpp"
#include "scene/UnitConversion.hpp"
#include "scene/UnitText.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

using namespace Rhegma;

namespace
{

struct Known
{
  const char* unit;
  const char* expected;
  double factor; ///< derived by hand from the definitions of the units
};

const double pi = std::acos(-1.0);

/// Units that users write. Inch, pound, calorie: 0.0254 m, 0.45359237 kg, 4.184 J as defined.
const std::vector<Known> table = {
    {"mm", "m", 1e-3},
    {"um", "m", 1e-6},
    {"\xC2\xB5m", "m", 1e-6}, // micro sign
    {"\xCE\xBCm", "m", 1e-6}, // Greek mu
    {"cm", "m", 1e-2},
    {"km", "m", 1e3},
    {"inch", "m", 0.0254},
    {"MPa", "Pa", 1e6},
    {"GPa", "Pa", 1e9},
    {"bar", "Pa", 1e5},
    {"N/mm2", "Pa", 1e6},
    {"N/mm^2", "Pa", 1e6},
    {"N/mm**2", "Pa", 1e6},
    {"N mm-2", "Pa", 1e6},
    {"psi", "Pa", 0.45359237 * 9.80665 / (0.0254 * 0.0254)},
    {"kJ/m2", "J/m2", 1e3},
    {"J/m^2", "J/m2", 1.0},
    {"J/m\xC2\xB2", "J/m2", 1.0},
    {"N/mm", "J/m2", 1e3},
    {"mJ/mm2", "J/m2", 1e3},
    {"us", "s", 1e-6},
    {"ms", "s", 1e-3},
    {"h", "min", 60.0},
    {"s", "min", 1.0 / 60.0},
    {"m/s", "m/s", 1.0},
    {"km/s", "m/s", 1e3},
    {"km/h", "m/s", 1.0 / 3.6},
    {"g/cm3", "kg/m3", 1e3},
    {"kg/m3", "kg/m3", 1.0},
    {"t/m3", "kg/m3", 1e3},
    {"deg", "degrees", 1.0},
    {"rad", "degrees", 180.0 / pi},
    {"rpm", "rad/s", 2.0 * pi / 60.0},
    {"deg/s", "rad/s", pi / 180.0},
    {"W/(m K)", "W/(m K)", 1.0},
    {"W/m/K", "W/(m K)", 1.0},
    {"W/(m*K)", "W/(m K)", 1.0},
    {"mW/(mm K)", "W/(m K)", 1.0},
    {"W/(m degC)", "W/(m K)", 1.0},
    {"1/K", "1/K", 1.0},
    {"1/degC", "1/K", 1.0},
    {"um/(m K)", "1/K", 1e-6},
    {"kJ/(kg K)", "J/(kg K)", 1e3},
    {"W/mm2", "W/m2", 1e6},
    {"kN", "N", 1e3},
    {"mPa s", "Pa s", 1e-3},
    {"cm3/kg", "m3/kg", 1e-6},
    // With a root: Pa m^0.5 = N m^-1.5, so that N mm^-1.5 is 1000^1.5 of it.
    {"MPa m^0.5", "Pa m^0.5", 1e6},
    {"MPa m^(1/2)", "Pa m^0.5", 1e6},
    {"MPa*m**0.5", "Pa m^0.5", 1e6},
    {"MPa sqrt(m)", "Pa m^0.5", 1e6},
    {"MPa\xE2\x88\x9Am", "Pa m^0.5", 1e6},
    {"m^0.5 kPa", "Pa m^0.5", 1e3},
    {"MPa mm^0.5", "Pa m^0.5", 1e6 * std::sqrt(1e-3)},
    {"N/mm^1.5", "Pa m^0.5", std::pow(1e3, 1.5)},
    {"N/(mm^2) mm^0.5", "Pa m^0.5", std::pow(1e3, 1.5)},
    {"psi inch^0.5", "Pa m^0.5", 0.45359237 * 9.80665 / (0.0254 * 0.0254) * std::sqrt(0.0254)},
};

/// The reason for which a unit is refused; empty if it is not.
std::string reasonOf(const std::string& given, const std::string& expected,
                     TemperatureKind kind = TemperatureKind::Absolute)
{
  try
  {
    conversionOf(given, expected, kind);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return {};
}

void expectReason(const std::string& given, const std::string& expected,
                  const std::vector<std::string>& pieces)
{
  const std::string reason = reasonOf(given, expected);
  EXPECT_FALSE(reason.empty()) << given << " is accepted for " << expected;
  for (const std::string& piece : pieces)
    EXPECT_NE(reason.find(piece), std::string::npos) << given << ": " << reason << "\nlacks " << piece;
}

/// Adds the units of a section and of all in it.
void collect(const Section& section, std::set<std::string>& units)
{
  for (const Parameter& parameter : section.parameters)
    if (!parameter.unit.empty())
      units.insert(parameter.unit);
  for (const auto* more : {&section.sections, &section.variants, &section.entry})
    for (const Section& sub : *more)
      collect(sub, units);
}

} // namespace

TEST(Units, HaveTheFactorsOfTheirDefinitions)
{
  std::random_device device;
  const unsigned seed = device();
  std::cout << "seed " << seed << "\n";
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1e3, 1e3);
  // A product, a quotient and the rounding to a decimal: each within two units of the last position.
  const double few = 8.0 * std::numeric_limits<double>::epsilon();
  for (const Known& known : table)
  {
    const UnitConversion conversion = conversionOf(known.unit, known.expected);
    EXPECT_EQ(conversion.offset, 0.0) << known.unit;
    EXPECT_NEAR(conversion(1.0) / known.factor, 1.0, few) << known.unit;
    const double x = number(random);
    EXPECT_NEAR(conversion(x), x * known.factor, few * std::fabs(x * known.factor))
        << known.unit << " of " << x;
  }
}

TEST(Units, OfStressIntensityAreOfThatAlone)
{
  for (const char* unit : {"MPa", "MPa m", "J/m2", "MPa m^0.6", "MPa mm^1.5", "MPa s^0.5", "m^0.5",
                           "MPa m^0.5 m^0.5", "m^0.5/MPa", "MPa/m^0.5", "Pa^0.5 m", "MPa sqrt m", "MPa^1.5"})
    expectReason(unit, "Pa m^0.5", {"stress intensity", "MPa m^0.5"});
  expectReason("MPa m^0.5", "J/m2", {"K_Ic", "K^2 (1 - nu^2) / E"});
}

TEST(Units, OfPowersOfTenGiveTheNumberThatIsWrittenInSi)
{
  const unsigned seed = std::random_device()();
  std::cout << "seed " << seed << "\n";
  std::mt19937 random(seed);
  std::uniform_int_distribution<long long> digits(1, 999999999999);
  const std::vector<std::pair<const char*, int>> powers = {
      {"mm", -3}, {"um", -6}, {"cm", -2}, {"km", 3}, {"nm", -9}};
  for (int trial = 0; trial < 20000; ++trial)
  {
    const auto& [unit, power] = powers[trial % powers.size()];
    const std::string written = std::to_string(digits(random)) + "e-";
    const int scale = static_cast<int>(random() % 14);
    const auto given = parseReal(written + std::to_string(scale));
    const auto expected = parseReal(written + std::to_string(scale - power));
    if (scale - power < 0) // "1e--3" is no number
      continue;
    ASSERT_TRUE(given && expected);
    ASSERT_EQ(conversionOf(unit, "m")(*given), *expected) << written << scale << " " << unit;
  }
  EXPECT_EQ(conversionOf("g/cm3", "kg/m3")(7.83), 7830.0);
  EXPECT_EQ(conversionOf("mm", "m")(1.1), 0.0011);
}

TEST(Units, ThatAreThoseOfTheParameterChangeNothing)
{
  const double odd = 0.1 + 0.2; // more than 15 digits
  EXPECT_EQ(conversionOf("m", "m")(odd), odd);
  EXPECT_EQ(conversionOf("N/m", "J/m2")(odd), odd);
  // More digits than a decimal keeps are rounded once.
  EXPECT_NEAR(conversionOf("mm", "m")(odd), odd * 1e-3,
              4.0 * std::numeric_limits<double>::epsilon() * odd * 1e-3);
}

TEST(Units, OfTemperaturesCountFromTheirZero)
{
  EXPECT_EQ(conversionOf("degC", "K")(20.0), 293.15);
  EXPECT_EQ(conversionOf("\xC2\xB0"
                         "C",
                         "K")(25.3),
            298.45);
  EXPECT_EQ(conversionOf("celsius", "K")(-273.15), 0.0);
  EXPECT_NEAR(conversionOf("degF", "K")(32.0), 273.15, 1e-12); // libudunits2 has 12 digits of 5/9
  EXPECT_NEAR(conversionOf("degF", "K")(212.0), 373.15, 1e-11);
  EXPECT_EQ(conversionOf("K", "K", TemperatureKind::Difference)(20.0), 20.0);
  EXPECT_EQ(conversionOf("mK", "K", TemperatureKind::Difference)(20.0), 0.02);
  EXPECT_NE(reasonOf("degC", "K", TemperatureKind::Difference).find("difference of temperatures"),
            std::string::npos);
  // Per degree there is no zero to count from.
  EXPECT_EQ(conversionOf("W/(m2 degC)", "W/(m2 K)")(3.0), 3.0);
}

TEST(Units, OfAnotherDimensionAreRefused)
{
  expectReason("MPa", "J/m2", {"MPa, a pressure", "energy per area", "J/m2, kJ/m2 or N/mm"});
  expectReason("kJ/m2", "Pa", {"kJ/m2, an energy per area", "pressure", "MPa"});
  expectReason("mm2", "m", {"an area", "a length"});
  expectReason("C", "K", {"an electric charge", "a temperature", "degC"});
  expectReason("deg", "K", {"an angle", "a temperature"});
  expectReason("W/m K", "W/(m K)", {"parentheses", "W/(m K)"});
  expectReason("kg m5/s", "m", {"kg m5 s-1"});
  // Angles count: a revolution is not a pure number.
  expectReason("Hz", "rad/s", {"a rate", "an angular velocity", "rpm"});
  expectReason("rpm", "1/s", {"an angular velocity", "a rate"});
  expectReason("%", "degrees", {"a pure number", "an angle"});
}

TEST(Units, ThatNobodyKnowsAreRefused)
{
  expectReason("Gpa", "Pa", {"\"Gpa\"", "no known unit", "\"GPa\""});
  expectReason("furlongs_", "m", {"no known unit", "m, mm or um"});
  expectReason("", "m", {"empty"});
  expectReason("  ", "m", {"empty"});
  expectReason("m;s", "m", {"no unit"});
  expectReason(std::string(70, 'm'), "m", {"60 characters"});
  expectReason("seconds since 1970", "s", {"no numbers"});
  expectReason("dBm", "W", {"no known unit"});
}

TEST(Units, WithRootsOrNumbersAreRefused)
{
  // libudunits2 alone reads "MPa m^0.5" as 0.5 MPa.
  for (const char* unit : {"MPa m^0.5", "MPa*sqrt(m)", "MPa m^(1/2)", "MPa m**0.5", "MPa m0.5", "MPa m1/2"})
  {
    expectReason(unit, "J/m2", {"a unit with a root", "K^2 / E"});
    expectReason(unit, "Pa", {"a unit with a root", "such as Pa"});
  }
  for (const char* unit : {"10 mm", "mm 10", "1e-6/K", "0.5 m", "m10", "2", "10^-6/K", "1 m"})
    expectReason(unit, "m", {"no numbers other than whole powers"});
}

TEST(Units, OfTheSchemaAreKnown)
{
  std::set<std::string> units, others;
  collect(effectSchema().root(), units);
  ASSERT_GT(units.size(), 20u);
  for (const std::string& unit : units)
    if (!isConvertible(unit))
      others.insert(unit);
    else
      EXPECT_EQ(conversionOf(unit, unit)(1.5), 1.5) << unit;
  EXPECT_EQ(others, (std::set<std::string>{"Pa:m/s", "m/s/Pa^n", "m2 Pa^n"}));
  expectReason("m/s", "m/s/Pa^n", {"m/s/Pa^n is not converted"});
}

TEST(Units, OfAnyTextAreRefusedOrConverted)
{
  const unsigned seed = std::random_device()();
  std::cout << "seed " << seed << "\n";
  std::mt19937 random(seed);
  const std::vector<std::string> pieces = {"m",  "k",  "Pa", "s", "K",   "1",    "2",       "^",
                                           "-",  "/",  "*",  "(", ")",   " ",    ".",       "e",
                                           "lg", "re", "@",  "0", "deg", "from", "\xC2\xB5"};
  int converted = 0;
  for (int trial = 0; trial < 20000; ++trial)
  {
    std::string unit;
    for (std::size_t k = random() % 6 + 1; k > 0; --k)
      unit += pieces[random() % pieces.size()];
    try
    {
      const UnitConversion conversion = conversionOf(unit, trial % 2 == 0 ? "m" : "Pa");
      ++converted;
      ASSERT_TRUE(std::isfinite(conversion(1.0)) && conversion(1.0) > 0.0) << unit;
    }
    catch (const std::invalid_argument& error)
    {
      ASSERT_FALSE(std::string(error.what()).empty()) << unit;
    }
  }
  EXPECT_GT(converted, 0);
}

TEST(Units, AreDividedFromTheirNumbers)
{
  const auto expect = [](const std::string& text, const std::string& value, const std::string& unit)
  {
    const auto quantity = quantityOf(text);
    ASSERT_TRUE(quantity) << text;
    EXPECT_EQ(quantity->value, value);
    EXPECT_EQ(quantity->unit, unit);
  };
  expect("2.5 MPa", "2.5", "MPa");
  expect(" -1e-3m ", "-1e-3", "m");
  expect("2eV", "2", "eV");
  expect(".5 1/K", ".5", "1/K");
  expect("20 \xC2\xB0"
         "C",
         "20",
         "\xC2\xB0"
         "C");
  expect("{0, 1.5} mm", "{0, 1.5}", "mm");
  for (const char* text : {"2.5", "2*t", "0:0, 1e-3:5", "mm", "", "1, 2 mm", "{1, x} mm", "2 3", "1 1",
                           "5 /2", "2 - t", "1e5", "{1, 2}", "t < 1 ? 2 : 3", "300 + 1e4 * x", ". m"})
    EXPECT_FALSE(quantityOf(text)) << text;
}
