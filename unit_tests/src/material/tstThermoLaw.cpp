/// What temperature does to stress and energy, for every law: free expansion, the first law, and the rise
/// that straining without heat flow brings.

#include "material/ThermoLaw.hpp"
#include "material/ThermoMaterials.hpp"
#include "transfer/LaneHeat.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace Rhegma
{
namespace Test
{

namespace
{

constexpr double reference = 293.0;

Teuchos::ParameterList materials(const std::string& model)
{
  Teuchos::ParameterList all;
  Teuchos::ParameterList& list = all.sublist("Body");
  list.set("Model", model);
  list.set("Density", 1200.0);
  list.set("Specific Heat", 1400.0);
  list.set("Thermal Expansion", 7e-5);
  if (model == "Mooney-Rivlin")
  {
    list.set("C10", 0.5e9);
    list.set("C01", 0.1e9);
    list.set("Bulk Modulus", 2.9e9);
  }
  else
  {
    list.set("Young Modulus", 3e9);
    list.set("Poisson Ratio", 0.33);
  }
  if (model == "J2 Plastic")
    list.set("Yield Stress", 1e12);
  return all;
}

/// One particle that is strained without heat flow, as the transfers strain it.
template <int D>
struct Particle
{
  ThermoTables tables;
  Properties law;
  double T, F[gradientSize<D>] = {}, tau[symmetricSize<D>] = {}, history[historyCapacity] = {}, energy = 0.0;

  Particle(const Teuchos::ParameterList& list, Plane plane, double start)
      : tables(makeThermoTables(list, plane, reference, true)), law(makePropertiesAt(list, plane)), T(start)
  {
    for (int d = 0; d < D; ++d)
      F[d * D + d] = 1.0;
    if (D == 2)
      F[4] = 1.0;
    energy = evaluate(T, tau, history);
  }

  static Properties makePropertiesAt(const Teuchos::ParameterList& list, Plane plane)
  {
    const ThermoTables tables = makeThermoTables(list, plane, reference, true);
    return ThermoPoint(tables, 0, reference).properties();
  }

  double evaluate(double at, double* stress, double* memory)
  {
    ThermoState result;
    EXPECT_TRUE(
        withLaw<D>(law.law, law.plane,
                   ThermoStress{{F, 0.0, at}, ThermoPoint(tables, 0, at), at, F, stress, memory, result}));
    EXPECT_GT(result.wave, 0.0);
    return result.internal;
  }

  /// F <- (1 + L) F.
  void strain(const double (&L)[D * D])
  {
    detail::StrainLanes<D> at;
    detail::HeatLanes<D> heat;
    for (int k = 0; k < D * D; ++k)
      at.gradient[k][0] = L[k];
    if (D == 2)
      at.gradient[gradientSize<D> - 1][0] = 0.0;
    for (int k = 0; k < gradientSize<D>; ++k)
      at.F[k][0] = F[k];
    for (int k = 0; k < symmetricSize<D>; ++k)
      at.tau[k][0] = tau[k];
    at.speed[0] = 0.0;
    heat.temperature[0] = T;
    heat.internal[0] = energy;
    heat.firstFraction[0] = 1.0;
    const ThermoMaterial material = tables.material(0);
    const int width = historySize<D>(law);
    if (material.count == 1)
      withLaw<D>(
          law.law, law.plane,
          detail::HeatOfLanes<D>{law, material, tables.knot(0), at, heat, history, width, 1.0, 1.0, 0, 1});
    else
      detail::HeatByTables<D>{law, tables, 0, at, heat, history, width, 1.0, 1.0, 0, 1}.run();
    EXPECT_LT(at.speed[0], 1e300);
    T = heat.temperature[0];
    energy = heat.internal[0];
    for (int k = 0; k < gradientSize<D>; ++k)
      F[k] = at.F[k][0];
    for (int k = 0; k < symmetricSize<D>; ++k)
      tau[k] = at.tau[k][0];
  }
};

class ThermoLaw : public testing::TestWithParam<std::string>
{
};

/// A body that is free to expand has no stress and no more energy than its heat, whatever its temperature.
TEST_P(ThermoLaw, FreeExpansionIsFreeOfStress)
{
  Particle<3> solid(materials(GetParam()), Plane::Solid, 393.0);
  const double theta = ThermoPoint(solid.tables, 0, 393.0).stretch();
  EXPECT_NEAR(theta, 1.0 + 7e-5 * 100.0, 1e-15);
  for (int d = 0; d < 3; ++d)
    solid.F[4 * d] = theta;
  const double energy = solid.evaluate(393.0, solid.tau, solid.history);
  for (const double t : solid.tau)
    EXPECT_NEAR(t, 0.0, 1e-14 * 3e9);
  // rho c dT, and what the capacity at constant stress has on top: 9 K alpha^2 (T^2 - T0^2) / 2.
  const double bulk = solid.law.bulk;
  EXPECT_NEAR(energy, 1200.0 * 1400.0 * 100.0 + 4.5 * bulk * 49e-10 * (393.0 * 393.0 - 293.0 * 293.0),
              1e-6 * energy);
}

/// A body held everywhere stores rho c per kelvin, and its stress is -3 K alpha dT.
TEST_P(ThermoLaw, HeldBodyHasTheGivenCapacity)
{
  Particle<3> solid(materials(GetParam()), Plane::Solid, reference);
  const double cold = solid.evaluate(reference, solid.tau, solid.history);
  const double warm = solid.evaluate(reference + 1.0, solid.tau, solid.history);
  // Beyond the linear term: finite strain, 7e-5 per kelvin, times the 2 % that heat of stress makes of all.
  EXPECT_NEAR(warm - cold, 1200.0 * 1400.0, 1e-5 * 1200.0 * 1400.0);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(solid.tau[i], -3.0 * solid.law.bulk * 7e-5, 1e-3 * 3.0 * solid.law.bulk * 7e-5);
}

/// Straining without heat flow cools by T 3 K alpha tr(eps) / (rho c) (eq. 4 of the C-SAFE report: -0.10772 K
/// at 1e-3).
TEST_P(ThermoLaw, ThermoelasticRise)
{
  Particle<3> solid(materials(GetParam()), Plane::Solid, reference);
  const int steps = 100;
  const double size = 1e-4 / steps;
  const double L[9] = {2.0 * size, 0.5 * size, 0.0, 0.5 * size, -0.7 * size, 0.0, 0.0, 0.0, -0.3 * size};
  for (int s = 0; s < steps; ++s)
    solid.strain(L);
  const double trace = 1e-4, expected = -293.0 * 3.0 * solid.law.bulk * 7e-5 * trace / (1200.0 * 1400.0);
  // Quadratic terms in strain are 1e-3 of it.
  EXPECT_NEAR(solid.T - reference, expected, 5e-3 * std::fabs(expected));
}

/// A closed cycle of strain without heat flow brings a body back to its temperature: what cools also warms.
TEST_P(ThermoLaw, CyclesAreReversible)
{
  Particle<2> solid(materials(GetParam()), Plane::Stress, reference);
  const int steps = 200;
  const double pi = 3.14159265358979323846;
  for (int s = 0; s < steps; ++s)
  {
    const double a = 1e-2 * (std::sin(2.0 * pi * (s + 1) / steps) - std::sin(2.0 * pi * s / steps));
    // (1 + a) of one step after another: the logarithm of stretch goes round in a circle.
    const double L[4] = {std::expm1(a), 0.0, 0.0, std::expm1(0.3 * a)};
    solid.strain(L);
  }
  // A step finds its temperature with the capacity at constant strain, which is not that of plane stress, and
  // leaves a fraction of its own change to the next.
  const double rest[4] = {};
  for (int s = 0; s < 3; ++s)
    solid.strain(rest);
  EXPECT_NEAR(solid.F[0], 1.0, 1e-13);
  // The work is that of the mean stress: an error of the third order in a step's strain of 3e-4, and 1 K for
  // the cycle.
  EXPECT_NEAR(solid.T, reference, 1e-4);
}

/// If stress does not depend on temperature, straining does not change the temperature, however large the
/// strain of a step is, and the energy is that of the law: it is a function of the state and not of the path.
TEST_P(ThermoLaw, LargeStepsOfStrainLeaveTheTemperatureAlone)
{
  Teuchos::ParameterList list = materials(GetParam());
  list.sublist("Body").remove("Thermal Expansion");
  for (const Plane plane : {Plane::Strain, Plane::Stress})
  {
    Particle<2> solid(list, plane, reference);
    // There and, by the inverse of 1 + L, back.
    const double L[4] = {0.2, 0.1, -0.05, -0.1}, J = 1.2 * 0.9 + 0.05 * 0.1;
    const double back[4] = {0.9 / J - 1.0, -0.1 / J, 0.05 / J, 1.2 / J - 1.0};
    double most = 0.0;
    const int steps = 20;
    for (int s = 0; s < steps; ++s)
    {
      solid.strain(s % 2 == 0 ? L : back);
      const double stored = storedEnergy<2>(solid.law, solid.F, solid.history);
      most = std::max(most, stored);
      // Rounding of energies, which each step adds to and takes from.
      EXPECT_NEAR(solid.energy, stored, 4e-16 * (s + 1) * 10.0 * most);
      EXPECT_NEAR(solid.T, reference, 4e-16 * (s + 1) * (10.0 * most / (1200.0 * 1400.0) + reference));
    }
    EXPECT_GT(most, 1e7);
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, ThermoLaw,
                         testing::Values("Linear Elastic", "Neo-Hookean", "Mooney-Rivlin", "J2 Plastic"),
                         [](const auto& test)
                         {
                           std::string name;
                           for (const char c : test.param)
                             if (std::isalnum(static_cast<unsigned char>(c)) != 0)
                               name += c;
                           return name;
                         });

/// dW/dT of the energy is that of its moduli, in a table and of entropic rubber: e + T dW/dT = W + h by
/// differences.
TEST(ThermoMaterials, TablesOfModuliCarryTheirHeat)
{
  Teuchos::ParameterList list = materials("Neo-Hookean");
  list.sublist("Body").remove("Young Modulus");
  list.sublist("Body").set("Young Modulus", std::string("250:4e9, 350:2e9"));
  Particle<3> solid(list, Plane::Solid, 300.0);
  solid.F[0] = 1.02;
  solid.F[1] = 0.01;
  const auto stored = [&](double T)
  {
    return withLaw<3>(solid.law.law, solid.law.plane,
                      ThermoEnergy{ThermoPoint(solid.tables, 0, T), solid.F, nullptr});
  };
  const double T = 300.0, slope = (stored(T + 0.5) - stored(T - 0.5)) / 1.0;
  const double internal = solid.evaluate(T, solid.tau, nullptr);
  const ThermoPoint at(solid.tables, 0, T);
  const double heat = at.heat() + 0.5 * at.material.coupling * (T * T - reference * reference);
  // The difference quotient is exact to the third derivative, 1e-4 of the slope per kelvin squared at most.
  EXPECT_NEAR(internal - heat, stored(T) - T * slope, 1e-4 * T * std::fabs(slope));
  EXPECT_GT(std::fabs(T * slope), 1e-2 * stored(T));
}

/// Entropic rubber warms when it is stretched, by its work over rho c: de = W - T W_T = 0 of the shear
/// energy.
TEST(ThermoMaterials, EntropicRubberTurnsWorkIntoHeat)
{
  Teuchos::ParameterList list;
  Teuchos::ParameterList& rubber = list.sublist("Rubber");
  rubber.set("Model", "Mooney-Rivlin");
  rubber.set("Density", 1000.0);
  rubber.set("Specific Heat", 2000.0);
  rubber.set("C10", 0.4e6);
  rubber.set("C01", 0.1e6);
  rubber.set("Bulk Modulus", 1e9);
  rubber.set("Entropic", true);
  Particle<3> body(list, Plane::Solid, reference);
  const int steps = 400;
  const double a = std::log(2.0) / steps;
  const double L[9] = {std::expm1(a), 0, 0, 0, std::expm1(-0.5 * a), 0, 0, 0, std::expm1(-0.5 * a)};
  for (int s = 0; s < steps; ++s)
    body.strain(L);
  // W = C10 (I1 - 3) + C01 (I2 - 3) at stretch 2; the temperature itself stiffens it, dT / T = 1e-3 at most.
  const double work = 0.4e6 * (4.0 + 1.0 - 3.0) + 0.1e6 * (4.0 + 0.25 - 3.0);
  EXPECT_NEAR(body.T - reference, work / 2e6, 2e-3 * work / 2e6);
}

/// Plastic work becomes heat by the given fraction, whichever property is a table.
TEST(ThermoMaterials, PlasticWorkBecomesHeat)
{
  for (const std::string table : {"none", "Specific Heat", "Conductivity"})
  {
    Teuchos::ParameterList list = materials("J2 Plastic");
    Teuchos::ParameterList& body = list.sublist("Body");
    body.set("Yield Stress", 1e6);
    body.set("Plastic Heat Fraction", 0.6);
    body.remove("Thermal Expansion");
    if (table == "Specific Heat")
    {
      body.remove(table);
      body.set(table, std::string("250:1300, 350:1500"));
    }
    if (table == "Conductivity")
      body.set(table, std::string("250:1, 350:2"));
    Particle<3> solid(list, Plane::Solid, reference);
    const int steps = 2000;
    const double a = 0.2 / steps;
    const double L[9] = {std::expm1(a), 0, 0, 0, std::expm1(-0.5 * a), 0, 0, 0, std::expm1(-0.5 * a)};
    double rise = 0.0;
    for (int s = 0; s < steps; ++s)
    {
      solid.strain(L);
      // Each step heats: none adds what the one before has added, nor takes it back.
      EXPECT_GE(solid.T - reference, rise) << table << " " << s;
      rise = solid.T - reference;
    }
    const double dissipated = dissipatedEnergy<3>(solid.law, solid.history);
    EXPECT_GT(dissipated, 0.9 * 0.2e6);
    const double heat =
        ThermoPoint(solid.tables, 0, solid.T).heat() - ThermoPoint(solid.tables, 0, reference).heat();
    // First law: work is stored or becomes heat. Rounding of 2,000 sums of some 1e6 J/m3, of twice as many
    // with a table, which finds the temperature in two parts.
    EXPECT_NEAR(heat, 0.6 * dissipated, (table == "none" ? 1e-11 : 2e-11) * dissipated) << table;
  }
}

TEST(ThermoMaterials, WrongOnesAreRefused)
{
  Teuchos::ParameterList list = materials("Linear Elastic");
  list.sublist("Body").remove("Specific Heat");
  EXPECT_THROW(makeThermoTables(list, Plane::Solid, reference, true), std::invalid_argument);
  list.sublist("Body").set("Specific Heat", std::string("300:1000, 290:1100"));
  EXPECT_THROW(makeThermoTables(list, Plane::Solid, reference, true), std::invalid_argument);
  list.sublist("Body").set("Specific Heat", std::string("-3:1000, 290:1100"));
  EXPECT_THROW(makeThermoTables(list, Plane::Solid, reference, true), std::invalid_argument);
}

/// Heat and temperature are each other's inverse over a table, beyond its ends too.
TEST(ThermoMaterials, HeatAndTemperatureAreInverse)
{
  Teuchos::ParameterList list = materials("Linear Elastic");
  list.sublist("Body").remove("Specific Heat");
  list.sublist("Body").set("Specific Heat", std::string("250:1000, 300:1400, 500:1200"));
  const ThermoTables tables = makeThermoTables(list, Plane::Solid, reference, false);
  for (const double T : {100.0, 250.0, 270.0, 293.0, 299.0, 400.0, 800.0})
    EXPECT_NEAR(temperatureOfHeat(tables, 0, ThermoPoint(tables, 0, T).heat()), T, 1e-12 * T);
  EXPECT_NEAR(ThermoPoint(tables, 0, 500.0).heat() - ThermoPoint(tables, 0, 300.0).heat(),
              1200.0 * 1300.0 * 200.0, 1e-3);
}

} // namespace

} // namespace Test
} // namespace Rhegma
