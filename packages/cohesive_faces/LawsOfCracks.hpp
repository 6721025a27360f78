#pragma once
/// The laws of the cracks of a scene.

#include "cohesive_faces/FaceCohesion.hpp"
#include "state/State.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace Rhegma::cohesive_faces
{

/// The law of one list of the section. \param modulus P-wave modulus of the softest body at the crack [Pa]
/// \param cell edge of the coarsest cells [m] \param equilibrium whether no time step limits the stiffness
TractionLaw readLaw(const Teuchos::ParameterList& list, double modulus, double cell, bool equilibrium);

/// What lies at a crack.
struct AtCrack
{
  double modulus = 0.0;   ///< smallest P-wave modulus of the materials within two cells [Pa]
  double effective = 0.0; ///< smallest E' of fracture mechanics [Pa]
};

/// The materials at each crack; of all materials where no particle is near. Collective.
template <int D>
std::vector<AtCrack> materialsAtCracks(const State<D>& state);

/// Length of the process zone of each mode, E' G_c / T^2 [m] (Turon, Davila, Camanho and Costa, Eng. Fract.
/// Mech. 74 (2007) 1665).
struct ProcessZone
{
  double opening = 0.0, sliding = 0.0;
};
ProcessZone processZone(const Teuchos::ParameterList& list, double effective);

/// Warns where a process zone has too few cells. \param name of the crack \param cell there [m]
std::string warningOfZone(const std::string& name, const ProcessZone& zone, double cell);

/// Warns where faces that press on each other, without contact, resist less than those in contact by its
/// default penalty. \param law of the crack \param modulus of AtCrack [Pa] \param cell edge of the coarsest
/// cells [m] \param moves whether Contact may be added
std::string warningOfOverlap(const std::string& name, const TractionLaw& law, double modulus, double cell,
                             bool moves);

/// Largest stable step with the laws' springs [s]; infinite without one. An explicit step resolves
/// frequencies w below 2 / w. Cells have w^2 <= 4 D c^2 / h^2; a spring of stiffness K per area adds 4 K /
/// (rho h) on nodes with half a cell's mass on each side, and no more where a crack cuts cells, because mass
/// and stiffness of a node both go with the square of its distance from the crack. A tenth is kept as a
/// margin.
template <int D>
double timeStepLimit(const State<D>& state, const std::vector<TractionLaw>& laws);

} // namespace Rhegma::cohesive_faces
