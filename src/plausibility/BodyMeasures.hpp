#pragma once
/// Sizes and masses of bodies, by which a scene is judged.

#include "material/MaterialTable.hpp"
#include "state/State.hpp"

#include <string>
#include <vector>

namespace Rhegma
{

/// One body as it is at the start.
template <int D>
struct BodyMeasure
{
  std::string name;         ///< as in the scene
  double mass = 0.0;        ///< [kg]
  double volume = 0.0;      ///< [m3]
  Vector<D> lower;          ///< corners of its bounds [m]
  Vector<D> upper;          ///< [m]
  double axes[D][D];        ///< its own axes, unit vectors, one a row
  Vector<D> ownLower;       ///< bounds along its own axes [m]
  Vector<D> ownUpper;       ///< [m]
  double shortest = 0.0;    ///< extents along its own axes [m]
  double longest = 0.0;     ///< [m]
  double fill = 1.0;        ///< volume over that of the box of these extents, 1 at most [-]
  Vector<D> velocity{};     ///< of its centre of mass at the start [m/s]
  double size = 0.0;        ///< edge of the square (2D) or cube of the same area or volume [m]
  double density = 0.0;     ///< [kg/m3]
  double speed = 0.0;       ///< of dilatational waves [m/s]
  bool linear = false;      ///< its law is Hooke's
  bool anisotropic = false; ///< its stiffness depends on direction
  double yield = 0.0;       ///< yield stress of its material; 0 without plasticity [Pa]
  Elasticity moduli{};      ///< of its material
  std::string material;     ///< its name
};

/// All bodies with particles; call it before particles are divided among ranks.
template <int D>
std::vector<BodyMeasure<D>> measureBodies(const State<D>& state);

} // namespace Rhegma
