/// Estimates of numerical errors: what they are made of, and when there is none. How large true errors are
/// next to them is in program/test_error_bars.py.

#include "LatticeState.hpp"
#include "Pi.hpp"

#include "energy_release/ErrorEstimate.hpp"
#include "energy_release/FrontLengths.hpp"
#include "energy_release/HeldFronts.hpp"
#include "energy_release/StressError.hpp"
#include "material/Laws.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <random>

using namespace Rhegma;
using namespace Rhegma::energy_release;
using namespace Rhegma::energy_release::test;
using Rhegma::Test::pi;

namespace
{

constexpr double half = 0.01, cell = 1e-3, shearModulus = young / (2.0 * (1.0 + poisson));

/// A body on whole cells whose particles have the stress that a function says.
template <class Stress>
State<2> stressed(ShapeKind shape, const Stress& stressAt)
{
  State<2> state = makeBody(half, cell, Plane::Stress, shape);
  sortParticles<2>(state.mesh.grid, state.particles, state.mesh.blocks, state.mesh.nodes.active);
  const auto position = state.particles.real<2>(fields::position);
  const auto stress = state.particles.real<symmetricSize<2>>(fields::stress);
  for (int p = 0; p < state.particles.size(); ++p)
  {
    const std::array<double, 3> s = stressAt(position(p, 0), position(p, 1));
    for (int k = 0; k < 3; ++k)
      stress(p, k) = s[k];
  }
  return state;
}

/// Errors of the whole body count fully.
std::vector<ErrorSight<2>> everywhere() { return {{{{0.0, 0.0}}, 0.0, 10.0 * half}}; }

double volumeOf(const State<2>&) { return 4.0 * half * half * thickness; }

/// A sample of a front in the middle of a body, with a crack that ends at its surface.
FrontSample<2> sampleOf(State<2>& state)
{
  CrackFront<2> front = addFront(state, {{0.0, 0.0}}, 0.0);
  front.length = half;
  front.nodes[0].position = front.position;
  front.nodes[0].direction = front.direction;
  front.nodes[0].normal = front.normal;
  state.cracks.fronts = {front};
  state.clock.settled = true;
  FrontSample<2> sample(front, 0.0);
  sample.J = {10.0};
  sample.tube.radii = {3e-3, 6e-3};
  return sample;
}

} // namespace

/// A stress that is linear in space has no error, also next to surfaces and in corners. What is left is due
/// to the thousandth of a squared cell in the variances: a value at a surface is off by less than a hundredth
/// of the change over a cell, so the energy by 1e-4 of that of this change, a 1e-4th of the body's.
TEST(StressError, OfALinearStressIsNone)
{
  const unsigned seed = 20261126;
  std::printf("seed %u\n", seed);
  std::mt19937 draw(seed);
  std::uniform_real_distribution<double> slope(-1e8, 1e8);
  for (const ShapeKind shape : {ShapeKind::Linear, ShapeKind::Gimp})
  {
    double a[3][3];
    double largest = 0.0;
    for (auto& row : a)
      for (double& x : row)
        largest = std::max(largest, std::fabs(x = slope(draw)));
    const State<2> state = stressed(shape,
                                    [&](double x, double y)
                                    {
                                      std::array<double, 3> s;
                                      for (int k = 0; k < 3; ++k)
                                        s[k] = a[k][0] * half + a[k][1] * x + a[k][2] * y;
                                      return s;
                                    });
    const double change = largest * cell, ofChange = volumeOf(state) * change * change / (2.0 * young);
    EXPECT_LT(energyOfStressError<2>(state, everywhere()), 1e-4 * ofChange);
  }
}

/// Shear that swings by s in each cell along x, as that of a bent cell. At particles a quarter of a cell from
/// the middle it is -s/4, s/4; the fit at inner nodes is zero, and that at nodes of the two end faces is -s/2
/// or s/2, which is taken into the cell by weights of 3/4 and 1/4: errors of 1/8 and 3/8 of s there.
TEST(StressError, OfSwingingShearIsItsEnergy)
{
  const double s = 1e6;
  const State<2> state = stressed(ShapeKind::Linear,
                                  [&](double x, double)
                                  {
                                    const double from = x / cell - std::floor(x / cell) - 0.5;
                                    return std::array<double, 3>{0.0, 0.0, s * from};
                                  });
  const int cells = static_cast<int>(std::lround(2.0 * half / cell));
  const double atEnds = 0.5 * (1.0 / 64.0 + 9.0 / 64.0), inside = 1.0 / 16.0;
  const double mean = s * s * (2.0 * atEnds + (cells - 2.0) * inside) / cells;
  const double expected = volumeOf(state) * mean / (2.0 * shearModulus);
  // Variances of 3/64 and more squared cells get a thousandth more.
  EXPECT_NEAR(energyOfStressError<2>(state, everywhere()), expected, 0.02 * expected);
}

/// Energy of a hydrostatic difference in the plane, by (1 - nu) / E s^2 in plane stress.
TEST(StressError, HasTheComplianceOfThePlane)
{
  const double s = 1e6;
  const State<2> state = stressed(ShapeKind::Linear,
                                  [&](double x, double)
                                  {
                                    const double from = x / cell - std::floor(x / cell) - 0.5;
                                    return std::array<double, 3>{s * from, s * from, 0.0};
                                  });
  const State<2> shear = stressed(ShapeKind::Linear,
                                  [&](double x, double)
                                  {
                                    const double from = x / cell - std::floor(x / cell) - 0.5;
                                    return std::array<double, 3>{0.0, 0.0, s * from};
                                  });
  const double ratio = ((1.0 - poisson) / young) / (1.0 / (2.0 * shearModulus));
  EXPECT_NEAR(energyOfStressError<2>(state, everywhere()) / energyOfStressError<2>(shear, everywhere()),
              ratio, 1e-9);
}

/// Nothing counts within the cells of a front, and (reach / r)^2 of what is farther from it than its reach;
/// of several fronts the nearest in this sense decides. A swinging stress has the same energy in each cell,
/// so that the energies are areas: of a square of edge 2 a less a circle of radius a / 2, and of a disk of
/// radius a / 4 and its surroundings, a^2 / 16 (pi + int r^-2 dA) with int r^-2 dA = 2 pi ln 4 + 8 int_0^(pi
/// / 4) -ln cos t dt up to the edges.
TEST(StressError, CountsByTheDistanceFromFronts)
{
  const State<2> state = stressed(ShapeKind::Linear,
                                  [&](double x, double)
                                  {
                                    const double from = x / cell - std::floor(x / cell) - 0.5;
                                    return std::array<double, 3>{0.0, 0.0, 1e6 * from};
                                  });
  const Vector<2> middle{{0.0, 0.0}};
  const double all = energyOfStressError<2>(state, everywhere());
  EXPECT_EQ(energyOfStressError<2>(state, {{middle, 2.0 * half, 10.0 * half}}), 0.0);
  EXPECT_NEAR(energyOfStressError<2>(state, {{middle, 0.5 * half, 10.0 * half}}) / all, 1.0 - pi / 16.0,
              0.02);
  // int_0^(pi / 4) -ln cos t dt = pi / 4 ln 2 - Catalan's constant / 2
  const double corners = 8.0 * (pi / 4.0 * std::log(2.0) - 0.5 * 0.915965594);
  const double weighted = (pi + 2.0 * pi * std::log(4.0) + corners) / 16.0 / 4.0;
  EXPECT_NEAR(energyOfStressError<2>(state, {{middle, 0.0, 0.25 * half}}) / all, weighted, 0.02);
  const std::vector<ErrorSight<2>> two = {{middle, 0.0, 0.25 * half}, everywhere()[0]};
  EXPECT_EQ(energyOfStressError<2>(state, two), all);
}

/// A crack from one surface to the middle of the body has the ligament to the other; with a front at its
/// other end, half of its length counts, and a front ahead limits the ligament.
TEST(FrontLengths, AreThoseOfCrackAndLigament)
{
  State<2> state = makeBody(half, cell, Plane::Stress, ShapeKind::Gimp);
  const FrontSample<2> sample = sampleOf(state);
  const NodeCover<2> cover = coverOfNodes(state, Vector<2>{}, 1e300);
  const FrontLengths one = lengthsAt(state, sample.front, cover);
  EXPECT_NEAR(one.crack, half, 1e-12);
  EXPECT_NEAR(one.ligament, half, 1e-9);
  EXPECT_NEAR(one.front, thickness, 1e-12);
  EXPECT_EQ(one.ends, 1);
  EXPECT_NEAR(one.arm, half, 1e-9);
  CrackFront<2> ahead = sample.front;
  ahead.number = 1;
  ahead.position = ahead.nodes[0].position = {{0.4 * half, 0.1 * half}};
  state.cracks.fronts.push_back(ahead);
  const FrontLengths two = lengthsAt(state, sample.front, cover);
  EXPECT_NEAR(two.crack, 0.5 * half, 1e-12);
  EXPECT_NEAR(two.ligament, half * std::sqrt(0.17), 1e-9);
  EXPECT_NEAR(two.front, 2.0 * thickness, 1e-12);
  EXPECT_EQ(two.ends, 2);
}

/// G of a short crack is proportional to a and b^-3; that of a beam whose ends are held to (a + 0.64 h)^-4.
TEST(FrontLengths, GiveTheSlopeOfG)
{
  const FrontLengths edge{0.01, 0.03, 1, 1.0, 0.02}, arms{0.05, 0.25, 1, 1.0, 0.01},
      central{0.05, 0.25, 2, 1.0, 0.01};
  EXPECT_NEAR(edge.slope(), 1.0 / 0.01 + 3.0 / 0.03, 1e-9);
  EXPECT_NEAR(arms.slope(), 4.0 / 0.0564, 1e-9);
  EXPECT_NEAR(central.slope(), 1.0 / 0.05 + 1.0 / 0.25, 1e-9);
}

/// Squares of the parts of G add; K has half of the relative error of G, and of its own part.
TEST(ErrorEstimate, AddsSquares)
{
  State<2> state = makeBody(half, cell, Plane::Stress, ShapeKind::Gimp);
  FrontSample<2> sample = sampleOf(state);
  const auto intensity = [](double fraction) { return std::sqrt(fraction * 10.0 * young); };
  sample.modeI = {intensity(0.5)};
  sample.modeII = {intensity(0.5)};
  ErrorEstimate one, same, modes;
  one.parts.field = 0.05;
  same.parts = {0.03, 0.0, 0.04, 0.0};
  combineParts(sample, young, one);
  combineParts(sample, young, same);
  EXPECT_NEAR(one.release, same.release, 1e-12);
  EXPECT_GE(one.release, 0.05 * 10.0);
  EXPECT_NEAR(one.intensity / intensity(1.0), 0.5 * one.release / 10.0, 1e-12);
  EXPECT_EQ(one.closure, one.release);
  sample.modeI = {intensity(0.62)};
  combineParts(sample, young, modes);
  EXPECT_NEAR(modes.parts.modes, 0.12, 1e-12);
  EXPECT_EQ(modes.release, 0.0); // of stress intensities alone
  EXPECT_NEAR(modes.intensity, 0.06 * intensity(1.12), 1e-9 * intensity(1.0));
}

/// Each state of which an estimate would be wrong has its reason.
TEST(ErrorEstimate, IsRefusedWithAReason)
{
  State<2> state = makeBody(half, cell, Plane::Stress, ShapeKind::Gimp);
  FrontSample<2> good = sampleOf(state);
  good.modeI = {std::sqrt(10.0 * young)};
  const auto reason = [&](const State<2>& of, const FrontSample<2>& sample)
  { return reasonForNoEstimate(of, sample, Options()); };
  EXPECT_EQ(reason(state, good), "");
  FrontSample<2> sample = good;
  sample.front.grown = true;
  EXPECT_EQ(reason(state, sample), "the front has grown");
  sample = good;
  sample.J = {FrontSample<2>::notYet};
  EXPECT_NE(reason(state, sample), "");
  sample.J = {-1.0};
  EXPECT_NE(reason(state, sample), "");
  sample = good;
  sample.modeI = {-good.modeI[0]};
  EXPECT_NE(reason(state, sample).find("closed"), std::string::npos);
  sample.modeI = {0.94 * good.modeI[0]}; // 11.6 % of G
  EXPECT_NE(reason(state, sample).find("another G"), std::string::npos);
  sample.modeI = {0.96 * good.modeI[0]}; // 7.8 %
  EXPECT_EQ(reason(state, sample), "");
  const auto changed = [&](const std::function<void(State<2>&)>& change)
  {
    State<2> other = state;
    change(other);
    return reason(other, good);
  };
  EXPECT_NE(changed([](State<2>& s) { s.clock.settled = false; }).find("at rest"), std::string::npos);
  EXPECT_NE(changed([](State<2>& s) { s.cracks.pressure = View<double*>("p", 1); }).find("pressure"),
            std::string::npos);
  EXPECT_NE(
      changed([](State<2>& s) { s.cracks.tractions = [](int) { return std::vector<FaceTraction<2>>(); }; })
          .find("touch"),
      std::string::npos);
  EXPECT_NE(changed([](State<2>& s) { s.cracks.dualField = false; }).find("single field"), std::string::npos);
  EXPECT_EQ(changed(
                [](State<2>& s)
                {
                  s.materials.names = {"Rubber"};
                  s.materials.properties[0].law = lawIndex<NeoHookean>;
                })
                .rfind("Materials > Rubber > Model is not Linear Elastic", 0),
            0u);
  EXPECT_EQ(changed(
                [](State<2>& s)
                {
                  s.materials.properties.push_back(s.materials.properties[0]);
                  s.materials.properties[1].mu *= 2.0;
                }),
            "the bodies have different stiffness");
}

/// The summary has null and the reason, and the answer a message, where there is no estimate.
TEST(ErrorEstimate, IsReportedWithItsReason)
{
  State<2> state = makeBody(half, cell, Plane::Stress, ShapeKind::Gimp);
  const FrontSample<2> sample = sampleOf(state);
  const auto summaryOf = [&](const ErrorEstimate& estimate)
  {
    nlohmann::json summary;
    nlohmann::json& entry = summary["cracks"][0]["fronts"][0];
    sample.report({}, entry);
    reportError(sample, {}, estimate, entry);
    addAnswersOfHeldFronts(state.cracks, {sample}, 4e-3, summary);
    return summary;
  };
  ErrorEstimate known, unknown;
  known.release = 0.25;
  known.intensity = 1500.0;
  unknown.none = "the front has grown";
  const nlohmann::json with = summaryOf(known), without = summaryOf(unknown);
  EXPECT_EQ(with["cracks"][0]["fronts"][0]["G_J_error_estimate"], 0.25);
  EXPECT_FALSE(with["cracks"][0]["fronts"][0].contains("no_error_estimate"));
  const std::string line = with["answers"][0];
  EXPECT_EQ(line.rfind("crack Notch, front 0: G = 10 +- 0.25 J/m2 (2.5 %), K_I = 0 +- 1.5 kPa m^0.5", 0), 0u)
      << line;
  ASSERT_EQ(without["answers"].size(), 2u);
  EXPECT_EQ(without["answers"][1],
            "no error estimate (the front has grown; compare with --twice) for crack Notch, front 0");
  EXPECT_TRUE(without["cracks"][0]["fronts"][0]["G_J_error_estimate"].is_null());
  EXPECT_EQ(without["cracks"][0]["fronts"][0]["no_error_estimate"], "the front has grown");
}
