#pragma once
/// Metals of random constants for the law High-Rate Solid, and its equations integrated as they stand.

#include "Cases.hpp"
#include "Reference3.hpp"

#include <cstdio>

namespace Rhegma
{
namespace Test
{

using LongHistory = std::array<double, historyCapacity>;

/// Constants of a metal.
struct Metal
{
  double density = 8960.0, young = 124e9, poisson = 0.34;
  double A = 90e6, B = 292e6, n = 0.31, C = 0.025, m = 1.09, rate = 1.0, transition = 293.0, melt = 1356.0;
  double voce = 0.0, voceRate = 0.0, capacity = 383.0, fraction = 0.9, temperature = 293.0;
  bool shocked = false;
  double speed = 3940.0, slope = 1.489, gamma = 2.02, linear = 0.0, quadratic = 0.0;

  double mu() const { return young / (2.0 * (1.0 + poisson)); }
  double K() const { return shocked ? density * speed * speed : young / (3.0 * (1.0 - 2.0 * poisson)); }

  Teuchos::ParameterList list() const
  {
    Teuchos::ParameterList p;
    p.set("Model", "High-Rate Solid");
    p.set("Density", density);
    p.set("Young Modulus", young);
    p.set("Poisson Ratio", poisson);
    p.set("Reference Temperature", temperature);
    p.set("Plastic Heat Fraction", fraction);
    if (capacity > 0.0)
      p.set("Specific Heat", capacity);
    if (A != 0.0)
    {
      p.set("Johnson-Cook A", A);
      p.set("Johnson-Cook B", B);
      p.set("Johnson-Cook n", n);
      p.set("Johnson-Cook C", C);
      p.set("Johnson-Cook Rate", rate);
      if (m > 0.0)
      {
        p.set("Johnson-Cook m", m);
        p.set("Transition Temperature", transition);
        p.set("Melting Temperature", melt);
      }
    }
    p.set("Voce Stress", voce);
    p.set("Voce Rate", voceRate);
    if (shocked)
    {
      p.set("Equation Of State", "Mie-Grueneisen");
      p.set("Hugoniot Speed", speed);
      p.set("Hugoniot Slope", slope);
      p.set("Grueneisen Coefficient", gamma);
      p.set("Linear Viscosity", linear);
      p.set("Quadratic Viscosity", quadratic);
    }
    return p;
  }
  Properties properties(Plane plane) const { return makeProperties(list(), "Test", plane); }

  double quasiStatic(double alpha) const
  {
    return A + B * std::pow(std::max(alpha, 0.0), n) + voce * (1.0 - std::exp(-voceRate * alpha));
  }
  double thermal(double T) const
  {
    return T > transition ? 1.0 - std::pow((T - transition) / (melt - transition), m) : 1.0;
  }
  /// Plastic strain rate of an equivalent stress: sigma = sigma_y solved for the rate, which is at least the
  /// reference rate where there is flow.
  double flowRate(double stress, double alpha, double T) const
  {
    const double excess = stress / (quasiStatic(alpha) * thermal(T)) - 1.0;
    return excess > 0.0 ? rate * std::exp(excess / C) : 0.0;
  }
  /// Pressure on the Hugoniot with the term of the energy left out.
  double cold(double eta) const
  {
    if (eta <= 0.0)
      return K() * eta;
    return K() * eta / ((1.0 - slope * eta) * (1.0 - slope * eta)) * (1.0 - 0.5 * gamma * eta);
  }
};

/// Prints the seed.
inline Metal randomMetal(unsigned seed)
{
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const auto between = [&](double low, double high) { return low + (high - low) * uniform(engine); };
  Metal p;
  p.A = between(80e6, 800e6);
  p.B = between(100e6, 500e6);
  p.n = between(0.2, 0.7);
  p.C = between(0.01, 0.06);
  p.m = between(0.7, 1.3);
  p.voce = between(0.0, 100e6);
  p.voceRate = between(1.0, 20.0);
  p.rate = 1e-3;
  std::printf("seed %u: A %.4g B %.4g n %.3g C %.3g m %.3g\n", seed, p.A, p.B, p.n, p.C, p.m);
  return p;
}

/// State of the integrated equations: Cp^-1, plastic strain, temperature, internal energy of the volume,
/// dissipated energy.
using MetalState = std::array<double, 13>;

inline Matrix plasticOf(const MetalState& y)
{
  Matrix c{};
  for (std::size_t k = 0; k < 9; ++k)
    c[k] = y[k];
  return c;
}

/// be = J^(-2/3) F Cp^-1 F^T.
inline Matrix elasticOf(const Matrix& F, const MetalState& y)
{
  const Matrix b = times(F, times(plasticOf(y), transposed(F)));
  return sumOf(std::pow(det(F), -2.0 / 3.0), b, 0.0, b);
}

/// dy/dt along F(t): flow L_v be = -2 gamma (tr be / 3) n + k 1 with det be = 1, which fixes k; plastic work
/// and compression warm the material.
template <class Path>
MetalState rateOf(const Metal& p, const Path& path, double t, const MetalState& y, double step)
{
  const Matrix F = path(t), be = elasticOf(F, y), s = deviator(be);
  const double norm = std::sqrt(doubleProduct(s, s)), J = det(F);
  const double alphaRate = p.flowRate(std::sqrt(1.5) * p.mu() * norm, y[9], y[10]);
  MetalState r{};
  double work = 0.0;
  if (alphaRate > 0.0)
  {
    const Matrix normal = sumOf(1.0 / norm, s, 0.0, s), inverse = inverted(be);
    const double size = 2.0 * std::sqrt(1.5) * alphaRate * traceOf(be) / 3.0;
    const double spherical = size * doubleProduct(inverse, normal) / traceOf(inverse);
    const Matrix change = sumOf(-size, normal, spherical, one), back = inverted(F);
    const Matrix plastic = times(back, times(change, transposed(back)));
    for (std::size_t k = 0; k < 9; ++k)
      r[k] = std::pow(J, 2.0 / 3.0) * plastic[k];
    work = -0.5 * p.mu() * traceOf(change);
  }
  const double compression = -(det(path(t + step)) - det(path(t - step))) / (2.0 * step);
  r[9] = alphaRate;
  r[10] = p.fraction * work / (p.density * p.capacity);
  if (p.shocked)
  {
    r[10] += p.gamma * y[10] * compression;
    r[11] = (p.cold(1.0 - J) + p.gamma * y[11]) * compression + p.fraction * work;
  }
  r[12] = work;
  return r;
}

/// Kirchhoff stress of a state.
inline Matrix stressOf(const Metal& p, const Matrix& F, const MetalState& y)
{
  const double J = det(F);
  const double mean = p.shocked ? -J * (p.cold(1.0 - J) + p.gamma * y[11]) : 0.5 * p.K() * (J * J - 1.0);
  return sumOf(p.mu(), deviator(elasticOf(F, y)), mean, one);
}

} // namespace Test
} // namespace Rhegma
