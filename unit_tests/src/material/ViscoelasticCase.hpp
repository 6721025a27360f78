#pragma once
/// A viscoelastic material of random constants, and paths for it.

#include "Cases.hpp"
#include "Reference3.hpp"

#include <Teuchos_Array.hpp>

#include <cstdio>
#include <vector>

namespace Rhegma
{
namespace Test
{

using LongHistory = std::array<double, historyCapacity>;

/// Constants of a Prony series; moduli of order one.
struct Prony
{
  double young = 2.6, poisson = 0.3;
  std::vector<double> times, shear, bulk;
  std::string shift = "None";
  double shiftTemperature = 300.0, c1 = 6.0, c2 = 120.0, activation = 9000.0, temperature = 300.0;

  double mu() const { return young / (2.0 * (1.0 + poisson)); }
  double K() const { return young / (3.0 * (1.0 - 2.0 * poisson)); }

  Teuchos::ParameterList list() const
  {
    Teuchos::ParameterList m;
    m.set("Model", "Viscoelastic");
    m.set("Density", 2.0);
    m.set("Young Modulus", young);
    m.set("Poisson Ratio", poisson);
    m.set("Relaxation Times", Teuchos::Array<double>(times));
    m.set("Shear Fractions", Teuchos::Array<double>(shear));
    if (!bulk.empty())
      m.set("Bulk Fractions", Teuchos::Array<double>(bulk));
    m.set("Time Shift", shift);
    m.set("Reference Temperature", temperature);
    m.set("Shift Temperature", shiftTemperature);
    if (shift == "Williams-Landel-Ferry")
    {
      m.set("WLF C1", c1);
      m.set("WLF C2", c2);
    }
    if (shift == "Arrhenius")
      m.set("Activation Temperature", activation);
    return m;
  }
  Properties properties(Plane plane) const { return makeProperties(list(), "Test", plane); }
};

/// Fractions whose sum is below one, and times over three decades around 1 s; prints the seed.
inline Prony randomProny(unsigned seed, int terms)
{
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  Prony p;
  p.young = 1.0 + 2.0 * uniform(engine);
  p.poisson = 0.1 + 0.35 * uniform(engine);
  for (int i = 0; i < terms; ++i)
  {
    p.times.push_back(std::pow(10.0, -1.5 + 3.0 * uniform(engine)));
    p.shear.push_back(0.9 / terms * uniform(engine));
    p.bulk.push_back(0.8 / terms * uniform(engine));
  }
  std::printf("seed %u: %d terms\n", seed, terms);
  return p;
}

/// A path from F = 1 over the time 1: stretch, shear and volume at strains of some tenths.
inline Matrix strainedAt(double t)
{
  const Matrix shear = {1.0, 0.3 * std::sin(2.0 * t), 0.0, 0.0, 1.0, 0.1 * t, 0.05 * t * t, 0.0, 1.0};
  const Matrix stretch = {1.0 + 0.2 * t, 0.0, 0.0, 0.0, 1.0 - 0.1 * t * t, 0.0, 0.0, 0.0, 1.0 - 0.05 * t};
  return times(shear, stretch);
}

} // namespace Test
} // namespace Rhegma
