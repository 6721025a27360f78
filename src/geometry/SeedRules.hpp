#pragma once
/// How the lattice of a body's particles is placed and divided.

#include "geometry/Cuts.hpp"
#include "geometry/Slivers.hpp"

#include <functional>
#include <optional>

namespace Rhegma
{

/// Whether a cell of a lattice, which has been halved `level` times, is too large for the grid cells that it
/// touches.
template <int D>
using IsDivided = std::function<bool(const Geometry::OrientedBox<D>& cell, int level)>;

/// What divides the cells of a lattice.
template <int D>
struct SeedRules
{
  IsDivided<D> isDivided{}; ///< empty: no cell is halved
  /// A node of the grid, from which the lattices of bodies that are not rotated start; none: each starts at
  /// its body's lower corner.
  std::optional<Vector<D>> node{};
  /// Parts that fill less of a cell of a lattice are joined with others [-].
  double joinedBelow = Geometry::joinedBelow;
  /// The same for parts next to a surface that divides their cell.
  double joinedBelowAtCuts = Geometry::joinedBelow;
  Geometry::Cuts<D> cuts{}; ///< empty: no surface divides the body
};

} // namespace Rhegma
