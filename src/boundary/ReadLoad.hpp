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

/// A surface of a body, a line (2D) or a parallelogram (3D) as Traction has it, with points but without
/// force.
template <int D>
struct Surface
{
  Load<D> points;
  double area; ///< [m2]
};

/// Reads `Body` and `From`, `To` or `Corner`, `Edge 1`, `Edge 2` and places the surface. Throws
/// std::invalid_argument where it meets no particle. \param where path of the list, for messages
template <int D>
Surface<D> readSurface(const Teuchos::ParameterList& list, const State<D>& state, const std::string& name);

} // namespace Rhegma
