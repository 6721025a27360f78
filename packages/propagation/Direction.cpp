#include "propagation/Direction.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::propagation
{

namespace
{

const double pi = 4.0 * std::atan(1.0);

} // namespace

double kinkedRelease(double angle, double modeI, double modeII)
{
  const double m = angle / pi, m2 = m * m, p2 = pi * pi;
  const auto series = [&](std::initializer_list<double> terms)
  {
    double sum = 0.0, power = 1.0;
    for (const double term : terms)
    {
      sum += term * power;
      power *= m2;
    }
    return sum;
  };
  const double p4 = p2 * p2, p6 = p4 * p2;
  const double F11 =
      series({1.0, -3.0 * p2 / 8.0, p2 - 5.0 * p4 / 128.0, p2 / 9.0 - 11.0 * p4 / 72.0 + 119.0 * p6 / 15360.0,
              5.07790, -2.88312, -0.0925, 2.996, -4.059, 1.63, 4.1});
  const double F12 = m * series({-1.5 * pi, 10.0 * pi / 3.0 + pi * p2 / 16.0,
                                 -2.0 * pi - 133.0 * pi * p2 / 180.0 + 59.0 * pi * p4 / 1280.0, 12.313906,
                                 -7.32433, 1.5793, 4.0216, -6.915, 4.21, 4.56});
  const double F21 = m * series({0.5 * pi, -4.0 * pi / 3.0 - pi * p2 / 48.0,
                                 -2.0 * pi / 3.0 + 13.0 * pi * p2 / 30.0 - 59.0 * pi * p4 / 3840.0, -6.176023,
                                 4.44112, -1.5340, -2.0700, 4.684, -3.95, -1.32});
  const double F22 = series({1.0, -(4.0 + 3.0 * p2 / 8.0), 8.0 / 3.0 + 29.0 * p2 / 18.0 - 5.0 * p4 / 128.0,
                             -32.0 / 15.0 - 4.0 * p2 / 9.0 - 1159.0 * p4 / 7200.0 + 119.0 * p6 / 15360.0,
                             10.58254, -4.78511, -1.8804, 7.280, -7.591, 0.25, 12.5});
  const double kI = F11 * modeI + F12 * modeII, kII = F21 * modeI + F22 * modeII;
  return kI * kI + kII * kII;
}

double energyReleaseAngle(double modeI, double modeII)
{
  // The kink turns to the side where sliding opens it.
  const double sign = modeII > 0.0 ? -1.0 : 1.0;
  return sign *
         largestIn(0.0, mostTurn, [&](double angle) { return kinkedRelease(sign * angle, modeI, modeII); });
}

double turningAngle(const DrivingForce& driving, DirectionRule rule)
{
  if (rule == DirectionRule::HoopStress)
    return driving.hoopAngle;
  if (rule == DirectionRule::EnergyRelease)
    return energyReleaseAngle(std::max(driving.modeI, 0.0), driving.modeII);
  return 0.0;
}

} // namespace Rhegma::propagation
