#include "FieldStates.hpp"
#include "Hdf5Reader.hpp"
#include "output/FieldWriter.hpp"

#include <cmath>
#include <stdexcept>

using namespace Rhegma;

namespace
{

std::size_t count(const std::string& text, const std::string& part)
{
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++n;
  return n;
}

using Numbers = std::vector<double>;

} // namespace

TEST(FieldWriter, WritesParticles)
{
  const Folder folder;
  State<2> state = twoParticles();
  state.clock.time = 0.125;
  FieldWriter<2>(folder.path()).write(state);
  const Hdf5Reader file(folder.path("fields.h5"));
  EXPECT_EQ(file.attribute("/t00000", "time"), 0.125);
  const std::string p = "/t00000/particles/";
  EXPECT_EQ(file.extents(p + "position"), (std::vector<std::size_t>{2, 3}));
  EXPECT_EQ(file.numbers(p + "position"), (Numbers{0.25, 0.5, 0, 1.5, 0.75, 0}));
  EXPECT_EQ(file.numbers(p + "displacement"), (Numbers{0.25, 0, 0, 0, 0.5, 0}));
  EXPECT_EQ(file.numbers(p + "velocity"), (Numbers{1, 2, 0, 3, 4, 0}));
  EXPECT_EQ(file.numbers(p + "mass"), (Numbers{1, 1}));
  EXPECT_EQ(file.numbers(p + "edge"), (Numbers{0.5, 0.5}));
  EXPECT_EQ(file.extents(p + "edge"), (std::vector<std::size_t>{2}));
  EXPECT_EQ(file.numbers(p + "body"), (Numbers{0, 1}));
  EXPECT_EQ(file.numbers(p + "material"), (Numbers{0, 0}));
}

/// What a particle's box is drawn from: F, and the edges along the axes of its body, here turned a quarter.
TEST(FieldWriter, WritesTheBoxesOfParticles)
{
  const Folder folder;
  State<2> state = twoParticles();
  fill(state.particles.table(fields::edge), {0.5, 0.25, 0.5, 0.25});
  BodyInfo<2>& turned = state.bodies.info[1];
  turned.axes[0][0] = 0.0;
  turned.axes[0][1] = 1.0;
  turned.axes[1][0] = -1.0;
  turned.axes[1][1] = 0.0;
  FieldWriter<2>(folder.path()).write(state);
  const Hdf5Reader file(folder.path("fields.h5"));
  EXPECT_EQ(file.numbers("/t00000/particles/deformation"),
            (Numbers{2, 0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1}));
  EXPECT_EQ(file.numbers("/t00000/particles/edges"),
            (Numbers{0.5, 0, 0, 0, 0.25, 0, 0, 0, 0, 0, 0.5, 0, -0.25, 0, 0, 0, 0, 0}));
}

/// sigma = tau / J; pure shear s has the von Mises stress sqrt(3) s, and diag(10, 20, 40) with shear 30 has
/// sqrt((10^2 + 20^2 + 30^2)/2 + 3 30^2) = sqrt(3400).
TEST(FieldWriter, WritesCauchyStress)
{
  const Folder folder;
  FieldWriter<2>(folder.path()).write(twoParticles());
  const Hdf5Reader file(folder.path("fields.h5"));
  EXPECT_EQ(file.numbers("/t00000/particles/stress"), (Numbers{10, 20, 40, 30, 0, 0, 0, 0, 0, 5, 0, 0}));
  const Numbers vonMises = file.numbers("/t00000/particles/von_mises");
  EXPECT_DOUBLE_EQ(vonMises[0], std::sqrt(3400.0));
  EXPECT_DOUBLE_EQ(vonMises[1], 5.0 * std::sqrt(3.0));
}

TEST(FieldWriter, WritesStressIn3D)
{
  const Folder folder;
  State<3> state = smallState<3>(1);
  fill(state.particles.table(fields::deformation), {2, 0, 0, 0, 1, 0, 0, 0, 1});
  fill(state.particles.table(fields::stress), {2, 4, 6, 8, 10, 12});
  FieldWriter<3>(folder.path()).write(state);
  EXPECT_EQ(Hdf5Reader(folder.path("fields.h5")).numbers("/t00000/particles/stress"),
            (Numbers{1, 2, 3, 4, 5, 6}));
}

TEST(FieldWriter, WritesFieldsThatEffectsAdded)
{
  const Folder folder;
  State<2> state = twoParticles();
  state.particles.add({"face normal", 3, "", ""});
  state.particles.add({"temperature", 1, "K", ""});
  state.particles.add({"side", 1, "", "", true});
  fill(state.particles.table("face normal"), {1, 2, 3, 4, 5, 6});
  fill(state.particles.table("temperature"), {300, 310});
  fill(state.particles.integer("side"), {-1, 1});
  FieldWriter<2>(folder.path()).write(state);
  const Hdf5Reader file(folder.path("fields.h5"));
  EXPECT_EQ(file.numbers("/t00000/particles/face_normal"), (Numbers{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(file.numbers("/t00000/particles/temperature"), (Numbers{300, 310}));
  EXPECT_EQ(file.numbers("/t00000/particles/side"), (Numbers{-1, 1}));
  EXPECT_NE(contents(folder.path("fields.xdmf")).find("Name=\"face_normal\" AttributeType=\"Vector\""),
            std::string::npos);
}

/// Two cells next to each other have six nodes.
TEST(FieldWriter, WritesTheCellsThatHoldParticles)
{
  const Folder folder;
  FieldWriter<2>(folder.path()).write(twoParticles());
  const Hdf5Reader file(folder.path("fields.h5"));
  const Numbers points = file.numbers("/t00000/leaves/points");
  const Numbers cells = file.numbers("/t00000/leaves/cells");
  ASSERT_EQ(points.size(), 18u);
  ASSERT_EQ(cells.size(), 8u);
  const double expected[2][4][2] = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{1, 0}, {2, 0}, {2, 1}, {1, 1}}};
  for (int c = 0; c < 2; ++c)
  {
    const int x = cells[4 * c] == cells[0] && points[3 * static_cast<int>(cells[0])] == 0.0 ? 0 : 1;
    for (int k = 0; k < 4; ++k)
    {
      const int at = static_cast<int>(cells[4 * c + k]);
      EXPECT_DOUBLE_EQ(points[3 * at], expected[x][k][0]);
      EXPECT_DOUBLE_EQ(points[3 * at + 1], expected[x][k][1]);
      EXPECT_EQ(points[3 * at + 2], 0.0);
    }
  }
}

/// The hexahedron's lower face first, each counter-clockwise: then the triple product of its edges is its
/// volume.
TEST(FieldWriter, WritesHexahedraInTheOrderOfVtk)
{
  const Folder folder;
  State<3> state = smallState<3>(1);
  fill(state.particles.table(fields::position), {2.5, 1.5, 3.5});
  FieldWriter<3>(folder.path()).write(state);
  const Hdf5Reader file(folder.path("fields.h5"));
  const Numbers points = file.numbers("/t00000/leaves/points");
  const Numbers cells = file.numbers("/t00000/leaves/cells");
  ASSERT_EQ(cells.size(), 8u);
  const double expected[8][3] = {{2, 1, 3}, {3, 1, 3}, {3, 2, 3}, {2, 2, 3},
                                 {2, 1, 4}, {3, 1, 4}, {3, 2, 4}, {2, 2, 4}};
  for (int k = 0; k < 8; ++k)
    for (int d = 0; d < 3; ++d)
      EXPECT_DOUBLE_EQ(points[3 * static_cast<int>(cells[k]) + d], expected[k][d]) << k << " " << d;
}

TEST(FieldWriter, WritesCracks)
{
  const Folder folder;
  State<2> state = twoParticles();
  addCrack(state);
  FieldWriter<2>(folder.path()).write(state);
  const Hdf5Reader file(folder.path("fields.h5"));
  EXPECT_EQ(file.numbers("/t00000/cracks/points"), (Numbers{0, 1, 0, 1, 1, 0, 2, 1, 0}));
  EXPECT_EQ(file.numbers("/t00000/cracks/cells"), (Numbers{0, 1, 1, 2}));
  EXPECT_EQ(file.extents("/t00000/cracks/cells"), (std::vector<std::size_t>{2, 2}));
  EXPECT_EQ(file.numbers("/t00000/cracks/crack"), (Numbers{0, 0}));
  const Numbers opening = file.numbers("/t00000/cracks/opening");
  ASSERT_EQ(opening.size(), 9u);
  // Differences of numbers near 1: round-off of 1.
  EXPECT_NEAR(opening[1], 0.1, 3.0e-16);
  EXPECT_NEAR(opening[4], 0.04, 3.0e-16);
  EXPECT_EQ(opening[7], 0.0);
  EXPECT_NE(contents(folder.path("fields.xdmf")).find("\"Polyline\""), std::string::npos);
}

TEST(FieldWriter, HasNoCracksWithoutCracks)
{
  const Folder folder;
  FieldWriter<2>(folder.path()).write(twoParticles());
  EXPECT_FALSE(Hdf5Reader(folder.path("fields.h5")).has("/t00000/cracks"));
  EXPECT_EQ(contents(folder.path("fields.xdmf")).find("cracks"), std::string::npos);
}

/// The files can be read after every time, while the writer lives.
TEST(FieldWriter, AddsTimes)
{
  const Folder folder;
  State<2> state = twoParticles();
  FieldWriter<2> writer(folder.path());
  for (int k = 0; k < 3; ++k)
  {
    state.clock.time = 0.5 * k;
    fill(state.particles.table(fields::mass), {k + 1.0, 1.0});
    writer.write(state);
    writer.write(state); // the same time
    const std::string group = "/t0000" + std::to_string(k);
    const Hdf5Reader file(folder.path("fields.h5"));
    EXPECT_EQ(file.attribute(group, "time"), 0.5 * k);
    EXPECT_EQ(file.numbers(group + "/particles/mass")[0], k + 1.0);
    EXPECT_FALSE(file.has("/t0000" + std::to_string(k + 1)));
    const std::string guide = contents(folder.path("fields.xdmf"));
    // One grid of particles and one of leaves.
    EXPECT_EQ(count(guide, "<Time "), static_cast<std::size_t>(2 * (k + 1)));
    EXPECT_EQ(count(guide, "<Grid "), count(guide, "</Grid>"));
    EXPECT_NE(guide.find("fields.h5:" + group + "/particles/position"), std::string::npos);
  }
}

TEST(FieldWriter, ReplacesOlderFiles)
{
  const Folder folder;
  State<2> state = twoParticles();
  FieldWriter<2>(folder.path()).write(state);
  const Hdf5Reader open(folder.path("fields.h5"));
  FieldWriter<2> writer(folder.path());
  EXPECT_FALSE(std::filesystem::exists(folder.path("fields.xdmf")));
  EXPECT_FALSE(Hdf5Reader(folder.path("fields.h5")).has("/t00000"));
  EXPECT_TRUE(open.has("/t00000"));
}

TEST(FieldWriter, SaysThatFilesCannotBeMade)
{
  const Folder folder;
  EXPECT_THROW(FieldWriter<2>(folder.path("none")), std::runtime_error);
}
