/// Cracks in 3D whose springs and contact follow the substeps of fine cells.

#include "../cracks/CubeScene.hpp"

#include "state/EnergySums.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace Rhegma;
using namespace Rhegma::cracks::test;

namespace
{

constexpr double speed = 0.1, height = 0.004;

/// A block with a flat crack halfway up, whose front and part of its faces lie in fine cells.
std::unique_ptr<Run<3>> crackedBlock(int levels, bool contact, bool substeps)
{
  Teuchos::ParameterList scene = blockScene({0.006, height, 0.004});
  setCrack(scene, {0.0, 0.002, 0.004, 0.0032, 0.002, 0.004, 0.0032, 0.002, 0.0, 0.0, 0.002, 0.0});
  if (contact)
    scene.sublist("Contact").set("Law", std::string("Frictionless"));
  Teuchos::ParameterList& adaptivity = scene.sublist("Adaptivity");
  adaptivity.set("Maximum Level", levels);
  adaptivity.set("Front Cells", 0.0);
  adaptivity.set("Interval", 1000000);
  Teuchos::ParameterList& box = adaptivity.sublist("Front");
  box.set("Lower Corner", numbers({0.001, 0.001, -0.004}));
  box.set("Upper Corner", numbers({0.004, 0.003, 0.008}));
  box.set("Level", levels);
  if (substeps)
    scene.sublist("Sub-Cycling").set("Levels", levels);
  return start<3>(scene);
}

/// What became of a block whose halves run apart, or into one another.
struct Outcome
{
  double mean = 0.0;     ///< energy over the last third of the steps, over that in the beginning
  double layer = 0.0;    ///< most energy of contact
  double springs = 0.0;  ///< most energy of springs
  double momentum = 0.0; ///< largest change, over mass times speed
  double half = 0.0;     ///< momentum of the upper half in the end, over that in the beginning
};

/// \param end time, 0: 60 steps
Outcome follow(Run<3>& run, bool apart, double end = 0.0)
{
  State<3>& state = run.state();
  setVelocity(state,
              [apart](const Vector<3>& x)
              {
                const double up = apart == (x[1] > 0.5 * height) ? speed : -speed;
                return Vector<3>{{0.0, up, 0.2 * speed * x[0] / 0.006}};
              });
  measureEnergy(state);
  const double given = state.energy.kinetic, mass = density * 0.006 * height * 0.004;
  const Vector<3> momentum = state.sample.momentum;
  Outcome o;
  int samples = 0;
  for (int k = 0; end > 0.0 ? state.clock.time < end : k < 60; ++k)
  {
    run.step(end > 0.0 ? end : 1.0, false);
    measureEnergy(state);
    if (k >= 40)
    {
      o.mean += (state.energy.kinetic + state.energy.strain + state.energy.contact) / given;
      ++samples;
    }
    o.layer = std::max(o.layer, state.energy.contact / given);
    o.springs = std::max(o.springs, state.energy.springs / given);
    o.momentum = std::max(o.momentum, norm(state.sample.momentum - momentum) / (mass * speed));
  }
  o.mean /= samples;
  const auto copy = [](const auto& view) { return onHost(view); };
  const auto v = copy(state.particles.real<3>(fields::velocity));
  const auto m = copy(state.particles.scalar(fields::mass));
  const auto side = copy(state.particles.real<3>(fields::reference));
  for (int p = 0; p < state.particles.size(); ++p)
    if (side(p, 1) > 0.5 * height)
      o.half += m(p) * v(p, 1) / (0.5 * mass * (apart ? speed : -speed));
  return o;
}

} // namespace

/// No momentum comes from contact, and no energy: the mean over some steps wavers less than that of single
/// ones, and stands by (w dt)^2 / 8 too high for a motion of frequency w, as kinetic energy is that at the
/// end of the impulses; 0.012 for waves across the block, more for faster ones. Three percent is the accuracy
/// of substeps from rough starts.
TEST(SubCycling3D, AreStableWithContact)
{
  for (const int levels : {1, 2})
  {
    const Outcome o = follow(*crackedBlock(levels, true, true), false);
    std::printf("%d levels: %.4f of the energy in the end, %.4f in the layer between faces, %.1e in springs; "
                "momentum by %.1e\n",
                levels, o.mean, o.layer, o.springs, o.momentum);
    EXPECT_GT(o.layer, 0.01);
    EXPECT_LT(o.mean, 1.03);
    EXPECT_LT(o.momentum, 1e-12);
  }
}

/// Halves that run apart and are held by the material before the front and by springs. A motion of frequency
/// w is seen by steps dt at a frequency off by the fraction (w dt)^2 / 24; that of the halves is no faster
/// than waves that cross the block's height and back, pi c / height, for which half a period is followed.
TEST(SubCycling3D, AreStableWithSprings)
{
  const double wave =
      std::sqrt(young / density * (1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson)));
  for (const int levels : {1, 2})
  {
    const double frequency = std::acos(-1.0) * wave / height, end = std::acos(-1.0) / frequency;
    const auto some = crackedBlock(levels, false, true), all = crackedBlock(levels, false, false);
    const double steps = frequency * some->stableTimeStep();
    const Outcome a = follow(*some, true, end), b = follow(*all, true, end);
    EXPECT_TRUE(some->state().cracks.frontSprings);
    std::printf(
        "%d levels: upper half %.5f, in substeps only %.5f, may differ by %.1e; %.1e in springs; momentum "
        "by %.1e\n",
        levels, a.half, b.half, std::acos(-1.0) * steps * steps / 24.0, a.springs, a.momentum);
    EXPECT_GT(a.springs, 0.0);
    EXPECT_NEAR(a.half, b.half, std::acos(-1.0) * steps * steps / 24.0);
    EXPECT_LT(a.momentum, 1e-12);
  }
}
