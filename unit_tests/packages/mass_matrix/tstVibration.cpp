/// A bar that vibrates freely, with each mass matrix: what it keeps of its energy over ten periods, and how
/// long they are.
///
/// The bar of unit_tests/src/step/tstFreeVibration.cpp: n cells, free ends, mode j, kh = pi j / n. On nodes
/// with lumped mass its frequency is w0 = (2 c / h) sin(kh / 2). With two particles along a cell the
/// consistent mass of the mode is S = (5 + 3 cos kh) / 8 of the lumped one. A matrix that makes a = f / m and
/// v = p / m with m times the lumped mass, and particles that keep the fraction g of their velocity's
/// amplitude V, step by
///
///     V' = g V - dt w0^2 u / m,   u' = u + dt (S / m) V'
///
/// so that sin(w dt / 2) = w0 sqrt(S) dt / 2m where g = 1, and a step leaves g of the energy. Lumped m = 1,
/// Full m = (1 - eps) S + eps, FMPM(2) 1 / m = 2 - S. FLIP has g = 1. PIC has g = S / m, and the series of
/// order 2 of XPIC and FMPM, with lumped m, has g = S (2 - S).

#include "../../src/step/Vibration.hpp"

#include <cmath>
#include <cstdio>

namespace Rhegma
{
namespace Test
{

namespace
{

constexpr double lumpedFraction = 0.1;

struct Case
{
  const char* name;
  const char* type;
  const char* update;
};

Vibration vibrateWith(const Case& c, const std::string& shape, int mode, double period)
{
  Teuchos::ParameterList scene = barScene<2>("MUSL", shape);
  scene.sublist("Time").set("CFL", 0.3);
  scene.sublist("Mass Matrix").set("Type", c.type);
  scene.sublist("Mass Matrix").set("Velocity Update", c.update);
  return vibrate<2>(scene, mode, period);
}

/// S, and w0, of a mode.
struct Wave
{
  explicit Wave(int mode)
      : kh(pi * mode / barCells), smoothed((5.0 + 3.0 * std::cos(kh)) / 8.0), lumped(2.0 * std::sin(0.5 * kh))
  {
  }
  /// Mass of the mode next to the lumped one.
  double massOf(const std::string& type) const
  {
    return type == "Full"   ? (1.0 - lumpedFraction) * smoothed + lumpedFraction
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
        const Vibration v = vibrateWith(c, shape, mode, wave.periodOf(c.type, 0.3));
        const double derived = wave.periodOf(c.type, v.dt), ideal = 2.0 * barCells / mode;
        std::printf("%s, %s, %d cells a wave: energy kept over ten periods %.5f, period %+.3f %%, derived "
                    "%+.3f %%\n",
                    c.name, shape, 2 * barCells / mode, v.kept, 100.0 * (v.period / ideal - 1.0),
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
    const Vibration v = vibrateWith(c, "Linear", 1, 2.0 * barCells);
    const bool series = std::string(c.update) != "PIC";
    const double fraction =
        series ? wave.smoothed * (2.0 - wave.smoothed) : wave.smoothed / wave.massOf(c.type);
    const double lost = -std::log(v.kept), derived = -std::log(fraction) * 10.0 * 2.0 * barCells / v.dt;
    std::printf("%s: energy kept over ten periods %.5f, derived %.5f\n", c.name, v.kept, std::exp(-derived));
    EXPECT_NEAR(lost, derived, 0.02 * derived) << c.name;
  }
}

} // namespace Test
} // namespace Rhegma
