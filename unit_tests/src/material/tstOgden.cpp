/// The law of Ogden: other laws that it contains, closed forms, its tangent, and what it refuses.

#include "Cases.hpp"
#include "Seed.hpp"
#include "equilibrium/TrialStress.hpp"

namespace Rhegma
{
namespace Test
{

namespace
{

struct Terms
{
  std::vector<double> moduli, exponents;

  double shear() const
  {
    double sum = 0.0;
    for (std::size_t p = 0; p < moduli.size(); ++p)
      sum += 0.5 * moduli[p] * exponents[p];
    return sum;
  }
  /// sum mu_p l^alpha_p.
  double power(double stretch) const
  {
    double sum = 0.0;
    for (std::size_t p = 0; p < moduli.size(); ++p)
      sum += moduli[p] * std::pow(stretch, exponents[p]);
    return sum;
  }
  double slope(double stretch) const
  {
    double sum = 0.0;
    for (std::size_t p = 0; p < moduli.size(); ++p)
      sum += moduli[p] * exponents[p] * std::pow(stretch, exponents[p]);
    return sum;
  }
};

/// 1 to 6 terms whose exponents are from -3 to 5, with shares of one unit of shear modulus.
class DrawTerms
{
public:
  double between(double low, double high) { return low + (high - low) * unit_(engine_); }

  Terms terms()
  {
    Terms drawn;
    const int count = 1 + static_cast<int>(between(0.0, 5.999));
    for (int p = 0; p < count; ++p)
    {
      double exponent = between(-3.0, 5.0);
      exponent += exponent < 0.0 ? -0.2 : 0.2;
      drawn.exponents.push_back(exponent);
      drawn.moduli.push_back(2.0 * between(0.2, 1.0) / count / exponent);
    }
    return drawn;
  }

private:
  std::mt19937 engine_{seed()};
  std::uniform_real_distribution<double> unit_{0.0, 1.0};
};

/// Stress and energy of both laws, in units of the largest modulus times the largest power of the stretches
/// at J^(-1/3) stretches of 0.3 to 4: some roundings of 20 * 16 * 16.
template <int D, Plane P>
void compareWithMooneyRivlin()
{
  DrawTerms draw;
  Random random;
  for (int sample = 0; sample < 100; ++sample)
  {
    const double c10 = draw.between(0.1, 0.5), c01 = draw.between(0.01, 0.3), bulk = draw.between(5.0, 20.0);
    const Properties m = ogden(P, {2.0 * c10, -2.0 * c01}, {2.0, -2.0}, bulk),
                     same = mooneyRivlin(P, c10, c01, bulk);
    EXPECT_NEAR(m.mu, same.mu, 1e-15);
    Gradient<D> F = random.deformation<D>(0.5, 2.0), G = F;
    History<D> history{};
    const Symmetric<D> tau = stressOf<Case<Ogden, D, P>>(m, F, history);
    const Symmetric<D> expected = stressOf<Case<MooneyRivlin, D, P>>(same, G, history);
    constexpr double rounding = 1e-12;
    for (int i = 0; i < symmetricSize<D>; ++i)
      EXPECT_NEAR(tau[i], expected[i], rounding) << i;
    for (int k = 0; k < gradientSize<D>; ++k)
      EXPECT_NEAR(F[k], G[k], rounding);
    EXPECT_NEAR((Ogden::energy<D, P>(m, F.data(), nullptr)),
                (MooneyRivlin::energy<D, P>(same, G.data(), nullptr)), rounding);
  }
}

} // namespace

TEST(Ogden, OfTwoAndMinusTwoIsMooneyRivlin)
{
  compareWithMooneyRivlin<2, Plane::Strain>();
  compareWithMooneyRivlin<2, Plane::Stress>();
  compareWithMooneyRivlin<3, Plane::Solid>();
}

/// One term of alpha = 2 is mu/2 (tr b - 3) where the volume stays: the shape of the neo-Hookean law, whose
/// stress differs by a pressure.
TEST(Ogden, OfTwoIsNeoHookean)
{
  Random random;
  const Properties same = hookean("Neo-Hookean", Plane::Solid, 2.6, 0.3);
  const Properties m = ogden(Plane::Solid, {same.mu}, {2.0}, same.bulk);
  EXPECT_NEAR(m.mu, same.mu, 1e-15);
  for (int sample = 0; sample < 100; ++sample)
  {
    Gradient<3> F = random.deformation<3>(0.5, 2.0);
    const double scale = 1.0 / std::cbrt(determinant<3>(F.data()));
    for (double& component : F)
      component *= scale;
    History<3> history{};
    Symmetric<3> tau = stressOf<Case<Ogden, 3, Plane::Solid>>(m, F, history);
    Symmetric<3> expected = stressOf<Case<NeoHookean, 3, Plane::Solid>>(same, F, history);
    const double pressure = trace<3>(tau.data()) / 3.0, other = trace<3>(expected.data()) / 3.0;
    for (int i = 0; i < 6; ++i)
      EXPECT_NEAR(tau[i] - (i < 3 ? pressure : 0.0), expected[i] - (i < 3 ? other : 0.0), 1e-13) << i;
    EXPECT_NEAR((Ogden::energy<3, Plane::Solid>(m, F.data(), nullptr)),
                (NeoHookean::energy<3, Plane::Solid>(same, F.data(), nullptr)), 1e-13);
  }
}

namespace
{

/// Cauchy stress of a bar with free sides, by bisection of the lateral stretch.
template <int D, Plane P>
double barStress(const Terms& terms, double bulk, double stretch)
{
  const Properties m = ogden(P, terms.moduli, terms.exponents, bulk);
  double low = 0.1, high = 3.0, stress = 0.0;
  for (int i = 0; i < 100; ++i)
  {
    const double s = 0.5 * (low + high);
    Gradient<D> F = identity<D>();
    F[0] = stretch;
    F[D + 1] = s;
    if (D == 3)
      F[D * D - 1] = s;
    History<D> history{};
    const Symmetric<D> tau = stressOf<Case<Ogden, D, P>>(m, F, history);
    (tau[1] > 0.0 ? high : low) = s;
    stress = tau[0] / determinant<D>(F.data());
  }
  return stress;
}

double sheetStress(const Terms& terms, double bulk, double stretch)
{
  const Properties m = ogden(Plane::Stress, terms.moduli, terms.exponents, bulk);
  Gradient<2> F{stretch, 0.0, 0.0, stretch, 1.0};
  History<2> history{};
  const Symmetric<2> tau = stressOf<Case<Ogden, 2, Plane::Stress>>(m, F, history);
  return tau[0] / determinant<2>(F.data());
}

/// The limit of infinite K: the error is of order stress / K, which two values remove; its square remains,
/// with 1e7 times the shear modulus and stresses up to 2e4 times it below 1e-5. K leaves roundings of 1e-9 of
/// the shear modulus.
template <class Stress>
double limitOf(const Stress& stress, double shear)
{
  const double bulk = 1e7 * shear;
  return 2.0 * stress(2.0 * bulk) - stress(bulk);
}

} // namespace

/// Of incompressible rubber (Ogden 1972): sum mu_p (L^alpha_p - L^(-alpha_p / 2)) of a bar, sum mu_p
/// (L^alpha_p - L^(-2 alpha_p)) of a sheet that is stretched along both axes.
TEST(Ogden, BarsAndSheetsHaveTheClosedForm)
{
  DrawTerms draw;
  std::vector<Terms> all = {{{0.63e6, 0.0012e6, -0.01e6}, {1.3, 5.0, -2.0}}};
  for (int k = 0; k < 20; ++k)
    all.push_back(draw.terms());
  for (const Terms& terms : all)
    for (const double stretch : {3.0, 0.4, draw.between(0.4, 3.0)})
    {
      const double bar = terms.power(stretch) - terms.power(1.0 / std::sqrt(stretch));
      const double sheet = terms.power(stretch) - terms.power(1.0 / (stretch * stretch));
      const auto solid = [&](double K) { return barStress<3, Plane::Solid>(terms, K, stretch); };
      const auto thin = [&](double K) { return barStress<2, Plane::Stress>(terms, K, stretch); };
      const auto both = [&](double K) { return sheetStress(terms, K, stretch); };
      constexpr double part = 1e-4;
      EXPECT_NEAR(limitOf(solid, terms.shear()) / bar, 1.0, part) << stretch;
      EXPECT_NEAR(limitOf(thin, terms.shear()) / bar, 1.0, part) << stretch;
      EXPECT_NEAR(limitOf(both, terms.shear()) / sheet, 1.0, part) << stretch;
    }
}

/// dW = tau : grad du with random constants; differences of fourth order, as in tstLaws.cpp, with exponents
/// up to 5.2 and stretches up to 1.4 / 0.7.
TEST(Ogden, StressIsTheSlopeOfTheEnergyForAnyTerms)
{
  using C = Case<Ogden, 3, Plane::Solid>;
  DrawTerms draw;
  Random random;
  for (int sample = 0; sample < 50; ++sample)
  {
    const Terms terms = draw.terms();
    const Properties m = ogden(Plane::Solid, terms.moduli, terms.exponents, draw.between(2.0, 20.0));
    Gradient<3> F = random.deformation<3>(0.7, 1.4);
    History<3> history{};
    const Symmetric<3> tau = stressOf<C>(m, F, history);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
      {
        std::array<double, 3> ei{}, ej{};
        ei[i] = ej[j] = 1.0;
        const auto energy = [&](double e)
        { return energyOf<C>(m, multiply<3>(dyad<3>(e, ei, ej), F), history); };
        EXPECT_NEAR(slopeAtZero(energy, 1.0e-3), tau[symmetricIndex<3>(i, j)], 1.0e-7) << i << j;
      }
  }
}

namespace
{

/// dP / dG of a solid of principal stretches l along the axes, of (3 i + j) and (3 k + l): Ogden, Non-Linear
/// Elastic Deformations, 6.1.4. Written apart from the law, which has no tangent.
std::array<double, 81> principalTangent(const Terms& terms, double bulk, const double (&l)[3])
{
  const double J = l[0] * l[1] * l[2], root = std::cbrt(J);
  double t[3], h[3], mean = 0.0;
  for (int i = 0; i < 3; ++i)
    mean += terms.power(l[i] / root) / 3.0;
  for (int i = 0; i < 3; ++i)
  {
    t[i] = terms.power(l[i] / root) - mean + bulk * J * (J - 1.0);
    h[i] = terms.slope(l[i] / root);
  }
  std::array<double, 81> A{};
  const auto at = [&A](int i, int j, int k, int m) -> double& { return A[9 * (3 * i + j) + 3 * k + m]; };
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
    {
      double W = bulk * J * (2.0 * J - 1.0);
      for (int k = 0; k < 3; ++k)
        W += h[k] * ((i == k) - 1.0 / 3.0) * ((j == k) - 1.0 / 3.0);
      at(i, i, j, j) += W - (i == j ? t[i] : 0.0);
      if (i == j)
        continue;
      const double squares = l[i] * l[i] - l[j] * l[j];
      const double s = l[i] == l[j] ? h[i] / (2.0 * l[i] * l[i]) : (t[i] - t[j]) / squares;
      at(j, i, j, i) += s * l[i] * l[i];
      at(i, j, j, i) += s * l[i] * l[i] - t[i];
    }
  return A;
}

/// The same of a body whose stretches lie along the rows of Q^T.
std::array<double, 81> turned(const std::array<double, 81>& A, const Gradient<3>& Q)
{
  std::array<double, 81> result{};
  for (int r = 0; r < 81; ++r)
    for (int c = 0; c < 81; ++c)
    {
      const int a[4] = {r / 27, r / 9 % 3, r / 3 % 3, r % 3}, b[4] = {c / 27, c / 9 % 3, c / 3 % 3, c % 3};
      double product = A[c];
      for (int k = 0; k < 4; ++k)
        product *= Q[3 * a[k] + b[k]];
      result[r] += product;
    }
  return result;
}

} // namespace

/// The tangent of equilibrium, by differences of 1e-5 whose relative error is 1e-9 for strains of order one,
/// times the sixth power of stretch that the third derivatives of such terms have, against the closed form;
/// also where two or all stretches are equal, in 3D and in plane strain.
TEST(Ogden, TangentIsTheClosedFormAlsoAtEqualStretches)
{
  DrawTerms draw;
  Random random;
  for (int sample = 0; sample < 60; ++sample)
  {
    const Terms terms = draw.terms();
    const double bulk = draw.between(2.0, 20.0);
    double l[3] = {draw.between(0.6, 1.6), draw.between(0.6, 1.6), draw.between(0.6, 1.6)};
    if (sample % 3 > 0)
      l[1] = l[0];
    if (sample % 3 > 1)
      l[2] = l[0];
    const bool flat = sample % 2 == 0; // 2D, then the third axis is z
    Gradient<3> Q = random.rotation<3>();
    if (flat)
      Q = solid(random.rotation<2>());
    const std::array<double, 81> expected = turned(principalTangent(terms, bulk, l), Q);
    Gradient<3> U = identity<3>();
    for (int i = 0; i < 3; ++i)
      U[4 * i] = l[i];
    const Gradient<3> F =
        multiply<3>(Q, multiply<3>(U, flat ? solid(random.rotation<2>()) : random.rotation<3>()));
    const double size = (bulk + 1.0) * 1e-6;
    const ThermoTables none;
    if (flat)
    {
      const Properties m = ogden(Plane::Strain, terms.moduli, terms.exponents, bulk);
      const double before[5] = {F[0], F[1], F[3], F[4], F[8]}, G[5] = {};
      double A[5][5];
      ASSERT_TRUE(equilibrium::trialTangent<2>({m, before, nullptr, 0, 1.0, none, 0, 0.0}, G, A, 5));
      const int at[] = {0, 1, 3, 4, 8}; // of components in 2D, the last across the plane
      for (int r = 0; r < 5; ++r)
        for (int c = 0; c < 5; ++c)
          EXPECT_NEAR(A[r][c], expected[9 * at[r] + at[c]], size) << r << c;
      continue;
    }
    const Properties m = ogden(Plane::Solid, terms.moduli, terms.exponents, bulk);
    const double G[9] = {};
    double A[9][9];
    ASSERT_TRUE(equilibrium::trialTangent<3>({m, F.data(), nullptr, 0, 1.0, none, 0, 0.0}, G, A, 9));
    for (int r = 0; r < 9; ++r)
      for (int c = 0; c < 9; ++c)
        EXPECT_NEAR(A[r][c], expected[9 * r + c], size) << r << c;
  }
}

/// b is put together again from its axes, to some roundings, however close its eigenvalues are.
TEST(Ogden, AxesAreFoundAlsoWhereStretchesAreClose)
{
  DrawTerms draw;
  Random random;
  for (int sample = 0; sample < 2000; ++sample)
  {
    Gradient<3> U = identity<3>();
    const double first = draw.between(0.5, 2.0);
    for (int i = 0; i < 3; ++i)
      U[4 * i] = sample % 4 == 0 ? draw.between(0.1, 4.0) : first + std::pow(10.0, draw.between(-18.0, -1.0));
    const Gradient<3> F = multiply<3>(random.rotation<3>(), multiply<3>(U, random.rotation<3>()));
    const PrincipalStretches<3> stretches(F.data());
    double square[3], b[6], g[6], largest = 0.0;
    for (int i = 0; i < 3; ++i)
      largest = std::fmax(largest, square[i] = std::exp(2.0 * stretches.log[i]));
    stretches.assemble(square, b);
    leftStrain<3>(F.data(), g);
    for (int i = 0; i < 6; ++i)
      EXPECT_NEAR(b[i], g[i] + (i < 3 ? 1.0 : 0.0), 2e-14 * largest) << sample;
  }
}

TEST(Ogden, RefusesWhatIsNoRubber)
{
  EXPECT_EQ(refusalOf("Rubber", ogdenList({1.0, -0.1}, {2.0, -2.0}, 20.0)), "");
  expectIn(refusalOf("Rubber", ogdenList({1.0, 0.1}, {2.0, -2.0}, 20.0)),
           "Materials > Rubber > Moduli: has 0.1 Pa in term 2, with the exponent -2: mu_p alpha_p > 0 fails, "
           "-0.2 <= 0");
  expectIn(refusalOf("Rubber", ogdenList({-1.0}, {2.0}, 20.0)), "mu_p alpha_p > 0 fails, -2 <= 0");
  expectIn(refusalOf("Rubber", ogdenList({1.0}, {0.0}, 20.0)),
           "Materials > Rubber > Exponents: has 0 in term 1");
  expectIn(
      refusalOf("Rubber", ogdenList({1.0, 2.0}, {2.0}, 20.0)),
      "Materials > Rubber > Exponents: has 1 numbers, but Moduli has 2; give one exponent for each modulus.");
  expectIn(refusalOf("Rubber", ogdenList({}, {}, 20.0)),
           "Moduli: has 0 numbers; give the moduli of 1 to 6 terms");
  const std::vector<double> seven(7, 1.0);
  expectIn(refusalOf("Rubber", ogdenList(seven, seven, 20.0)),
           "Moduli: has 7 numbers; give the moduli of 1 to 6 terms");
  expectIn(refusalOf("Rubber", ogdenList({3.0}, {2.0}, 1.9)),
           "Materials > Rubber > Bulk Modulus: is 1.9 Pa; this law is for nearly incompressible material, "
           "and K >= "
           "2/3 mu fails with the shear modulus mu = 1/2 sum mu_p alpha_p = 3 Pa; give at least 2.");
  expectIn(refusalOf("Rubber", ogdenList({3.0}, {2.0}, 0.0)), "Bulk Modulus: is 0; give a positive");
}

} // namespace Test
} // namespace Rhegma
