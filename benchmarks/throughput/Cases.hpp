#pragma once
/// The bodies whose steps are timed.

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_RCP.hpp>

#include <string>
#include <vector>

namespace Rhegma::benchmarks
{

/// One scene and the bounds of its step.
struct Case
{
  std::string name;
  int dimension;
  bool gimp;
  bool crack;            ///< a short crack in a corner of the body, far from nearly all particles
  double boundBytes;     ///< that a particle-step has to move
  double allowed;        ///< multiple of the bandwidth bound on two threads
  std::string compareTo; ///< the case without the crack or with shear strain at particles; empty without one
  bool centres = false;  ///< shear strain at the cells' centres
};

/// All cases. The bound is the time that 288 bytes (2D) or 472 bytes (3D) take at the bandwidth of the triad:
/// what the passes of a MUSL step read and write of a particle's position, velocity, mass, volume, stress and
/// deformation gradient.
const std::vector<Case>& allCases();

/// The scene of a case: an elastic box that turns slowly as it flies.
/// \param particles approximate number; exact for 200,000 (2D) and 300,000 (3D)
/// \param flow steps that it flies a hundred times as fast before anything is timed: a hundredth of a cell
/// each, and in 10,000 it turns by 12 degrees; the domain is large enough
Teuchos::RCP<Teuchos::ParameterList> makeScene(const Case& which, int particles, int flow);

} // namespace Rhegma::benchmarks
