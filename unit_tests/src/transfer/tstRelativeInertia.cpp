/// Inertia against the relative motion of two masses: springs of any stiffness are stable with it.

#include "transfer/Motion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>

namespace Rhegma
{

/// Masses m1 and m2 under forces f1 and f2 part with (f1 / m1 - f2 / m2) m0 / (m0 + added), m0 their reduced
/// mass, and the sum of the forces stays the same.
TEST(RelativeInertia, SlowsTheRelativeMotionAlone)
{
  const double m1 = 2.0, m2 = 3.0, f1 = 5.0, f2 = -4.0, added = 0.7, reduced = 1.2;
  const double taken = takenByInertia(m1, m2, f1, f2, added);
  const double apart = (f1 - taken) / m1 - (f2 + taken) / m2;
  EXPECT_NEAR(apart, (f1 / m1 - f2 / m2) * reduced / (reduced + added), 1e-14);
  EXPECT_NEAR(taken, added * apart, 1e-14);
  EXPECT_EQ(takenByInertia(m1, m2, f1, f2, 0.0), 0.0);
}

namespace
{

constexpr int nodes = 8, particles = 14;

/// Two bars of four nodes in a line whose first and last nodes are joined by springs of 1 N/m in each bar;
/// the stiff spring joins the last node of one to the first of the other. Two particles a cell carry the
/// velocity.
struct Bars
{
  std::array<double, particles> mass, velocity;
  std::array<double, nodes> displacement{}, lumped{};
  double stiff, added;

  static bool isSplit(int cell) { return cell == 3; } ///< no particle between the bars
  static double weight(int p) { return p % 2 == 0 ? 0.75 : 0.25; }
  static int cellOf(int p) { return p / 2; }

  template <class To>
  void toNodes(const std::array<double, particles>& value, To& to) const
  {
    to.fill(0.0);
    for (int p = 0; p < particles; ++p)
      if (!isSplit(cellOf(p)))
      {
        to[cellOf(p)] += weight(p) * mass[p] * value[p];
        to[cellOf(p) + 1] += (1.0 - weight(p)) * mass[p] * value[p];
      }
  }

  void slow(std::array<double, nodes>& value) const
  {
    const double taken = takenByInertia(lumped[3], lumped[4], value[3], value[4], added);
    value[3] -= taken;
    value[4] += taken;
  }

  std::array<double, nodes> force() const
  {
    std::array<double, nodes> f{};
    for (int cell = 0; cell + 1 < nodes; ++cell)
    {
      const double k = isSplit(cell) ? stiff : 1.0, pull = k * (displacement[cell + 1] - displacement[cell]);
      f[cell] += pull;
      f[cell + 1] -= pull;
    }
    return f;
  }

  double stored() const
  {
    double sum = 0.0;
    for (int cell = 0; cell + 1 < nodes; ++cell)
    {
      const double stretch = displacement[cell + 1] - displacement[cell];
      sum += 0.5 * (isSplit(cell) ? stiff : 1.0) * stretch * stretch;
    }
    return sum;
  }

  /// A step of MUSL with FLIP. \param also whether the velocity that stretches the springs is slowed, too
  /// \return the energy that such a step keeps: with the velocities before and after it
  double step(double dt, bool also)
  {
    std::array<double, nodes> f = force(), moved;
    const double before = stored();
    slow(f);
    double kinetic = 0.0;
    for (int p = 0; p < particles; ++p)
      if (!isSplit(cellOf(p)))
      {
        const int n = cellOf(p);
        const double acceleration =
            weight(p) * f[n] / lumped[n] + (1.0 - weight(p)) * f[n + 1] / lumped[n + 1];
        kinetic += 0.5 * mass[p] * velocity[p] * (velocity[p] + dt * acceleration);
        velocity[p] += dt * acceleration;
      }
    toNodes(velocity, moved);
    if (also)
      slow(moved);
    for (int n = 0; n < nodes; ++n)
      displacement[n] += dt * moved[n] / lumped[n];
    return kinetic + before;
  }
};

Bars randomBars(std::mt19937& random, double dt)
{
  std::uniform_real_distribution<double> number(-1.0, 1.0), exponent(1.0, 5.0);
  Bars bars;
  std::array<double, particles> ones;
  ones.fill(1.0);
  for (int p = 0; p < particles; ++p)
  {
    bars.mass[p] = 1.0 + 0.4 * number(random);
    bars.velocity[p] = number(random);
  }
  bars.toNodes(ones, bars.lumped);
  bars.stiff = std::pow(10.0, exponent(random));
  bars.added = 0.25 * bars.stiff * dt * dt;
  return bars;
}

} // namespace

/// With a quarter of S dt^2 a step keeps v (v + dt a) / 2 + u K u / 2, as any step that is symmetric, if the
/// force and the velocity are slowed; the material's frequencies are at most sqrt(4 N/m over 0.6 kg) here.
TEST(RelativeInertia, MakesStiffSpringsStableAndKeepsTheEnergy)
{
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  const double dt = 0.9 * 2.0 / std::sqrt(4.0 / 0.6);
  double worst = 0.0, worstOfForce = 0.0;
  for (int draw = 0; draw < 50; ++draw)
  {
    const Bars start = randomBars(random, dt);
    for (const bool also : {true, false})
    {
      Bars bars = start;
      const double first = bars.step(dt, also);
      double change = 0.0;
      for (int k = 0; k < 5000; ++k)
        change = std::max(change, std::fabs(bars.step(dt, also) / first - 1.0));
      (also ? worst : worstOfForce) = std::max(also ? worst : worstOfForce, change);
    }
  }
  EXPECT_LT(worst, 1e-8);       // rounding of 5,000 steps, of springs up to 1e5 times stiffer than the rest
  EXPECT_GT(worstOfForce, 0.1); // on forces alone it is another energy that changes
}

} // namespace Rhegma
