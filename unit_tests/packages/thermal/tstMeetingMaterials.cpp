/// Two materials on the same nodes: one that does not conduct has no part in the other's heat, and two that
/// do end at no temperature that neither had.

#include "packages/thermal/HeatedBars.hpp"

namespace Rhegma
{
namespace Test
{

namespace
{

constexpr double joint = 4.0, jump = 100.0;

/// A bar of 8 m in two halves of a material each, on cells of 1 m whose nodes lie `shift` beside the joint.
template <int D>
Teuchos::ParameterList halves(double conductivity, double capacity, double first, double second, double shift)
{
  Teuchos::ParameterList scene = bar<D>(1.0, "GIMP", 2.0 * joint);
  Teuchos::Array<double> lower = scene.sublist("Domain").get<Teuchos::Array<double>>("Lower Corner");
  Teuchos::Array<double> upper = scene.sublist("Domain").get<Teuchos::Array<double>>("Upper Corner");
  lower[0] += shift;
  upper[0] += shift;
  scene.sublist("Domain").set("Lower Corner", lower);
  scene.sublist("Domain").set("Upper Corner", upper);
  Teuchos::ParameterList& other = scene.sublist("Materials").sublist("Other");
  other = scene.sublist("Materials").sublist("Solid");
  other.set("Conductivity", conductivity);
  other.set("Specific Heat", capacity);
  Vector<D> middle = all<D>(2.0), from = all<D>(0.0), end = all<D>(2.0);
  middle[0] = from[0] = joint;
  end[0] = 2.0 * joint;
  scene.sublist("Bodies").remove("Bar");
  addBox<D>(scene, "First", all<D>(0.0), middle).set("Temperature", first);
  Teuchos::ParameterList& body = addBox<D>(scene, "Second", from, end);
  body.set("Material", "Other");
  body.set("Temperature", second);
  return scene;
}

/// How far below and above the temperatures of the start the bar comes in some steps.
template <int D>
double overshoot(const Teuchos::ParameterList& scene, int count)
{
  Rhegma::Run<D> run(validated(scene));
  run.initialize();
  const auto before = heatOf(run.state());
  double most = 0.0;
  for (int s = 0; s < count; ++s)
  {
    run.step(1e30, false);
    forEach<D>(run.state(),
               [&](const Vector<D>&, double T) {
                 most = std::max({most, start - T, T - start - jump});
               });
  }
  EXPECT_NEAR(heatOf(run.state()).first, before.first, 1e-12 * before.second);
  return most;
}

template <int D>
void checkInsulator(double shift)
{
  for (const bool hot : {false, true})
  {
    Rhegma::Run<D> run(validated(halves<D>(0.0, 3.0, hot ? 400.0 : 300.0, hot ? 300.0 : 400.0, shift)));
    run.initialize();
    steps(run, 100);
    forEach<D>(run.state(), [&](const Vector<D>& x, double T)
               { EXPECT_NEAR(T, (x[0] < joint) == hot ? 400.0 : 300.0, 1e-10) << x[0]; });
  }
}

} // namespace

TEST(MeetingMaterials, AnInsulatorKeepsItsHeatAndLeavesAConductorItsOwn)
{
  for (const double shift : {0.0, 0.3, 0.5})
    checkInsulator<2>(shift);
  checkInsulator<3>(0.3);
}

/// Supply of an insulator stays in it, through its own nodes and where it has none.
TEST(MeetingMaterials, AnInsulatorKeepsItsSupply)
{
  Teuchos::ParameterList scene = halves<2>(0.0, 3.0, 300.0, 300.0, 0.3);
  Teuchos::ParameterList& source = scene.sublist("Thermal").sublist("Sources").sublist("Lamp");
  source.set("Type", "Box");
  source.set("Lower Corner", array(Vector<2>{{joint, 0.0}}));
  source.set("Upper Corner", array(Vector<2>{{joint + 1.0, 2.0}}));
  source.set("Power Density", 5.0);
  scene.sublist("Time").set("Final Time", 10.0);
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  const double before = heatOf(run.state()).first;
  while (run.state().time < 10.0)
    run.step(10.0, false);
  // 5 W/m3 in 2 m3 for 10 s.
  EXPECT_NEAR(run.state().energy.heat, 100.0, 1e-9);
  EXPECT_NEAR(heatOf(run.state()).first - before, 100.0, 1e-9);
  forEach<2>(run.state(),
             [&](const Vector<2>& x, double T) { EXPECT_NEAR(x[0] < joint ? T : 300.0, 300.0, 1e-10); });
}

/// A node drains by D / h^2 at most while its particles come together by pi^2 D / h^2: of half of the jump a
/// share of 1 / pi^2 can be drawn too much.
TEST(MeetingMaterials, NeitherOvershoots)
{
  const double pi = 3.14159265358979323846, bound = 0.5 * jump / (pi * pi);
  for (const double conductivity : {2e-3, 0.2, 2.0, 200.0})
    for (const double capacity : {0.4, 2.0, 10.0})
      for (const double shift : {0.0, 0.3, 0.5})
        for (const bool hot : {false, true})
          EXPECT_LT(
              overshoot<2>(halves<2>(conductivity, capacity, hot ? 400.0 : 300.0, hot ? 300.0 : 400.0, shift),
                           60),
              bound)
              << conductivity << " " << capacity << " " << shift;
  EXPECT_LT(overshoot<3>(halves<3>(0.02, 3.0, 300.0, 400.0, 0.3), 30), bound);
}

/// The worst of all, beside a temperature that is there: what short steps of conduction make of it.
TEST(MeetingMaterials, NeitherOvershootsInShortSteps)
{
  const double pi = 3.14159265358979323846, bound = 0.5 * jump / (pi * pi);
  double most = 0.0;
  for (const double number : {0.35, 0.1, 0.02})
  {
    Teuchos::ParameterList scene = halves<2>(0.02, 2.0, 300.0, 400.0, 0.0);
    scene.sublist("Thermal").set("Diffusion Number", number);
    most = std::max(most, overshoot<2>(scene, static_cast<int>(10.0 / number)));
  }
  std::printf("largest overshoot %.3f K of a jump of %.0f K\n", most, jump);
  EXPECT_LT(most, bound);
}

/// A steady flux through two materials is linear in each and bends at their joint; particles are there
/// exactly.
TEST(MeetingMaterials, KeepASteadyFlux)
{
  Teuchos::ParameterList scene = halves<2>(0.5, 1.0, 300.0, 300.0, 0.0);
  hold<2>(scene, "Cold", 1.0, 1.0, 300.0);
  hold<2>(scene, "Hot", 7.0, 7.0, 400.0);
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  steps(run, 3000);
  // Conductivities 2 and 0.5: a fifth of the difference over the first half.
  double worst = 0.0;
  forEach<2>(run.state(),
             [&](const Vector<2>& x, double T)
             {
               if (x[0] > 1.0 && x[0] < 7.0)
                 worst = std::max(worst, std::fabs(T - (x[0] < joint ? 300.0 + 20.0 / 3.0 * (x[0] - 1.0)
                                                                     : 400.0 - 80.0 / 3.0 * (7.0 - x[0]))));
             });
  EXPECT_LT(worst, 1e-8);
}

} // namespace Test
} // namespace Rhegma
