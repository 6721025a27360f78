/// Cells that Domain > Accuracy chooses.

#include "plan/EffectSchema.hpp"
#include "scene/Scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>
#include <string>

using namespace Rhegma;

namespace
{

SceneResult sceneOf(const std::string& domain, const std::string& body, const std::string& more)
{
  return readSceneText(R"xml(<ParameterList name="Rhegma">
  <ParameterList name="Domain">)xml" +
                           domain + R"xml(</ParameterList>
  <ParameterList name="Time"><Parameter name="Final Time" type="double" value="1e-3"/></ParameterList>
  <ParameterList name="Materials">
    <ParameterList name="Polymer">
      <Parameter name="Model" type="string" value="Linear Elastic"/>
      <Parameter name="Density" type="double" value="1200"/>
      <Parameter name="Young Modulus" type="double" value="3e9"/>
      <Parameter name="Poisson Ratio" type="double" value="0.33"/>
      <Parameter name="Specific Heat" type="double" value="1400"/>
      <Parameter name="Conductivity" type="double" value="0.2"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Bodies">
    <ParameterList name="Plate">
      <Parameter name="Material" type="string" value="Polymer"/>
      <Parameter name="Shape" type="string" value="Box"/>)xml" +
                           body + "</ParameterList></ParameterList>" + more + "</ParameterList>",
                       {}, effectSchema());
}

std::string array(const std::string& name, const std::string& values)
{
  return "<Parameter name=\"" + name + "\" type=\"Array(double)\" value=\"" + values + "\"/>";
}

const std::string plane = R"xml(<Parameter name="Dimension" type="int" value="2"/>)xml" +
                          array("Lower Corner", "{-0.01, -0.01}") + array("Upper Corner", "{0.05, 0.09}");
const std::string strip = array("Lower Corner", "{0, 0}") + array("Upper Corner", "{0.04, 0.08}");
/// 10 mm from the left edge; the nearest surface is 30 mm away.
const std::string notch = R"xml(<ParameterList name="Cracks"><ParameterList name="Notch">)xml" +
                          array("Points", "{0, 0.04, 0.01, 0.04}") + "</ParameterList></ParameterList>";

std::string within(const std::string& accuracy)
{
  return R"xml(<Parameter name="Accuracy" type="string" value=")xml" + accuracy + R"xml("/>)xml";
}

const std::string atRest = R"xml(<ParameterList name="Damping">
    <Parameter name="Mass Rate" type="double" value="1e4"/>
    <Parameter name="Stop When Settled" type="bool" value="true"/></ParameterList>)xml";

double cellOf(const SceneResult& scene) { return scene.list->sublist("Domain").get<double>("Cell Size"); }

int levelsOf(const SceneResult& scene)
{
  return scene.list->isSublist("Adaptivity") ? scene.list->sublist("Adaptivity").get<int>("Maximum Level")
                                             : 0;
}

} // namespace

/// In motion, cells at the front and all others are fractions of the crack's length.
TEST(Accuracy, ChoosesCellsNextToTheCrack)
{
  const struct
  {
    const char* accuracy;
    double cell;
    int levels;
  } wanted[] = {{"10 %", 0.01 / 3.0, 1}, {"3 %", 0.002, 2}, {"1 %", 0.00125, 2}, {"0.3 %", 0.000625, 3}};
  for (const auto& w : wanted)
  {
    const SceneResult scene = sceneOf(plane + within(w.accuracy), strip, notch);
    ASSERT_TRUE(scene.errors.empty()) << toString(scene.errors.front());
    EXPECT_NEAR(cellOf(scene), w.cell, 1e-12) << w.accuracy;
    EXPECT_EQ(levelsOf(scene), w.levels) << w.accuracy;
    EXPECT_EQ(scene.list->isSublist("Sub-Cycling"), w.levels > 0);
  }
}

/// A crack of 4 mm in a plate of 200 mm at rest: a 24th of the half length at its fronts, and at most six
/// levels of cells that grow from there; cells of 7 mm would be enough for the plate.
TEST(Accuracy, ChoosesCoarseCellsFarFromACrackAtRest)
{
  const std::string domain = R"xml(<Parameter name="Dimension" type="int" value="2"/>)xml" +
                             array("Lower Corner", "{-0.12, -0.12}") + array("Upper Corner", "{0.12, 0.12}");
  const std::string plate = array("Lower Corner", "{-0.1, -0.1}") + array("Upper Corner", "{0.1, 0.1}");
  const std::string slit = R"xml(<ParameterList name="Cracks"><ParameterList name="Slit">)xml" +
                           array("Points", "{-0.002, 0.003, 0.002, 0.003}") +
                           "</ParameterList></ParameterList>";
  const SceneResult scene = sceneOf(domain + within("1 %"), plate, slit + atRest);
  ASSERT_TRUE(scene.errors.empty()) << toString(scene.errors.front());
  EXPECT_EQ(levelsOf(scene), 6);
  EXPECT_GE(cellOf(scene), 64.0 * 0.002 / 24.0 * 2.0 / 3.0 - 1e-12);
  EXPECT_LE(cellOf(scene) / (1 << levelsOf(scene)), 0.002 / 24.0 + 1e-12);
  EXPECT_EQ(scene.list->sublist("Adaptivity").get<double>("Front Cells"), 5.0);
  // Pressure on the faces asks for cells of half the size.
  const std::string pressed = R"xml(<ParameterList name="Face Pressure"><ParameterList name="Slit">
    <Parameter name="Pressure" type="double" value="1e5"/></ParameterList></ParameterList>)xml";
  const SceneResult loaded = sceneOf(domain + within("1 %"), plate, slit + pressed + atRest);
  ASSERT_TRUE(loaded.errors.empty()) << toString(loaded.errors.front());
  EXPECT_LE(cellOf(loaded) / (1 << levelsOf(loaded)), 0.002 / 48.0 + 1e-12);
}

/// Arms of 10 mm next to a crack of 50 mm bend; two cells are in the inner radius of a contour.
TEST(Accuracy, ResolvesArmsAndContours)
{
  const std::string domain = R"xml(<Parameter name="Dimension" type="int" value="2"/>)xml" +
                             array("Lower Corner", "{-0.01, -0.01}") + array("Upper Corner", "{0.11, 0.03}");
  const std::string beam = array("Lower Corner", "{0, 0}") + array("Upper Corner", "{0.1, 0.02}");
  const std::string crack = R"xml(<ParameterList name="Cracks"><ParameterList name="Notch">)xml" +
                            array("Points", "{0, 0.01, 0.05, 0.01}") + "</ParameterList></ParameterList>";
  EXPECT_NEAR(cellOf(sceneOf(domain + within("10 %"), beam, crack + atRest)), 0.0025, 1e-9);
  const std::string contour = R"xml(<ParameterList name="Energy Release">
    <Parameter name="Inner Radius" type="double" value="3e-3"/></ParameterList>)xml";
  const SceneResult scene = sceneOf(domain + within("3 %"), beam, crack + contour + atRest);
  ASSERT_TRUE(scene.errors.empty()) << toString(scene.errors.front());
  EXPECT_NEAR(cellOf(scene), 0.01 / 6.0, 1e-9);
  EXPECT_EQ(levelsOf(scene), 1);
}

TEST(Accuracy, LeavesWhatTheSceneGives)
{
  const std::string cell = R"xml(<Parameter name="Cell Size" type="double" value="1e-3"/>)xml";
  EXPECT_EQ(cellOf(sceneOf(plane + cell + within("10 %"), strip, notch)), 1e-3);
  const std::string own = R"xml(<ParameterList name="Adaptivity">
    <Parameter name="Maximum Level" type="int" value="1"/></ParameterList>)xml";
  const SceneResult scene = sceneOf(plane + within("1 %"), strip, notch + own);
  EXPECT_EQ(levelsOf(scene), 1);
  EXPECT_FALSE(scene.list->isSublist("Sub-Cycling"));
}

/// A scene for which cells have been chosen is read again as it is, as a run with --twice does.
TEST(Accuracy, AcceptsItsOwnChoice)
{
  const SceneResult scene = sceneOf(plane + within("1 %"), strip, notch);
  ASSERT_TRUE(scene.errors.empty()) << toString(scene.errors.front());
  const double cell = cellOf(scene);
  const int levels = levelsOf(scene);
  ASSERT_GT(levels, 0);
  std::vector<SceneError> errors;
  validateList(*scene.list, effectSchema(), errors);
  EXPECT_TRUE(errors.empty()) << toString(errors.front());
  EXPECT_EQ(cellOf(scene), cell);
  EXPECT_EQ(levelsOf(scene), levels);
}

/// Cells of a running crack stay equal: a Cell Size that is larger than the accuracy asks for, and no other,
/// is refused.
TEST(Accuracy, RefusesCellsThatItCannotRefine)
{
  const std::string running = notch + R"xml(<ParameterList name="Energy Release"/>
    <ParameterList name="Propagation"><Parameter name="Toughness" type="string" value="100"/></ParameterList>)xml";
  const SceneResult chosen = sceneOf(plane + within("3 %"), strip, running);
  ASSERT_TRUE(chosen.errors.empty()) << toString(chosen.errors.front());
  ASSERT_EQ(levelsOf(chosen), 0);
  std::random_device seeds;
  const unsigned seed = seeds();
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> draw(0.3, 1.0);
  for (const double factor :
       {draw(engine), 1.7 + draw(engine)}) // the choice fits the body: up to 1.5 times finer
  {
    const std::string cell = R"xml(<Parameter name="Cell Size" type="double" value=")xml" +
                             std::to_string(factor * cellOf(chosen)) + R"xml("/>)xml";
    const SceneResult scene = sceneOf(plane + cell + within("3 %"), strip, running);
    ASSERT_EQ(scene.errors.empty(), factor <= 1.0) << "seed " << seed;
    if (factor <= 1.0)
      continue;
    EXPECT_NE(toString(scene.errors.front()).find("Domain > Accuracy: is 3 %, which asks for cells of "),
              std::string::npos)
        << toString(scene.errors.front());
  }
}

/// Levels that a scene has of its own must reach the cells that the accuracy asks for at fronts, and as many
/// of them around these; cells far from fronts must be small enough by themselves.
TEST(Accuracy, RefusesTooFewLevels)
{
  const SceneResult chosen = sceneOf(plane + within("1 %"), strip, notch);
  ASSERT_TRUE(chosen.errors.empty()) << toString(chosen.errors.front());
  const int levels = levelsOf(chosen);
  ASSERT_GT(levels, 1);
  const double around = chosen.list->sublist("Adaptivity").get<double>("Front Cells");
  std::random_device seeds;
  const unsigned seed = seeds();
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> draw(0.5, 1.0);
  struct Case
  {
    double size; // of the cells far from fronts, over those that are chosen
    int levels;
    double frontCells;
    const char* said;
  };
  const double part = draw(engine);
  for (const auto& [size, own, frontCells, said] :
       {Case{part, levels, around, ""}, Case{1.0, levels - 1, around, "write more levels of refinement"},
        Case{1.0, levels, part * around - 0.1, "more cells around fronts"},
        Case{1.0, levels, 0.0, "more cells around fronts"},
        Case{2.0 + part, levels + 2, around, "everywhere, but Domain > Cell Size"}})
  {
    std::ostringstream text;
    text.precision(17);
    text << R"xml(<ParameterList name="Adaptivity"><Parameter name="Maximum Level" type="int" value=")xml"
         << own << R"xml("/><Parameter name="Front Cells" type="double" value=")xml" << frontCells
         << R"xml("/></ParameterList>)xml";
    std::ostringstream cell;
    cell.precision(17);
    cell << R"xml(<Parameter name="Cell Size" type="double" value=")xml" << size * cellOf(chosen)
         << R"xml("/>)xml";
    const SceneResult scene = sceneOf(plane + cell.str() + within("1 %"), strip, notch + text.str());
    ASSERT_EQ(scene.errors.empty(), std::string(said).empty()) << "seed " << seed << ", " << said;
    if (scene.errors.empty())
      continue;
    EXPECT_NE(toString(scene.errors.front()).find(said), std::string::npos)
        << "seed " << seed << ", " << toString(scene.errors.front());
  }
}

/// Cells of 2 mm are asked for; the faces of the plate are 9, 51 and 90 mm from the domain's corner, so that
/// cells of 1.5 mm are the largest below it that have all of them on their lines.
TEST(Accuracy, FitsCellsToTheBodies)
{
  const std::string domain = R"xml(<Parameter name="Dimension" type="int" value="2"/>)xml" +
                             array("Lower Corner", "{-0.009, -0.009}") + array("Upper Corner", "{0.06, 0.1}");
  const std::string plate = array("Lower Corner", "{0, 0}") + array("Upper Corner", "{0.042, 0.081}");
  EXPECT_NEAR(cellOf(sceneOf(domain + within("3 %"), plate, notch)), 0.0015, 1e-12);
}

/// Radius 6 mm: three cells while it moves, five where it stays, with cells that fit the body's faces at 10,
/// 50 and 90 mm from the domain's corner.
TEST(Accuracy, KnowsSourcesOfHeat)
{
  const auto torch = [](const std::string& velocity)
  {
    return R"xml(<ParameterList name="Thermal">
    <Parameter name="Initial Temperature" type="double" value="300"/>
    <ParameterList name="Sources"><ParameterList name="Torch">
      <Parameter name="Type" type="string" value="Ball"/>
      <Parameter name="Radius" type="double" value="0.006"/>
      <Parameter name="Power" type="double" value="1"/>)xml" +
           array("Centre", "{0.02, 0.04}") + velocity + "</ParameterList></ParameterList></ParameterList>";
  };
  const SceneResult moving = sceneOf(plane + within("1 %"), strip, torch(array("Velocity", "{1, 0}")));
  ASSERT_TRUE(moving.errors.empty()) << toString(moving.errors.front());
  EXPECT_NEAR(cellOf(moving), 0.002, 1e-12);
  EXPECT_EQ(levelsOf(moving), 0);
  const SceneResult resting = sceneOf(plane + within("1 %"), strip, torch(""));
  ASSERT_TRUE(resting.errors.empty()) << toString(resting.errors.front());
  EXPECT_LE(cellOf(resting), 0.0012 + 1e-12);
  EXPECT_GE(cellOf(resting), 0.0012 * 2.0 / 3.0);
}

/// A crack of 1 mm at the edge of a body of 80 mm has a front, and one that begins outside of the body is as
/// long as what is in it.
TEST(Accuracy, KnowsShortCracksAndCracksFromOutside)
{
  const auto crack = [](const std::string& points)
  {
    return R"xml(<ParameterList name="Cracks"><ParameterList name="Notch">)xml" + array("Points", points) +
           "</ParameterList></ParameterList>";
  };
  const SceneResult tiny = sceneOf(plane + within("10 %"), strip, crack("{0, 0.04, 0.0005, 0.04}"));
  ASSERT_TRUE(tiny.errors.empty()) << toString(tiny.errors.front());
  EXPECT_LE(cellOf(tiny), 0.0005 / 3.0 + 1e-12);
  EXPECT_GE(cellOf(tiny), 0.0005 / 3.0 * 2.0 / 3.0);
  const SceneResult outside = sceneOf(plane + within("3 %"), strip, crack("{-0.005, 0.04, 0.01, 0.04}"));
  ASSERT_TRUE(outside.errors.empty()) << toString(outside.errors.front());
  EXPECT_NEAR(cellOf(outside), 0.002, 1e-12);
  EXPECT_EQ(levelsOf(outside), 2);
}

TEST(Accuracy, KnowsDisks)
{
  const std::string space = R"xml(<Parameter name="Dimension" type="int" value="3"/>)xml" +
                            array("Lower Corner", "{-0.02, -0.02, -0.02}") +
                            array("Upper Corner", "{0.02, 0.02, 0.02}");
  const std::string penny = R"xml(<ParameterList name="Cracks"><ParameterList name="Penny">
      <Parameter name="Radius" type="double" value="0.006"/>)xml" +
                            array("Centre", "{0, 0, 0}") + array("Normal", "{0, 0, 1}") +
                            "</ParameterList></ParameterList>";
  const SceneResult scene = sceneOf(space + within("10 %"),
                                    array("Lower Corner", "{-0.016, -0.016, -0.016}") +
                                        array("Upper Corner", "{0.016, 0.016, 0.016}"),
                                    penny);
  ASSERT_TRUE(scene.errors.empty()) << toString(scene.errors.front());
  EXPECT_NEAR(cellOf(scene), 0.002, 1e-12);
}

TEST(Accuracy, SaysWhyItCanNotChoose)
{
  const auto message = [](const SceneResult& scene)
  { return scene.errors.size() == 1 ? toString(scene.errors.front()) : std::string(); };
  EXPECT_NE(message(sceneOf(plane + within("1 %"), strip, "")).find("neither"), std::string::npos);
  EXPECT_NE(message(sceneOf(plane, strip, notch)).find("Cell Size"), std::string::npos);
  EXPECT_NE(message(sceneOf(plane + within("5 %"), strip, notch)).find("Accuracy"), std::string::npos);
  const std::string running = R"xml(<ParameterList name="Energy Release"/><ParameterList name="Propagation">
    <Parameter name="Toughness" type="string" value="100"/></ParameterList>)xml";
  EXPECT_NE(message(sceneOf(plane + within("1 %"), strip, notch + running)).find("run"), std::string::npos);
  const SceneResult scene = sceneOf(plane + within("3 %"), strip, notch + running);
  ASSERT_TRUE(scene.errors.empty()) << toString(scene.errors.front());
  EXPECT_NEAR(cellOf(scene), 0.000625, 1e-12);
  EXPECT_EQ(levelsOf(scene), 0);
}

/// Cells at a front are a fraction of its distance to whatever is nearest: a hole or another crack anywhere
/// round the front.
TEST(Accuracy, KnowsWhatIsNextToAFront)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(0.0, 1.0);
  const double front[2] = {0.01, 0.04};
  for (int k = 0; k < 12; ++k)
  {
    const double gap = 1e-3 * (0.2 + 1.8 * anywhere(random)), angle = M_PI * (anywhere(random) - 0.5);
    const auto away = [&](double distance)
    {
      return std::to_string(front[0] + distance * std::cos(angle)) + ", " +
             std::to_string(front[1] + distance * std::sin(angle));
    };
    const std::string hole = R"xml(<ParameterList name="Operations"><ParameterList name="Bore">
      <Parameter name="Operation" type="string" value="Cut"/><Parameter name="Shape" type="string" value="Ball"/>
      <Parameter name="Radius" type="double" value="0.002"/>)xml" +
                             array("Centre", "{" + away(gap + 0.002) + "}") +
                             "</ParameterList></ParameterList>";
    const std::string other = R"xml(<ParameterList name="Cracks"><ParameterList name="Notch">)xml" +
                              array("Points", "{0, 0.04, 0.01, 0.04}") +
                              R"xml(</ParameterList><ParameterList name="Other">)xml" +
                              array("Points", "{" + away(gap) + ", " + away(gap + 0.008) + "}") +
                              "</ParameterList></ParameterList>";
    for (const SceneResult& scene : {sceneOf(plane + within("10 %"), strip + hole, notch + atRest),
                                     sceneOf(plane + within("10 %"), strip, other + atRest)})
    {
      ASSERT_TRUE(scene.errors.empty()) << toString(scene.errors.front());
      const double finest = cellOf(scene) / (1 << levelsOf(scene));
      EXPECT_LE(finest, 1.01 * gap / 5.0) << "gap " << gap << ", angle " << angle;
      EXPECT_GE(finest, gap / 5.0 / 3.0);
    }
  }
}

/// Two long cracks 1 mm apart, with fronts far from there: three cells and more between them, in boxes that
/// cover them where they are near, and larger cells elsewhere.
TEST(Accuracy, SeparatesCracksThatAreNearEachOther)
{
  const std::string pair = R"xml(<ParameterList name="Cracks"><ParameterList name="Lower">)xml" +
                           array("Points", "{0.004, 0.036, 0.02, 0.04, 0.036, 0.036}") +
                           R"xml(</ParameterList><ParameterList name="Upper">)xml" +
                           array("Points", "{0.004, 0.046, 0.02, 0.041, 0.036, 0.046}") +
                           "</ParameterList></ParameterList>";
  const SceneResult scene = sceneOf(plane + within("10 %"), strip, pair + atRest);
  ASSERT_TRUE(scene.errors.empty()) << toString(scene.errors.front());
  ASSERT_TRUE(scene.list->isSublist("Adaptivity"));
  const Teuchos::ParameterList& adaptivity = scene.list->sublist("Adaptivity");
  const double cell = cellOf(scene);
  EXPECT_GT(cell, 1e-3);
  for (double y = 0.0398; y < 0.0412; y += 1e-4) // across the gap
  {
    int level = 0;
    for (const auto& entry : adaptivity)
    {
      if (!entry.second.isList())
        continue;
      const Teuchos::ParameterList& box = adaptivity.sublist(entry.first);
      const auto lower = box.get<Teuchos::Array<double>>("Lower Corner"),
                 upper = box.get<Teuchos::Array<double>>("Upper Corner");
      if (lower[0] <= 0.02 && upper[0] >= 0.02 && lower[1] <= y && upper[1] >= y)
        level = std::max(level, box.get<int>("Level"));
      EXPECT_LE(box.get<int>("Level"), levelsOf(scene));
    }
    EXPECT_LE(cell / (1 << level), 1e-3 / 3.0) << "at y = " << y;
  }
}
