/// Steady conduction against closed forms, at random positions and turns.

#include "src/step/Bodies.hpp"

#include <cmath>
#include <iostream>
#include <random>

namespace Rhegma
{
namespace Test
{

namespace
{

/// A body that heat does not strain, with steady conduction.
template <int D>
Teuchos::ParameterList steadyScene(double half, double cell, const std::string& analysis = "Static",
                                   const std::string& conductivity = "2")
{
  Teuchos::ParameterList scene = emptyScene<D>(all<D>(-half), all<D>(half), cell, "MUSL", "GIMP");
  scene.sublist("Time").set("Analysis", analysis);
  scene.sublist("Time").set("Rigid Modes", "Remove");
  scene.sublist("Time").set("Final Time", 1.0);
  addMaterial(scene, "Neo-Hookean", 0.3);
  Teuchos::ParameterList& solid = scene.sublist("Materials").sublist("Solid");
  solid.set("Specific Heat", 1e3);
  if (conductivity.find(':') == std::string::npos)
    solid.set("Conductivity", std::stod(conductivity));
  else
    solid.set("Conductivity", conductivity);
  scene.sublist("Thermal").set("Initial Temperature", 300.0);
  scene.sublist("Thermal").set("Conduction", "Steady");
  return scene;
}

template <int D>
void holdBox(Teuchos::ParameterList& scene, const std::string& name, const Vector<D>& lower,
             const Vector<D>& upper, double temperature)
{
  Teuchos::ParameterList& box = scene.sublist("Boundaries").sublist(name);
  box.set("Type", "Temperature");
  box.set("Lower Corner", array(lower));
  box.set("Upper Corner", array(upper));
  box.set("Temperature", temperature);
}

struct Errors
{
  double most = 0.0, mean = 0.0; ///< of a particle [K]
};

/// Runs a scene to its end. \return largest difference of a particle's temperature from a field, where the
/// field is a number [K]
template <int D, class Field>
Errors errorsOf(const Teuchos::ParameterList& scene, const Field& field)
{
  Rhegma::Run<D> run(validated(scene));
  run.initialize();
  while (run.state().clock.time < 1.0)
    run.step(1.0, false);
  const HostParticles<D> particles(run.state());
  const auto T = onHost(run.state().particles.scalar(fields::temperature));
  Errors errors;
  int compared = 0;
  for (int p = 0; p < particles.size; ++p)
    if (const double difference = std::fabs(T(p) - field(particles.at(p))); !std::isnan(difference))
    {
      errors.most = std::max(errors.most, difference);
      errors.mean += difference;
      ++compared;
    }
  EXPECT_GT(compared, particles.size / 4);
  errors.mean /= compared;
  return errors;
}

/// A bar whose ends are held at rows of nodes, and whose sides lie anywhere: linear between, whatever the
/// conductivity.
template <int D>
void testStrip(const std::string& conductivity, double tolerance)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  for (int k = 0; k < 4; ++k)
  {
    Teuchos::ParameterList scene =
        steadyScene<D>(7.0, 1.0, k % 2 == 0 ? "Static" : "Quasi-Static", conductivity);
    Vector<D> lower = all<D>(-3.0), upper = all<D>(3.0), low = all<D>(-7.0), high = all<D>(7.0);
    for (int d = 1; d < D; ++d)
    {
      lower[d] += 2.0 * part(random);
      upper[d] -= 2.0 * part(random);
    }
    addBox<D>(scene, "Bar", lower, upper);
    low[0] = high[0] = -3.0;
    holdBox<D>(scene, "Left", low, high, 300.0);
    low[0] = high[0] = 3.0;
    holdBox<D>(scene, "Right", low, high, 400.0);
    const bool linear = conductivity.find(':') == std::string::npos;
    const Errors error =
        errorsOf<D>(scene,
                    [linear](const Vector<D>& x)
                    {
                      const double s = (x[0] + 3.0) / 6.0; // Kirchhoff: k from 1 to 3 between the ends
                      const double between = linear ? s : 0.5 * (std::sqrt(1.0 + 8.0 * s) - 1.0);
                      return 300.0 + 100.0 * between;
                    });
    EXPECT_LT(error.most, tolerance) << "bar from " << lower[1] << " to " << upper[1];
  }
}

} // namespace

TEST(SteadyConduction, TwoTemperatures) { testStrip<2>("2", 1e-6); }
TEST(SteadyConduction, TwoTemperatures3D) { testStrip<3>("2", 1e-6); }

/// Bodies whose edges lie on lines of the grid but for round-off, which then decides which nodes their
/// particles touch: cells and domains at random, in metres as people write them.
TEST(SteadyConduction, EdgesOnGridLines)
{
  std::mt19937 random(5);
  std::uniform_int_distribution<int> hundredths(80, 400), cells(3, 20);
  for (int k = 0; k < 20; ++k)
  {
    const double h = 1e-5 * hundredths(random);
    const int before = cells(random), across = cells(random), after = cells(random);
    Teuchos::ParameterList scene = steadyScene<2>(1.0, 0.1);
    const Vector<2> lower = all<2>(-before * h), upper = all<2>((across + after) * h);
    scene.sublist("Domain").set("Lower Corner", array(lower));
    scene.sublist("Domain").set("Upper Corner", array(upper));
    scene.sublist("Domain").set("Cell Size", h);
    const double width = across * h;
    addBox<2>(scene, "Plate", all<2>(0.0), all<2>(width));
    holdBox<2>(scene, "Left", {{-0.1 * h, -h}}, {{0.1 * h, width + h}}, 400.0);
    holdBox<2>(scene, "Right", {{width - 0.1 * h, -h}}, {{width + 0.1 * h, width + h}}, 300.0);
    const Errors error =
        errorsOf<2>(scene, [width](const Vector<2>& x) { return 400.0 - 100.0 * x[0] / width; });
    EXPECT_LT(error.most, 1e-4) << "cells of " << h << " m, " << before << " before, " << across << " across";
  }
}

/// Conductivity linear in temperature: (k0 + k1)/2 of the ends conducts, and the profile is a parabola of x
/// in T. The tolerance is that of linear functions over cells of a sixth, curvature 200 K times (1/6)^2 / 8.
TEST(SteadyConduction, ConductivityOfTemperature) { testStrip<2>("300:1, 400:3", 800.0 / 36.0 / 8.0); }

namespace
{

constexpr double slabConductivity = 2.0, slabSource = 30.0, slabCoefficient = 0.5, slabThickness = 8.0;

/// A slab with a heat source and convection on both sides, one three times the other, turned about a point
/// anywhere: there is no node on its surfaces.
Teuchos::ParameterList slab(const Vector<2>& middle, double degrees, double cell)
{
  constexpr double width = 6.0;
  const double c = std::cos(degrees * M_PI / 180.0), s = std::sin(degrees * M_PI / 180.0);
  Teuchos::ParameterList scene = steadyScene<2>(10.0, cell, "Static");
  const Vector<2> half{{0.5 * slabThickness, 0.5 * width}};
  addBox<2>(scene, "Slab", middle - half, middle + half).set("Rotation", degrees);
  for (const int side : {-1, 1})
  {
    Teuchos::ParameterList& air = scene.sublist("Boundaries").sublist(side < 0 ? "Left" : "Right");
    const auto corner = [&](double y) {
      return middle + Vector<2>{{c * side * half[0] - s * y, s * side * half[0] + c * y}};
    };
    air.set("Type", "Convection");
    air.set("Body", "Slab");
    air.set("From", array(corner(-side * half[1])));
    air.set("To", array(corner(side * half[1])));
    air.set("Coefficient", side < 0 ? slabCoefficient : 3.0 * slabCoefficient);
    air.set("Ambient Temperature", 300.0);
  }
  Teuchos::ParameterList& heat = scene.sublist("Thermal").sublist("Sources").sublist("All");
  heat.set("Type", "Box");
  heat.set("Lower Corner", array(all<2>(-10.0)));
  heat.set("Upper Corner", array(all<2>(10.0)));
  heat.set("Power Density", slabSource);
  return scene;
}

} // namespace

/// T = 300 + q0 / h + (q0 x - source x^2 / 2) / k from the left, where the flux q0 leaves. The boxes of
/// turned bodies do not tile the cells (Steffen, Kirby and Berzins, Int. J. Numer. Meth. Eng. 76 (2008) 922):
/// an error of first order, largest at corners.
TEST(SteadyConduction, SlabWithASource)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  constexpr double k = slabConductivity, h = slabCoefficient, thick = slabThickness;
  const double q0 =
      slabSource * thick * (1.0 / (3.0 * h) + 0.5 * thick / k) / (1.0 / h + 1.0 / (3.0 * h) + thick / k);
  double sums[2] = {};
  for (int turn = 0; turn < 4; ++turn)
  {
    const double degrees = 90.0 * part(random), c = std::cos(degrees * M_PI / 180.0),
                 s = std::sin(degrees * M_PI / 180.0);
    const Vector<2> middle{{part(random), part(random)}};
    for (const int fine : {0, 1})
    {
      const Errors error = errorsOf<2>(slab(middle, degrees, fine == 0 ? 0.5 : 0.25),
                                       [&](const Vector<2>& at)
                                       {
                                         const double x =
                                             c * (at[0] - middle[0]) + s * (at[1] - middle[1]) + 0.5 * thick;
                                         return 300.0 + q0 / h + (q0 * x - 0.5 * slabSource * x * x) / k;
                                       });
      std::cout << "turned by " << degrees << ", cells 1 / " << (fine == 0 ? 16 : 32) << ": mean "
                << error.mean << " K, largest " << error.most << " K\n";
      sums[fine] += error.mean;
    }
  }
  EXPECT_LT(sums[1], 0.65 * sums[0]);
  EXPECT_LT(sums[1] / 4.0, 0.01 * (q0 / h + 0.5 * q0 * q0 / (slabSource * k)));
}

/// Heat flows from the inner to the outer edge of a ring with its centre anywhere: T falls with ln r.
TEST(SteadyConduction, Ring)
{
  std::mt19937 random(13);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  constexpr int edges = 40;
  constexpr double k = 2.0, inner = 1.0, outer = 3.0, flux = 100.0;
  const Vector<2> centre{{0.2 * part(random), 0.2 * part(random)}};
  Teuchos::ParameterList scene = steadyScene<2>(4.0, 0.1, "Static");
  const auto corner = [&](double r, int e) {
    return centre + Vector<2>{{r * std::cos(2.0 * M_PI * e / edges), r * std::sin(2.0 * M_PI * e / edges)}};
  };
  const auto polygon = [&](double r)
  {
    Teuchos::Array<double> points;
    for (int e = 0; e < edges; ++e)
      for (int d = 0; d < 2; ++d)
        points.push_back(corner(r, e)[d]);
    return points;
  };
  Teuchos::ParameterList& ring = scene.sublist("Bodies").sublist("Ring");
  ring.set("Material", "Solid");
  ring.set("Shape", "Polygon");
  ring.set("Points", polygon(outer));
  Teuchos::ParameterList& hole = ring.sublist("Operations").sublist("Hole");
  hole.set("Operation", "Cut");
  hole.set("Shape", "Polygon");
  hole.set("Points", polygon(inner));
  for (int e = 0; e < edges; ++e)
  {
    Teuchos::ParameterList& in = scene.sublist("Boundaries").sublist("In " + std::to_string(e));
    in.set("Type", "Heat Flux");
    in.set("Body", "Ring");
    in.set("From", array(corner(inner, e + 1)));
    in.set("To", array(corner(inner, e)));
    in.set("Flux", flux);
    Teuchos::ParameterList& out = scene.sublist("Boundaries").sublist("Out " + std::to_string(e));
    out.set("Type", "Convection");
    out.set("Body", "Ring");
    out.set("From", array(corner(outer, e)));
    out.set("To", array(corner(outer, e + 1)));
    out.set("Coefficient", 10.0);
    out.set("Ambient Temperature", 300.0);
  }
  // Of polygons with the perimeter 2 n r sin(pi / n); the potential of one is that of a circle with nearly
  // its area.
  const double sine = edges * std::sin(M_PI / edges), heat = 2.0 * inner * sine * flux;
  const double radius = outer * std::sqrt(0.5 * edges * std::sin(2.0 * M_PI / edges) / M_PI);
  const double atOuter = 300.0 + heat / (10.0 * 2.0 * outer * sine);
  const double scale = heat / (2.0 * M_PI * k);
  const Errors error =
      errorsOf<2>(scene,
                  [&](const Vector<2>& at)
                  {
                    const double r = norm(at - centre);
                    return r < 1.2 || r > 2.8 ? std::nan("") : atOuter + scale * std::log(radius / r);
                  });
  std::cout << "ring at " << centre[0] << ", " << centre[1] << ": " << error.most << " K of "
            << scale * std::log(3.0) << "\n";
  EXPECT_LT(error.most, 0.01 * scale * std::log(outer / inner));
}

/// Without a prescribed temperature there are many steady states, and with heat that cannot leave a body
/// there is none.
TEST(SteadyConduction, StatesThatDoNotExistAreRefused)
{
  Teuchos::ParameterList scene = steadyScene<2>(7.0, 1.0);
  addBox<2>(scene, "Bar", all<2>(-2.0), all<2>(2.0));
  std::vector<SceneError> errors;
  Teuchos::ParameterList singular(scene);
  validateList(singular, effectSchema(), errors);
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_EQ(errors[0].where, "Thermal > Conduction");

  addBox<2>(scene, "Other", all<2>(4.0), all<2>(6.0));
  holdBox<2>(scene, "Held", all<2>(-7.0), Vector<2>{{-1.0, 7.0}}, 300.0);
  Teuchos::ParameterList& heat = scene.sublist("Thermal").sublist("Sources").sublist("All");
  heat.set("Type", "Box");
  heat.set("Lower Corner", array(all<2>(3.5)));
  heat.set("Upper Corner", array(all<2>(6.5)));
  heat.set("Power Density", 1.0);
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  EXPECT_THROW(run.step(1.0, false), RunError);
  EXPECT_NE(run.state().failure.find("prescribe a temperature of this body"), std::string::npos)
      << run.state().failure;
}

} // namespace Test
} // namespace Rhegma
