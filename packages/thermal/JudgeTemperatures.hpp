#pragma once
/// Whether the temperatures of a scene are those that its materials are given for
/// (docs/reference/warnings-of-cracks-and-runs.md).

#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "base/ShortNumber.hpp"
#include "geometry/Cross.hpp"
#include "material/TemperatureTable.hpp"
#include "material/ThermoMaterials.hpp"
#include "plausibility/LoadEstimate.hpp"
#include "thermal/Conduction.hpp"
#include "thermal/Start.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace Rhegma::thermal
{

/// Lowest and highest temperature [K].
struct TemperatureRange
{
  double lowest = std::numeric_limits<double>::infinity(); ///< of all that were included
  double highest = 0.0;                                    ///< zero: none was

  void include(double T) ///< a temperature [K]
  {
    lowest = std::min(lowest, T);
    highest = std::max(highest, T);
  }
};

/// A property that is a table of temperature.
struct TabulatedProperty
{
  std::string where;      ///< its path in the scene
  int material;           ///< its number
  TemperatureRange table; ///< of its temperatures

  /// A message where temperatures lie outside of the table by more than a tenth of its span, beyond which its
  /// last value is used. \param when "the bodies start at"
  std::optional<std::string> messageOn(const TemperatureRange& range, const std::string& when) const
  {
    const double slack = 0.1 * (table.highest - table.lowest);
    const bool below = range.lowest < table.lowest - slack;
    const bool above = range.highest > table.highest + slack;
    if (!below && !above)
      return {};
    return where + ": " + when + " " + formatShort(below ? range.lowest : range.highest) +
           " K, and its table covers " + formatShort(table.lowest) + " to " + formatShort(table.highest) +
           " K, beyond which its last value is used; temperatures are absolute (K)";
  }
};

/// All of the section Materials.
inline std::vector<TabulatedProperty> tabulated(const Teuchos::ParameterList& materials)
{
  std::vector<TabulatedProperty> all;
  int number = 0;
  for (const std::string& name : sublistNames(materials))
  {
    const Teuchos::ParameterList& list = materials.sublist(name);
    for (const std::string& property : tabulatedProperties(list))
    {
      const std::vector<double> at = TemperatureTable::parse(list.get<std::string>(property)).temperature;
      if (at.size() > 1)
        all.push_back({std::string("Materials > ").append(name).append(" > ").append(property),
                       number,
                       {at.front(), at.back()}});
    }
    ++number;
  }
  return all;
}

/// Temperatures of the particles of each material.
template <int D>
std::vector<TemperatureRange> temperaturesOf(const State<D>& state)
{
  std::vector<TemperatureRange> ranges(state.materials.properties.size());
  const auto T = onHost(state.particles.scalar(fields::temperature));
  const auto material = onHost(state.particles.integer(fields::material));
  for (int p = 0; p < state.particles.size(); ++p)
    ranges[material(p)].include(T(p));
  return ranges;
}

/// Thermal strain at a temperature, from the reference temperature: the integral of the expansion.
inline double thermalStrain(const TemperatureTable& expansion, double from, double to)
{
  constexpr int pieces = 1000;
  double sum = 0.0;
  for (int k = 0; k < pieces; ++k)
    sum += expansion(from + (k + 0.5) / pieces * (to - from)) * (to - from) / pieces;
  return sum;
}

/// Warns of an expansion that no solid has, and of a thermal strain at the start that is beyond small
/// strains. \param initial Thermal > Initial Temperature [K]
inline void judgeExpansion(const Teuchos::ParameterList& list, const std::string& where, double initial,
                           const TemperatureRange& start, std::vector<std::string>& warnings)
{
  constexpr double largest = 1e-3, mostStrain = 0.01; // wax and rubber have 3e-4 / K
  const bool given = list.isParameter("Reference Temperature");
  const double reference = given ? list.get<double>("Reference Temperature") : initial;
  if (given)
    warnOfCold(warnings, where + " > Reference Temperature: it is", reference);
  if (!list.isParameter("Thermal Expansion") || !(start.highest > 0.0))
    return;
  const TemperatureTable expansion =
      list.isType<double>("Thermal Expansion")
          ? TemperatureTable{{1.0}, {list.get<double>("Thermal Expansion")}}
          : TemperatureTable::parse(list.get<std::string>("Thermal Expansion"));
  double most = 0.0;
  for (const double alpha : expansion.value)
    most = std::max(most, std::fabs(alpha));
  if (most > largest)
    warnings.push_back(where + " > Thermal Expansion is " + formatShort(most) +
                       " 1/K, more than of any solid (3e-4); it is the linear expansion per kelvin");
  const double low = thermalStrain(expansion, reference, start.lowest),
               high = thermalStrain(expansion, reference, start.highest);
  const bool cold = std::fabs(low) > std::fabs(high);
  if (const double strain = cold ? low : high; std::fabs(strain) > mostStrain)
    warnings.push_back(where + (given ? " > Reference Temperature" : " > Thermal Expansion") +
                       ": bodies start at " + formatShort(cold ? start.lowest : start.highest) +
                       " K with a thermal strain of " + formatShort(100.0 * strain) +
                       " %, for they have none at " + formatShort(reference) +
                       " K; write the temperature (K) at which they are free of stress");
}

/// What heats a body, as an estimate without losses.
struct Heating
{
  std::string where; ///< path of the parameter that is its size
  double rise;       ///< of temperature up to the end [K]
};

/// The heat of a source or a surface over the capacity of what it reaches: the ball along its path, the box
/// or the surface, with what conduction reaches around it, and no more than all bodies. \param end of the run
/// [s]
template <int D>
std::vector<Heating> heatings(const Teuchos::ParameterList& scene, const Conduction<D>& conduction,
                              double end, const State<D>& state)
{
  double volume = 0.0, longest = 0.0;
  for (const BodyMeasure<D>& body : measureBodies(state))
  {
    volume += body.volume;
    longest = std::max(longest, body.longest);
  }
  constexpr double pi = 3.14159265358979;
  const double cell = state.mesh.smallestSpacing(), capacity = conduction.leastCapacity;
  const double reach = std::sqrt(conduction.diffusivity * end), depth = D == 2 ? state.method.thickness : 1.0;
  const Teuchos::ParameterList none;
  const Teuchos::ParameterList& sources =
      scene.sublist("Thermal").isSublist("Sources") ? scene.sublist("Thermal").sublist("Sources") : none;
  const Teuchos::ParameterList& boundaries =
      scene.isSublist("Boundaries") ? scene.sublist("Boundaries") : none;
  // Where surfaces take heat away, they take most of it once it has come there.
  double lost = 1.0;
  for (const std::string& name : sublistNames(boundaries))
    if (const std::string type = boundaries.sublist(name).template get<std::string>("Type");
        type == "Temperature" || type == "Convection")
      lost = std::min(1.0, longest * longest / (reach * reach));
  const auto seconds = [&](const Teuchos::ParameterList& list)
  { return lost * rangeOf(list.get<std::string>("History"), end).integral; };
  std::vector<Heating> all;
  for (const Source<D>& source : conduction.sources)
  {
    const std::string where = "Thermal > Sources > " + source.name;
    const double time = seconds(sources.sublist(source.name));
    if (source.ball)
    {
      const double r = std::max(source.radius, cell) + reach, path = norm(source.velocity) * end;
      const double swept = D == 2 ? (pi * r + 2.0 * path) * r * depth : (4.0 / 3.0 * r + path) * pi * r * r;
      all.push_back({where + " > Power", source.power * time / (capacity * std::min(volume, swept))});
      continue;
    }
    double part = 1.0;
    for (int d = 0; d < D; ++d)
    {
      const double edge = std::max(source.upper[d] - source.lower[d], cell);
      part *= edge / (edge + 2.0 * reach);
    }
    all.push_back({where + " > Power Density", source.density * part * time / capacity});
  }
  for (const std::string& name : sublistNames(boundaries))
    if (const Teuchos::ParameterList& list = boundaries.sublist(name);
        list.get<std::string>("Type") == "Heat Flux")
      all.push_back({"Boundaries > " + name + " > Flux",
                     list.get<double>("Flux") * seconds(list) / (capacity * std::max(cell, reach))});
  return all;
}

/// Warns of temperatures at the start for which materials are not given, of expansions and thermal strains,
/// and of heat that evaporates what it reaches. Call it when particles have their temperatures.
/// \param scene its core and Thermal \param end of the run [s]
template <int D>
void judgeTemperatures(const Teuchos::ParameterList& scene, const Conduction<D>& conduction, double end,
                       State<D>& state)
{
  constexpr double evaporates = 1e4; // above all boiling points, with a margin for losses
  const std::vector<TemperatureRange> start = temperaturesOf(state);
  const Teuchos::ParameterList& materials = scene.sublist("Materials");
  for (const TabulatedProperty& property : tabulated(materials))
    if (start[property.material].highest > 0.0)
      if (const auto message = property.messageOn(start[property.material], "bodies start at"))
        state.warnings.push_back(*message);
  std::size_t number = 0;
  for (const std::string& name : sublistNames(materials))
  {
    if (state.method.mechanics)
      judgeExpansion(materials.sublist(name), "Materials > " + name,
                     scene.sublist("Thermal").get<double>("Initial Temperature"), start[number],
                     state.warnings);
    ++number;
  }
  if (conduction.integrator.method == Method::Steady)
    return; // its heat flows out
  for (const Heating& heating : heatings(scene, conduction, end, state))
    if (std::fabs(heating.rise) > evaporates && std::isfinite(heating.rise))
      state.warnings.push_back(
          heating.where + ": its heat changes the temperature of all that it reaches by " +
          formatShort(heating.rise) + " K up to Time > Final Time = " + readableTime(end) +
          ", at which no solid exists; check units (W, W/m2, W/m3, s)");
}

} // namespace Rhegma::thermal
