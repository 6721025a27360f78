#pragma once
/// Materials, deformations and small linear algebra for the tests of the constitutive laws.

#include "material/MaterialTable.hpp"
#include "material/Materials.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace Rhegma
{
namespace Test
{

template <int D>
using Gradient = std::array<double, gradientSize<D>>;
template <int D>
using Symmetric = std::array<double, symmetricSize<D>>;
template <int D>
using History = std::array<double, symmetricSize<D> + 2>;

inline Properties hookean(const std::string& model, Plane plane, double young, double poisson)
{
  Teuchos::ParameterList list;
  list.set("Model", model);
  list.set("Density", 2.0);
  list.set("Young Modulus", young);
  list.set("Poisson Ratio", poisson);
  return makeProperties(list, "Test", plane);
}

/// The message with which a material is refused; empty if it is not.
inline std::string refusalOf(const char* name, const Teuchos::ParameterList& list, Plane plane = Plane::Solid)
{
  try
  {
    makeProperties(list, name, plane);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "";
}

inline void expectIn(const std::string& text, const char* part)
{
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

inline Properties mooneyRivlin(Plane plane, double c10, double c01, double bulk)
{
  Teuchos::ParameterList list;
  list.set("Model", "Mooney-Rivlin");
  list.set("Density", 2.0);
  list.set("C10", c10);
  list.set("C01", c01);
  list.set("Bulk Modulus", bulk);
  return makeProperties(list, "Test", plane);
}

inline Properties plastic(Plane plane, double young, double poisson, double yield, double hardening,
                          double saturation = 0.0, double rate = 0.0)
{
  Teuchos::ParameterList list;
  list.set("Model", "J2 Plastic");
  list.set("Density", 2.0);
  list.set("Young Modulus", young);
  list.set("Poisson Ratio", poisson);
  list.set("Yield Stress", yield);
  list.set("Hardening Modulus", hardening);
  list.set("Saturation Stress", saturation);
  list.set("Saturation Rate", rate);
  return makeProperties(list, "Test", plane);
}

/// A value of a list.
inline Teuchos::Array<double> arrayOf(const std::vector<double>& values)
{
  return Teuchos::Array<double>(values);
}

/// Of moduli E1, E2, E3 of 4, 2 and 1.5, with fibres 20 degrees from x.
inline Teuchos::ParameterList orthotropicList(Plane plane)
{
  Teuchos::ParameterList list;
  list.set("Model", "Orthotropic");
  list.set("Density", 2.0);
  list.set("Young Moduli", arrayOf({4.0, 2.0, 1.5}));
  list.set("Poisson Ratios", arrayOf({0.25, 0.3, 0.2}));
  list.set("Shear Moduli", arrayOf({0.9, 0.7, 0.8}));
  const double c = std::cos(0.35), s = std::sin(0.35);
  list.set("Fibre Direction", plane == Plane::Solid ? arrayOf({c, s, 0.0}) : arrayOf({c, s}));
  return list;
}

inline Teuchos::ParameterList ogdenList(const std::vector<double>& moduli,
                                        const std::vector<double>& exponents, double bulk)
{
  Teuchos::ParameterList list;
  list.set("Model", "Ogden");
  list.set("Density", 2.0);
  list.set("Moduli", arrayOf(moduli));
  list.set("Exponents", arrayOf(exponents));
  list.set("Bulk Modulus", bulk);
  return list;
}

inline Properties ogden(Plane plane, const std::vector<double>& moduli, const std::vector<double>& exponents,
                        double bulk)
{
  return makeProperties(ogdenList(moduli, exponents, bulk), "Test", plane);
}

/// A law, a dimension, a plane, and a material of moduli of order one. The J2 material does not yield.
template <class L, int dimension, Plane plane>
struct Case
{
  using Law = L;
  static constexpr int D = dimension;
  static constexpr Plane P = plane;
  static Properties material()
  {
    if constexpr (std::is_same_v<L, LinearElastic>)
      return hookean("Linear Elastic", P, 2.6, 0.3);
    else if constexpr (std::is_same_v<L, NeoHookean>)
      return hookean("Neo-Hookean", P, 2.6, 0.3);
    else if constexpr (std::is_same_v<L, MooneyRivlin>)
      return mooneyRivlin(P, 0.4, 0.1, 20.0);
    else if constexpr (std::is_same_v<L, Ogden>)
      return ogden(P, {0.9, 0.01, -0.1}, {1.3, 5.0, -2.0}, 20.0);
    else if constexpr (std::is_same_v<L, Orthotropic>)
      return makeProperties(orthotropicList(P), "Test", P);
    else
      return plastic(P, 2.6, 0.3, 1.0e6, 0.0);
  }
};

template <class Law>
constexpr bool isAnisotropicLaw = std::is_same_v<Law, Orthotropic>;

using EveryCase = testing::Types<Case<LinearElastic, 2, Plane::Strain>, Case<LinearElastic, 2, Plane::Stress>,
                                 Case<LinearElastic, 3, Plane::Solid>, Case<NeoHookean, 2, Plane::Strain>,
                                 Case<NeoHookean, 2, Plane::Stress>, Case<NeoHookean, 3, Plane::Solid>,
                                 Case<MooneyRivlin, 2, Plane::Strain>, Case<MooneyRivlin, 2, Plane::Stress>,
                                 Case<MooneyRivlin, 3, Plane::Solid>, Case<J2Plastic, 2, Plane::Strain>,
                                 Case<J2Plastic, 2, Plane::Stress>, Case<J2Plastic, 3, Plane::Solid>,
                                 Case<Orthotropic, 2, Plane::Strain>, Case<Orthotropic, 2, Plane::Stress>,
                                 Case<Orthotropic, 3, Plane::Solid>, Case<Ogden, 2, Plane::Strain>,
                                 Case<Ogden, 2, Plane::Stress>, Case<Ogden, 3, Plane::Solid>>;

template <int D>
Gradient<D> identity()
{
  Gradient<D> F{};
  for (int d = 0; d < D; ++d)
    F[d * D + d] = 1.0;
  if (D == 2)
    F[gradientSize<2> - 1] = 1.0;
  return F;
}

/// A F, in the plane; zz of A multiplies zz of F.
template <int D>
Gradient<D> multiply(const Gradient<D>& A, const Gradient<D>& F)
{
  Gradient<D> r{};
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j)
      for (int k = 0; k < D; ++k)
        r[i * D + j] += A[i * D + k] * F[k * D + j];
  if constexpr (D == 2)
    r[4] = A[4] * F[4];
  return r;
}

/// 1 + size m n^T.
template <int D>
Gradient<D> dyad(double size, const std::array<double, D>& m, const std::array<double, D>& n)
{
  Gradient<D> G = identity<D>();
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j)
      G[i * D + j] += size * m[i] * n[j];
  return G;
}

class Random
{
public:
  double between(double low, double high) { return low + (high - low) * uniform(engine); }

  template <int D>
  std::array<double, D> direction()
  {
    std::array<double, D> n{};
    double square = 0.0;
    do
    {
      square = 0.0;
      for (double& c : n)
      {
        c = between(-1.0, 1.0);
        square += c * c;
      }
    } while (square < 0.01 || square > 1.0);
    for (double& c : n)
      c /= std::sqrt(square);
    return n;
  }

  /// A rotation: two reflections.
  template <int D>
  Gradient<D> rotation()
  {
    const auto a = direction<D>();
    const auto b = direction<D>();
    return multiply<D>(dyad<D>(-2.0, a, a), dyad<D>(-2.0, b, b));
  }

  /// Rotation, stretches between two bounds, rotation. Plane strain gets a thickness stretch as heat may give
  /// it.
  template <int D>
  Gradient<D> deformation(double low, double high)
  {
    Gradient<D> U = identity<D>();
    for (int d = 0; d < D; ++d)
      U[d * D + d] = between(low, high);
    if constexpr (D == 2)
      U[4] = between(0.95, 1.05);
    return multiply<D>(rotation<D>(), multiply<D>(U, rotation<D>()));
  }

private:
  std::mt19937 engine{20240229};
  std::uniform_real_distribution<double> uniform{0.0, 1.0};
};

/// Q a Q^T.
template <int D>
Symmetric<D> rotate(const Gradient<D>& Q, const Symmetric<D>& a)
{
  Symmetric<D> r{};
  for (int i = 0; i < D; ++i)
    for (int j = i; j < D; ++j)
      for (int k = 0; k < D; ++k)
        for (int l = 0; l < D; ++l)
          r[symmetricIndex<D>(i, j)] += Q[i * D + k] * a[symmetricIndex<D>(k, l)] * Q[j * D + l];
  if (D == 2)
    r[3] = a[3];
  return r;
}

/// The same deformation in three dimensions.
inline Gradient<3> solid(const Gradient<2>& F) { return {F[0], F[1], 0.0, F[2], F[3], 0.0, 0.0, 0.0, F[4]}; }

inline Symmetric<3> solid(const Symmetric<2>& a) { return {a[0], a[1], a[3], a[2], 0.0, 0.0}; }

/// Stress of a law; completes F.
template <class C>
Symmetric<C::D> stressOf(const Properties& m, Gradient<C::D>& F, History<C::D>& history)
{
  Symmetric<C::D> tau;
  EXPECT_TRUE((C::Law::template stress<C::D, C::P>(m, F.data(), tau.data(), history.data())));
  return tau;
}

/// Energy of a law, in plane stress at the thickness that the law finds.
template <class C>
double energyOf(const Properties& m, Gradient<C::D> F, const History<C::D>& history)
{
  History<C::D> copy = history;
  stressOf<C>(m, F, copy);
  return C::Law::template energy<C::D, C::P>(m, F.data(), history.data());
}

/// Slope at zero by central differences of fourth order: error step^4 f^(5) / 30 + round-off of f / step.
template <class Function>
double slopeAtZero(const Function& f, double step)
{
  return (8.0 * (f(step) - f(-step)) - (f(2.0 * step) - f(-2.0 * step))) / (12.0 * step);
}

} // namespace Test
} // namespace Rhegma
