/// Inertia against the relative motion of two masses: springs of any stiffness are stable with it.

#include "transfer/Motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace Rhegma
{

/// Masses m1 and m2 under forces f1 and f2 part with (f1 / m1 - f2 / m2) m0 / (m0 + added), m0 their reduced
/// mass, and the sum of the forces stays the same.
TEST(RelativeInertia, SlowsTheRelativeMotionAlone)
{
  const double m1 = 2.0, m2 = 3.0, f1 = 5.0, f2 = -4.0, added = 0.7, reduced = 1.2;
  const double force = relativeInertiaForce(m1, m2, f1, f2, added);
  const double apart = (f1 + force) / m1 - (f2 - force) / m2;
  EXPECT_NEAR(apart, (f1 / m1 - f2 / m2) * reduced / (reduced + added), 1e-14);
  EXPECT_NEAR(force, -added * apart, 1e-14);
  EXPECT_EQ(relativeInertiaForce(m1, m2, f1, f2, 0.0), 0.0);
}

/// A chain of masses in steps just below the limit of its own springs, one of which is between two masses
/// that a far stiffer spring joins: stable with S dt^2 / 4 of added mass, unstable without.
TEST(RelativeInertia, MakesStiffSpringsStable)
{
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1.0, 1.0), exponent(0.5, 5.0);
  const int count = 8;
  for (int draw = 0; draw < 50; ++draw)
  {
    std::vector<double> mass(count), start(count);
    for (int i = 0; i < count; ++i)
    {
      mass[i] = 1.0 + 0.5 * number(random);
      start[i] = number(random);
    }
    // Gershgorin: a frequency is at most sqrt(4 / 0.5), of springs of 1 N/m and masses of at least 0.5 kg.
    const double dt = 0.999 * 2.0 / std::sqrt(8.0), stiff = std::pow(10.0, exponent(random));
    for (const double quarter : {0.25, 0.0})
    {
      std::vector<double> x = start, v(count, 0.0), force(count);
      double largest = 0.0;
      for (int step = 0; step < 4000; ++step)
      {
        for (int i = 0; i < count; ++i)
          force[i] = x[(i + 1) % count] + x[(i + count - 1) % count] - 2.0 * x[i];
        const double pull = stiff * (x[3] - x[4]);
        force[3] -= pull;
        force[4] += pull;
        const double inertia =
            relativeInertiaForce(mass[3], mass[4], force[3], force[4], quarter * stiff * dt * dt);
        force[3] += inertia;
        force[4] -= inertia;
        for (int i = 0; i < count; ++i)
        {
          v[i] += dt * force[i] / mass[i];
          x[i] += dt * v[i];
          largest = std::max(largest, std::fabs(x[i]));
        }
        if (largest > 1e6)
          break;
      }
      if (quarter > 0.0)
      {
        EXPECT_LT(largest, 1e3) << "stiffness " << stiff;
      }
      else if (stiff * dt * dt > 8.0) // 4 m0, m0 of at most 0.75 kg, and the material's part
      {
        EXPECT_GT(largest, 1e6) << "stiffness " << stiff;
      }
    }
  }
}

} // namespace Rhegma
