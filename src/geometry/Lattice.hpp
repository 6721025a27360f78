#pragma once
/// Lattices of boxes that fill a shape.

#include "geometry/Shape.hpp"

#include <optional>

namespace Rhegma::Geometry
{

/// Cells of the lattice, counted from the base shape's lower corner; `first` may be negative.
template <int D>
struct Lattice
{
  Vector<D> origin; ///< own coordinates [m]
  Vector<D> edge;   ///< [m]
  double first[D];
  double count[D];

  /// Own coordinates of an index from the first cell; cells are at whole numbers and their middles at halves.
  Vector<D> positionOf(const double (&index)[3]) const
  {
    Vector<D> own;
    for (int d = 0; d < D; ++d)
      own[d] = origin[d] + (first[d] + index[d]) * edge[d];
    return own;
  }

  /// Number of cells; as a real number, for it may be more than any integer.
  double total() const
  {
    double product = 1.0;
    for (int d = 0; d < D; ++d)
      product *= count[d];
    return product;
  }
};

/// The lattice that covers a shape, in the axes of its base shape (see seedParticles). \param edge of a cell,
/// about [m] \param node a position that the lattice of a shape that is not rotated passes through
template <int D>
Lattice<D> makeLattice(const Shape<D>& shape, double edge, const std::optional<Vector<D>>& node = {});

} // namespace Rhegma::Geometry
