/// A full turn leaves no stress.

#include "Bodies.hpp"
#include "Pi.hpp"

#include "state/EnergySums.hpp"
#include "step/CoreStep.hpp"
#include "transfer/Gather.hpp"

#include <cmath>
#include <tuple>

namespace Rhegma
{
namespace Test
{

namespace
{

using Rhegma::Test::pi;

/// A square or cube that turns about an axis through the middle of the domain.
template <int D>
Rhegma::Run<D> turningBody(const std::string& model, const std::string& plane, const std::string& shape,
                           double cells, double spin, const std::string& shear = "At Particles")
{
  Teuchos::ParameterList scene =
      emptyScene<D>(all<D>(-cells - 2.0), all<D>(cells + 2.0), 1.0, "MUSL", shape, plane);
  scene.sublist("Domain").set("Shear Strain", shear);
  addMaterial(scene, model, 0.3);
  Teuchos::Array<double> axis(D == 2 ? 1 : 3, 0.0);
  axis.back() = spin;
  addBox<D>(scene, "Body", all<D>(-0.5 * cells), all<D>(0.5 * cells)).set("Angular Velocity", axis);
  Rhegma::Run<D> run(validated(scene));
  run.initialize();
  return run;
}

enum class Velocity
{
  Tangent, ///< w x r
  Chord    ///< moves a point along the chord of its circle: (R(w dt) - 1) r / dt
};

/// One step of the kernel with the velocity of a turn by `angle` about z at the nodes.
template <int D>
void turn(State<D>& state, double angle, Velocity velocity)
{
  const double cosine = velocity == Velocity::Chord ? std::cos(angle) - 1.0 : 0.0;
  const double sine = velocity == Velocity::Chord ? std::sin(angle) : angle;
  const auto motion = Kokkos::create_mirror_view(state.mesh.nodes.motion);
  Kokkos::deep_copy(motion, 0.0);
  for (int n = 0; n < state.mesh.grid.numNodes; ++n)
  {
    const Vector<D> x = state.mesh.grid.nodePosition(n);
    motion(n, 0) = cosine * x[0] - sine * x[1];
    motion(n, 1) = sine * x[0] + cosine * x[1];
  }
  Kokkos::deep_copy(state.mesh.nodes.motion, motion);
  state.clock.dt = 1.0;
  ASSERT_TRUE(std::isfinite(strainAndMove(state, StrainVelocity::Motion, true, true)));
  ASSERT_EQ(state.failure, "");
  if (!state.particles.sorted)
    sortState(state);
}

template <int D>
double largestStress(const State<D>& state)
{
  const HostParticles<D> particles(state);
  double largest = 0.0;
  for (int p = 0; p < particles.size; ++p)
    for (int k = 0; k < symmetricSize<D>; ++k)
      largest = std::max(largest, std::abs(particles.stress(p, k)));
  return largest;
}

/// Largest component of F^T F - 1 in the plane of the turn, and how far any particle's is from `expected`.
template <int D>
double strainOff(const State<D>& state, double expected)
{
  const HostParticles<D> particles(state);
  double off = 0.0;
  for (int p = 0; p < particles.size; ++p)
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
      {
        double C = 0.0;
        for (int k = 0; k < D; ++k)
          C += particles.deformation(p, k * D + i) * particles.deformation(p, k * D + j);
        off = std::max(off, std::abs(C - (i == j ? 1.0 + expected : 0.0)));
      }
  return off;
}

using Solid = std::tuple<std::string, std::string>;

class Turn : public testing::TestWithParam<Solid>
{
protected:
  const std::string& model() const { return std::get<0>(GetParam()); }
  const std::string& plane() const { return std::get<1>(GetParam()); }

  /// With W the spin and theta = w dt, a step multiplies F by 1 + dt W. In the plane of the turn W^T W = w^2
  /// and W + W^T = 0, so (1 + dt W)^T (1 + dt W) = 1 + theta^2: F^T F of n steps is (1 + theta^2)^n whatever
  /// the shape functions, which reproduce a linear velocity. A turn of n = 2 pi / theta steps stretches by
  /// about exp(pi theta), and the positions of the particles by just as much: the stress is that of the
  /// motion made. The chord takes the stretch away.
  template <int D>
  void checkKernel(const std::string& shape, const std::string& shear = "At Particles")
  {
    const int steps = 360;
    const double theta = 2.0 * pi / steps;
    Rhegma::Run<D> tangent = turningBody<D>(model(), plane(), shape, 4.0, 0.0, shear);
    Rhegma::Run<D> chord = turningBody<D>(model(), plane(), shape, 4.0, 0.0, shear);
    for (Rhegma::Run<D>* run : {&tangent, &chord})
      sortState(run->state());
    const HostParticles<D> start(chord.state());
    const auto startId = onHost(chord.state().particles.integer(fields::id));
    std::vector<Vector<D>> home(start.size);
    for (int p = 0; p < start.size; ++p)
      home[startId(p)] = start.at(p);
    double largest = 0.0;
    for (int n = 0; n < steps; ++n)
    {
      turn(tangent.state(), theta, Velocity::Tangent);
      turn(chord.state(), theta, Velocity::Chord);
      largest = std::max(largest, largestStress(chord.state()));
    }
    const double growth = std::pow(1.0 + theta * theta, steps) - 1.0;
    const HostParticles<D> end(chord.state());
    const auto id = onHost(chord.state().particles.integer(fields::id));
    double away = 0.0;
    for (int p = 0; p < end.size; ++p)
      away = std::max(away, norm(end.at(p) - home[id(p)]));
    const double tangentOff = strainOff(tangent.state(), growth), chordOff = strainOff(chord.state(), 0.0);
    std::printf(
        "%s, %s: tangent: strain %.6f as derived but for %.1e; chord: strain %.1e, largest stress / E %.1e, "
        "position off by %.1e\n",
        model().c_str(), shape.c_str(), growth, tangentOff, chordOff, largest, away);
    // Each step rounds F at 1e-16; the errors of 360 steps add up at worst to 1e-13.
    EXPECT_LT(tangentOff, 1e-12);
    EXPECT_LT(chordOff, 1e-12);
    // Moduli of up to 3.3 E on strains of 1e-13.
    EXPECT_LT(largest, 1e-12);
    EXPECT_LT(away, 1e-12);
  }
};

class TurnIn2D : public Turn
{
};
class TurnIn3D : public Turn
{
};

} // namespace

TEST_P(TurnIn2D, LeavesTheDerivedStretch)
{
  checkKernel<2>("Linear");
  checkKernel<2>("GIMP");
  checkKernel<2>("GIMP", "At Cell Centres");
}

TEST_P(TurnIn3D, LeavesTheDerivedStretch)
{
  checkKernel<3>("Linear");
  checkKernel<3>("GIMP");
  checkKernel<3>("GIMP", "At Cell Centres");
}

/// A free square of half width R that spins, its rim at v = w R. Here the nodes' velocity is not linear at
/// the rim: what the particles give a node there is the velocity of their mean position, 3/8 of a cell inside
/// of it. The particles meet that misfit, 3/8 w h, with an elastic pulse of the stress rho c 3/8 w h whenever
/// the rim enters other cells, about N = 2 pi R / h times a turn and out of step, so that the stress grows as
/// a random walk: rho c (3/8) w h sqrt(N) after one turn, and as the square root of the turns after that.
/// FLIP keeps such waves, and they are larger than the stress rho v^2 of the spin. The largest of a thousand
/// particles' stress may be three times the mean.
///
/// So the rotation of a free body leaves stress: this test bounds it.
TEST(RigidRotation, FreeBodyShakesAsARandomWalk)
{
  const double cells = 12.0, half = 0.5 * cells, rim = 0.05, spin = rim / half;
  Rhegma::Run<2> run = turningBody<2>("Linear Elastic", "Strain", "GIMP", cells, spin);
  State<2>& state = run.state();
  measureEnergy(state);
  const double start = state.energy.kinetic;
  double largest = 0.0;
  while (state.clock.time < 2.0 * pi / spin)
  {
    run.step(1e30, false);
    if (state.clock.step % 10 == 0)
      largest = std::max(largest, largestStress(state));
  }
  measureEnergy(state);
  const double speed =
      std::sqrt(state.materials.properties[0].lambda + 2.0 * state.materials.properties[0].mu);
  const double walk = speed * 0.375 * spin * std::sqrt(2.0 * pi * half);
  const double total = (state.energy.kinetic + state.energy.strain) / start;
  std::printf("free square, one turn in %ld steps: largest stress / E %.4f, random walk %.4f, spin %.4f; "
              "energy %.4f\n",
              state.clock.step, largest, walk, rim * rim, total);
  EXPECT_LT(largest, 3.0 * walk);
  EXPECT_NEAR(total, 1.0, 0.01);
}

const auto laws = testing::Values("Linear Elastic", "Neo-Hookean", "Mooney-Rivlin", "J2 Plastic", "Ogden");
INSTANTIATE_TEST_SUITE_P(RigidRotation, TurnIn2D, testing::Combine(laws, testing::Values("Strain", "Stress")),
                         CaseName());
INSTANTIATE_TEST_SUITE_P(RigidRotation, TurnIn3D, testing::Combine(laws, testing::Values("Solid")),
                         CaseName());

} // namespace Test
} // namespace Rhegma
