#pragma once
/// Temperature and internal energy of particles at the start.

#include "state/State.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace Rhegma::thermal
{

/// Warns of a temperature below that of liquid nitrogen, 77 K: it may be meant in degrees Celsius. \param
/// what path of the section, and its subject \param T [K]
void warnOfCold(std::vector<std::string>& warnings, const std::string& what, double T);

/// Gives every particle the temperature of its body. Throws std::invalid_argument, with the path, for one
/// that is not above zero; warns of cold ones. \param bodies the section Bodies \param initial
/// temperature of bodies that do not say another [K]
template <int D>
void startTemperature(State<D>& state, const Teuchos::ParameterList& bodies, double initial);

/// Corrects the strain at the start of bodies with a Temperature Field for what their cells cannot represent
/// of it (CellExpansion.hpp). To be called once the stencils of the first step are known. \param bodies the
/// section Bodies
template <int D>
void correctStart(State<D>& state, const Teuchos::ParameterList& bodies);

/// Finds the particles' internal energy from their temperature and, where there is mechanics, their stress.
template <int D>
void startEnergy(State<D>& state);

/// Sets the temperatures of the parts of a split particle by its gradient, and strains them by their
/// expansion, so that their stress is that of the whole particle. Their total energy does not change.
template <int D>
void copyGradient(State<D>& state, const SplitParts& parts);

} // namespace Rhegma::thermal
