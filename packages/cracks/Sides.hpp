#pragma once
/// Sides of nodes and particles, and the second fields of nodes.

#include "cracks/CrackGeometry.hpp"
#include "state/State.hpp"

#include <vector>

namespace Rhegma::cracks
{

/// A node less than this share of a cell below a crack counts as above it, so that a crack on a row of nodes
/// stays so while the body deforms a little.
constexpr double tieTolerance = 0.1;

/// A node less than this share of a cell behind a front counts as at the front and stays closed: so a front
/// on a column of nodes stays there, and the crack that the cells have is neither too long nor too short in
/// the mean (unit test InclinedCracks; with a tenth of a cell it was 0.14 cells too long).
constexpr double frontTolerance = 0.25;

/// Cells over which a crack matters to nodes: a particle a stencil away on the other side must find the
/// node's side.
constexpr double bandWidth = 3.0;

/// What each step finds out about the surroundings of the cracks.
struct Surroundings
{
  View<int*> cellMark; ///< stamp of the last step in which a cell was near a crack
  int stamp = 0;
};

/// Finds the side of every node that lies behind a front near a crack, gives it a second field (dual field),
/// marks the particles that can see one of these nodes, and gives those a side if they have none yet. A
/// particle keeps its side for good, so faces that press against each other never swap particles.
///
/// \param row 0 for marked particles; others are left as they are
void findSides(State<2>& state, Surroundings& surroundings, const View<int*>& row);

/// The polylines of all cracks.
std::vector<Polyline> polylines(const CrackSet<2>& cracks);

} // namespace Rhegma::cracks
