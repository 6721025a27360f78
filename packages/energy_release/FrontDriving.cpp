#include "energy_release/FrontDriving.hpp"

#include "archive/Archive.hpp"
#include "energy_release/CrackTipFields.hpp"
#include "energy_release/FrontIntegral.hpp"
#include "energy_release/FrontOpening.hpp"
#include "transfer/LocalSpacing.hpp"
#include "transfer/NearestMaterial.hpp"

#include <algorithm>
#include <string>

namespace Rhegma::energy_release
{

namespace
{

/// Cells by which a front node may move before its tube is fitted anew: less than four advances of a quarter
/// of a cell, of which last digits would tell whether they are more.
constexpr double lookAgain = 0.9;

bool hasMoved(const std::vector<double>& at, const FrontLine& line, double cell)
{
  if (at.size() != 3 * line.nodes.size())
    return true;
  double most = 0.0;
  for (std::size_t k = 0; k < line.nodes.size(); ++k)
    most = std::max(most, norm(line.nodes[k].position - Vector<3>{at[3 * k], at[3 * k + 1], at[3 * k + 2]}));
  return most > lookAgain * cell;
}

} // namespace

const FrontTube& FrontDriving::tubeOf(const State<3>& state, std::size_t f, const FrontLine& line)
{
  fitted_.resize(state.cracks.fronts.size());
  Fitted& own = fitted_[f];
  const CrackFront<3>& front = state.cracks.fronts[f];
  if (!hasMoved(own.at, line, spacingAt(state, front.position)))
    return own.tube;
  own.at.clear();
  for (const FrontNode<3>& s : line.nodes)
    own.at.insert(own.at.end(), s.position.c, s.position.c + 3);
  own.tube = fittingTube(state, front, line, radiiInSpace());
  return own.tube;
}

void FrontDriving::measureRelease(State<3>& state)
{
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    CrackFront<3>& front = state.cracks.fronts[f];
    if (front.ended || front.stopped())
      continue;
    const FrontLine line = lineOf(front);
    if (line.empty())
      continue;
    const FrontTube& tube = tubeOf(state, f, line);
    const std::vector<double> J = integrateAlongFront(state, front.crack, line, tube, acceleration_);
    for (std::size_t k = 0; k < J.size(); ++k)
      front.nodes[k].driving.release = J[k];
  }
}

void FrontDriving::measureIntensities(State<3>& state)
{
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
  {
    CrackFront<3>& front = state.cracks.fronts[f];
    const FrontLine line = lineOf(front);
    if (!front.advances() || line.empty())
      continue;
    const Elasticity e = elasticity(state.materials.list[materialAt(state, front.position)]);
    const std::vector<Intensities> openings = openingsBehind(
        state.cracks, front, line, e, spacingAt(state, front.position), tubeOf(state, f, line).halfWidth);
    for (std::size_t k = 0; k < openings.size(); ++k)
    {
      DrivingForce& driving = front.nodes[k].driving;
      const Intensities K = scaleTo(openings[k], driving.release, e);
      driving.modeI = K.modeI;
      driving.modeII = K.modeII;
      driving.modeIII = K.modeIII;
      // Faces that touch do not overlap: a mode I that closes is none.
      driving.hoopAngle = hoopStressAngle(std::max(K.modeI, 0.0), K.modeII);
    }
  }
}

void FrontDriving::keep(Archive& archive)
{
  int count = static_cast<int>(fitted_.size());
  archive("fronts", count);
  fitted_.resize(count);
  for (int k = 0; k < count; ++k)
  {
    const Archive::Group group(archive, "tube " + std::to_string(k));
    archive("at", fitted_[k].at);
    archive("inner", fitted_[k].tube.radii.inner);
    archive("outer", fitted_[k].tube.radii.outer);
    archive("half_width", fitted_[k].tube.halfWidth);
  }
}

} // namespace Rhegma::energy_release
