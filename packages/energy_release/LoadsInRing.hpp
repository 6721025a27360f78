#pragma once
/// Loads and supports that act where the weight of the J integral falls.

#include "energy_release/Contour.hpp"
#include "state/State.hpp"

#include <Teuchos_ParameterList.hpp>
#include <string>
#include <vector>

namespace Rhegma::energy_release
{

/// The region of a load: a straight line in a body, or a point; or a box whose nodes are held, or all nodes
/// beyond it.
struct LoadRegion
{
  /// Shape of the region.
  enum class Kind
  {
    Line,   ///< a line in a body, or a point of it
    Box,    ///< a box whose nodes are held
    Outside ///< the same, but the nodes beyond the box
  };
  std::string name;       ///< as in the scene
  Vector<2> from{}, to{}; ///< its ends at the start, or the corners of the box [m]
  Kind kind = Kind::Line; ///< of the region
};

/// How far a position is from the nearest and from the furthest point of a load [m].
struct Reach
{
  double nearest;  ///< [m]
  double furthest; ///< [m]
};
Reach reachOf(const LoadRegion& load, const Vector<2>& x);

/// The loads on points and lines of a 2D scene whose History is not zero at all of 257 times of the run, and
/// its boxes of held nodes (BoundaryType::region).
std::vector<LoadRegion> readLoads(const Teuchos::ParameterList& scene);

/// Warns, once, of each load that acts in the ring round a front, a cell more on both sides, and of each box
/// of held nodes that reaches into it; with the positions of the start. What a load does inside of the ring
/// is in the integral (docs/theory.md), but in the ring the stress next to it, which no cells resolve, is
/// multiplied by the slope of the weight: two forces on the faces of a crack change J by 4 and 8 % there and
/// by 0.7 % at most elsewhere (unit test program/test_odd_cracks.py; K by 0.1 %), a node held six cells ahead
/// of a crack in a plate under tension by 2 % there and by 0.01 % elsewhere, against crack closure.
void warnOfLoads(State<2>& state, const CrackFront<2>& front, const ContourRadii& radii,
                 const std::vector<LoadRegion>& loads);

} // namespace Rhegma::energy_release
