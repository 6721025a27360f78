#pragma once
/// Which particles cracks divide, by geometry.

#include "geometry/NearBoxes.hpp"
#include "state/State.hpp"

#include <array>
#include <vector>

namespace Rhegma
{

/// The cracks of a scene as they are at the start, before particles have their sides.
template <int D>
class CrackWalls
{
public:
  explicit CrackWalls(const State<D>& state);

  /// Whether a crack's bounds come within a distance of a position [m].
  bool isNear(const Vector<D>& x, double distance) const { return !boxes_.near({x, x}, distance).empty(); }

  /// Index of a crack that crosses the straight line between two positions; -1: none does.
  int between(const Vector<D>& x, const Vector<D>& y) const;

private:
  bool crosses(int simplex, const Vector<D>& x, const Vector<D>& y) const;

  std::vector<std::array<Vector<D>, D>> simplices_; ///< their vertices [m]
  std::vector<int> crackOf_;
  Geometry::NearBoxes<D> boxes_{{}};
};

} // namespace Rhegma
