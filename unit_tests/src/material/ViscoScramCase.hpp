#pragma once
/// A material of the law ViscoSCRAM of random constants, and its equations as an initial value problem.

#include "ViscoelasticCase.hpp"

namespace Rhegma
{
namespace Test
{

/// Constants of the cracks; moduli, times and strains of order one.
struct Scram
{
  Prony prony;
  double radius = 0.06, scale = 0.15, toughness = 0.0, friction = 0.4, exponent = 8.0, speed = 0.2;

  double G() const { return prony.mu(); }
  double longShear() const
  {
    double left = G();
    for (const double fraction : prony.shear)
      left -= fraction * G();
    return left;
  }

  Teuchos::ParameterList list() const
  {
    Teuchos::ParameterList m = prony.list();
    m.set("Model", "ViscoSCRAM");
    m.remove("Bulk Fractions", false);
    m.set("Initial Crack Radius", radius);
    m.set("Crack Length Scale", scale);
    m.set("Crack Toughness", toughness);
    m.set("Crack Friction", friction);
    m.set("Crack Growth Exponent", exponent);
    m.set("Maximum Crack Speed", speed);
    return m;
  }
  Properties properties(Plane plane) const { return makeProperties(list(), "Test", plane); }

  /// The growth as Bennett et al. (1998) write it. \param s deviator of the true stress \param mean of it
  double growth(double c, const Matrix& s, double mean) const
  {
    const double pi = std::acos(-1.0), square = doubleProduct(s, s);
    const double sigma = std::sqrt(1.5 * (mean > 0.0 ? square + 3.0 * mean * mean : square));
    const double K = std::sqrt(pi * c) * sigma;
    const double slope = std::sqrt(45.0 / (2.0 * (3.0 - 2.0 * friction * friction))) * friction;
    const double x = mean < 0.0 ? slope * -mean * std::sqrt(c) / toughness : 0.0;
    const double K0 = toughness * std::sqrt(1.0 + pi * x * (1.0 + x));
    const double change = K0 * std::sqrt(1.0 + 2.0 / exponent);
    const double K1 = change * std::pow(1.0 + exponent / 2.0, 1.0 / exponent);
    return K < change ? speed * std::pow(K / K1, exponent) : speed * (1.0 - std::pow(K0 / K, 2.0));
  }
};

inline Scram randomScram(unsigned seed, int terms)
{
  Scram scram;
  scram.prony = randomProny(seed, terms);
  scram.toughness = std::sqrt(2.5e-3 * scram.prony.young); // of faces of some 2e-3 J/m2
  std::mt19937 engine(seed + 7u);
  std::uniform_real_distribution<double> uniform(0.7, 1.3);
  for (double* number :
       {&scram.radius, &scram.scale, &scram.toughness, &scram.friction, &scram.exponent, &scram.speed})
    *number *= uniform(engine);
  return scram;
}

/// State of the equations: E, the e_i of five elements, c.
constexpr std::size_t scramState = 9 + 45 + 1;

/// S and the true stress of a state.
struct ScramStress
{
  Matrix S, deviator;
  double mean;
};

inline ScramStress scramStress(const Scram& p, const Matrix& F, const std::array<double, scramState>& y)
{
  ScramStress now{};
  for (std::size_t k = 0; k < 9; ++k)
  {
    now.S[k] = 2.0 * p.longShear() * y[k];
    for (std::size_t i = 0; i < p.prony.times.size(); ++i)
      now.S[k] += 2.0 * p.prony.shear[i] * p.G() * y[9 + 9 * i + k];
  }
  const double J = det(F);
  const Matrix pushed = times(F, times(now.S, transposed(F)));
  now.deviator = sumOf(std::pow(J, -5.0 / 3.0), deviator(pushed), 0.0, one);
  now.mean = 0.5 * p.prony.K() * (J * J - 1.0) / J;
  return now;
}

/// Integrates dEb = dE + d((c/a)^3 S) / (2 G) along strainedAt(t / duration), whose shape may be another
/// path. \param path F as a function of the time from 0 to 1
template <class Path>
std::array<double, scramState> integrateScram(const Scram& p, double duration, int count, const Path& path)
{
  constexpr double small = 1e-5;
  const auto isochoric = [&](double t)
  {
    const Matrix F = path(t), C = times(transposed(F), F);
    return sumOf(0.5 * std::pow(det(F), -2.0 / 3.0), C, -0.5, one);
  };
  const auto rate = [&](double t, const std::array<double, scramState>& y)
  {
    std::array<double, scramState> r{};
    const Matrix dEb = sumOf(0.5 / small, isochoric(t + small), -0.5 / small, isochoric(t - small));
    const ScramStress now = scramStress(p, path(t), y);
    const double c = y[54], g = std::pow(c / p.scale, 3.0);
    r[54] = duration * p.growth(c, now.deviator, now.mean);
    const double dg = 3.0 * g * r[54] / c;
    for (std::size_t k = 0; k < 9; ++k)
    {
      double relaxing = 0.0; // of S, at constant E
      for (std::size_t i = 0; i < p.prony.times.size(); ++i)
        relaxing += 2.0 * p.prony.shear[i] * p.G() * y[9 + 9 * i + k] * duration / p.prony.times[i];
      r[k] = (dEb[k] - (dg * now.S[k] - g * relaxing) / (2.0 * p.G())) / (1.0 + g);
      for (std::size_t i = 0; i < p.prony.times.size(); ++i)
        r[9 + 9 * i + k] = r[k] - duration / p.prony.times[i] * y[9 + 9 * i + k];
    }
    return r;
  };
  std::array<double, scramState> start{};
  start[54] = p.radius;
  return integrate(rate, start, 1.0, count);
}

} // namespace Test
} // namespace Rhegma
