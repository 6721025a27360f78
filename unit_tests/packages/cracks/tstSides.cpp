#include "CubeScene.hpp"

#include "base/ReadList.hpp"
#include "cracks/Ghosts.hpp"
#include "cracks/Overlap.hpp"
#include "cracks/Sides.hpp"

using namespace Rhegma;
using namespace Rhegma::cracks;
using namespace Rhegma::cracks::test;

namespace
{

constexpr double height = 2.5, front = 4.0; ///< of the crack, from the left edge on [cells]

/// A block of 6 cells in height with a crack midway between two rows of nodes, after one very small step.
/// \param length of the crack, half that of the block [cells] \param thermalStrain of the whole block
std::unique_ptr<Run<2>> crackedBlock(double length = front, double thermalStrain = 0.0)
{
  Teuchos::ParameterList scene = blockScene({2.0 * length * cell, 6.0 * cell});
  if (thermalStrain > 0.0)
  {
    scene.sublist("Thermal").set("Initial Temperature", 400.0);
    for (const std::string& name : sublistNames(scene.sublist("Materials")))
    {
      Teuchos::ParameterList& material = scene.sublist("Materials").sublist(name);
      material.set("Specific Heat", 1000.0);
      material.set("Reference Temperature", 300.0);
      material.set("Thermal Expansion", thermalStrain / 100.0);
    }
  }
  setCrack(scene, {0.0, height * cell, length * cell, height * cell});
  auto run = start<2>(scene);
  run->step(1e-15, false);
  return run;
}

} // namespace

/// Nodes behind the front have the side on which they lie and an enriched field, up to three cells from the
/// crack; the one at the front itself as well, as springs hold it.
TEST(Sides, OfNodesBehindAFront)
{
  const auto run = crackedBlock();
  const State<2>& state = run->state();
  const auto side = onHost(state.cracks.nodeSide), second = onHost(state.cracks.enrichedField),
             active = onHost(state.mesh.nodes.active);
  int above = 0, below = 0;
  for (std::size_t i = 0; i < active.extent(0); ++i)
  {
    const int n = active(i);
    const Vector<2> x = (1.0 / cell) * state.mesh.grid.nodePosition(n);
    if (x[0] < -1e-6 || std::abs(x[1] - height) > 2.9)
      continue;
    const int expected = x[0] > front + 0.5 ? 0 : x[1] > height ? 1 : -1;
    EXPECT_EQ(side(n), expected) << x[0] << ", " << x[1];
    EXPECT_EQ(second(n) >= 0, expected != 0) << x[0] << ", " << x[1];
    above += side(n) > 0 ? 1 : 0;
    below += side(n) < 0 ? 1 : 0;
  }
  // Columns 0 to 4, rows 3 to 5 and 0 to 2.
  EXPECT_EQ(above, 15);
  EXPECT_EQ(below, 15);
}

/// Particles that touch such a node have a side.
TEST(Sides, OfParticlesNextToACrack)
{
  const auto run = crackedBlock();
  const State<2>& state = run->state();
  const auto x = onHost(state.particles.real<2>(fields::position));
  const auto side = onHost(state.particles.integer(fields::side));
  int sided = 0;
  for (int p = 0; p < state.particles.size(); ++p)
  {
    const int expected = x(p, 1) > height * cell ? 1 : -1;
    if (x(p, 0) < 3.0 * cell && std::abs(x(p, 1) - height * cell) < cell)
    {
      EXPECT_EQ(side(p), expected);
    }
    EXPECT_TRUE(side(p) == 0 || side(p) == expected);
    sided += side(p) != 0 ? 1 : 0;
  }
  EXPECT_GT(sided, 0);
}

/// No particle sees a node of the other side; what it sees adds up to one.
TEST(Visibility, OfEnrichedFields)
{
  const auto run = crackedBlock();
  const State<2>& state = run->state();
  const auto nodeSide = onHost(state.cracks.nodeSide);
  const auto particle = onHost(state.stored.particle);
  const auto count = onHost(state.stored.table.count);
  const auto side = onHost(state.particles.integer(fields::side));
  const auto node = onHost(state.stored.table.node);
  const auto weight = onHost(state.stored.table.weight);
  int replaced = 0;
  ASSERT_GT(state.stored.count, 0);
  for (int r = 0; r < state.stored.count; ++r)
  {
    double sum = 0.0;
    for (int k = 0; k < count(r); ++k)
    {
      sum += weight(r, k);
      const bool isSecond = node(r, k) >= state.mesh.nodes.numLattice;
      replaced += isSecond ? 1 : 0;
      if (!isSecond && nodeSide(node(r, k)) != 0)
      {
        EXPECT_EQ(nodeSide(node(r, k)), side(particle(r)));
      }
    }
    EXPECT_NEAR(sum, 1.0, 1e-12);
  }
  EXPECT_GT(replaced, 0);
}

/// A node right above the crack is extrapolated from the two below it, and vice versa; the next row from one
/// step further on.
TEST(Ghosts, AreExtrapolatedAcrossTheCrack)
{
  const auto run = crackedBlock();
  const State<2>& state = run->state();
  const View<int*> none("none", state.particles.size());
  Kokkos::deep_copy(none, -1);
  Ghosts ghosts;
  findGhosts(state, none, ghosts);
  const auto step = onHost(ghosts.step), distance = onHost(ghosts.distance),
             active = onHost(state.mesh.nodes.active);
  const auto linear = onHost(ghosts.linear);
  int found = 0;
  for (std::size_t i = 0; i < active.extent(0); ++i)
  {
    const int n = active(i);
    const Vector<2> x = (1.0 / cell) * state.mesh.grid.nodePosition(n);
    if (x[0] < -1e-6 || x[0] > front - 0.5 || std::abs(x[1] - height) > 1.6)
      continue;
    const int row = static_cast<int>(std::lround(x[1])), up = row > height ? 1 : -1;
    EXPECT_EQ(step(n), -up * state.mesh.grid.stride[1]) << x[0] << ", " << x[1];
    EXPECT_EQ(distance(n), row == 3 || row == 2 ? 1 : 2) << x[0] << ", " << x[1];
    EXPECT_EQ(linear(n), 1.0); // without mass beyond the crack nothing is limited
    ++found;
  }
  EXPECT_EQ(found, 16);
}

/// Faces that are at rest and overlap are reported by their crack's name; open or closed ones are not.
TEST(Overlap, OfFacesIsReported)
{
  const auto run = crackedBlock();
  State<2>& state = run->state();
  const auto face = onHost(state.cracks.face);
  const auto shift = [&](double by)
  {
    for (std::size_t v = 0; v + 1 < face.extent(0); ++v)
    {
      face(v, 0, 1) = height * cell - 0.5 * by;
      face(v, 1, 1) = height * cell + 0.5 * by;
    }
    Kokkos::deep_copy(state.cracks.face, face);
    return warningOfOverlap(state, 0);
  };
  EXPECT_EQ(shift(0.1 * cell), "");
  EXPECT_EQ(shift(0.0), "");
  EXPECT_NE(shift(-0.1 * cell).find("Cut"), std::string::npos);
}

/// Where the crack is open at one end and its faces overlap at the other, as in bending, the part that
/// overlaps is named.
TEST(Overlap, OfAPartOfTheFacesIsReported)
{
  const auto run = crackedBlock(16.0);
  State<2>& state = run->state();
  const auto face = onHost(state.cracks.face);
  const auto F = onHost(state.particles.real<gradientSize<2>>(fields::deformation));
  const auto vertices = face.extent(0);
  for (std::size_t p = 0; p < F.extent(0); ++p)
    F(p, 3) = 1.01; // so that single vertices may overlap by 0.01 cells
  Kokkos::deep_copy(state.particles.real<gradientSize<2>>(fields::deformation), F);
  const auto bend = [&](double closed, double by)
  {
    for (std::size_t v = 0; v < vertices; ++v)
    {
      const double opening = v < closed * vertices ? -by : by;
      face(v, 0, 1) = height * cell - 0.5 * opening;
      face(v, 1, 1) = height * cell + 0.5 * opening;
    }
    Kokkos::deep_copy(state.cracks.face, face);
    return warningOfOverlap(state, 0);
  };
  EXPECT_EQ(bend(0.5, 0.03 * cell), ""); // waves may do that
  state.clock.settled = true;
  EXPECT_NE(bend(0.5, 0.03 * cell).find(" % of the crack, because the scene has no contact"),
            std::string::npos);
  EXPECT_EQ(bend(0.5, 0.003 * cell), "");
  EXPECT_EQ(bend(0.0, 0.03 * cell), "");
}

/// Thermal strain moves both faces alike, so that it excuses no overlap: in a block that has expanded freely
/// by 1 % faces overlap by a tenth of what that strain would give single vertices.
TEST(Overlap, IsNotExcusedByThermalStrain)
{
  constexpr double strain = 0.01, by = 0.1 * strain * cell;
  for (const bool isHot : {false, true})
  {
    const auto run = crackedBlock(16.0, isHot ? strain : 0.0);
    State<2>& state = run->state();
    const auto F = onHost(state.particles.real<gradientSize<2>>(fields::deformation));
    for (std::size_t p = 0; p < F.extent(0); ++p)
      F(p, 0) = F(p, 3) = 1.0 + strain;
    Kokkos::deep_copy(state.particles.real<gradientSize<2>>(fields::deformation), F);
    const auto face = onHost(state.cracks.face);
    for (std::size_t v = 0; v < face.extent(0); ++v)
    {
      const double opening = 2 * v < face.extent(0) ? -by : by;
      face(v, 0, 1) = height * cell - 0.5 * opening;
      face(v, 1, 1) = height * cell + 0.5 * opening;
    }
    Kokkos::deep_copy(state.cracks.face, face);
    state.clock.settled = true;
    EXPECT_EQ(warningOfOverlap(state, 0).empty(), !isHot);
  }
}
