/// A pulse along a bar, with each mass matrix: how far it stays behind, and what it keeps of its shape.
///
/// The bar and the waves are those of tstVibration.cpp. The nodes within 4 cells of a free end start with the
/// velocity A cos^2(pi x / 8); what leaves the end is a pulse of 8 cells and half the height. In modes of the
/// bar its velocity is the sum of c_j cos(pi j x / n), and each amplitude steps by
///
///     V' = V - dt w0^2 u / m,   u' = u + dt (S / m) V'
///
/// with w0, S and m of the mode: which is the dispersion relation of tstVibration.cpp, ends and start
/// included.

#include "../../src/step/Bodies.hpp"
#include "Pi.hpp"

#include <cmath>
#include <cstdio>

namespace Rhegma
{
namespace Test
{

namespace
{

using Rhegma::Test::pi;
constexpr int cells = 64;
constexpr double width = 8.0;   ///< of the pulse [cells]
constexpr double travel = 50.0; ///< cells, and seconds, as waves go at 1 m/s
constexpr double height = 1e-6; ///< A [m/s]
constexpr double lumpedFraction = 0.1;

/// The pulse about its middle, 1 there.
double hump(double x) { return std::fabs(x) < 0.5 * width ? std::pow(std::cos(pi * x / width), 2) : 0.0; }

/// A function between nodes, given at them.
template <class Function>
double interpolated(const Function& f, double x)
{
  const double node = std::floor(x), s = x - node;
  return (1.0 - s) * f(node) + s * f(node + 1.0);
}

/// Velocities over height / 2 of particles at positions along the bar.
struct Profile
{
  std::vector<double> x, v;
};

/// What the pulse is next to one that went `travel` cells unchanged.
struct Change
{
  double lag = 0.0;  ///< distance by which the latter fits best when it is moved back [cells]
  double lost = 0.0; ///< fraction of the velocities' square that it then leaves
  double peak = 0.0; ///< largest velocity
};

Change changeOf(const Profile& p)
{
  Change best;
  double fit = -1.0, square = 0.0;
  for (const double v : p.v)
  {
    square += v * v;
    best.peak = std::max(best.peak, v);
  }
  for (double lag = -4.0; lag < 4.0; lag += 0.002)
  {
    double product = 0.0, norm = 0.0;
    for (std::size_t k = 0; k < p.x.size(); ++k)
    {
      const double h = hump(p.x[k] - travel + lag);
      product += p.v[k] * h;
      norm += h * h;
    }
    const double fraction = product > 0.0 ? product * product / (norm * square) : 0.0;
    if (fraction > fit)
    {
      fit = fraction;
      best.lag = lag;
      best.lost = 1.0 - fraction;
    }
  }
  return best;
}

/// The modes' amplitudes, stepped.
class Modes
{
public:
  explicit Modes(const std::string& type)
  {
    for (int j = 0; j <= cells; ++j)
    {
      const double kh = pi * j / cells, smoothed = (5.0 + 3.0 * std::cos(kh)) / 8.0;
      const double m = type == "Full"   ? (1.0 - lumpedFraction) * smoothed + lumpedFraction
                       : type == "FMPM" ? 1.0 / (2.0 - smoothed)
                                        : 1.0;
      // Cosines on the nodes of the bar, the end nodes counted half, are at right angles to one another.
      double product = 0.0, norm = 0.0;
      for (int i = 0; i <= cells; ++i)
      {
        const double fraction = i == 0 || i == cells ? 0.5 : 1.0, wave = std::cos(kh * i);
        product += fraction * wave * hump(i);
        norm += fraction * wave * wave;
      }
      modes_.push_back({kh, std::pow(2.0 * std::sin(0.5 * kh), 2) / m, smoothed / m, product / norm, 0.0});
    }
  }

  void step(double dt)
  {
    for (Mode& mode : modes_)
    {
      mode.velocity -= dt * mode.stiffness * mode.strain;
      mode.strain += dt * mode.heard * mode.velocity;
    }
  }

  /// Over half the height.
  double velocityAt(double x) const
  {
    double sum = 0.0;
    for (const Mode& mode : modes_)
      sum += mode.velocity * interpolated([&mode](double node) { return std::cos(mode.kh * node); }, x);
    return 2.0 * sum;
  }

private:
  struct Mode
  {
    double kh, stiffness, heard, velocity, strain;
  };
  std::vector<Mode> modes_;
};

} // namespace

TEST(Pulse, TrailsAsTheDispersionOfItsMatrixHasIt)
{
  std::vector<Change> changes;
  for (const std::string type : {"Lumped", "Full", "FMPM"})
  {
    Teuchos::ParameterList scene =
        emptyScene<2>(Vector<2>{{-2.0, -2.0}}, Vector<2>{{cells + 2.0, 4.0}}, 1.0, "MUSL", "Linear");
    addMaterial(scene, "Linear Elastic", 0.0);
    addBox<2>(scene, "Bar", Vector<2>{{0.0, 0.0}}, Vector<2>{{cells, 2.0}});
    scene.sublist("Time").set("CFL", 0.3);
    scene.sublist("Mass Matrix").set("Type", type);
    Rhegma::Run<2> run(validated(scene));
    run.initialize();
    State<2>& state = run.state();
    {
      const HostParticles<2> particles(state);
      for (int p = 0; p < particles.size; ++p)
        particles.velocity(p, 0) = height * interpolated(hump, particles.position(p, 0));
      particles.store(state);
    }
    Modes modes(type);
    while (state.clock.time < travel)
    {
      run.step(travel, false);
      modes.step(state.clock.dt);
    }
    Profile measured, derived;
    const HostParticles<2> particles(state);
    double difference = 0.0;
    for (int p = 0; p < particles.size; ++p)
    {
      const double x = particles.position(p, 0);
      measured.x.push_back(x);
      measured.v.push_back(2.0 * particles.velocity(p, 0) / height);
      derived.v.push_back(modes.velocityAt(x));
      difference = std::max(difference, std::fabs(measured.v.back() - derived.v.back()));
    }
    derived.x = measured.x;
    const Change is = changeOf(measured), asDerived = changeOf(derived);
    std::printf("%s: after %g cells %.2f cells behind (derived %.2f), height %.3f (%.3f), out of shape %.1f "
                "%% (%.1f %%), largest difference from the derived pulse %.1e of its height\n",
                type.c_str(), travel, is.lag, asDerived.lag, is.peak, asDerived.peak, 100.0 * is.lost,
                100.0 * asDerived.lost, difference);
    // Strains of 1e-6 and solves to 1e-6 leave no more.
    EXPECT_LT(difference, 1e-3) << type;
    EXPECT_NEAR(is.lag, asDerived.lag, 0.01) << type;
    changes.push_back(is);
  }
  // Long waves: (kh)^2 (1/24 + 3/32) late with lumped mass; with Full and FMPM(2) about a third of it early.
  EXPECT_GT(changes[0].lag, 0.0);
  for (const int k : {1, 2})
  {
    EXPECT_LT(std::fabs(changes[k].lag), 0.5 * changes[0].lag);
    EXPECT_LT(changes[k].lost, changes[0].lost);
  }
}

} // namespace Test
} // namespace Rhegma
