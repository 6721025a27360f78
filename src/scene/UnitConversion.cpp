#include "scene/UnitConversion.hpp"

#include "base/Numbers.hpp"
#include "scene/NearestName.hpp"
#include "scene/RootUnit.hpp"
#include "scene/UnitText.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <udunits2.h>
#include <utility>
#include <vector>

namespace Rhegma
{

namespace
{

struct FreeUnit
{
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
struct FreeSystem
{
  void operator()(ut_system* system) const { ut_free_system(system); }
};
using UnitPointer = std::unique_ptr<ut_unit, FreeUnit>;

/// A unit in those of the SI: factor * (x + offset), and the powers of the base units, angles included.
struct Measure
{
  std::map<std::string, int> powers;
  double factor = 1.0;
  double offset = 0.0;
};

/// The number with at most 15 digits that a rounded product stands for, if there is one: libudunits2 gives
/// 999.9999999999999 for g/cm3 in kg/m3. \param scale size of what the product is rounded from
double asDecimal(double value, double scale)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.15g", value);
  const double rounded = *parseReal(text);
  constexpr double few = 4.0 * std::numeric_limits<double>::epsilon();
  return std::fabs(rounded - value) <= few * scale ? rounded : value;
}

// The visitor of libudunits2: it calls the function for the form of the unit.
ut_status visitBasic(const ut_unit* unit, void* measure)
{
  ++static_cast<Measure*>(measure)->powers[ut_get_symbol(unit, UT_ASCII)];
  return UT_SUCCESS;
}

ut_status visitProduct(const ut_unit*, int count, const ut_unit* const* units, const int* powers,
                       void* measure)
{
  for (int k = 0; k < count; ++k)
    static_cast<Measure*>(measure)->powers[ut_get_symbol(units[k], UT_ASCII)] += powers[k];
  return UT_SUCCESS;
}

ut_status visitGalilean(const ut_unit*, double scale, const ut_unit* underlying, double offset,
                        void* measure);

/// Dates and decibels.
ut_status refuseDate(const ut_unit*, const ut_unit*, double, void*) { return UT_MEANINGLESS; }
ut_status refuseLogarithm(const ut_unit*, double, const ut_unit*, void*) { return UT_MEANINGLESS; }

const ut_visitor measuring = {visitBasic, visitProduct, visitGalilean, refuseDate, refuseLogarithm};

ut_status visitGalilean(const ut_unit*, double scale, const ut_unit* underlying, double offset, void* measure)
{
  Measure& all = *static_cast<Measure*>(measure);
  const ut_status status = ut_accept_visitor(underlying, &measuring, measure);
  all.offset = offset + all.offset / scale;
  all.factor *= scale;
  return status;
}

int printNothing(const char*, va_list) { return 0; }

/// The units that libudunits2 knows, and a few more names. Use from one thread at a time.
class UnitSystem
{
public:
  UnitSystem()
  {
    ut_set_error_message_handler(printNothing);
    system_.reset(ut_read_xml(nullptr));
    if (system_ == nullptr)
      return;
    constexpr std::array<std::pair<const char*, const char*>, 2> more{
        {{"deg", "arc_degree"}, {"degs", "arc_degree"}}};
    for (const auto& [name, meaning] : more)
      if (const UnitPointer unit(ut_parse(system_.get(), meaning, UT_UTF8)); unit != nullptr)
        ut_map_name_to_unit(name, UT_UTF8, unit.get());
  }

  bool isThere() const { return system_ != nullptr; }

  std::optional<Measure> measure(const std::string& text) const
  {
    const UnitPointer unit(ut_parse(system_.get(), trimmed(text).c_str(), UT_UTF8));
    Measure measure;
    if (unit == nullptr || ut_accept_visitor(unit.get(), &measuring, &measure) != UT_SUCCESS)
      return {};
    for (auto power = measure.powers.begin(); power != measure.powers.end();)
      power = power->second == 0 ? measure.powers.erase(power) : std::next(power);
    return measure;
  }

private:
  std::unique_ptr<ut_system, FreeSystem> system_;
};

/// Made when the first unit is met: most scenes have none. Throws std::invalid_argument without its data.
const UnitSystem& unitSystem()
{
  static const UnitSystem system;
  if (!system.isThere())
    throw std::invalid_argument(
        "has a unit, but the table of units of libudunits2 is missing on this machine; "
        "install it (Debian: libudunits2-data), set UDUNITS2_XML_PATH to its "
        "udunits2.xml, or write numbers in SI units.");
  return system;
}

std::mutex& unitMutex()
{
  static std::mutex mutex;
  return mutex;
}

/// What a unit is of, such as "a pressure".
std::string dimensionAsText(const Measure& measure)
{
  static const std::vector<std::pair<const char*, const char*>> known = {
      {"m", "a length"},
      {"m2", "an area"},
      {"m3", "a volume"},
      {"s", "a time"},
      {"kg", "a mass"},
      {"kg/m3", "a density"},
      {"m/s", "a speed"},
      {"m/s2", "an acceleration"},
      {"N", "a force"},
      {"Pa", "a pressure or stress"},
      {"J", "an energy"},
      {"W", "a power"},
      {"J/m2", "an energy per area"},
      {"K", "a temperature"},
      {"1/K", "an inverse temperature"},
      {"W/(m K)", "a thermal conductivity"},
      {"J/(kg K)", "a specific heat"},
      {"W/(m2 K)", "a heat transfer coefficient"},
      {"W/m2", "a heat flux"},
      {"W/m3", "a power per volume"},
      {"Pa s", "a viscosity"},
      {"1/s", "a rate"},
      {"rad", "an angle"},
      {"rad/s", "an angular velocity"},
      {"m3/kg", "a volume per mass"},
      {"C", "an electric charge"},
      {"1", "a pure number"},
  };
  for (const auto& [unit, name] : known)
    if (const auto other = unitSystem().measure(unit); other && other->powers == measure.powers)
      return name;
  std::string base;
  for (const auto& [unit, power] : measure.powers)
    base += (base.empty() ? "" : " ") + unit + (power == 1 ? "" : std::to_string(power));
  return "a quantity in " + base;
}

/// Some units of a dimension.
std::vector<std::string> usualUnits(const Measure& measure, TemperatureKind kind)
{
  std::vector<std::string> units;
  for (const char* unit :
       {"m",        "mm",       "um",       "s",      "ms",   "us",    "kg/m3", "g/cm3", "Pa",      "MPa",
        "GPa",      "J/m2",     "kJ/m2",    "N/mm",   "m/s",  "km/s",  "K",     "degC",  "W/(m K)", "1/K",
        "um/(m K)", "J/(kg K)", "W/(m2 K)", "kW/m2",  "W/m2", "W/mm3", "W/m3",  "W",     "kW",      "N",
        "kN",       "m/s2",     "mm3",      "m3",     "deg",  "rad",   "rad/s", "rpm",   "1/s",     "1/ms",
        "Pa s",     "mPa s",    "m3/kg",    "cm3/kg", "min",  "h"})
    if (const auto other = unitSystem().measure(unit);
        other && other->powers == measure.powers &&
        (kind == TemperatureKind::Absolute || other->offset == 0.0))
      units.emplace_back(unit);
  return units;
}

/// "; write a unit such as m, mm or um."
std::string adviceOnUnits(const std::string& expected, const Measure& measure, TemperatureKind kind)
{
  std::vector<std::string> units = usualUnits(measure, kind);
  constexpr std::size_t several = 3;
  units.resize(std::min(units.size(), several), "");
  return "; write a unit such as " + (units.empty() ? expected : asText(units)) + ".";
}

/// The conversion to a unit with a root: that of their squares.
UnitConversion conversionOfRoots(const std::string& given, const std::string& expected)
{
  const auto square = squareOfRoot(given);
  const auto from = square ? unitSystem().measure(*square) : std::nullopt;
  const auto to = unitSystem().measure(*squareOfRoot(expected));
  if (!from || from->powers != to->powers || from->offset != 0.0)
    throw std::invalid_argument("is given in \"" + given +
                                "\", but it is a stress intensity; write a unit such as " + expected + ", M" +
                                expected + " or N/mm^1.5.");
  const double factor = std::sqrt(from->factor / to->factor);
  return {asDecimal(factor, factor), 0.0};
}

/// A division and a product after it without parentheses: "W/m K" is W K/m.
bool dividesOnlyPart(const std::string& unit)
{
  const std::size_t slash = unit.find('/');
  return slash != std::string::npos && unit.find('(') == std::string::npos &&
         unit.find_first_of(" *.", unit.find_first_not_of(' ', slash + 1)) != std::string::npos;
}

} // namespace

double UnitConversion::operator()(double x) const
{
  if (factor == 1.0 && offset == 0.0)
    return x;
  return asDecimal(factor * (x + offset), std::fabs(factor) * (std::fabs(x) + std::fabs(offset)));
}

UnitConversion conversionOf(const std::string& given, const std::string& expected, TemperatureKind kind)
{
  const std::lock_guard<std::mutex> lock(unitMutex());
  const auto to = unitSystem().measure(expected);
  if ((!to || hasRoot(expected)) && given == expected)
    return {1.0, 0.0};
  if (hasRoot(expected) && squareOfRoot(expected))
    return conversionOfRoots(given, expected);
  if (!to || hasRoot(expected))
    throw std::invalid_argument("is given in " + given + ", but its unit " + expected +
                                " is not converted; write its numbers in that unit and leave the unit out.");
  if (const std::string mistake = mistakeInUnitText(given, expected); !mistake.empty())
    throw std::invalid_argument(mistake);
  const auto from = unitSystem().measure(given);
  if (!from)
  {
    const std::string nearest = nearestName(given, usualUnits(*to, kind));
    throw std::invalid_argument(
        "is given in \"" + given + "\", which is no known unit" +
        (nearest.empty() ? adviceOnUnits(expected, *to, kind) : "; did you mean \"" + nearest + "\"?"));
  }
  if (from->powers != to->powers)
    throw std::invalid_argument(
        "is given in " + given + ", " + dimensionAsText(*from) + ", but it is " + dimensionAsText(*to) +
        (dividesOnlyPart(given) ? " (divisors of several units need parentheses, as in W/(m K))" : "") +
        adviceOnUnits(expected, *to, kind));
  if (from->offset != 0.0 && kind == TemperatureKind::Difference)
    throw std::invalid_argument(
        "is given in " + given +
        ", a scale with another zero than K, but it is a difference of temperatures; write "
        "it in K.");
  const double factor = from->factor / to->factor;
  return {asDecimal(factor, std::fabs(factor)), from->offset};
}

bool isConvertible(const std::string& unit)
{
  const std::lock_guard<std::mutex> lock(unitMutex());
  const auto square = squareOfRoot(unit);
  return hasRoot(unit) ? square && unitSystem().measure(*square) : unitSystem().measure(unit).has_value();
}

} // namespace Rhegma
