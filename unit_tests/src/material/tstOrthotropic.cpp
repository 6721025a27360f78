/// The law of orthotropic materials.

#include "Cases.hpp"
#include "Seed.hpp"
#include "material/CrackCompliance.hpp"
#include "material/LawStiffness.hpp"
#include "material/RayleighSpeed.hpp"

namespace Rhegma
{
namespace Test
{

namespace
{

/// Of the unidirectional carbon fibres and epoxy of verification, in GPa, fibres along x.
Teuchos::ParameterList composite()
{
  Teuchos::ParameterList list;
  list.set("Model", "Orthotropic");
  list.set("Density", 1600.0);
  list.set("Young Moduli", arrayOf({140e9, 10e9, 10e9}));
  list.set("Poisson Ratios", arrayOf({0.3, 0.4, 0.3}));
  list.set("Shear Moduli", arrayOf({5e9, 3.5e9, 5e9}));
  return list;
}

Teuchos::ParameterList isotropic(double young, double poisson)
{
  Teuchos::ParameterList list = composite();
  const double shear = young / (2.0 * (1.0 + poisson));
  list.set("Young Moduli", arrayOf({young, young, young}));
  list.set("Poisson Ratios", arrayOf({poisson, poisson, poisson}));
  list.set("Shear Moduli", arrayOf({shear, shear, shear}));
  return list;
}

template <int D>
Properties propertiesOf(const Teuchos::ParameterList& list, Plane plane)
{
  return makeProperties(list, "Ply", plane);
}

/// Stress at a small strain.
template <class C>
Symmetric<C::D> smallStress(const Properties& m, const Gradient<C::D>& change)
{
  Gradient<C::D> F = identity<C::D>();
  for (int k = 0; k < C::D * C::D; ++k)
    F[k] += change[k];
  History<C::D> history{};
  return stressOf<C>(m, F, history);
}

template <class C>
void compareWithIsotropic()
{
  constexpr int D = C::D;
  const double young = 3e9, poisson = 0.33;
  Teuchos::ParameterList list = isotropic(young, poisson);
  list.set("Fibre Direction", D == 3 ? arrayOf({0.3, -0.5, 0.9}) : arrayOf({0.3, -0.5}));
  const Properties m = propertiesOf<D>(list, C::P), same = hookean("Linear Elastic", C::P, young, poisson);
  EXPECT_NEAR(m.mu, same.mu, 1e-13 * young);
  EXPECT_NEAR(m.bulk, same.bulk, 1e-13 * young);
  EXPECT_NEAR(elasticity(m).constrainedModulus, elasticity(same).constrainedModulus, 1e-13 * young);
  Random random;
  for (int sample = 0; sample < 20; ++sample)
  {
    Gradient<D> F = random.deformation<D>(0.9, 1.1), G = F;
    History<D> history{};
    const Symmetric<D> tau = stressOf<C>(m, F, history);
    const Symmetric<D> expected = stressOf<Case<LinearElastic, D, C::P>>(same, G, history);
    for (int i = 0; i < symmetricSize<D>; ++i)
      EXPECT_NEAR(tau[i], expected[i], 1e-14 * 10.0 * young); // both are Saint-Venant and Kirchhoff's
    for (int k = 0; k < gradientSize<D>; ++k)
      EXPECT_NEAR(F[k], G[k], 1e-14);
  }
}

} // namespace

TEST(Orthotropic, IsLinearElasticForIsotropicConstants)
{
  compareWithIsotropic<Case<Orthotropic, 2, Plane::Strain>>();
  compareWithIsotropic<Case<Orthotropic, 2, Plane::Stress>>();
  compareWithIsotropic<Case<Orthotropic, 3, Plane::Solid>>();
}

/// A stress along each axis strains the others by Poisson's ratios: found by solving for the strain with the
/// law, from the definition of the constants. Strains of 1e-9: their squares are below the tolerance.
TEST(Orthotropic, HasTheConstantsOfItsParameters)
{
  using C = Case<Orthotropic, 3, Plane::Solid>;
  const Properties m = propertiesOf<3>(composite(), Plane::Solid);
  const double E[3] = {140e9, 10e9, 10e9}, nu12 = 0.3, nu23 = 0.4, nu13 = 0.3;
  const double strains[3][3] = {{1.0, -nu12, -nu13},
                                {-nu12 * E[1] / E[0], 1.0, -nu23},
                                {-nu13 * E[2] / E[0], -nu23 * E[2] / E[1], 1.0}};
  const double size = 1e-9;
  for (int axis = 0; axis < 3; ++axis)
  {
    Gradient<3> A{};
    for (int d = 0; d < 3; ++d)
      A[4 * d] = size * strains[axis][d];
    const Symmetric<3> s = smallStress<C>(m, A);
    for (int d = 0; d < 6; ++d)
      EXPECT_NEAR(s[d], d == axis ? E[axis] * size : 0.0, 1e-7 * E[0] * size) << axis << d;
  }
  const double G[3] = {5e9, 3.5e9, 5e9}; // xy, yz, xz
  constexpr int row[3] = {0, 1, 0}, column[3] = {1, 2, 2};
  for (int k = 0; k < 3; ++k)
  {
    Gradient<3> A{};
    A[3 * row[k] + column[k]] = size;
    EXPECT_NEAR(smallStress<C>(m, A)[3 + k], G[k] * size, 1e-7 * E[0] * size);
  }
}

/// A body that is turned with its axes before it deforms has the turned stress.
TEST(Orthotropic, AxesTurnWithTheBody)
{
  using C = Case<Orthotropic, 3, Plane::Solid>;
  Random random;
  const Properties m = propertiesOf<3>(composite(), Plane::Solid);
  for (int sample = 0; sample < 20; ++sample)
  {
    const Gradient<3> Q = random.rotation<3>();
    Teuchos::ParameterList list = composite();
    list.set("Fibre Direction", arrayOf({Q[0], Q[3], Q[6]}));
    list.set("Second Direction", arrayOf({2.0 * Q[1] + Q[0], 2.0 * Q[4] + Q[3], 2.0 * Q[7] + Q[6]}));
    const Properties turned = propertiesOf<3>(list, Plane::Solid);
    Gradient<3> F = random.deformation<3>(0.9, 1.1);
    const Gradient<3> back{Q[0], Q[3], Q[6], Q[1], Q[4], Q[7], Q[2], Q[5], Q[8]};
    Gradient<3> G = multiply<3>(Q, multiply<3>(F, back)); // of the body turned as a whole
    History<3> history{};
    const Symmetric<3> expected = rotate<3>(Q, stressOf<C>(m, F, history));
    const Symmetric<3> tau = stressOf<C>(turned, G, history);
    for (int i = 0; i < 6; ++i)
      EXPECT_NEAR(tau[i], expected[i], 1e-13 * 200e9);
    EXPECT_NEAR(turned.own[Orthotropic::fastestAt], m.own[Orthotropic::fastestAt], 1e-12 * 200e9);
  }
}

/// The stiffness in the plane is symmetric under a turn by half, and along the fibres it is that of the
/// constants: 1 / a11 is E1 in plane stress and E1 / (1 - nu13 nu31) in plane strain.
TEST(Orthotropic, KnowsItsStiffnessAlongTheFibres)
{
  Random random;
  for (int sample = 0; sample < 20; ++sample)
  {
    Teuchos::ParameterList list = composite();
    const double angle = random.between(-4.0, 4.0), c = std::cos(angle), s = std::sin(angle);
    list.set("Fibre Direction", arrayOf({3.0 * c, 3.0 * s}));
    for (const Plane plane : {Plane::Stress, Plane::Strain})
    {
      const PlaneStiffness own = planeStiffness(propertiesOf<2>(list, plane));
      const CrackCompliance along = crackCompliance(own, {{c, s}}, {{-s, c}});
      const double nu31 = 0.3 * 10.0 / 140.0, held = plane == Plane::Stress ? 0.0 : 1.0;
      EXPECT_NEAR(along.a11 * 140e9, 1.0 - held * 0.3 * nu31, 1e-11);
      EXPECT_NEAR(along.a22 * 10e9, 1.0 - held * 0.16, 1e-11);
      EXPECT_NEAR(along.a16 * 10e9, 0.0, 1e-11);
      EXPECT_NEAR(own.shear, 5e9, 1e-2);
      EXPECT_NEAR(own.axis[0], c, 1e-15);
    }
  }
}

/// The largest speed is at least that of all of many directions, and that of one of them but for their
/// distance.
TEST(Orthotropic, HasTheSpeedOfItsFastestWave)
{
  const unsigned start = seed();
  std::mt19937 engine(start);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int sample = 0; sample < 5; ++sample)
  {
    Teuchos::ParameterList list = composite();
    list.set("Young Moduli", arrayOf({1.0 + 30.0 * unit(engine), 1.0 + 3.0 * unit(engine), 1.0}));
    list.set("Shear Moduli", arrayOf({5.0 * unit(engine) + 0.1, unit(engine) + 0.1, unit(engine) + 0.1}));
    const Properties m = propertiesOf<2>(list, Plane::Strain);
    const double xx = m.own[0], xy = m.own[1], yy = m.own[4], ss = m.own[7];
    double largest = 0.0;
    for (int k = 0; k < 10000; ++k)
    {
      const double a = std::acos(-1.0) * k / 10000, c = std::cos(a), s = std::sin(a);
      const double A = xx * c * c + ss * s * s, B = yy * s * s + ss * c * c, between = (xy + ss) * c * s;
      largest = std::fmax(largest, 0.5 * (A + B) + std::hypot(0.5 * (A - B), between));
    }
    EXPECT_GE(m.own[Orthotropic::fastestAt], largest * (1.0 - 1e-12));
    EXPECT_LE(m.own[Orthotropic::fastestAt], largest * (1.0 + 1e-6));
    EXPECT_LT(rayleighSpeed(m), std::sqrt(m.own[Orthotropic::fastestAt] / m.density));
  }
}

TEST(Orthotropic, RefusesConstantsWithoutAPositiveEnergy)
{
  EXPECT_EQ(refusalOf("Ply", composite()), "");
  Teuchos::ParameterList list = composite();
  list.set("Young Moduli", arrayOf({25.0, 10.0, 10.0}));
  list.set("Poisson Ratios", arrayOf({2.0, 0.4, 0.3}));
  expectIn(refusalOf("Ply", list), "Materials > Ply > Poisson Ratios: ");
  expectIn(refusalOf("Ply", list), "nu12^2 < E1/E2 fails: 4 > 2.5");
  list = composite();
  list.set("Poisson Ratios", arrayOf({0.3, 1.1, 0.3}));
  expectIn(refusalOf("Ply", list), "nu23^2 < E2/E3 fails: 1.21 > 1");
  list = isotropic(1.0, 0.6);
  expectIn(refusalOf("Ply", list), "1 - nu12 nu21 - nu23 nu32 - nu13 nu31 - 2 nu21 nu32 nu13 > 0 fails");
  list = composite();
  list.set("Shear Moduli", arrayOf({5e9, 0.0, 5e9}));
  expectIn(refusalOf("Ply", list), "Materials > Ply > Shear Moduli: has 0; give three positive numbers");
  list = composite();
  list.set("Young Moduli", arrayOf({5e9, 1e9}));
  expectIn(refusalOf("Ply", list), "Materials > Ply > Young Moduli: has 2 numbers; give three");
}

TEST(Orthotropic, RefusesAxesThatAreNone)
{
  Teuchos::ParameterList list = composite();
  list.set("Fibre Direction", arrayOf({0.0, 0.0, 0.0}));
  expectIn(refusalOf("Ply", list), "Materials > Ply > Fibre Direction: is zero");
  list.set("Fibre Direction", arrayOf({0.0, 2.0, 0.0}));
  expectIn(refusalOf("Ply", list), "Second Direction: is parallel to Fibre Direction");
  list.set("Second Direction", arrayOf({0.0, 1.0, 1.0}));
  EXPECT_EQ(refusalOf("Ply", list), "");
  expectIn(refusalOf("Ply", list, Plane::Strain), "Fibre Direction: has 3 numbers; give 2");
}

/// Two materials with other fibres are not one stiffness.
TEST(Orthotropic, DiffersByItsDirection)
{
  Teuchos::ParameterList list = composite();
  const Properties one = propertiesOf<2>(list, Plane::Stress);
  list.set("Fibre Direction", arrayOf({0.0, 1.0}));
  const Properties other = propertiesOf<2>(list, Plane::Stress);
  EXPECT_TRUE(haveSameStiffness(one, one));
  EXPECT_FALSE(haveSameStiffness(one, other));
  EXPECT_TRUE(isAnisotropic(one));
  EXPECT_TRUE(isLinear(one));
  EXPECT_NEAR(one.mu, other.mu, 1e-12 * one.mu);
}

} // namespace Test
} // namespace Rhegma
