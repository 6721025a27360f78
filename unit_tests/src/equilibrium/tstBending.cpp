/// Bars that bend, of few cells, against beam theory.
///
/// A bar along the cells with the displacement u = K x y, v = -K (x^2 + nu y^2) / 2 at its nodes is in
/// equilibrium. Of its energy E I K^2 L / 2, rows of n cells of the height H / n give the fraction 1 - 1 /
/// n^2 by their means, and strains that vary within a cell the rest, f (1 - 1 / m^2) / n^2, with m particles
/// along an edge at the middles of its parts: f = 1 / (1 - nu^2) of the normal strain K y, whose lateral
/// contraction cells don't follow, and with shear strain at the particles also G / E = 1 / (2 (1 + nu)) of
/// the shear strain K x, which a bar does not have.

#include "src/step/Bodies.hpp"
#include "state/EnergySums.hpp"

#include <cmath>
#include <random>
#include <sstream>

namespace Rhegma
{
namespace Test
{

namespace
{

constexpr double length = 10.0, curvature = 1e-6;
constexpr unsigned seed = 4;

struct Bar
{
  int cells, particles; ///< over the height; along an edge of a cell
  double poisson;       ///< of the plane
};

/// A bar of unit cells whose ends bend; in 3D a slab of which nothing moves along z. \param poisson of the
/// material
template <int D>
Teuchos::ParameterList bentBar(const Bar& bar, double poisson, const std::string& shape,
                               const std::string& shear)
{
  const double height = bar.cells;
  Vector<D> lower = all<D>(0.0), upper = all<D>(2.0);
  upper[0] = length;
  upper[1] = height;
  Teuchos::ParameterList scene =
      emptyScene<D>(lower - all<D>(2.0), upper + all<D>(2.0), 1.0, "MUSL", shape, "Stress");
  scene.sublist("Domain").set("Shear Strain", shear);
  scene.sublist("Time").set("Analysis", "Static");
  scene.sublist("Time").set("Final Time", 1.0);
  addMaterial(scene, "Linear Elastic", poisson);
  addBox<D>(scene, "Bar", lower, upper).set("Particles Per Cell", bar.particles);
  std::ostringstream field;
  field.precision(17);
  field << curvature << "*(x - " << 0.5 * length << ")*(y - " << 0.5 * height << "), " << -0.5 * curvature
        << "*((x - " << 0.5 * length << ")^2 + " << bar.poisson << "*(y - " << 0.5 * height << ")^2)"
        << (D == 2 ? "" : ", 0");
  Teuchos::ParameterList& ends = scene.sublist("Boundaries").sublist("Ends");
  ends.set("Type", "Velocity");
  ends.set("Nodes", "Outside");
  lower = lower - all<D>(10.0);
  upper = upper + all<D>(10.0);
  lower[0] = 1.5;
  upper[0] = length - 1.5;
  ends.set("Lower Corner", array(lower));
  ends.set("Upper Corner", array(upper));
  ends.set("Field", field.str());
  if (D == 3)
  {
    Teuchos::ParameterList& slab = scene.sublist("Boundaries").sublist("Slab");
    slab.set("Type", "Velocity");
    slab.set("Lower Corner", array(all<D>(-20.0)));
    slab.set("Upper Corner", array(all<D>(20.0)));
    slab.set("Components", "z");
    slab.set("Value", array(all<D>(0.0)));
  }
  return scene;
}

template <int D>
void checkEnergy(const std::string& shape, const std::string& shear)
{
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> number(0.0, 0.4);
  for (const Bar& of : {Bar{2, 2, 0.0}, Bar{2, 3, 0.0}, Bar{4, 2, 0.0}, Bar{4, 3, 0.0}, Bar{5, 4, 0.0}})
  {
    const double poisson = number(engine);
    // Plane strain is plane stress with other constants.
    const Bar bar{of.cells, of.particles, D == 2 ? poisson : poisson / (1.0 - poisson)};
    Rhegma::Run<D> run(validated(bentBar<D>(bar, poisson, shape, shear)));
    run.initialize();
    run.step(1.0, false);
    State<D>& state = run.state();
    measureEnergy(state);
    const double young = D == 2 ? 1.0 : 1.0 / (1.0 - poisson * poisson), height = bar.cells;
    const double beam =
        0.5 * young * std::pow(height, 3) / 12.0 * curvature * curvature * length * (D == 2 ? 1.0 : 2.0);
    const double within = (1.0 - 1.0 / (bar.particles * bar.particles)) / (height * height);
    const double normal = 1.0 / (1.0 - bar.poisson * bar.poisson);
    const double parasitic = shear == "At Particles" ? 0.5 / (1.0 + bar.poisson) : 0.0;
    const double expected = 1.0 - 1.0 / (height * height) + (normal + parasitic) * within;
    std::printf(
        "%dD, %s, shear %s, %d cells, %d particles, nu %.3f: energy %.5f of the beam's, derived %.5f\n", D,
        shape.c_str(), shear.c_str(), bar.cells, bar.particles, poisson, state.energy.strain / beam,
        expected);
    // Strains of 1e-5 are small to that order.
    EXPECT_NEAR(state.energy.strain / beam, expected, 2e-5);
  }
}

} // namespace

TEST(Bending, EnergyOfABar)
{
  for (const char* shape : {"Linear", "GIMP"})
    for (const char* shear : {"At Particles", "At Cell Centres"})
      checkEnergy<2>(shape, shear);
}

TEST(Bending, EnergyOfASlab)
{
  for (const char* shear : {"At Particles", "At Cell Centres"})
    checkEnergy<3>("GIMP", shear);
}

} // namespace Test
} // namespace Rhegma
