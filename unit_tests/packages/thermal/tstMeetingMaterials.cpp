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

/// A bar of 8 m in two halves of a material each, on cells of 1 m whose nodes lie `shift` off the joint.
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

constexpr const char* methods[] = {"Explicit", "Super Time Stepping", "Implicit"};

template <int D>
void checkInsulator(double shift, const std::string& method)
{
  for (const bool hot : {false, true})
  {
    Teuchos::ParameterList scene = halves<D>(0.0, 3.0, hot ? 400.0 : 300.0, hot ? 300.0 : 400.0, shift);
    scene.sublist("Thermal").set("Conduction", method);
    Rhegma::Run<D> run(validated(scene));
    run.initialize();
    steps(run, 100);
    forEach<D>(run.state(), [&](const Vector<D>& x, double T)
               { EXPECT_NEAR(T, (x[0] < joint) == hot ? 400.0 : 300.0, 1e-10) << x[0]; });
  }
}

} // namespace

TEST(MeetingMaterials, AnInsulatorKeepsItsHeatAndLeavesAConductorItsOwn)
{
  for (const std::string method : methods)
  {
    for (const double shift : {0.0, 0.3, 0.5})
      checkInsulator<2>(shift, method);
    checkInsulator<3>(0.3, method);
  }
}

/// Next to a conductor that warms an insulator sees nothing of it, neither a temperature nor a gradient.
TEST(MeetingMaterials, AnInsulatorSeesNoGradientOfAConductor)
{
  for (const std::string method : methods)
    for (const double shift : {0.0, 0.3})
    {
      Teuchos::ParameterList scene = halves<2>(0.0, 3.0, 300.0, 300.0, shift);
      hold<2>(scene, "Hot", -0.9, 1.0, 400.0);
      scene.sublist("Thermal").set("Conduction", method);
      Rhegma::Run<2> run(validated(scene));
      run.initialize();
      steps(run, 30);
      const auto x = onHost(run.state().particles.template real<2>(fields::position));
      const auto g = onHost(run.state().particles.template real<2>(fields::temperatureGradient));
      const auto T = onHost(run.state().particles.scalar(fields::temperature));
      double warmest = 300.0;
      for (int p = 0; p < run.state().particles.size(); ++p)
        if (x(p, 0) < joint)
          warmest = std::max(warmest, x(p, 0) > joint - 1.0 ? T(p) : 300.0);
        else
        {
          EXPECT_NEAR(T(p), 300.0, 1e-10) << method << " " << x(p, 0);
          EXPECT_NEAR(g(p, 0), 0.0, 1e-10) << method << " " << x(p, 0);
        }
      EXPECT_GT(warmest, 301.0) << method;
    }
}

/// Faces that conduct have nobody behind them to conduct to.
TEST(MeetingMaterials, AnInsulatorBehindAConductingCrackKeepsItsHeat)
{
  for (const std::string method : {"Explicit", "Implicit"})
    for (const double shift : {0.0, 0.3, 0.5})
    {
      Teuchos::ParameterList scene = halves<2>(0.0, 3.0, 300.0, 400.0, shift);
      scene.sublist("Cracks").sublist("Cut").set("Points", numbers({joint, -1.0, joint, 3.0}));
      Teuchos::ParameterList& faces = scene.sublist("Thermal").sublist("Crack Faces").sublist("Cut");
      faces.set("Conduction", "Always");
      faces.set("Conductance", 2.0);
      scene.sublist("Thermal").set("Conduction", method);
      Rhegma::Run<2> run(validated(scene));
      run.initialize();
      steps(run, 20);
      forEach<2>(run.state(), [&](const Vector<2>& x, double T)
                 { EXPECT_NEAR(T, x[0] < joint ? 300.0 : 400.0, 1e-10) << method << " " << x[0]; });
    }
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
  while (run.state().clock.time < 10.0)
    run.step(10.0, false);
  // 5 W/m3 in 2 m3 for 10 s.
  EXPECT_NEAR(run.state().energy.heat, 100.0, 1e-9);
  EXPECT_NEAR(heatOf(run.state()).first - before, 100.0, 1e-9);
  forEach<2>(run.state(),
             [&](const Vector<2>& x, double T) { EXPECT_NEAR(x[0] < joint ? T : 300.0, 300.0, 1e-10); });
}

/// MeetingMaterials.hpp: 1 / (2 pi^2) of the jump for each node on which the materials meet that a particle
/// sees, one where the joint runs along faces of cells and two where it runs through cells.
constexpr double perNode = 0.5 * jump / (3.14159265358979323846 * 3.14159265358979323846);

/// All joints stay below the bound of those along faces at steps as they are by default.
TEST(MeetingMaterials, NeitherOvershoots)
{
  for (const std::string method : methods)
    for (const double ratio : {20.0, 100.0})
    {
      double most = 0.0;
      for (const double conductivity : {2e-3, 0.2, 2.0, 200.0})
        for (const double capacity : {0.04, 0.4, 2.0, 10.0})
          for (const double shift : {0.0, 0.3, 0.5})
            for (const bool hot : {false, true})
            {
              Teuchos::ParameterList scene =
                  halves<2>(conductivity, capacity, hot ? 400.0 : 300.0, hot ? 300.0 : 400.0, shift);
              scene.sublist("Thermal").set("Conduction", method);
              scene.sublist("Thermal").set("Step Ratio", ratio);
              const double beyond = overshoot<2>(scene, 20);
              EXPECT_LT(beyond, perNode) << method << " " << conductivity << " " << capacity << " " << shift;
              most = std::max(most, beyond);
            }
      std::printf("%s, Step Ratio %.0f: largest overshoot %.3f K of a jump of %.0f K\n", method.c_str(),
                  ratio, most, jump);
      if (method == "Explicit")
        break; // it has no ratio
    }
  EXPECT_LT(overshoot<3>(halves<3>(0.02, 3.0, 300.0, 400.0, 0.3), 30), perNode);
}

/// The worst of all, next to a temperature that is there: what substeps of conduction make of it.
TEST(MeetingMaterials, NeitherOvershootsInSmallSteps)
{
  struct Joint
  {
    double conductivity, capacity, shift;
  };
  for (const Joint at : {Joint{0.02, 2.0, 0.0}, Joint{200.0, 0.04, 0.0}, Joint{0.02, 10.0, 0.5}})
  {
    double most = 0.0;
    for (const double number : {0.35, 0.1, 0.02, 0.005})
    {
      Teuchos::ParameterList scene = halves<2>(at.conductivity, at.capacity, 300.0, 400.0, at.shift);
      scene.sublist("Thermal").set("Diffusion Number", number);
      most = std::max(most, overshoot<2>(scene, static_cast<int>(4.0 / number)));
    }
    const bool alongFaces = at.shift == 0.0;
    std::printf("joint %s cells: largest overshoot %.3f K of a jump of %.0f K\n",
                alongFaces ? "along faces of" : "through", most, jump);
    EXPECT_LT(most, alongFaces ? perNode : 2.0 * perNode);
  }
}

/// Next to a good conductor one that hardly conducts has its temperature at the common nodes from the
/// beginning: it takes the heat that its part of them holds, half a cell where the joint runs along faces of
/// cells and less than one and a half where it runs through them, on top of what a half space takes from a
/// face of given temperature, 2 dT sqrt(k rho c t / pi).
TEST(MeetingMaterials, APoorConductorTakesNoMoreAtOnceThanItsNodesHold)
{
  for (const double shift : {0.0, 0.3, 0.7})
  {
    const double conductivity = 2e-6, capacity = 2.0, width = 2.0;
    Rhegma::Run<2> run(validated(halves<2>(conductivity, capacity, 400.0, 300.0, shift)));
    run.initialize();
    steps(run, 200);
    double heat = 0.0;
    forEach<2>(run.state(), [&](const Vector<2>& x, double T)
               { heat += x[0] > joint ? 0.25 * capacity * (T - 300.0) : 0.0; });
    const double cell = capacity * width * jump, pi = 3.14159265358979323846;
    const double through =
        2.0 * jump * width * std::sqrt(conductivity * capacity * run.state().clock.time / pi);
    std::printf("nodes %.1f m from the joint: the poor conductor has %.3f cells' heat, a half space %.3f\n",
                shift, heat / cell, through / cell);
    EXPECT_GT(heat, through);
    EXPECT_LT(heat, (shift == 0.0 ? 0.5 : 1.5) * cell + through);
  }
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
