#pragma once
/// What a field is: its name, shape and unit.

#include <string>
#include <vector>

namespace Rhegma
{

/// A quantity that every particle stores.
struct Field
{
  std::string name;     ///< free text that identifies the field
  int components = 1;   ///< numbers of a particle
  std::string unit;     ///< SI; empty: a pure number
  std::string meaning;  ///< description for readers
  bool integer = false; ///< whole numbers
};

/// Treatment of a nodal field where cells are refined or coarsened. Nodes that exist before and after are
/// identified by their position.
enum class OnRemesh
{
  Keep,        ///< nodes that stay keep their values; new ones begin with zero
  Interpolate, ///< nodes that stay keep their values; new ones begin with the value interpolated in the
               ///< earlier cells
  Drop         ///< all begin with zero
};

/// A quantity that an effect stores on nodes from step to step (parallel/NodalFieldTable.hpp).
struct NodalField
{
  Field field;                        ///< real numbers of each node, identified by its name
  OnRemesh onRemesh = OnRemesh::Keep; ///< where cells are refined or coarsened
  bool enriched = false;              ///< whether the enriched field of a node has values of its own
  bool reportsLost = false; ///< whether values of nodes that vanish are listed (NodalFieldTable::lost)
};

/// The fields that the method itself needs, whatever the effects.
namespace fields
{
inline const std::string position = "position";                ///< [m]
inline const std::string reference = "reference position";     ///< at the start [m]
inline const std::string velocity = "velocity";                ///< [m/s]
inline const std::string mass = "mass";                        ///< [kg]
inline const std::string volume = "initial volume";            ///< undeformed [m3]
inline const std::string deformation = "deformation gradient"; ///< see gradientSize
inline const std::string stress = "Kirchhoff stress";          ///< see symmetricSize [Pa]
inline const std::string edge = "edge";                        ///< undeformed edges [m]
inline const std::string box = "box";                          ///< half widths that GIMP averages over [m]
inline const std::string history = "history";                  ///< of the material's law
inline const std::string material = "material";                ///< its number
inline const std::string body = "body";                        ///< its number
inline const std::string id = "id";                            ///< the particle's own number
/// Since the start [m]; only where the cells lie in the undeformed body.
inline const std::string displacement = "displacement";
/// Velocity gradient, row by row; only where an effect asks for it.
inline const std::string rate = "velocity gradient";
/// Which side of a crack a particle lies on (CrackSet); only where an effect cuts the body.
inline const std::string side = "side";
/// How often a particle was split; only where an effect splits them.
inline const std::string level = "level";
/// Only with heat; the internal energy is per undeformed volume.
inline const std::string temperature = "temperature";
inline const std::string temperatureGradient = "temperature gradient"; ///< [K/m]
inline const std::string internalEnergy = "internal energy";           ///< [J/m3]
} // namespace fields

} // namespace Rhegma
