#pragma once
/// Sides of nodes and particles, and the enriched fields of nodes.

#include "cracks/CohesiveLaw.hpp"
#include "cracks/CrackGeometry.hpp"
#include "state/State.hpp"

#include <cstdint>
#include <functional>

namespace Rhegma::cracks
{

/// A node less than this fraction of a cell below a crack counts as above it, so that a crack on a row of
/// nodes stays so while the body deforms a little. Not a round number: rounding would decide on the side of
/// nodes exactly so far below a crack, and the motion of a step would change it.
constexpr double sideTolerance = 0.097;

/// A node less than this fraction of a cell behind a front counts as at the front and stays closed: so a
/// front on a column of nodes stays there, and the crack that the cells have is neither too long nor too
/// short in the mean (with a tenth of a cell it was 0.14 cells too long). With front springs: splitAhead.
constexpr double frontTolerance = 0.25;

/// The surroundings of the cracks in a step.
struct Surroundings
{
  View<int*> cellMark;          ///< stamp of the last step in which a cell was near a crack
  View<std::uint64_t*> nearest; ///< of each active node: square distance and number of the nearest simplex
  View<double* [4]> reach;      ///< of each crack: its ends along the two axes of blocks [cells]
  int stamp = 0;
  int generation = 0; ///< of the nodes
  /// That of FrontCell.hpp is not where faces touch in motion, nor where heat cannot pass between the fields
  /// of a node, nor where fronts are held until a time in motion.
  FrontLaw law;
  /// New faces cohere (CohesiveLaw.hpp). In 2D a node then opens by the other law once its front has grown,
  /// when the front has passed it: as that of FrontCell.hpp opens it a quarter of a cell ahead of the front,
  /// the force that holds it is smaller, and new faces would cohere over twice the length.
  bool releases = false;
};

/// The simplex in an entry of Surroundings::nearest.
KOKKOS_INLINE_FUNCTION int simplexOf(std::uint64_t packed) { return static_cast<int>(packed & 0xffffffffU); }

/// Finds the side of every node that lies behind a front near a crack, gives it an enriched field (dual
/// field), gives the particles that can see one of these nodes a side if they have none yet, and marks those
/// that reach a node on the other side. A particle never changes its side, so that faces in contact do not
/// exchange particles.
///
/// \param row 0 for marked particles; others are left as they are \param claim changes which simplex nodes
/// take for the nearest, before their sides follow from it
template <int D>
void findSides(State<D>& state, Surroundings& surroundings, const View<int*>& row,
               const std::function<void()>& claim = {});

} // namespace Rhegma::cracks
