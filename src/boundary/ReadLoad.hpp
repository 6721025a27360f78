#pragma once
/// Loads from the scene.

#include "boundary/Loads.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>

namespace Rhegma
{

/// Reads a boundary of type Traction, Point Load or Line Load and places it on the particles of its body.
/// Throws std::invalid_argument, with the section's path, for one that meets no particle.
template <int D>
Load<D> readLoad(const Teuchos::ParameterList& list, const State<D>& state, const std::string& name);

} // namespace Rhegma
