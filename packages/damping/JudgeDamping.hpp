#pragma once
/// Whether damping leaves any motion (docs/plausibility.md).

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "plausibility/BodyMeasures.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::damping
{

/// Warns where a body can't come near rest before the end. With mass damping r its longest wave, of frequency
/// w = pi c / L, creeps there in the time r / w^2, with a viscosity in (2 eta + zeta) / M.
/// \param rate [1/s] \param shear viscosity \param bulk viscosity [Pa s] \param end of damping or run [s]
template <int D>
void judgeDamping(double rate, double shear, double bulk, double end, State<D>& state)
{
  constexpr double pi = 3.14159265358979;
  const BodyMeasure<D>* quick = nullptr;
  const std::vector<BodyMeasure<D>> bodies = measureBodies(state);
  for (const BodyMeasure<D>& body : bodies)
    if (quick == nullptr || body.longest / body.speed < quick->longest / quick->speed)
      quick = &body;
  if (quick == nullptr)
    return;
  const double frequency = pi * quick->speed / quick->longest, creep = rate / (frequency * frequency);
  if (creep > end)
    state.warnings.push_back("Damping > Mass Rate is " + formatReal(rate) + " 1/s: body " + quick->name +
                             ", " + readableLength(quick->longest) + " long, moves to its rest in about " +
                             readableTime(creep) + ", and is damped for " + readableTime(end) +
                             ": it hardly moves at all; its longest wave is critically damped at " +
                             formatShort(2.0 * frequency) + " 1/s");
  const double ofStep = rate * state.method.cfl * state.mesh.smallestSpacing() / quick->speed;
  if (ofStep > 1.0)
    state.warnings.push_back(
        "Damping > Mass Rate is " + formatReal(rate) + " 1/s, " + formatShort(ofStep) +
        " times 1 over the stable step: a body loses its velocity in each step, and what "
        "moves is an artefact of the step; write less than " +
        formatShort(0.1 * rate / ofStep) + " 1/s");
  const double retardation = (2.0 * shear + bulk) / quick->moduli.constrainedModulus;
  if (retardation > end / 3.0)
    state.warnings.push_back(
        "Damping > " + std::string(2.0 * shear > bulk ? "Shear Viscosity" : "Bulk Viscosity") +
        ": viscosity over stiffness is " + readableTime(retardation) + ", and the body is damped for " +
        readableTime(end) + ": it hardly strains at all; viscosities are in Pa s");
}

} // namespace Rhegma::damping
