#pragma once
/// The opening behind a front in 3D, which divides the energy release between the modes.

#include "energy_release/FrontLine.hpp"
#include "material/MaterialTable.hpp"
#include "state/State.hpp"

#include <vector>

namespace Rhegma::energy_release
{

/// Stress intensities [Pa m^0.5] in the frame of a front node: K_I is positive where the faces open, K_II
/// where side +1 slides ahead, K_III where side +1 slides along `direction` x `normal`.
struct Intensities
{
  double modeI = 0.0, modeII = 0.0, modeIII = 0.0;
};

/// E' J of intensities over E': (K_I^2 + K_II^2) / E' + K_III^2 / (2 mu) [J/m2].
double releaseOf(const Intensities& K, const Elasticity& e);

/// Intensities whose ratios are those of the openings behind the front, at every front node.
///
/// The faces' openings at the distance r behind a front are (8 K_I, 8 K_II) / E' sqrt(r / 2 pi) and 4 K_III /
/// mu sqrt(r / 2 pi) (Williams). These are fitted to the face positions, between 1 and 3 cells behind the
/// front, with the hat of half width `halfWidth` about the front node. On a curved crack openings are
/// taken in a frame that has turned half as much as the faces have there; of a front that has grown, in that
/// of the front. Their size is that of the cells' opening, which is not accurate; scaleTo corrects it.
///
/// \param cell edge of the cells at the front [m]
std::vector<Intensities> openingsBehind(const CrackSet<3>& cracks, const CrackFront<3>& front,
                                        const FrontLine& line, const Elasticity& e, double cell,
                                        double halfWidth);

/// Scales intensities so that they release J; zero where J is not positive.
Intensities scaleTo(const Intensities& K, double J, const Elasticity& e);

/// Both: intensities at every front node whose opening is that of the faces and which release J; not numbers
/// where J is none. Collective.
std::vector<Intensities> intensitiesAlong(const State<3>& state, const CrackFront<3>& front, double halfWidth,
                                          const std::vector<double>& J);

} // namespace Rhegma::energy_release
