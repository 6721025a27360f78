/// Cracks whose faces conduct: the jump of temperature is what flux and conductance say, heat is kept, and
/// perfect contact is no crack.

#include "packages/thermal/HeatedBars.hpp"
#include "step/CoreStep.hpp"

namespace Rhegma
{
namespace Test
{

namespace
{

/// A cut through the bar at x = `at`.
template <int D>
void cut(Teuchos::ParameterList& scene, double at)
{
  Teuchos::ParameterList& crack = scene.sublist("Cracks").sublist("Cut");
  if (D == 2)
    crack.set("Points", numbers({at, -1.0, at, 3.0}));
  else
    crack.set("Points", numbers({at, -1.0, -1.0, at, 3.0, -1.0, at, 3.0, 3.0, at, -1.0, 3.0}));
}

void conducts(Teuchos::ParameterList& scene, double conductance, const std::string& kind = "Always")
{
  Teuchos::ParameterList& faces = scene.sublist("Thermal").sublist("Crack Faces").sublist("Cut");
  faces.set("Conduction", kind);
  if (conductance > 0.0)
    faces.set("Conductance", conductance);
}

/// A slab between two held columns with a crack of conductance h across: q = dT / (L / k + 1 / h), the jump
/// is q / h, and the field is linear on either side.
template <int D>
void checkJump(double at, double h, int level, const std::string& shape = "GIMP")
{
  const double k = 2.0, left = 1.0, right = 5.0, cold = 320.0, hot = 400.0;
  Teuchos::ParameterList scene = bar<D>(1.0, shape);
  hold<D>(scene, "Cold", left, left, cold);
  hold<D>(scene, "Hot", right, right, hot);
  cut<D>(scene, at);
  conducts(scene, h);
  if (level > 0)
    refineMiddle<D>(scene, level);
  Run<D> run(validated(scene));
  run.initialize();
  steps(run, 1500 << (2 * level));
  const double resistance = h > 0.0 ? 1.0 / h : 0.0;
  const double flux = (hot - cold) / ((right - left) / k + resistance), jump = flux * resistance;
  double worst = 0.0;
  int below = 0, above = 0;
  forEach<D>(run.state(),
             [&](const Vector<D>& position, double T)
             {
               if (position[0] < left || position[0] > right)
                 return;
               ++(position[0] < at ? below : above);
               const double exact = cold + flux / k * (position[0] - left) + (position[0] < at ? 0.0 : jump);
               worst = std::max(worst, std::fabs(T - exact));
             });
  EXPECT_GT(below, 5);
  EXPECT_GT(above, 5);
  // 1 % of the jump is asked for; with the flux distributed to nodes as that of the field it is exact to
  // round-off.
  EXPECT_LT(worst, 1e-7 * (hot - cold)) << D << "D at " << at << " h " << h << " level " << level;
}

/// Heat of an insulated bar with a random temperature, through steps with a conducting crack.
template <int D>
void checkThatHeatIsKept(double at, double h)
{
  Teuchos::ParameterList scene = bar<D>(1.0);
  scene.sublist("Materials").sublist("Solid").set("Specific Heat", std::string("250:1.5, 350:2.5"));
  cut<D>(scene, at);
  conducts(scene, h);
  Run<D> run(validated(scene));
  run.initialize();
  randomTemperature(run.state());
  const auto before = heatOf(run.state());
  steps(run, 200);
  EXPECT_NEAR(heatOf(run.state()).first, before.first, 1e-12 * before.second);
  EXPECT_EQ(run.state().energy.heat, 0.0);
}

/// Mean temperature left of a position.
double meanLeftOf(const State<2>& state, double at)
{
  double sum = 0.0;
  int count = 0;
  forEach<2>(state,
             [&](const Vector<2>& position, double T)
             {
               if (position[0] < at)
               {
                 sum += T;
                 ++count;
               }
             });
  return sum / count;
}

/// Two blocks, hot and cold, that move at +-speed from the start; the mean temperature of the hot one at the
/// end.
double afterMoving(double speed, const std::string& kind)
{
  Teuchos::ParameterList scene = emptyScene<2>(all<2>(-2.0), all<2>(8.0), 0.5, "MUSL", "GIMP");
  Teuchos::ParameterList& material = scene.sublist("Materials").sublist("Solid");
  material.set("Model", "Linear Elastic");
  material.set("Density", 1.0);
  material.set("Young Modulus", 4e4); // 300 steps
  material.set("Poisson Ratio", 0.0);
  material.set("Specific Heat", 2.0);
  material.set("Conductivity", 2.0);
  addBox<2>(scene, "Left", all<2>(0.0), Vector<2>{3.0, 2.0});
  addBox<2>(scene, "Right", Vector<2>{3.0, 0.0}, Vector<2>{6.0, 2.0});
  scene.sublist("Bodies").sublist("Left").set("Temperature", 400.0);
  scene.sublist("Bodies").sublist("Left").set("Velocity", numbers({-speed, 0.0}));
  scene.sublist("Bodies").sublist("Right").set("Velocity", numbers({speed, 0.0}));
  scene.sublist("Thermal").set("Initial Temperature", start);
  cut<2>(scene, 3.0);
  conducts(scene, 2.0, kind);
  Run<2> run(validated(scene));
  run.initialize();
  const double time = 0.2;
  while (run.state().clock.time < time)
    run.step(time, false);
  EXPECT_EQ(run.state().failure, "");
  return meanLeftOf(run.state(), 3.0);
}

} // namespace

TEST(CrackConduction, TheJumpIsFluxOverConductance)
{
  for (const double at : {3.0, 3.5, 3.3})
    for (const double h : {0.1, 2.0, 50.0})
      checkJump<2>(at, h, 0);
  checkJump<2>(3.5, 2.0, 0, "Linear");
  checkJump<3>(3.0, 2.0, 0);
  checkJump<3>(3.2, 2.0, 0);
  checkJump<3>(3.5, 2.0, 0);
}

TEST(CrackConduction, TheJumpIsFluxOverConductanceOnRefinedCells)
{
  checkJump<2>(3.0, 2.0, 1);
  checkJump<2>(3.1, 2.0, 1);
}

TEST(CrackConduction, PerfectContactIsNoCrack)
{
  checkJump<2>(3.0, 0.0, 0);
  checkJump<2>(3.5, 0.0, 0);
  checkJump<3>(3.5, 0.0, 0);
}

TEST(CrackConduction, KeepsHeat)
{
  for (const double h : {0.5, 1e3, 0.0})
  {
    checkThatHeatIsKept<2>(3.0, h);
    checkThatHeatIsKept<2>(3.4, h);
    checkThatHeatIsKept<3>(3.4, h);
  }
}

/// Two halves that conduct well come together as exp(-2 h t / (rho c L)), L the length of a half.
TEST(CrackConduction, TwoBlocksComeTogether)
{
  Teuchos::ParameterList scene = bar<2>(0.5);
  scene.sublist("Bodies").sublist("Bar").set("Temperature Field", std::string("x < 3 ? 400 : 300"));
  cut<2>(scene, 3.0);
  const double h = 0.002, time = 600.0;
  conducts(scene, h);
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  while (run.state().clock.time < time)
    run.step(time, false);
  // Biot number h L / (3 k) = 0.001: so much is the resistance of the halves.
  const double left = 350.0 + 50.0 * std::exp(-2.0 * h * time / (2.0 * 3.0));
  EXPECT_NEAR(meanLeftOf(run.state(), 3.0), left, 0.003 * 50.0);
}

/// A step of temperature spreads through perfect contact as through the whole bar.
TEST(CrackConduction, AStepSpreadsThroughPerfectContact)
{
  std::vector<std::vector<double>> found;
  for (const bool cracked : {false, true})
  {
    Teuchos::ParameterList scene = bar<2>(0.25);
    scene.sublist("Bodies").sublist("Bar").set("Temperature Field", std::string("x < 3 ? 400 : 300"));
    if (cracked)
    {
      cut<2>(scene, 3.125);
      conducts(scene, 0.0);
    }
    Rhegma::Run<2> run(validated(scene));
    run.initialize();
    while (run.state().clock.time < 0.5)
      run.step(0.5, false);
    found.emplace_back();
    forEach<2>(run.state(), [&](const Vector<2>&, double T) { found.back().push_back(T); });
  }
  ASSERT_EQ(found[0].size(), found[1].size());
  double apart = 0.0;
  for (std::size_t p = 0; p < found[0].size(); ++p)
    apart = std::max(apart, std::fabs(found[0][p] - found[1][p]));
  // Of 100 K, next to the 0.5 K by which cells of this size are off the error function.
  EXPECT_LT(apart, 0.5);
}

/// Wherever a jump of temperature lies next to a crack in perfect contact, the field is at all times that of
/// a bar without a crack, and no temperature leaves the range of those of the start by more than it does
/// there.
TEST(CrackConduction, PerfectContactNextToAJumpIsNoCrack)
{
  for (const double at : {2.5, 2.625, 2.75, 3.0, 3.125, 3.25})
  {
    std::vector<Rhegma::Run<2>> runs;
    for (const bool cracked : {false, true})
    {
      Teuchos::ParameterList scene = bar<2>(0.25);
      scene.sublist("Bodies").sublist("Bar").set("Temperature Field", std::string("x < 3 ? 400 : 300"));
      if (cracked)
      {
        cut<2>(scene, at);
        conducts(scene, 0.0);
      }
      runs.emplace_back(validated(scene));
      runs.back().initialize();
    }
    const double before = heatOf(runs[1].state()).first;
    for (int s = 0; s < 20; ++s)
    {
      std::vector<double> found[2];
      for (int k = 0; k < 2; ++k)
      {
        steps(runs[k], 1);
        forEach<2>(runs[k].state(), [&](const Vector<2>&, double T) { found[k].push_back(T); });
      }
      double apart = 0.0, beyond = 0.0;
      for (std::size_t p = 0; p < found[0].size(); ++p)
      {
        apart = std::max(apart, std::fabs(found[1][p] - found[0][p]));
        beyond = std::max({beyond, 300.0 - found[1][p], found[1][p] - 400.0});
      }
      EXPECT_LT(apart, 1e-9) << at << " " << s;
      // The reconstruction by gradients, in the cells of the jump.
      EXPECT_LT(beyond, 1.0) << at << " " << s;
    }
    EXPECT_NEAR(heatOf(runs[1].state()).first, before, 1e-12 * before);
  }
}

TEST(CrackConduction, OnlyClosedFacesConductWhereAskedFor)
{
  const double apart = afterMoving(1e-3, "When Closed"), whatever = afterMoving(1e-3, "Always"),
               pressed = afterMoving(-1e-3, "When Closed");
  // Faces touch in the first of 300 steps.
  EXPECT_NEAR(apart, 400.0, (400.0 - whatever) / 50.0);
  EXPECT_LT(whatever, 397.0);
  EXPECT_NEAR(pressed, whatever, 0.05);
}

} // namespace Test
} // namespace Rhegma
