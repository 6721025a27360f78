#pragma once
/// Surfaces inside bodies that divide them, such as cracks.

#include "geometry/PartOfBox.hpp"

#include <functional>
#include <vector>

namespace Rhegma::Geometry
{

/// Distance from a surface, positive on one side and negative on the other [m]; between two points it changes
/// by no more than their distance.
template <int D>
using SignedDistance = std::function<double(const Vector<D>&)>;

/// How surfaces meet a box.
template <int D>
struct BoxCuts
{
  bool any = false; ///< a surface enters it
  /// Those that divide it in two: none of their fronts is inside.
  std::vector<SignedDistance<D>> through{};
};

/// Surfaces that divide boxes; empty functions divide none.
template <int D>
struct Cuts
{
  std::function<BoxCuts<D>(const OrientedBox<D>&)> ofBox;
  /// Whether the line between two points meets a surface [m].
  std::function<bool(const Vector<D>&, const Vector<D>&)> separate;
};

/// The part of a region that lies on the given sides of surfaces. \param whole whether the region holds all
/// of the box that is asked for, so that its depth does not count \param sides as the bits of a number: bit i
/// is set on the positive side of surface i
template <int D>
Region<D> onSides(const Region<D>& region, bool whole, const std::vector<SignedDistance<D>>& surfaces,
                  int sides);

} // namespace Rhegma::Geometry
