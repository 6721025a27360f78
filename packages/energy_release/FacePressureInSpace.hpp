#pragma once
/// What a pressure on the faces of a crack adds to J along its fronts in 3D.

#include "energy_release/FrontOpening.hpp"
#include "energy_release/FrontTube.hpp"
#include "energy_release/InternalAcceleration.hpp"

#include <vector>

namespace Rhegma::energy_release
{

/// Whether anything presses on the faces of cracks (CrackSet::pressure).
bool isPressed(const State<3>& state);

/// Adds to the acceleration of nodes what the pressure gives them: the integral over the tube then leaves the
/// work of the pressure out, of which a good part is done within a cell of the front, where u,k is singular.
/// Collective.
void addAccelerationByPressure(const State<3>& state, const NodalAcceleration<3>& acceleration);

/// That work, as it follows by parts from the opening where it is well known (Li, Shih and Needleman, Eng.
/// Fract. Mech. 21 (1985) 405, for the term - int p [u_n],e q dS):
///
///     int p [u_n] ( e . grad q + q div e ) dS / int q ds
///
/// with q = ramp hat and e the direction of the front at its nearest point, as FrontIntegral.hpp has them. A
/// pressure that changes along the crack counts by its value only.
/// \return for every station [J/m2]
std::vector<double> releaseByPressure(const State<3>& state, int crack, const FrontLine& line,
                                      const FrontTube& tube);

/// Adds to J at every station what the nodes behind the front do not get. With ties the crack that the cells
/// have is right under a stress far away. Taken off as a uniform stress, that stress
/// pushes a split node by its whole hat, ahead of the front too, while a pressure acts on the faces alone.
/// What so lacks, p times the share that split nodes have of the plane ahead, is worth sqrt(2 / (pi r)) each
/// (Tada, Paris and Irwin, The Stress Analysis of Cracks Handbook, 3rd ed., 2000, 3.6) and in all the
/// intensity K, which adds ( 2 K_I + K ) K / E'. The mean over the hat by which a station weighs. Nothing
/// without a pressure. Collective.
///
/// \param openings of the stations: their modes share J as given
/// \param J of every station, changed [J/m2]
void addLostPressure(const State<3>& state, const CrackFront<3>& front, const FrontLine& line,
                     const FrontTube& tube, const Elasticity& e, const std::vector<Intensities>& openings,
                     std::vector<double>& J);

} // namespace Rhegma::energy_release
