/// The mass matrix where cells are refined: what it keeps, with each type.

#include "../../src/step/Vibration.hpp"

#include "Refined.hpp"
#include "SquareScene.hpp"

#include "mass_matrix/MassRows.hpp"
#include "mass_matrix/ParticleMass.hpp"
#include "state/EnergySums.hpp"
#include "transfer/ParticleViews.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <utility>
#include <vector>

namespace Rhegma
{
namespace Test
{

namespace
{

using mass_matrix::MassSystem;
using mass_matrix::Unlumping;

/// A body at an odd position in cells that are refined in three boxes anywhere. Its particles lie as nodes
/// saw them in the step that was taken: nothing moves.
template <int D>
Rhegma::Run<D> randomTree(const std::string& shape, std::mt19937& generator)
{
  std::uniform_real_distribution<double> within(0.0, 1.0);
  Teuchos::ParameterList scene = emptyScene<D>(all<D>(-3.0), all<D>(8.0), 1.0, "MUSL", shape);
  addMaterial(scene, "Linear Elastic", 0.3);
  addBox<D>(scene, "Block", all<D>(0.3 * within(generator)), all<D>(D == 2 ? 4.6 : 2.6))
      .set("Rotation", D == 2 ? 30.0 * within(generator) : 0.0);
  for (int b = 0; b < 3; ++b)
  {
    Vector<D> lower, upper;
    for (int d = 0; d < D; ++d)
    {
      lower[d] = (D == 2 ? 4.0 : 2.0) * within(generator);
      upper[d] = lower[d] + 0.1 + within(generator);
    }
    refine(scene, lower, upper, 1 + static_cast<int>(generator() % (D == 2 ? 3 : 2)),
           "Box " + std::to_string(b));
  }
  Rhegma::Run<D> run(validated(scene));
  run.initialize();
  run.step(1e30, false);
  return run;
}

/// Values of rows on the host.
template <int D>
struct Rows
{
  explicit Rows(const MassSystem<D>& system) : values("values", system.rowCapacity * MassSystem<D>::width) {}
  View<double*> values;
  double& operator()(int row, int axis) const { return values(row * MassSystem<D>::width + axis); }
};

/// Whether what a particle gives a node stays lumped as next to nothing: of a stored stencil by its weight,
/// of a product by the weight along any axis, which is the sum over the nodes with that coordinate.
template <int D>
bool isBarelyTouched(const State<D>& state, bool stored, int node, double weight,
                     const std::vector<std::pair<int, double>>& touched)
{
  if (stored)
    return weight <= mass_matrix::barelyTouched;
  const Vector<D> at = state.mesh.grid.nodePosition(node);
  bool barely = false;
  for (int d = 0; d < D; ++d)
  {
    double along = 0.0;
    for (const auto& [other, fraction] : touched)
      along += state.mesh.grid.nodePosition(other)[d] == at[d] ? fraction : 0.0;
    barely = barely || along <= mass_matrix::barelyTouched;
  }
  return barely;
}

/// M 1 against L 1, and x M y against the sum over particles, which have no cures here but for what they
/// barely touch.
template <int D>
void checkProducts(int trees)
{
  for (const char* shape : {"Linear", "GIMP"})
  {
    std::mt19937 generator(11);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    int lists = 0;
    for (int t = 0; t < trees; ++t)
    {
      const Rhegma::Run<D> run = randomTree<D>(shape, generator);
      const State<D>& state = run.state();
      Unlumping whole;
      whole.lumpedFraction = whole.smallestNode = 0.0;
      MassSystem<D> system;
      mass_matrix::assemble(state, whole, system);
      lists += system.numExtra;
      const Rows<D> one(system), x(system), y(system), ofOne(system), ofX(system), ofY(system);
      for (int row = system.first; row < system.last; ++row)
        for (int d = 0; d < D; ++d)
        {
          one(row, d) = 1.0;
          // Rows that nothing couples are no part of the solves.
          x(row, d) = system.coupled(row) != 0 ? number(generator) : 0.0;
          y(row, d) = system.coupled(row) != 0 ? number(generator) : 0.0;
        }
      mass_matrix::multiply<D>(system, one.values.data(), ofOne.values.data());
      mass_matrix::multiply<D>(system, x.values.data(), ofX.values.data());
      mass_matrix::multiply<D>(system, y.values.data(), ofY.values.data());
      double form = 0.0, other = 0.0, byParticles = 0.0, size = 0.0, worst = 0.0;
      for (int row = system.first; row < system.last; ++row)
        for (int d = 0; d < D; ++d)
        {
          worst = std::max(worst, std::fabs(ofOne(row, d) - system.lumped(row)));
          form += y(row, d) * ofX(row, d);
          other += x(row, d) * ofY(row, d);
        }
      const auto mass = state.particles.scalar(fields::mass);
      withConnectivity(state,
                       [&](const auto& connect)
                       {
                         for (int p = 0; p < state.particles.size(); ++p)
                         {
                           std::vector<std::pair<int, double>> touched;
                           connect.visit(p,
                                         [&](int node, double weight, const double*)
                                         {
                                           if (weight != 0.0)
                                             touched.emplace_back(node, weight);
                                         });
                           const bool stored = state.stored.count > 0 && state.stored.row(p) >= 0;
                           for (int d = 0; d < D; ++d)
                           {
                             double meanX = 0.0, meanY = 0.0, coupled = 0.0, sum = 0.0, rest = 0.0;
                             for (const auto& [node, weight] : touched)
                             {
                               const int row = system.rowOf(node);
                               if (row < 0)
                                 continue;
                               if (isBarelyTouched<D>(state, stored, node, weight, touched))
                               {
                                 rest += weight * x(row, d) * y(row, d);
                                 continue;
                               }
                               meanX += weight * x(row, d);
                               meanY += weight * y(row, d);
                               sum += weight * x(row, d) * y(row, d);
                               coupled += weight;
                             }
                             byParticles += mass(p) * (meanX * meanY + (1.0 - coupled) * sum + rest);
                             size += mass(p) * std::fabs(meanX * meanY);
                           }
                         }
                       });
      // A cell has a mass of 1.
      EXPECT_LT(worst, 1e-14) << shape << ", tree " << t;
      EXPECT_NEAR(form, byParticles, 1e-12 * size) << shape << ", tree " << t;
      EXPECT_NEAR(form, other, 1e-12 * size) << shape << ", tree " << t;
    }
    EXPECT_GT(lists, 50 * trees) << shape << ": hardly anything was refined";
  }
}

} // namespace

TEST(MassOnRefinedCells, MultipliesAsTheSumOverParticles)
{
  checkProducts<2>(200);
  checkProducts<3>(30);
}

/// A square of which a corner lies in cells that change as it shakes.
TEST(MassOnRefinedCells, KeepsMomentumWithEveryType)
{
  for (const Case& c : cases)
    for (const char* shape : {"Linear", "GIMP"})
    {
      Teuchos::ParameterList scene = withMass(squareScene("MUSL", shape, 17.0), c);
      refine(scene, Vector<2>{{0.5, 0.5}}, Vector<2>{{2.5, 2.5}}, 2);
      scene.sublist("Adaptivity").set("Velocity Change", 4e-4);
      scene.sublist("Adaptivity").set("Interval", 5);
      Rhegma::Run<2> run(validated(scene));
      run.initialize();
      State<2>& state = run.state();
      shake(state, 1e-3);
      double size = 0.0; // sum of |m v|
      const HostParticles<2> particles(state);
      for (int p = 0; p < particles.size; ++p)
        size += particles.mass(p) * std::hypot(particles.velocity(p, 0), particles.velocity(p, 1));
      measureEnergy(state);
      const Vector<2> start = state.sample.momentum;
      const int generation = state.mesh.tree.generation;
      for (int k = 0; k < 40; ++k)
      {
        run.step(1e30, false);
        measureEnergy(state);
        for (int d = 0; d < 2; ++d)
          EXPECT_NEAR(state.sample.momentum[d], start[d], 1e-12 * size) << c.name << " " << shape;
      }
      EXPECT_EQ(state.mesh.tree.deepest, 2);
      EXPECT_GT(state.mesh.tree.generation, generation + 2) << "the cells hardly changed";
    }
}

/// A body whose faces lie on those of cells flies into smaller ones, its boxes touching nodes by as little as
/// rounding makes of nothing.
template <int D>
void checkFlight()
{
  Teuchos::ParameterList scene = emptyScene<D>(all<D>(-4.0), all<D>(8.0), 1.0, "MUSL", "GIMP");
  scene.sublist("Time").set("CFL", 0.4);
  addMaterial(scene, "Neo-Hookean", 0.3);
  Vector<D> speed = all<D>(0.0), from = all<D>(0.0), upper = all<D>(8.0);
  speed[0] = -0.043;
  from[0] = 2.0;
  addBox<D>(scene, "Block", from, all<D>(4.0)).set("Velocity", array(speed));
  upper[0] = 1.0;
  refine(scene, all<D>(-4.0), upper, 1);
  scene.sublist("Mass Matrix").set("Type", "Full");
  Rhegma::Run<D> run(validated(scene));
  run.initialize();
  State<D>& state = run.state();
  for (int k = 0; k < 250; ++k)
    run.step(1e30, false);
  const HostParticles<D> particles(state);
  for (int p = 0; p < particles.size; ++p)
    for (int d = 0; d < D; ++d)
      ASSERT_NEAR(particles.velocity(p, d), speed[d], 1e-9) << "particle " << p;
}

TEST(MassOnRefinedCells, LetsABodyFlyOn)
{
  checkFlight<2>();
  checkFlight<3>();
}

/// Supports hold nodes at hanging nodes' masters as elsewhere: all nodes stretch evenly, and so does the
/// body.
TEST(MassOnRefinedCells, StretchesEvenlyWhereAllIsHeld)
{
  Teuchos::ParameterList scene = emptyScene<2>(all<2>(-3.0), all<2>(7.0), 1.0, "MUSL", "GIMP");
  addMaterial(scene, "Neo-Hookean", 0.3);
  addBox<2>(scene, "Block", all<2>(0.3), all<2>(4.3));
  Teuchos::ParameterList& held = scene.sublist("Boundaries").sublist("Held");
  held.set("Type", "Velocity");
  held.set("Lower Corner", array(all<2>(-3.0)));
  held.set("Upper Corner", array(all<2>(7.0)));
  held.set("Field", "0.01*x, -0.002*y");
  refine(scene, all<2>(1.0), all<2>(2.0), 2);
  scene.sublist("Mass Matrix").set("Type", "Full");
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  State<2>& state = run.state();
  double stretch = 1.0;
  for (int k = 0; k < 20; ++k)
  {
    run.step(1e30, false);
    stretch *= 1.0 + 0.01 * state.clock.dt;
    const HostParticles<2> particles(state);
    for (int p = 0; p < particles.size; ++p)
      ASSERT_NEAR(particles.deformation(p, 0), stretch, 1e-13);
  }
  EXPECT_EQ(state.mesh.tree.deepest, 2);
}

/// The step is that of the smallest cells, at a CFL number of 0.4 or less.
TEST(MassOnRefinedCells, LimitsTheStepByItsSmallestCells)
{
  double step[2] = {};
  for (const bool full : {false, true})
  {
    Teuchos::ParameterList scene = squareScene("MUSL", "GIMP", 17.0);
    refine(scene, Vector<2>{{0.5, 0.5}}, Vector<2>{{2.5, 2.5}}, 2);
    scene.sublist("Mass Matrix").set("Type", full ? "Full" : "Lumped");
    scene.sublist("Time").set("CFL", 0.8);
    Rhegma::Run<2> run(validated(scene));
    run.initialize();
    run.step(1e30, false);
    step[full ? 1 : 0] = run.state().clock.dt * run.state().clock.fastestSpeed;
    EXPECT_EQ(run.state().mesh.tree.deepest, 2);
  }
  EXPECT_NEAR(step[0], 0.8 * 0.25, 1e-12);
  EXPECT_NEAR(step[1], 0.4 * 0.25, 1e-12);
}

/// The first mode of a bar whose middle is refined, free at its ends.
TEST(MassOnRefinedCells, KeepsEnergyOverTenPeriods)
{
  for (const char* type : {"Lumped", "Full", "FMPM"})
    for (const char* shape : {"Linear", "GIMP"})
      for (const int level : {1, 2})
      {
        Teuchos::ParameterList scene = barScene<2>("MUSL", shape);
        scene.sublist("Time").set("CFL", 0.3);
        scene.sublist("Mass Matrix").set("Type", type);
        refine(scene, Vector<2>{{6.5, 0.5}}, Vector<2>{{9.5, 1.5}}, level);
        const Vibration v = vibrate<2>(scene, 1, 2.0 * barCells);
        std::printf("%s, %s, %d level(s): energy kept over ten periods %.5f, period %+.3f %%\n", type, shape,
                    level, v.kept, 100.0 * (v.period / (2.0 * barCells) - 1.0));
        // As the bar of equal cells.
        EXPECT_NEAR(v.kept, 1.0, 1e-3) << type << " " << shape << " " << level;
      }
}

} // namespace Test
} // namespace Rhegma
