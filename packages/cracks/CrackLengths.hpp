#pragma once
/// Lengths of a crack in the bodies of a scene: its own, and those of the material around it.

#include "scene/CellNeeds.hpp"
#include "scene/SceneBodies.hpp"

#include <Teuchos_ParameterList.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace Rhegma::cracks
{

/// Part of a polyline crack that lies in bodies, and which of its ends are fronts.
struct CrackLine
{
  std::string name;
  std::vector<Vector<2>> points;
  bool front[2] = {false, false}; ///< of the first and the last position
  double length = 0.0;
};

/// What is known of one crack.
struct CrackLengths
{
  CrackLine line{};                   ///< in 2D
  double ligament = CellNeeds::none;  ///< from its fronts to the nearest surface
  double crack = CellNeeds::none;     ///< its (half) length, or radius
  double ahead = CellNeeds::none;     ///< from its fronts along their directions to a surface
  double thickness = CellNeeds::none; ///< as in CellNeeds
  bool inside = false;                ///< whether any of it is in a body

  void front(double depth) { ligament = std::min(ligament, depth); }
};

/// A direction turned by a right angle, counter-clockwise.
inline Vector<2> turned(const Vector<2>& direction) { return {-direction[1], direction[0]}; }

/// Measures a crack [m]. \param crack its list, which has what its shape is made of \throws
/// std::invalid_argument with what is wrong with it
CrackLengths measureCrack(const Teuchos::ParameterList& crack, const SceneBodies<2>& bodies);
CrackLengths measureCrack(const Teuchos::ParameterList& crack, const SceneBodies<3>& bodies);

} // namespace Rhegma::cracks
