#pragma once
/// What a field is: its name, shape and unit.

#include <string>
#include <vector>

namespace Rhegma
{

/// A quantity that every particle carries.
struct Field
{
  std::string name;
  int components = 1;
  std::string unit;
  std::string meaning;
  bool integer = false;
};

/// The fields that the method itself needs, whatever the effects.
namespace fields
{
inline const std::string position = "position";
inline const std::string reference = "reference position";
inline const std::string velocity = "velocity";
inline const std::string mass = "mass";
inline const std::string volume = "initial volume";
inline const std::string deformation = "deformation gradient";
inline const std::string stress = "Kirchhoff stress";
inline const std::string edge = "edge";
inline const std::string box = "box";
inline const std::string history = "history";
inline const std::string material = "material";
inline const std::string body = "body";
inline const std::string id = "id";
/// Velocity gradient, row by row; only where an effect asks for it.
inline const std::string rate = "velocity gradient";
/// Which side of a crack a particle lies on (CrackSet); only where an effect cuts the body.
inline const std::string side = "side";
/// How often a particle was split; only where an effect splits them.
inline const std::string level = "level";
/// Only where an effect carries heat; the last is per undeformed volume.
inline const std::string temperature = "temperature";
inline const std::string temperatureGradient = "temperature gradient";
inline const std::string internalEnergy = "internal energy";
} // namespace fields

} // namespace Rhegma
