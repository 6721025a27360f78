#pragma once
/// Values at the nodes of a front in 3D, as last sampled.

#include "base/Types.hpp"

#include <string>
#include <vector>

namespace Rhegma
{

/// A front with its nodes, in their order along it; every list has an entry a node. A value that could not be
/// computed is not a number.
struct FrontValues
{
  std::string crack;               ///< name of its crack
  int number = 0;                  ///< counts the fronts of its crack from 0
  std::vector<int> line;           ///< of a front that the surface divides, from 0
  std::vector<double> arc;         ///< length of its line up to there [m]
  std::vector<Vector<3>> position; ///< [m]
  std::vector<double> release;     ///< energy release rate [J/m2]
  std::vector<double> modeI;       ///< stress intensity of mode I [Pa m^0.5]
  std::vector<double> modeII;      ///< of mode II
  std::vector<double> modeIII;     ///< of mode III
  std::vector<double> speed;       ///< [m/s]
};

} // namespace Rhegma
