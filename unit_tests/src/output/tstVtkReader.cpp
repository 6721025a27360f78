/// The files as in ParaView: read by VTK's own two readers of XDMF, where Python has them.

#include "FieldStates.hpp"
#include "output/FieldWriter.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <cstdio>
#include <cstdlib>

using namespace Rhegma;
using nlohmann::json;

namespace
{

const std::string script = std::string(RHEGMA_SOURCE_DIR) + "/unit_tests/src/output/readFields.py";

/// Cell types of VTK.
enum VtkCell
{
  PolyVertex = 2,
  PolyLine = 4,
  Triangle = 5,
  Quadrilateral = 9,
  Hexahedron = 12
};

/// A Python that has both readers, or nothing.
std::string python()
{
  for (const std::string name : {"python3", "/usr/bin/python3", "pvpython"})
    if (std::system((name + " '" + script + "' > /dev/null 2>&1").c_str()) == 0)
      return name;
  return "";
}

json readBack(const std::string& interpreter, const std::string& reader, const std::string& path)
{
  std::FILE* pipe = popen((interpreter + " '" + script + "' " + reader + " '" + path + "'").c_str(), "r");
  std::string text;
  std::array<char, 4096> buffer;
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe))
    text.append(buffer.data(), n);
  pclose(pipe);
  return json::parse(text, nullptr, false);
}

class VtkReader : public testing::TestWithParam<const char*>
{
protected:
  void SetUp() override
  {
    static const std::string found = python();
    interpreter = found;
    if (!interpreter.empty())
      return;
    if (std::getenv("RHEGMA_REQUIRE_VTK") != nullptr)
      FAIL() << "RHEGMA_REQUIRE_VTK is set, but neither python3 nor pvpython has VTK's readers of XDMF; on "
                "Debian "
                "install python3-paraview";
    GTEST_SKIP() << "no Python with VTK's readers of XDMF; on Debian install python3-paraview";
  }
  json read() const { return readBack(interpreter, GetParam(), folder.path("fields.xdmf")); }

  std::string interpreter;
  Folder folder;
};

} // namespace

TEST_P(VtkReader, SeesTimesParticlesLeavesAndCracks)
{
  State<2> state = twoParticles();
  addCrack(state);
  state.particles.add({"temperature", 1, "K", ""});
  {
    FieldWriter<2> writer(folder.path());
    for (int k = 0; k < 3; ++k)
    {
      state.clock.time = 0.1 * k;
      fill(state.particles.table("temperature"), {300.0 + k, 400.0});
      writer.write(state);
    }
  }
  const json times = read();
  ASSERT_EQ(times.size(), 3u);
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_EQ(times[k]["time"], 0.1 * k);
    const json& meshes = times[k]["meshes"];
    ASSERT_EQ(meshes.size(), 3u);

    const json& particles = meshes[0];
    EXPECT_EQ(particles["points"], json({{0.25, 0.5, 0.0}, {1.5, 0.75, 0.0}}));
    EXPECT_EQ(particles["types"], json({PolyVertex}));
    EXPECT_EQ(particles["cells"], json({{0}, {1}}));
    EXPECT_EQ(particles["on points"]["temperature"], json({{300.0 + k}, {400.0}}));
    EXPECT_EQ(particles["on points"]["stress"][0], json({10.0, 20.0, 40.0, 30.0, 0.0, 0.0}));
    EXPECT_EQ(particles["on points"]["displacement"][1], json({0.0, 0.5, 0.0}));
    EXPECT_EQ(particles["on points"]["deformation"][0], json({2.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}));
    EXPECT_EQ(particles["on points"]["body"], json({{0.0}, {1.0}}));

    const json& leaves = meshes[1];
    EXPECT_EQ(leaves["types"], json({Quadrilateral}));
    EXPECT_EQ(leaves["cells"].size(), 2u);
    EXPECT_EQ(leaves["points"].size(), 6u);

    const json& cracks = meshes[2];
    EXPECT_EQ(cracks["types"], json({PolyLine}));
    EXPECT_EQ(cracks["cells"], json({{0, 1}, {1, 2}}));
    EXPECT_EQ(cracks["on cells"]["crack"], json({{0.0}, {0.0}}));
    EXPECT_NEAR(cracks["on points"]["opening"][0][1].get<double>(), 0.1, 3.0e-16);
  }
}

TEST_P(VtkReader, SeesHexahedraAndTriangles)
{
  State<3> state = smallState<3>(1);
  fill(state.particles.table(fields::position), {2.5, 1.5, 3.5});
  CrackSet<3>& set = state.cracks;
  set.cracks.push_back({"Disk", 0, 3, 0, 1});
  set.vertex = View<double* [3]>("vertex", 3);
  set.face = View<double* [2][3]>("face", 3);
  set.simplex = View<int* [3]>("simplex", 1);
  set.crackOf = View<int*>("crackOf", 1);
  fillView<decltype(set.vertex), double>(set.vertex, {0, 0, 1, 1, 0, 1, 0, 1, 1});
  fillView<decltype(set.simplex), int>(set.simplex, {0, 1, 2});
  FieldWriter<3>(folder.path()).write(state);

  const json times = read();
  ASSERT_EQ(times.size(), 1u);
  const json& meshes = times[0]["meshes"];
  ASSERT_EQ(meshes.size(), 3u);
  EXPECT_EQ(meshes[0]["on points"]["stress"][0].size(), 6u);
  EXPECT_EQ(meshes[1]["types"], json({Hexahedron}));
  const std::vector<std::array<double, 3>> expected{{2, 1, 3}, {3, 1, 3}, {3, 2, 3}, {2, 2, 3},
                                                    {2, 1, 4}, {3, 1, 4}, {3, 2, 4}, {2, 2, 4}};
  ASSERT_EQ(meshes[1]["cells"].size(), 1u);
  for (int k = 0; k < 8; ++k)
    EXPECT_EQ(meshes[1]["points"][meshes[1]["cells"][0][k].get<int>()], json(expected[k])) << k;
  EXPECT_EQ(meshes[2]["types"], json({Triangle}));
  EXPECT_EQ(meshes[2]["points"], json({{0.0, 0.0, 1.0}, {1.0, 0.0, 1.0}, {0.0, 1.0, 1.0}}));
}

INSTANTIATE_TEST_SUITE_P(Xdmf, VtkReader, testing::Values("vtkXdmfReader", "vtkXdmf3Reader"));
