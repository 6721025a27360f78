#include "energy_release/DrivingForces.hpp"

#include "archive/Archive.hpp"
#include "energy_release/CrackTipFields.hpp"
#include "energy_release/DomainIntegral.hpp"
#include "transfer/LocalSpacing.hpp"

#include <algorithm>
#include <string>

namespace Rhegma::energy_release
{

namespace
{

/// Cells by which a front may move before its radii are found anew, unless its cells change.
constexpr double lookAgain = 1.0;
/// Smallest radii [cells].
constexpr double leastOuter = 2.0, leastInner = 1.0;

ContourRadii fitting(double inner, double outer, double room, double cell)
{
  ContourRadii radii;
  radii.outer = std::max(std::min(outer * cell, room), leastOuter * cell);
  // The weight falls over two cells at least, and over half of the radius where there is no room.
  radii.inner = std::min(inner * cell, std::max(radii.outer - 2.0 * cell, 0.5 * radii.outer));
  radii.inner = std::max(radii.inner, leastInner * cell);
  return radii;
}

} // namespace

const DrivingForces::Contours& DrivingForces::contoursOf(const State<2>& state, std::size_t f)
{
  contours_.resize(state.cracks.fronts.size());
  Contours& own = contours_[f];
  const CrackFront<2>& front = state.cracks.fronts[f];
  const double cell = spacingAt(state, front.position);
  if (own.cell == cell && norm(front.position - own.at) < lookAgain * own.cell)
    return own;
  own.at = front.position;
  own.cell = cell;
  const DrivingContours& wanted = state.cracks.drivingContours;
  const double room =
      roomAround(state, front, std::max(wanted.releaseOuter, wanted.intensityOuter) * own.cell);
  own.release = fitting(wanted.releaseInner, wanted.releaseOuter, room, own.cell);
  own.intensity = fitting(wanted.intensityInner, wanted.intensityOuter, room, own.cell);
  return own;
}

void DrivingForces::measureRelease(State<2>& state)
{
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    CrackFront<2>& front = state.cracks.fronts[f];
    if (front.ended || front.stopped())
      continue;
    const ContourRadii radii = contoursOf(state, f).release;
    internalAcceleration(state, front.position, accelerationReach(state, radii), acceleration_);
    front.nodes[0].driving.release = integrateRelease(state, front, radii, acceleration_);
  }
}

void DrivingForces::measureIntensities(State<2>& state)
{
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    CrackFront<2>& front = state.cracks.fronts[f];
    if (!front.advances())
      continue;
    const ContourRadii radii = contoursOf(state, f).intensity;
    internalAcceleration(state, front.position, accelerationReach(state, radii), acceleration_);
    const DomainIntegral integral = integrateDomain(state, front, radii, acceleration_);
    front.nodes[0].driving.modeI = integral.modeI;
    front.nodes[0].driving.modeII = integral.modeII;
    // Faces that touch do not overlap: a mode I that closes is none.
    front.nodes[0].driving.hoopAngle = hoopStressAngle(std::max(integral.modeI, 0.0), integral.modeII);
  }
}

void DrivingForces::keep(Archive& archive)
{
  int count = static_cast<int>(contours_.size());
  archive("fronts", count);
  contours_.resize(count);
  for (int k = 0; k < count; ++k)
  {
    const Archive::Group group(archive, "contours " + std::to_string(k));
    archive("at", contours_[k].at);
    archive("cell", contours_[k].cell);
    archive("release_inner", contours_[k].release.inner);
    archive("release_outer", contours_[k].release.outer);
    archive("intensity_inner", contours_[k].intensity.inner);
    archive("intensity_outer", contours_[k].intensity.outer);
  }
}

} // namespace Rhegma::energy_release
