#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "plausibility/Judges.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma
{

namespace
{

/// Fraction of the kinetic energy of a wave that its damping by PIC takes in a time. What particles give to
/// nodes and take back is their velocity times S = 1 - (k h)^2 / 6 or less: each of both spreads it by linear
/// functions, whose variance over the positions in a cell is h^2 / 6; a fraction f of the difference is lost
/// in each step. A wave has half of its energy as kinetic energy, which damping takes: exp(-r t), r = f (1 -
/// S) / dt. \param cells of the wave
double lost(double fraction, double cells, double steps)
{
  constexpr double pi = 3.14159265358979;
  const double number = 2.0 * pi / cells; // k h
  return -std::expm1(-fraction * number * number / 6.0 * steps);
}

} // namespace

template <int D>
Messages judgePic(const JudgedScene<D>& judged)
{
  const Method& method = judged.state.method;
  // That of the scene: updates of other names have a fraction of 1, and losses of their own.
  const double fraction = judged.scene.sublist("Time").template get<double>("PIC Fraction");
  if (!method.mechanics || method.equilibrium() || !(fraction > 0.0) || judged.bodies.empty() ||
      !(judged.step > 0.0))
    return {};
  constexpr double shortest = 10.0, noticed = 0.1; // cells of a wave, part of its energy
  const auto longest = std::max_element(judged.bodies.begin(), judged.bodies.end(),
                                        [](const BodyMeasure<D>& a, const BodyMeasure<D>& b)
                                        { return a.longest < b.longest; });
  const double cell = judged.state.mesh.grid.spacing,
               end = judged.scene.sublist("Time").template get<double>("Final Time");
  const double steps = std::min(end / judged.step, double(judged.state.clock.maximumSteps));
  const double across = std::min(steps, longest->longest / longest->speed / judged.step);
  const double ofLong = lost(fraction, 2.0 * longest->longest / cell, steps),
               ofShort = lost(fraction, shortest, across);
  if (std::max(ofLong, ofShort) < noticed)
    return {};
  return {"Time > PIC Fraction is " + formatReal(fraction) + ": it takes about " +
          formatShort(100.0 * ofLong) + " % of the energy of the longest wave in Bodies > " + longest->name +
          " (" + readableLength(2.0 * longest->longest) + ") up to the end, and " +
          formatShort(100.0 * ofShort) + " % of that of waves of 10 cells (" +
          readableLength(shortest * cell) +
          ") while they cross the body; these losses are not part of the energy warning: write 0 for motion "
          "without damping, or Damping > Mass Rate for a rate that does not depend on cells and steps"};
}

template Messages judgePic(const JudgedScene<2>&);
template Messages judgePic(const JudgedScene<3>&);

} // namespace Rhegma
