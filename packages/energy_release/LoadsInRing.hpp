#pragma once
/// Loads and supports that act where the weight of the J integral falls.

#include "energy_release/Contour.hpp"
#include "plan/BoundaryType.hpp"
#include "state/State.hpp"

#include <Teuchos_ParameterList.hpp>
#include <array>
#include <vector>

namespace Rhegma::energy_release
{

/// How far a front is from the nearest and from the furthest point of a load [m].
struct Reach
{
  double nearest;  ///< [m]
  double furthest; ///< of the ends of a line, the corners of a box [m]
};

/// A piece of a front, from one end to the other [m]; in 2D a point.
template <int D>
using FrontSegment = std::array<Vector<D>, 2>;

/// The pieces of a front; none of one that has ended.
std::vector<FrontSegment<2>> segmentsOf(const CrackFront<2>& front);
std::vector<FrontSegment<3>> segmentsOf(const CrackFront<3>& front);

/// \param load a line in a body or a point of it, a box whose nodes are held, or the outside of one, at the
/// start
template <int D>
Reach reachOf(const BoundaryRegion& load, const std::vector<FrontSegment<D>>& front);

/// The loads on points and lines of a scene whose History is not zero at all of 257 times of the run, and its
/// boxes of held nodes (BoundaryType::region).
std::vector<BoundaryRegion> readLoads(const Teuchos::ParameterList& scene);

/// Warns, once, of each load that acts in the ring (2D) or tube (3D) round a front, a cell more on the inner
/// side, and of each box of held nodes that reaches into it; with the positions of the start. Supports that
/// prescribe motion along a straight front only, as in plane strain, do no work on its virtual advance.
///
/// What a load does inside of the ring is in the integral (docs/explanation/energy-release.md), but in the
/// ring the stress next to it, which no cells resolve, is multiplied by the slope of the weight: two forces
/// on the faces of a crack change J by 4 and 8 % there and by 0.7 % at most elsewhere (unit test
/// program/test_odd_cracks.py; K by 0.1 %), a node held six cells ahead of a crack in a plate under tension
/// by 2 % there and by 0.01 % elsewhere, against crack closure.
template <int D>
void warnOfLoads(State<D>& state, const CrackFront<D>& front, const ContourRadii& radii,
                 const std::vector<BoundaryRegion>& loads);

} // namespace Rhegma::energy_release
