#pragma once
/// Loads that act where the weight of the J integral falls.

#include "energy_release/Contour.hpp"
#include "state/State.hpp"

#include <Teuchos_ParameterList.hpp>
#include <string>
#include <vector>

namespace Rhegma::energy_release
{

/// A load on a straight line in a body, or on one point of it.
struct PlacedLoad
{
  std::string name;       ///< as in the scene
  Vector<2> from{}, to{}; ///< its ends at the start [m]
};

/// The Point Loads and Line Loads of a 2D scene.
std::vector<PlacedLoad> readLoads(const Teuchos::ParameterList& scene);

/// Warns of each load that acts in the ring round a front, a cell more on both sides, at the start. What a
/// load does inside of the ring is in the integral (docs/theory.md), but in the ring the stress beside it,
/// which no cells resolve, is weighed with the slope of the weight: two forces on the faces of a crack put J
/// off by 4 and 8 % there and by 0.7 % at most elsewhere (unit test program/test_odd_cracks.py; K by 0.1 %).
void warnOfLoads(State<2>& state, const CrackFront<2>& front, const ContourRadii& radii,
                 const std::vector<PlacedLoad>& loads);

} // namespace Rhegma::energy_release
