#include "LatticeState.hpp"

#include "energy_release/OtherMaterials.hpp"

#include <gtest/gtest.h>

#include <limits>

using namespace Rhegma;
using namespace Rhegma::energy_release;
using namespace Rhegma::energy_release::test;

namespace
{

/// A body whose material has other moduli, or another name only, where x > 4 mm.
State<2> twoMaterials(double stiffness)
{
  State<2> state = makeBody(0.01, 1e-3, Plane::Strain, ShapeKind::Gimp);
  state.materials.properties.push_back(state.materials.properties[0]);
  state.materials.properties[1].mu *= stiffness;
  state.materials.names.resize(2, "Other");
  const auto x = onHost(state.particles.real<2>(fields::position));
  const auto material = onHost(state.particles.integer(fields::material));
  for (int p = 0; p < state.particles.size(); ++p)
    material(p) = x(p, 0) > 4e-3 ? 1 : 0;
  Kokkos::deep_copy(state.particles.integer(fields::material), material);
  return state;
}

} // namespace

TEST(OtherMaterials, AreFoundWithTheirDistance)
{
  State<2> state = twoMaterials(2.0);
  const CrackFront<2> front = addFront(state, {{0.0, 0.0}}, 0.0);
  const auto x = onHost(state.particles.real<2>(fields::position));
  double expected = std::numeric_limits<double>::infinity();
  for (int p = 0; p < state.particles.size(); ++p)
    if (x(p, 0) > 4e-3)
      expected = std::min(expected, std::hypot(x(p, 0), x(p, 1)));
  const OtherMaterials<2> others(state);
  EXPECT_TRUE(others.any());
  const OtherMaterial found = others.nearest(front, 6e-3);
  EXPECT_EQ(found.material, 1);
  EXPECT_DOUBLE_EQ(found.distance, expected);
  EXPECT_NEAR(found.distance, 4e-3, 0.5e-3); // to within half a cell
  EXPECT_EQ(others.nearest(front, 3.9e-3).material, -1);
}

TEST(OtherMaterials, WithTheSameModuliAreNone)
{
  State<2> same = twoMaterials(1.0), single = makeBody(0.01, 1e-3, Plane::Strain, ShapeKind::Gimp);
  const CrackFront<2> front = addFront(same, {{0.0, 0.0}}, 0.0);
  EXPECT_EQ(OtherMaterials<2>(same).nearest(front, 6e-3).material, -1);
  EXPECT_FALSE(OtherMaterials<2>(single).any());
}
