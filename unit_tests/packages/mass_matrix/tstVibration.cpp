/// A bar that vibrates freely, with each mass matrix: what it keeps of its energy over ten periods, and how
/// long they are.
///
/// The bar of unit_tests/src/step/tstFreeVibration.cpp: n cells, free ends, mode j, kh = pi j / n. On nodes
/// with lumped mass its frequency is w0 = (2 c / h) sin(kh / 2). With two particles along a cell the
/// consistent mass of the mode is S = (5 + 3 cos kh) / 8 of the lumped one. A matrix that makes a = f / m and
/// v = p / m with m times the lumped mass, and particles that keep the share g of their velocity's amplitude
/// V, step by
///
///     V' = g V - dt w0^2 u / m,   u' = u + dt (S / m) V'
///
/// so that sin(w dt / 2) = w0 sqrt(S) dt / 2m where g = 1, and a step leaves g of the energy. Lumped m = 1,
/// Full m = (1 - eps) S + eps, FMPM(2) 1 / m = 2 - S. FLIP has g = 1. PIC has g = S / m, and the series of
/// order 2 of XPIC and FMPM, with lumped m, has g = S (2 - S).

#include "../../src/step/Bodies.hpp"

#include <cmath>
#include <cstdio>

namespace Rhegma
{
namespace Test
{

namespace
{

constexpr double pi = 3.14159265358979323846;
constexpr int cells = 16;
constexpr double amplitude = 1e-5;
constexpr double lumpedShare = 0.1;

struct Case
{
  const char* name;
  const char* type;
  const char* update;
};

struct Vibration
{
  double kept = 0.0;   ///< mean energy of the eleventh period over that of the first
  double period = 0.0; ///< mean of ten [s]
  double dt = 0.0;
};

/// Mode `mode` at x as linear functions between nodes have it.
double shapeAt(double x, int mode)
{
  const double k = pi * mode / cells;
  const double node = std::floor(x), s = x - node;
  return (1.0 - s) * std::cos(k * node) + s * std::cos(k * (node + 1.0));
}

/// \param period over which energies are averaged [s]
Vibration vibrate(const Case& c, const std::string& shape, int mode, double period)
{
  Teuchos::ParameterList scene =
      emptyScene<2>(Vector<2>{{-2.0, -2.0}}, Vector<2>{{cells + 2.0, 4.0}}, 1.0, "MUSL", shape);
  addMaterial(scene, "Linear Elastic", 0.0);
  addBox<2>(scene, "Bar", Vector<2>{{0.0, 0.0}}, Vector<2>{{cells, 2.0}});
  scene.sublist("Time").set("CFL", 0.3);
  scene.sublist("Mass Matrix").set("Type", c.type);
  scene.sublist("Mass Matrix").set("Velocity Update", c.update);
  Rhegma::Run<2> run(validated(scene));
  run.initialize();
  State<2>& state = run.state();
  const auto id = [&state]
  { return Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, state.particles.integer(fields::id)); };
  std::vector<double> of(state.particles.size());
  {
    const HostParticles<2> particles(state);
    const auto number = id();
    for (int p = 0; p < particles.size; ++p)
    {
      of[number(p)] = shapeAt(particles.position(p, 0), mode);
      particles.velocity(p, 0) = amplitude * of[number(p)];
    }
    particles.store(state);
  }

  Vibration result;
  std::vector<double> crossings;
  double energy[11] = {}, weight[11] = {}, before = amplitude, timeBefore = 0.0;
  while (state.time < 11.0 * period || (crossings.size() < 21 && state.time < 13.0 * period))
  {
    run.step(1e30, false);
    result.dt = state.dt;
    measureEnergy(state);
    const int n = std::min(10, static_cast<int>(state.time / period));
    if (state.time < 11.0 * period)
      energy[n] += state.dt * (state.energy.kinetic + state.energy.strain);
    weight[n] += state.time < 11.0 * period ? state.dt : 0.0;
    const HostParticles<2> particles(state);
    const auto number = id();
    double modal = 0.0;
    for (int p = 0; p < particles.size; ++p)
      modal += particles.mass(p) * of[number(p)] * particles.velocity(p, 0);
    if (modal * before < 0.0)
      crossings.push_back(timeBefore + (state.time - timeBefore) * before / (before - modal));
    before = modal;
    timeBefore = state.time;
  }
  result.kept = energy[10] / weight[10] / (energy[0] / weight[0]);
  EXPECT_GE(crossings.size(), 21u) << c.name;
  result.period = crossings.size() > 20 ? (crossings[20] - crossings[0]) / 10.0 : 0.0;
  return result;
}

/// S, and w0, of a mode.
struct Wave
{
  explicit Wave(int mode)
      : kh(pi * mode / cells), smoothed((5.0 + 3.0 * std::cos(kh)) / 8.0), lumped(2.0 * std::sin(0.5 * kh))
  {
  }
  /// Mass of the mode beside the lumped one.
  double massOf(const std::string& type) const
  {
    return type == "Full"   ? (1.0 - lumpedShare) * smoothed + lumpedShare
           : type == "FMPM" ? 1.0 / (2.0 - smoothed)
                            : 1.0;
  }
  /// The period with steps of dt. [s]
  double periodOf(const std::string& type, double dt) const
  {
    return pi * dt / std::asin(0.5 * lumped * std::sqrt(smoothed) * dt / massOf(type));
  }
  double kh, smoothed, lumped;
};

} // namespace

/// Modes of 32 and of 8 cells a wave: what a pulse is made of.
TEST(Vibration, KeepsItsEnergyAndHasThePeriodOfItsMatrix)
{
  for (const int mode : {1, 4})
    for (const Case& c :
         {Case{"Lumped", "Lumped", "FLIP"}, Case{"Full", "Full", "FLIP"}, Case{"FMPM(2)", "FMPM", "FLIP"}})
      for (const char* shape : {"Linear", "GIMP"})
      {
        // Boxes that reach past the bar's ends leave their particles lumped, which short waves notice.
        if (mode == 4 && shape[0] == 'G')
          continue;
        const Wave wave(mode);
        const Vibration v = vibrate(c, shape, mode, wave.periodOf(c.type, 0.3));
        const double derived = wave.periodOf(c.type, v.dt), ideal = 2.0 * cells / mode;
        std::printf("%s, %s, %d cells a wave: energy kept over ten periods %.5f, period %+.3f %%, derived "
                    "%+.3f %%\n",
                    c.name, shape, 2 * cells / mode, v.kept, 100.0 * (v.period / ideal - 1.0),
                    100.0 * (derived / ideal - 1.0));
        EXPECT_NEAR(v.kept, 1.0, 1e-3) << c.name << " " << shape << " mode " << mode;
        EXPECT_NEAR(v.period, derived, 2e-4 * derived) << c.name << " " << shape << " mode " << mode;
      }
}

TEST(Vibration, LosesWhatTheVelocityUpdateFilters)
{
  const Wave wave(1);
  for (const Case& c : {Case{"PIC", "Lumped", "PIC"}, Case{"PIC with Full", "Full", "PIC"},
                        Case{"XPIC(2)", "Lumped", "XPIC"}, Case{"FMPM(2) update", "Lumped", "FMPM"}})
  {
    const Vibration v = vibrate(c, "Linear", 1, 2.0 * cells);
    const bool series = std::string(c.update) != "PIC";
    const double share = series ? wave.smoothed * (2.0 - wave.smoothed) : wave.smoothed / wave.massOf(c.type);
    const double lost = -std::log(v.kept), derived = -std::log(share) * 10.0 * 2.0 * cells / v.dt;
    std::printf("%s: energy kept over ten periods %.5f, derived %.5f\n", c.name, v.kept, std::exp(-derived));
    EXPECT_NEAR(lost, derived, 0.02 * derived) << c.name;
  }
}

} // namespace Test
} // namespace Rhegma
