#include "energy_release/DrivingForces.hpp"

#include "archive/Archive.hpp"
#include "energy_release/CrackTipFields.hpp"
#include "energy_release/DomainIntegral.hpp"
#include "energy_release/FrontIntegral.hpp"
#include "energy_release/FrontOpening.hpp"
#include "material/StartOfGrowth.hpp"
#include "plan/LastStage.hpp"
#include "transfer/LocalSpacing.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace Rhegma::energy_release
{

namespace
{

/// Cells by which a front node may move before its tube is fitted anew; in 3D slightly less than four
/// advances of a quarter of a cell, so that round-off does not decide.
template <int D>
constexpr double fitAgainAfter = D == 2 ? 1.0 : 0.9;

/// Positions of the nodes of a front, and of those of other fronts within a distance of its middle, one after
/// the other [m]: a crack that comes near leaves less room for the tube of a front that does not move.
template <int D>
std::vector<double> positionsAround(const State<D>& state, std::size_t f, double reach)
{
  const std::vector<CrackFront<D>>& fronts = state.cracks.fronts;
  std::vector<double> at;
  for (const FrontNode<D>& node : fronts[f].nodes)
    at.insert(at.end(), node.position.c, node.position.c + D);
  for (std::size_t g = 0; g < fronts.size(); ++g)
    for (const FrontNode<D>& node : fronts[g].nodes)
      if (g != f && norm(node.position - fronts[f].position) < reach)
        at.insert(at.end(), node.position.c, node.position.c + D);
  return at;
}

/// The largest distance of positions from where they were; infinite where they are others [m].
template <int D>
double largestMove(const std::vector<double>& before, const std::vector<double>& now)
{
  if (before.size() != now.size())
    return 1e300;
  double largest = 0.0;
  for (std::size_t k = 0; k < now.size(); k += D)
  {
    double square = 0.0;
    for (std::size_t d = k; d < k + D; ++d)
      square += (now[d] - before[d]) * (now[d] - before[d]);
    largest = std::max(largest, square);
  }
  return std::sqrt(largest);
}

/// Within this distance other fronts matter for tubes: one that is not yet in a tube, and what it moves by
/// until the tube is fitted anew [m].
double reachAround(const FrontTube& release, const FrontTube& intensity, double cell)
{
  constexpr double more = 4.0; // cells
  return 2.0 * std::max(release.radii.outer, intensity.radii.outer) + more * cell;
}

/// Smallest radii [cells].
constexpr double leastOuter = 2.0, leastInner = 1.0;

FrontTube fittingDisk(double inner, double outer, double clear, double cell)
{
  ContourRadii radii;
  radii.outer = std::max(std::min(outer * cell, clear), leastOuter * cell);
  // The weight falls over two cells at least, and over half of the radius where that does not fit.
  radii.inner = std::min(inner * cell, std::max(radii.outer - 2.0 * cell, 0.5 * radii.outer));
  radii.inner = std::max(radii.inner, leastInner * cell);
  return {radii, 0.0};
}

/// Tubes for J and for stress intensities.
void fitTubes(const State<2>& state, const CrackFront<2>& front, double cell, FrontTube& release,
              FrontTube& intensity)
{
  const DrivingContours& wanted = state.cracks.drivingContours;
  const double clear = clearAround(state, front, std::max(wanted.releaseOuter, wanted.intensityOuter) * cell);
  release = fittingDisk(wanted.releaseInner, wanted.releaseOuter, clear, cell);
  intensity = fittingDisk(wanted.intensityInner, wanted.intensityOuter, clear, cell);
}

void fitTubes(const State<3>& state, const CrackFront<3>& front, double, FrontTube& release,
              FrontTube& intensity)
{
  release = intensity = fittingTube(state, front, usualCells<3>());
}

/// The particles that accelerate the nodes in the integrals of a front.
Disk rangeOf(const State<2>& state, const CrackFront<2>& front, const FrontTube& tube)
{
  return accelerationRange(state, front, tube.radii);
}
Region<3> rangeOf(const State<3>& state, const CrackFront<3>& front, const FrontTube& tube)
{
  return accelerationRange(state, lineOf(front), tube);
}

/// J at the nodes of a front [J/m2]; none where it can't be computed.
std::vector<std::optional<double>> releaseAlong(const State<2>& state, const CrackFront<2>& front,
                                                const FrontTube& tube, InternalAcceleration<2>& acceleration,
                                                const FrontWork<2>& kept)
{
  return {integrateRelease(state, front, tube.radii, acceleration.around(state, rangeOf(state, front, tube)),
                           kept)};
}

std::vector<std::optional<double>> releaseAlong(const State<3>& state, const CrackFront<3>& front,
                                                const FrontTube& tube, InternalAcceleration<3>& acceleration,
                                                const FrontWork<3>& kept)
{
  return integrateAlongFront(state, front.crack, lineOf(front), tube, acceleration, kept);
}

/// Stress intensities at the nodes of a front.
std::vector<Intensities> intensitiesOf(const State<2>& state, const CrackFront<2>& front,
                                       const FrontTube& tube, InternalAcceleration<2>& acceleration,
                                       const FrontWork<2>& kept)
{
  const DomainIntegral integral = integrateDomain(
      state, front, tube.radii, acceleration.around(state, rangeOf(state, front, tube)), kept);
  return {{integral.modeI, integral.modeII, 0.0}};
}

std::vector<Intensities> intensitiesOf(const State<3>& state, const CrackFront<3>& front,
                                       const FrontTube& tube, InternalAcceleration<3>&, const FrontWork<3>&)
{
  std::vector<double> J;
  for (const FrontNode<3>& node : front.nodes)
    J.push_back(node.driving.release);
  return intensitiesAlong(state, front, tube.halfWidth, J);
}

} // namespace

template <int D>
const typename DrivingForces<D>::Fitted& DrivingForces<D>::tubesOf(const State<D>& state, std::size_t f)
{
  fitted_.resize(state.cracks.fronts.size());
  Fitted& own = fitted_[f];
  const CrackFront<D>& front = state.cracks.fronts[f];
  const double cell = spacingAt(state, front.position);
  const auto around = [&]
  { return positionsAround(state, f, reachAround(own.release, own.intensity, own.cell)); };
  // In equilibrium that costs little compared with a solution. A tube of an earlier front may reach over a
  // surface that the front comes near, and then G was up to 25 % too small.
  const double keep = state.method.equilibrium() ? 0.0 : fitAgainAfter<D>;
  if (largestMove<D>(own.at, around()) < keep * cell && (D == 3 || own.cell == cell))
    return own;
  own.cell = cell;
  fitTubes(state, front, cell, own.release, own.intensity);
  own.at = around();
  return own;
}

template <int D>
void DrivingForces<D>::computeRelease(State<D>& state)
{
  std::vector<std::size_t> due;
  std::vector<typename InternalAcceleration<D>::Range> ranges;
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    const CrackFront<D>& front = state.cracks.fronts[f];
    if (!front.due || front.ended || front.stopped() || front.numFacets == 0)
      continue;
    due.push_back(f);
    ranges.push_back(rangeOf(state, front, tubesOf(state, f).release));
  }
  if (due.empty())
    return;
  acceleration_.renew();
  acceleration_.around(state, ranges); // of all fronts at once
  for (const std::size_t f : due)
  {
    CrackFront<D>& front = state.cracks.fronts[f];
    const std::vector<std::optional<double>> J =
        releaseAlong(state, front, fitted_[f].release, acceleration_, FrontWork<D>{rows_, fitted_[f].blocks});
    for (std::size_t k = 0; k < J.size(); ++k)
    {
      DrivingForce& driving = front.nodes[k].driving;
      driving.lost = !J[k];
      driving.release = J[k].value_or(driving.release);
    }
  }
}

template <int D>
void DrivingForces<D>::computeIntensities(State<D>& state)
{
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    CrackFront<D>& front = state.cracks.fronts[f];
    if (!(front.advances() || front.measured) || front.numFacets == 0)
      continue;
    const FrontTube tube = tubesOf(state, f).intensity;
    // The accelerations are those of this step's driving forces.
    const std::vector<Intensities> K =
        intensitiesOf(state, front, tube, acceleration_, FrontWork<D>{rows_, fitted_[f].blocks});
    for (std::size_t k = 0; k < K.size(); ++k)
    {
      DrivingForce& driving = front.nodes[k].driving;
      driving.modeI = K[k].modeI;
      driving.modeII = K[k].modeII;
      driving.modeIII = K[k].modeIII;
      // Faces that touch do not overlap: a mode I that closes is none.
      driving.hoopAngle = hoopStressAngle(std::max(K[k].modeI, 0.0), K[k].modeII);
    }
  }
}

template <int D>
void DrivingForces<D>::serialize(Archive& archive)
{
  int count = static_cast<int>(fitted_.size());
  archive("fronts", count);
  if (archive.loads()) // what was found around the fronts was that of other particles
  {
    fitted_.clear();
    acceleration_ = InternalAcceleration<D>();
  }
  fitted_.resize(count);
  for (int k = 0; k < count; ++k)
  {
    const Archive::Group group(archive, "tube " + std::to_string(k));
    archive("at", fitted_[k].at);
    archive("cell", fitted_[k].cell);
    fitted_[k].release.store("release", archive);
    fitted_[k].intensity.store("intensity", archive);
  }
}

template <int D>
void addDrivingCalls(Effect<D>& effect, const Teuchos::ParameterList& scene,
                     const std::shared_ptr<DrivingForces<D>>& driving)
{
  effect.call(lastStage(scene), "driving forces of crack fronts",
              {quantity::particleStress, quantity::particleVelocity, quantity::crackGeometry,
               quantity::enrichedFields, ifWritten(quantity::dueFronts), ifWritten(quantity::springForce),
               ifWritten(quantity::facePressure)},
              {quantity::drivingForces}, {}, [driving](State<D>& state) { driving->computeRelease(state); });
  effect.call(lastStage(scene), "intensities at fronts that advance",
              {quantity::drivingForces, quantity::advancingFronts}, {quantity::stressIntensities}, {},
              [driving](State<D>& state) { driving->computeIntensities(state); });
}

template class DrivingForces<2>;
template class DrivingForces<3>;
template void addDrivingCalls(Effect<2>&, const Teuchos::ParameterList&,
                              const std::shared_ptr<DrivingForces<2>>&);
template void addDrivingCalls(Effect<3>&, const Teuchos::ParameterList&,
                              const std::shared_ptr<DrivingForces<3>>&);

} // namespace Rhegma::energy_release
