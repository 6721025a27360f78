/// Fields on request against closed forms: with the Green strain E, the law has the energy lambda/2 (tr E)^2
/// + mu E:E, so that formulas of small strain hold for E at any strain.

#include "Hdf5Reader.hpp"
#include "SmallState.hpp"
#include "output/FieldWriter.hpp"

#include <cmath>

using namespace Rhegma;

namespace
{

constexpr double lambda = 3.0, mu = 2.0, young = mu * (3.0 * lambda + 2.0 * mu) / (lambda + mu),
                 poisson = 0.5 * lambda / (lambda + mu), bulk = lambda + 2.0 * mu / 3.0;
constexpr double exact = 1e-12; ///< relative: round-off of some ten operations

struct Values
{
  double principal, energy;
};

/// What the file has of a particle with this deformation gradient, in the layout of the field.
template <int D, Plane P>
Values written(std::vector<double> F)
{
  State<D> state = smallState<D>(1);
  Properties material = state.materials.properties[0];
  material.plane = P;
  if (P == Plane::Stress)
    material.planeLambda = 2.0 * lambda * mu / (lambda + 2.0 * mu);
  state.method.plane = P;
  state.materials.properties[0] = material;
  const auto host = Kokkos::create_mirror_view(state.materials.device);
  host(0) = material;
  Kokkos::deep_copy(state.materials.device, host);
  std::vector<double> tau(symmetricSize<D>, 0.0);
  EXPECT_TRUE((LinearElastic::stress<D, P>(material, F.data(), tau.data(), nullptr)));
  fill(state.particles.table(fields::deformation), F);
  fill(state.particles.table(fields::stress), tau);
  const Folder folder;
  FieldWriter<D>(folder.path()).write(state, {true, true});
  const Hdf5Reader file(folder.path("fields.h5"));
  return {file.numbers("/t00000/particles/principal_stress")[0],
          file.numbers("/t00000/particles/energy_density")[0]};
}

double stretch(double greenStrain) { return std::sqrt(1.0 + 2.0 * greenStrain); }

} // namespace

/// A bar: second Piola-Kirchhoff stress E e, Cauchy stress F S F / J.
TEST(RequestedFields, BarIn3D)
{
  const double e = 0.02, a = stretch(e), b = stretch(-poisson * e);
  const Values found = written<3, Plane::Solid>({a, 0, 0, 0, b, 0, 0, 0, b});
  EXPECT_NEAR(found.principal, young * e * a / (b * b), exact * young);
  EXPECT_NEAR(found.energy, 0.5 * young * e * e, exact * young);
}

TEST(RequestedFields, BarInPlaneStress)
{
  const double e = 0.02, a = stretch(e), b = stretch(-poisson * e);
  const Values found = written<2, Plane::Stress>({a, 0, 0, b, 1});
  EXPECT_NEAR(found.principal, young * e * a / (b * b), exact * young);
  EXPECT_NEAR(found.energy, 0.5 * young * e * e, exact * young);
}

/// Free across the bar in the plane, held across the plane.
TEST(RequestedFields, BarInPlaneStrain)
{
  const double e = 0.02, a = stretch(e), b = stretch(-poisson / (1.0 - poisson) * e);
  const double modulus = young / (1.0 - poisson * poisson);
  const Values found = written<2, Plane::Strain>({a, 0, 0, b, 1});
  EXPECT_NEAR(found.principal, modulus * e * a / b, exact * young);
  EXPECT_NEAR(found.energy, 0.5 * modulus * e * e, exact * young);
}

/// Pressed along x and y the same, held across the plane: the least compressed direction is z.
TEST(RequestedFields, TheLargestStressIsAcrossThePlane)
{
  const double e = -0.01, a = stretch(e);
  const Values found = written<2, Plane::Strain>({a, 0, 0, a, 1});
  EXPECT_NEAR(found.principal, 2.0 * lambda * e / (a * a), exact * young);
  EXPECT_NEAR(found.energy, 2.0 * (lambda + mu) * e * e, exact * young);
}

/// The angle g between two directions: E_xy = g / 2. The Cauchy stress is mu g up to the square of g.
TEST(RequestedFields, PureShear)
{
  const double g = 1e-6, c = std::sqrt(1.0 - g * g);
  const Values flat = written<2, Plane::Strain>({1, g, 0, c, 1});
  const Values solid = written<3, Plane::Solid>({1, g, 0, 0, c, 0, 0, 0, 1});
  for (const Values& found : {flat, solid})
  {
    EXPECT_NEAR(found.principal, mu * g, 10.0 * young * g * g);
    EXPECT_NEAR(found.energy, 0.5 * mu * g * g, 1e-9 * mu * g * g);
  }
}

TEST(RequestedFields, Hydrostatic)
{
  for (const double e : {0.03, -0.03})
  {
    const double a = stretch(e);
    const Values found = written<3, Plane::Solid>({a, 0, 0, 0, a, 0, 0, 0, a});
    EXPECT_NEAR(found.principal, 3.0 * bulk * e / a, exact * young);
    EXPECT_NEAR(found.energy, 4.5 * bulk * e * e, exact * young);
  }
}

TEST(RequestedFields, AreNotWrittenWithoutRequest)
{
  const Folder folder;
  FieldWriter<2>(folder.path()).write(smallState<2>(1));
  const Hdf5Reader file(folder.path("fields.h5"));
  EXPECT_TRUE(file.has("/t00000/particles/von_mises"));
  EXPECT_FALSE(file.has("/t00000/particles/principal_stress"));
  EXPECT_FALSE(file.has("/t00000/particles/energy_density"));
}
