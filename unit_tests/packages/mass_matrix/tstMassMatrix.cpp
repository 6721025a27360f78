/// The mass matrix: its entries, and what runs keep with each type.

#include "mass_matrix/AngularMomentum.hpp"
#include "mass_matrix/MassRows.hpp"
#include "mass_matrix/MatrixMemory.hpp"
#include "transfer/ParticleViews.hpp"

#include "../../src/step/Bodies.hpp"

#include <cmath>
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

/// A square of 5 cells that lies askew to the lattice, with random velocities: every mode of the particles
/// moves.
Teuchos::ParameterList squareScene(const std::string& scheme, const std::string& shape, double rotation)
{
  Teuchos::ParameterList scene =
      emptyScene<2>(Vector<2>{{-8.0, -8.0}}, Vector<2>{{8.0, 8.0}}, 1.0, scheme, shape);
  addMaterial(scene, "Linear Elastic", 0.3);
  addBox<2>(scene, "Square", Vector<2>{{-2.37, -2.19}}, Vector<2>{{2.63, 2.81}}).set("Rotation", rotation);
  scene.sublist("Time").set("CFL", 0.3);
  return scene;
}

void shake(State<2>& state, double speed)
{
  HostParticles<2> particles(state);
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> number(-speed, speed);
  for (int p = 0; p < particles.size; ++p)
    for (int d = 0; d < 2; ++d)
      particles.velocity(p, d) = number(generator);
  particles.store(state);
}

double energyOf(State<2>& state)
{
  measureEnergy(state);
  return state.energy.kinetic + state.energy.strain;
}

/// Momentum over the sum of |m v|, largest component.
double relativeMomentum(const State<2>& state, const Vector<2>& start)
{
  const HostParticles<2> particles(state);
  Vector<2> total{{-start[0], -start[1]}};
  double size = 0.0;
  for (int p = 0; p < particles.size; ++p)
  {
    for (int d = 0; d < 2; ++d)
      total[d] += particles.mass(p) * particles.velocity(p, d);
    size += particles.mass(p) * std::hypot(particles.velocity(p, 0), particles.velocity(p, 1));
  }
  return std::max(std::fabs(total[0]), std::fabs(total[1])) / size;
}

Vector<2> momentumOf(const State<2>& state)
{
  const HostParticles<2> particles(state);
  Vector<2> total{{0.0, 0.0}};
  for (int p = 0; p < particles.size; ++p)
    for (int d = 0; d < 2; ++d)
      total[d] += particles.mass(p) * particles.velocity(p, d);
  return total;
}

struct Case
{
  const char* name;
  const char* type;
  const char* update;
  int order;
};

const std::vector<Case> cases = {{"Lumped", "Lumped", "FLIP", 0},     {"Full", "Full", "FLIP", 0},
                                 {"FullPic", "Full", "PIC", 0},       {"Fmpm2", "FMPM", "FLIP", 2},
                                 {"Fmpm4", "FMPM", "FLIP", 4},        {"Xpic2", "Lumped", "XPIC", 2},
                                 {"FmpmUpdate", "Lumped", "FMPM", 2}, {"Partial", "Partial", "FLIP", 0},
                                 {"PartialPic", "Partial", "PIC", 0}};

Teuchos::ParameterList withMass(Teuchos::ParameterList scene, const Case& c)
{
  Teuchos::ParameterList& list = scene.sublist("Mass Matrix");
  list.set("Type", c.type);
  list.set("Velocity Update", c.update);
  if (c.order > 0 && std::string(c.type) == "FMPM")
    list.set("Order", c.order);
  if (std::string(c.type) != "Partial")
    return scene;
  // Half of the square is unlumped, around the front of a crack that ends in its middle.
  list.set("Radius", 1.5);
  list.set("Edge Width", 1.0);
  const double angle = 17.0 * M_PI / 180.0;
  scene.sublist("Cracks").sublist("Slit").set(
      "Points", Teuchos::Array<double>(std::vector<double>{0.13 - 2.5 * std::cos(angle),
                                                           0.31 - 2.5 * std::sin(angle), 0.13, 0.31}));
  return scene;
}

} // namespace

/// M u for a linear u against the sum over particles, and the row sums: A 1 = 0.
TEST(MassSystem, MultipliesAsTheSumOverParticles)
{
  for (const char* shape : {"Linear", "GIMP"})
  {
    Rhegma::Run<2> run(validated(squareScene("MUSL", shape, 17.0)));
    run.initialize();
    State<2>& state = run.state();
    run.step(1e30, false);
    Unlumping whole;
    whole.lumpedShare = 0.0;
    whole.smallestNode = 0.0;
    MassSystem<2> system;
    // The nodes keep the masses of the step, for which the particles stood where they are but for the step's
    // move: so none moves here.
    mass_matrix::assemble(state, whole, system);
    ASSERT_GT(system.numCoupled, 30);
    const int n = system.room * 2;
    View<double*> one("one", n), x("x", n), y("y", n);
    const auto hostOne = Kokkos::create_mirror_view(one), hostX = Kokkos::create_mirror_view(x);
    std::mt19937 generator(3);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    for (int i = 2 * system.first; i < 2 * system.last; ++i)
    {
      hostOne(i) = 1.0;
      hostX(i) = number(generator);
    }
    Kokkos::deep_copy(one, hostOne);
    Kokkos::deep_copy(x, hostX);
    const auto lumped = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, system.lumped);
    // M x - L x
    const auto beyondLumped = [&](const View<double*>& from)
    {
      mass_matrix::multiply<2>(system, from.data(), y.data());
      const auto image = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, y);
      const auto given = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, from);
      std::vector<double> difference(n);
      for (int i = 2 * system.first; i < 2 * system.last; ++i)
        difference[i] = image(i) - lumped(i / 2) * given(i);
      return difference;
    };
    const double cellMass = 1.0;
    const auto ofOne = beyondLumped(one);
    double largest = 0.0;
    for (int i = 0; i < n; ++i)
      largest = std::max(largest, std::fabs(ofOne[i]));
    EXPECT_LT(largest, 1e-14 * cellMass) << shape;
    // x^T (M - L) x = - sum over particles of m times the variance of x over the weights; and the sum of
    // (M - L) x is 0, as it is symmetric with row sums of zero.
    const auto ofX = beyondLumped(x);
    double form = 0.0, sumOfImage = 0.0;
    for (int i = 0; i < n; ++i)
    {
      form += hostX(i) * ofX[i];
      sumOfImage += ofX[i];
    }
    const auto rowOf = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, system.rowOf);
    const auto mass = state.particles.scalar(fields::mass);
    double byParticles = 0.0;
    withConnectivity(state,
                     [&](const auto& connect)
                     {
                       for (int p = 0; p < state.particles.size(); ++p)
                         for (int d = 0; d < 2; ++d)
                         {
                           double mean = 0.0, square = 0.0;
                           connect.visit(p,
                                         [&](int node, double weight, const double*)
                                         {
                                           if (weight == 0.0)
                                             return;
                                           const double value = hostX(2 * rowOf(node) + d);
                                           mean += weight * value;
                                           square += weight * value * value;
                                         });
                           byParticles -= mass(p) * (square - mean * mean);
                         }
                     });
    EXPECT_LT(form, -0.1 * cellMass) << shape;
    EXPECT_NEAR(form, byParticles, 1e-12 * std::fabs(form)) << shape;
    EXPECT_LT(std::fabs(sumOfImage), 1e-12 * cellMass) << shape;
  }
}

TEST(MassMatrix, IsRefusedWhereItDoesNotFit)
{
  // A row of GIMP in space has 125 numbers of the band and 16 of vectors of four; a list has twice 125
  // numbers and their places.
  const double row = mass_matrix::bytesPerRow<3>(ShapeKind::Gimp, false);
  EXPECT_GT(row, (125 + 16 * 4) * sizeof(double));
  EXPECT_LT(row, 2.0 * (125 + 16 * 4) * sizeof(double));
  EXPECT_EQ(mass_matrix::bytesPerRow<3>(ShapeKind::Gimp, true) - row, 250 * (sizeof(double) + sizeof(int)));
  EXPECT_NO_THROW(mass_matrix::refuseLargeMatrix(1e6, row, 1e6 * row, "less"));
  try
  {
    mass_matrix::refuseLargeMatrix(1e6, row, 0.5e6 * row, "less");
    ADD_FAILURE() << "a matrix of twice the memory was taken";
  }
  catch (const std::invalid_argument& error)
  {
    const std::string words = error.what();
    EXPECT_EQ(words.rfind("Mass Matrix > Type: the matrix of about 1e+06 nodes needs ", 0), 0u) << words;
    EXPECT_NE(words.find("; take less"), std::string::npos) << words;
  }
}

/// As many rows as are reckoned with before a run, or fewer; in two fields beside a crack, and one elsewhere.
TEST(MassMatrix, HasNoMoreRowsThanAreReckonedWith)
{
  for (const char* shape : {"Linear", "GIMP"})
    for (const char* type : {"Full", "Partial"})
    {
      Rhegma::Run<2> run(validated(withMass(squareScene("MUSL", shape, 17.0), {type, type, "FLIP", 0})));
      run.initialize();
      Unlumping unlumping;
      unlumping.everywhere = std::string(type) == "Full";
      unlumping.radius = 1.5;
      unlumping.edge = 1.0;
      const double reckoned = mass_matrix::largestRows(run.state(), unlumping);
      run.step(1e30, false);
      MassSystem<2> system;
      mass_matrix::assemble(run.state(), unlumping, system);
      const int rows = system.last - system.first;
      EXPECT_LE(rows, reckoned) << type << " " << shape;
      EXPECT_GT(rows, 0.2 * reckoned) << type << " " << shape;
    }
}

TEST(MassMatrix, KeepsMomentumWithEveryType)
{
  for (const Case& c : cases)
    for (const auto& [scheme, shape] : {std::pair("MUSL", "GIMP"), std::pair("USF", "GIMP"),
                                        std::pair("MUSL", "Linear"), std::pair("USF", "Linear")})
    {
      // With USF, only the bodies without a crack.
      if (std::string(scheme) == "USF" && std::string(c.type) == "Partial")
        continue;
      Rhegma::Run<2> run(validated(withMass(squareScene(scheme, shape, 17.0), c)));
      run.initialize();
      State<2>& state = run.state();
      shake(state, 1e-3);
      const Vector<2> start = momentumOf(state);
      for (int k = 0; k < 40; ++k)
        run.step(1e30, false);
      EXPECT_LT(relativeMomentum(state, start), 1e-12) << c.name << " " << scheme << " " << shape;
    }
}

/// What a step of MUSL adds to the angular momentum of particles without a crack, from M and the nodes'
/// acceleration a. Forces turn nothing, as stresses are symmetric, so sum_I x_I x (M a)_I = 0; places change
/// by a velocity w with sum_I w_I x (M w)_I = 0, M being symmetric. What is left is that a particle of which
/// the share l is lumped takes the acceleration at its own place, and M has l m N_I at the nodes:
///
///     dL = - dt sum_p l m_p sum_I N_I (x_I - x_p) x a_I
///
/// with l = 1 (Lumped) or the lumped share (Full). A consistent mass would keep it.
TEST(MassMatrix, ChangesAngularMomentumByItsLumpedShareAlone)
{
  for (const char* shape : {"Linear", "GIMP"})
    for (const double lumpedShare : {1.0, 0.1})
    {
      Teuchos::ParameterList scene = squareScene("MUSL", shape, 17.0);
      Teuchos::ParameterList& list = scene.sublist("Mass Matrix");
      list.set("Type", lumpedShare < 1.0 ? "Full" : "Lumped");
      if (lumpedShare < 1.0)
      {
        list.set("Lumped Share", lumpedShare);
        list.set("Smallest Node", 0.0); // all particles alike
        list.set("Solver Tolerance", 1e-12);
        list.set("Maximum Iterations", 2000);
      }
      Rhegma::Run<2> run(validated(scene));
      run.initialize();
      State<2>& state = run.state();
      run.step(1e30, false);
      shake(state, 1e-3);
      struct Share
      {
        int node;
        double m; ///< m_p N_I
        Vector<2> arm;
      };
      for (int k = 0; k < 5; ++k)
      {
        std::vector<Share> shares;
        {
          const HostParticles<2> particles(state);
          withConnectivity(state,
                           [&](const auto& connect)
                           {
                             for (int p = 0; p < particles.size; ++p)
                               connect.visit(p,
                                             [&](int node, double weight, const double*)
                                             {
                                               const Vector<2> x = state.grid.nodePosition(node);
                                               shares.push_back(
                                                   {node, particles.mass(p) * weight,
                                                    Vector<2>{{x[0] - particles.position(p, 0),
                                                               x[1] - particles.position(p, 1)}}});
                                             });
                           });
        }
        const double before = mass_matrix::angularMomentum(state)[2];
        run.step(1e30, false);
        const double change = mass_matrix::angularMomentum(state)[2] - before;
        const auto motion = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.nodes.motion);
        double derived = 0.0, size = 0.0;
        for (const Share& s : shares)
        {
          const double turn = -state.dt * lumpedShare * s.m *
                              (s.arm[0] * motion(s.node, Nodes<2>::accelerationAt + 1) -
                               s.arm[1] * motion(s.node, Nodes<2>::accelerationAt));
          derived += turn;
          size += std::fabs(turn);
        }
        // The first step after the shake starts without stress.
        if (k > 0)
        {
          EXPECT_GT(size, 0.0) << shape << " " << lumpedShare;
        }
        // Angular momentum of 100 particles is summed to some 1e-16 of it.
        EXPECT_NEAR(change, derived, 1e-8 * size + 1e-15) << shape << " " << lumpedShare << " step " << k;
      }
    }
}

/// A wall that moves a body at rest: no force acts on the free nodes, and their share comes from the wall's
/// alone. All of the momentum is the wall's impulse.
TEST(MassMatrix, TakesWhatASupportDoesToABodyAtRest)
{
  Teuchos::ParameterList scene = squareScene("MUSL", "GIMP", 0.0);
  scene.sublist("Mass Matrix").set("Type", "Full");
  Teuchos::ParameterList& wall = scene.sublist("Boundaries").sublist("Wall");
  wall.set("Type", "Velocity");
  wall.set("Lower Corner", array(Vector<2>{{-8.0, -8.0}}));
  wall.set("Upper Corner", array(Vector<2>{{-1.5, 8.0}}));
  wall.set("Components", "x");
  wall.set("Value", array(Vector<2>{{1e-4, 0.0}}));
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  State<2>& state = run.state();
  for (int k = 0; k < 20; ++k)
    run.step(1e30, false);
  const Vector<2> momentum = momentumOf(state);
  EXPECT_GT(momentum[0], 0.0);
  EXPECT_NEAR(momentum[1], 0.0, 1e-12 * momentum[0]);
}

/// Random velocities, bodies at odd places and angles to the lattice. \return the mean energy of the last
/// tenth of the steps over that of the second tenth: the mean, as kinetic and strain energy are half a step
/// apart and their sum wavers. A run that stops counts as one that grew without bound.
double growth(double lumpedShare, double smallestNode, double rotation, const char* shape, int steps)
{
  Teuchos::ParameterList scene = squareScene("MUSL", shape, rotation);
  Teuchos::ParameterList& list = scene.sublist("Mass Matrix");
  list.set("Type", "Full");
  list.set("Lumped Share", lumpedShare);
  list.set("Smallest Node", smallestNode);
  list.set("Maximum Iterations", 2000);
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  State<2>& state = run.state();
  shake(state, 1e-6);
  double early = 0.0, late = 0.0;
  const int tenth = steps / 10;
  try
  {
    for (int k = 0; k < steps; ++k)
    {
      run.step(1e30, false);
      if (k / tenth == 1)
        early += energyOf(state);
      else if (k / tenth == 9)
        late += energyOf(state);
    }
  }
  catch (const RunError&)
  {
    return 1e300;
  }
  return std::isfinite(late) ? late / early : 1e300;
}

/// The cures (Lumped Share, Smallest Node) hold the energy where it is; what FLIP keeps in motions that the
/// nodes do not see stays too, and the rest may only fall.
TEST(MassMatrix, IsStableOnCutCells)
{
  for (const char* shape : {"Linear", "GIMP"})
    for (const double rotation : {0.0, 17.0, 45.0})
      EXPECT_LT(growth(0.1, 0.1, rotation, shape, 300), 1.01) << shape << " at " << rotation << " degrees";
}

TEST(MassMatrix, NeedsItsCures)
{
  double worst = 0.0;
  for (const double rotation : {0.0, 17.0, 45.0})
    worst = std::max(worst, growth(0.0, 0.0, rotation, "GIMP", 200));
  EXPECT_GT(worst, 10.0);
}

} // namespace Test
} // namespace Rhegma
