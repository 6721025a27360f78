/// The domain integrals around a front in a body whose stiffness depends on direction.

#include "LatticeState.hpp"
#include "Pi.hpp"
#include "Seed.hpp"
#include "energy_release/Disagreement.hpp"
#include "energy_release/DomainIntegral.hpp"
#include "energy_release/FrontDisk.hpp"

#include <gtest/gtest.h>

#include <random>

namespace Rhegma::energy_release::test::anisotropic
{

using Rhegma::Test::pi;

namespace
{

constexpr double half = 0.01, cell = 0.5e-3;
const ContourRadii radii{3e-3, 7e-3};

/// Strains are 1e-8 where the ring begins: rotations and stretch matter no more than that.
constexpr double smallK = 1.0;

Teuchos::Array<double> arrayOf(const std::vector<double>& values) { return Teuchos::Array<double>(values); }

struct RandomBody
{
  std::mt19937 engine{Rhegma::Test::seed()};
  double between(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(engine);
  }
  /// With the moduli of composites and wood, along fibres of an angle.
  Teuchos::ParameterList material(double angle)
  {
    Teuchos::ParameterList list;
    list.set<std::string>("Model", "Orthotropic");
    list.set("Density", density);
    list.set("Young Moduli", arrayOf({between(3.0, 40.0) * 1e9, between(1.0, 3.0) * 1e9, 2e9}));
    list.set("Poisson Ratios", arrayOf({between(0.1, 0.4), 0.3, 0.3}));
    list.set("Shear Moduli", arrayOf({between(0.5, 3.0) * 1e9, 1e9, 1e9}));
    list.set("Fibre Direction", arrayOf({std::cos(angle), std::sin(angle)}));
    return list;
  }
};

/// Quadrature, as of isotropic bodies (tstDomainIntegral.cpp), where fields change with the angle as with the
/// root of the ratio of moduli, 40 at most, faster: the error is of second order, and its like by 40.
double quadrature() { return 40.0 * cell * cell / (24.0 * radii.inner * radii.inner); }

} // namespace

/// The field of a crack of any direction in a body of any fibres, of which both intensities and J are known.
TEST(AnisotropicIntegral, FindsBothModes)
{
  RandomBody random;
  for (int sample = 0; sample < 12; ++sample)
  {
    const Plane plane = sample % 2 == 0 ? Plane::Strain : Plane::Stress;
    State<2> state = makeBody(half, cell, plane, ShapeKind::Gimp, {{0.3, -0.2}});
    setMaterial(state, random.material(random.between(-pi, pi)));
    CrackFront<2> front = addFront(state, {{0.13e-3, 0.07e-3}}, random.between(-pi, pi));
    if (sample % 3 == 0) // side +1 on its right
      front.normal = -1.0 * front.normal;
    const CrackCompliance material = complianceAtFront(state, front);
    const double K1 = smallK, K2 = random.between(-1.0, 1.0) * smallK, J = material.release(K1, K2);
    deform(state, tipDisplacement(front, material, K1, K2));
    const DomainIntegral result = integrateDomain(state, front, radii, nodalAcceleration(state));
    EXPECT_NEAR(result.J, J, quadrature() * J);
    EXPECT_NEAR(result.modeI, K1, quadrature() * (smallK + std::fabs(K2)));
    EXPECT_NEAR(result.modeII, K2, quadrature() * (smallK + std::fabs(K2)));
  }
}

/// A body that has turned by a finite angle has the fibres of before, and the same J and K.
TEST(AnisotropicIntegral, IsTheSameForATurnedBody)
{
  RandomBody random;
  const double fibres = random.between(-pi, pi), turn = 0.8;
  State<2> state = makeBody(half, cell, Plane::Strain, ShapeKind::Gimp);
  setMaterial(state, random.material(fibres));
  CrackFront<2> front = addFront(state, {{0.0, 0.0}}, 0.0);
  const CrackCompliance material = complianceAtFront(state, front);
  const DisplacementField field = tipDisplacement(front, material, smallK, 0.4 * smallK);
  const double c = std::cos(turn), s = std::sin(turn), R[4] = {c, -s, s, c};
  deform(state,
         [&](const Vector<2>& x)
         {
           const Displacement d = field(x);
           const Vector<2> moved = x + d.u;
           Displacement t;
           for (int i = 0; i < 2; ++i)
           {
             t.u[i] = R[2 * i] * moved[0] + R[2 * i + 1] * moved[1] - x[i];
             for (int j = 0; j < 2; ++j)
               t.gradient[2 * i + j] = R[2 * i] * (d.gradient[j] + (j == 0 ? 1.0 : 0.0)) +
                                       R[2 * i + 1] * (d.gradient[2 + j] + (j == 1 ? 1.0 : 0.0)) -
                                       (i == j ? 1.0 : 0.0);
           }
           return t;
         });
  front = addFront(state, {{0.0, 0.0}}, turn);
  const DomainIntegral result = integrateDomain(state, front, radii, nodalAcceleration(state));
  // As of isotropic bodies (tstDomainIntegral.cpp), and quadrature.
  const double ring = pi * (radii.outer * radii.outer - radii.inner * radii.inner);
  const double tolerance = 0.5 * cell / std::sqrt(ring) + quadrature(), J = material.release(1.0, 0.4);
  EXPECT_NEAR(result.J, J, tolerance * J);
  EXPECT_NEAR(result.modeI, smallK, tolerance);
  EXPECT_NEAR(result.modeII, 0.4 * smallK, tolerance);
}

/// K of which G is not J is warned of, by the matrix of the material.
TEST(AnisotropicIntegral, ComparesGWithK)
{
  RandomBody random;
  State<2> state = makeBody(half, cell, Plane::Strain, ShapeKind::Gimp);
  setMaterial(state, random.material(0.5));
  const CrackFront<2> front = addFront(state, {{0.0, 0.0}}, 0.0);
  const double J = complianceAtFront(state, front).release(2.0, 1.0);
  FrontSample<2> sample(front, 0.0);
  sample.modeI = {2.0};
  sample.modeII = {1.0};
  for (const double fraction : {0.88, 0.95, 1.0, 1.05, 1.15})
  {
    sample.J = {J / fraction};
    EXPECT_EQ(disagrees(state, sample), std::fabs(fraction - 1.0) > 0.1) << fraction;
  }
}

} // namespace Rhegma::energy_release::test::anisotropic
