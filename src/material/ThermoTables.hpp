#pragma once
/// Effects of temperature on materials: heat, thermal strain, and properties that are tables of temperature.

#include "material/Law.hpp"

namespace Rhegma
{

/// Thermal properties of one material. All tables of a material have the same temperatures ("knots"), first
/// .. first + count - 1.
struct ThermoMaterial
{
  double reference = 293.15;   ///< temperature of no thermal strain [K]
  double coupling = 0.0;       ///< 9 K alpha^2 at the reference temperature [Pa/K2]
  double ratio[3] = {1, 1, 1}; ///< conductivity along the body's axes over the given one [-]
  double plasticHeat = 0.9;    ///< fraction of plastic work that becomes heat [-]
  bool orthotropic = false;    ///< the ratios are not all one
  bool conducts = false;       ///< some conductivity is not zero
  bool coupled = false;        ///< its stress depends on temperature
  int first = 0, count = 0;
};

/// Values at a knot. Between knots capacity, conductivity and expansion are straight lines, and constant
/// beyond the ends.
struct ThermoKnot
{
  double temperature = 0.0;  ///< [K]
  double capacity = 0.0;     ///< rho c at constant strain, per undeformed volume [J/(m3 K)]
  double conductivity = 0.0; ///< [W/(m K)]
  double expansion = 0.0;    ///< alpha [1/K]
  double heat = 0.0;         ///< integral of the capacity from the reference temperature [J/m3]
  double strain = 0.0;       ///< integral of alpha from there [-]
};

/// All of them on the device.
struct ThermoTables
{
  View<ThermoMaterial*> material;
  View<ThermoKnot*> knot;
  View<Properties*> law; ///< at each knot

  KOKKOS_INLINE_FUNCTION bool empty() const { return material.extent(0) == 0; }
};

/// One material at one temperature.
struct ThermoPoint
{
  const ThermoMaterial& material;
  const ThermoKnot* knots;
  const Properties* laws;
  int at;          ///< the knot below, or the nearest end
  double since;    ///< temperature less that of the knot [K]
  double fraction; ///< of the interval to the next knot; 0 beyond the ends

  KOKKOS_INLINE_FUNCTION ThermoPoint(const ThermoTables& tables, int number, double temperature)
      : material(tables.material(number)),
        knots(&tables.knot(material.first)),
        laws(&tables.law(material.first)),
        at(0),
        since(0.0),
        fraction(0.0)
  {
    while (at + 1 < material.count && knots[at + 1].temperature <= temperature)
      ++at;
    since = temperature - knots[at].temperature;
    if (since > 0.0 && at + 1 < material.count)
      fraction = since / (knots[at + 1].temperature - knots[at].temperature);
  }

  KOKKOS_INLINE_FUNCTION double between(double ThermoKnot::*value) const
  {
    const double here = knots[at].*value;
    return fraction > 0.0 ? here + fraction * (knots[at + 1].*value - here) : here;
  }
  /// Integral of a value from the reference temperature, its integral at the knots being known: the trapezoid
  /// from the knot is exact.
  KOKKOS_INLINE_FUNCTION double integral(double ThermoKnot::*sum, double ThermoKnot::*value) const
  {
    return knots[at].*sum + 0.5 * since * (knots[at].*value + between(value));
  }

  KOKKOS_INLINE_FUNCTION double capacity() const { return between(&ThermoKnot::capacity); }
  KOKKOS_INLINE_FUNCTION double conductivity() const { return between(&ThermoKnot::conductivity); }
  KOKKOS_INLINE_FUNCTION double expansion() const { return between(&ThermoKnot::expansion); }
  /// Heat since the reference temperature at constant strain [J/m3].
  KOKKOS_INLINE_FUNCTION double heat() const { return integral(&ThermoKnot::heat, &ThermoKnot::capacity); }
  /// Stretch of the unstressed material, 1 + integral of alpha.
  KOKKOS_INLINE_FUNCTION double stretch() const
  {
    return 1.0 + integral(&ThermoKnot::strain, &ThermoKnot::expansion);
  }

  /// The law's numbers at this temperature.
  KOKKOS_INLINE_FUNCTION Properties properties() const
  {
    Properties p = laws[at];
    if (fraction > 0.0)
      combine(p, 1.0 - fraction, fraction, laws[at + 1]);
    return p;
  }
  /// Whether the law's numbers change with temperature here.
  KOKKOS_INLINE_FUNCTION bool varies() const { return since >= 0.0 && at + 1 < material.count; }
  /// By how much they change per kelvin; only the moduli, in which stored energies are linear.
  KOKKOS_INLINE_FUNCTION Properties slope() const
  {
    Properties p = laws[at];
    const double inverse = 1.0 / (knots[at + 1].temperature - knots[at].temperature);
    combine(p, -inverse, inverse, laws[at + 1]);
    return p;
  }

private:
  /// p = a p + b q for every number. Those that are not linear in the moduli are computed anew.
  KOKKOS_INLINE_FUNCTION static void combine(Properties& p, double a, double b, const Properties& q)
  {
    p.lambda = a * p.lambda + b * q.lambda;
    p.mu = a * p.mu + b * q.mu;
    p.bulk = a * p.bulk + b * q.bulk;
    for (int k = 0; k < lawNumbers; ++k)
      p.own[k] = a * p.own[k] + b * q.own[k];
    setPlaneModuli(p);
  }
};

/// Temperature of an unstrained material with a given heat [J/m3] above the reference temperature.
KOKKOS_INLINE_FUNCTION double temperatureOfHeat(const ThermoTables& tables, int number, double heat)
{
  const ThermoMaterial& m = tables.material(number);
  const ThermoKnot* const knots = &tables.knot(m.first);
  int at = 0;
  while (at + 1 < m.count && knots[at + 1].heat <= heat)
    ++at;
  const double rest = heat - knots[at].heat, capacity = knots[at].capacity;
  const double rise = rest > 0.0 && at + 1 < m.count ? (knots[at + 1].capacity - capacity) /
                                                           (knots[at + 1].temperature - knots[at].temperature)
                                                     : 0.0;
  // rest = capacity x + rise x^2 / 2, without cancellation where the rise is small.
  const double root = std::sqrt(capacity * capacity + 2.0 * rise * rest);
  return knots[at].temperature + 2.0 * rest / (capacity + root);
}

} // namespace Rhegma
