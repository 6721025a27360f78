#pragma once
/// Particles that are too small to stand alone.

#include "geometry/PartOfBox.hpp"

#include <vector>

namespace Rhegma::Geometry
{

/// Parts that fill less of a lattice cell are joined with a neighbour. The box of a part that fills the
/// fraction f has edges of at least f cells, so this bounds how much lighter a node can become than under
/// whole particles ([theory](../../docs/explanation/method.md), particles at edges).
constexpr double joinedBelow = 0.5;

/// A particle that fills a lattice cell or a part of it; all lengths in the lattice's axes.
template <int D>
struct LatticePart
{
  std::array<long long, D> cell; ///< of the lattice
  double fraction;               ///< of a cell's volume
  Vector<D> centroid;            ///< [m]
  Vector<D> variance;            ///< mean square distance from the centroid along each axis [m^2]
  int lineage = 0;               ///< which part of a whole larger cell it is (Seeds::lineage)
  int family = -1;               ///< number of that cell; -1: it is a part of none
  double least = joinedBelow;    ///< below this fraction it is joined with another

  bool stands() const { return fraction >= least; } ///< whether it is large enough to stand alone
};

/// Adds one part of a lattice cell to another, whose family it ends. Volume, first and second moments stay.
template <int D>
void join(const LatticePart<D>& one, LatticePart<D>& to);

/// Sorts parts as joinSlivers needs them; those of one cell stay in their order.
template <int D>
void sortByCell(std::vector<LatticePart<D>>& parts);

/// No part becomes so long by what joins it: a wall that is thinner than half a lattice cell keeps a part in
/// each of its cells, or in two of them [edges of a cell].
constexpr double longestJoined = 2.0;

/// Whether the line between two positions (in the lattice's axes) does not leave the body.
template <int D>
using IsSeen = std::function<bool(const Vector<D>&, const Vector<D>&)>;

/// Joins the parts that are too small to stand alone with others: the smallest first, each with the part, not
/// smaller than itself, of a neighbouring cell (over corners too) whose centroid is nearest and can be seen;
/// in equal pieces with those that are equally near. Volume, first and second moments stay. A part without
/// such a neighbour, or by which one would become longer than longestJoined, stays as it is.
///
/// \param parts   in the order of their cells: along the first axis first
/// \param edge    of a lattice cell [m]
template <int D>
void joinSlivers(std::vector<LatticePart<D>>& parts, const Vector<D>& edge, const IsSeen<D>& isSeen);

/// Parts of lattices that are finer by a level each.
template <int D>
using PartsOfLevels = std::vector<std::vector<LatticePart<D>>>;

/// Joins the parts that are too small and have no neighbour of their size with the nearest part of another
/// level that is no farther away than a cell of the larger of the two. \param edge of a cell of the first
/// level [m]
template <int D>
void joinOverLevels(PartsOfLevels<D>& parts, const Vector<D>& edge, const IsSeen<D>& isSeen);

} // namespace Rhegma::Geometry
