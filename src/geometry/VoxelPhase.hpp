#pragma once
/// The part of an image of voxels that has one value.

#include "geometry/Frame.hpp"
#include "geometry/PartOfBox.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace Rhegma::Geometry
{

/// All voxels of one value, in an image whose voxels have edges of 1 and whose lower corner is the origin.
template <int D>
class VoxelPhase
{
public:
  using Index = std::array<std::int64_t, D>;

  /// \param count voxels along each axis \param inside for each voxel 1 where it has the value, else -1; the
  /// last axis runs fastest. At least one voxel has the value.
  VoxelPhase(const Index& count, std::vector<std::int16_t> inside);

  /// Whether a point is in a voxel with the value, or no further than that outside of one.
  bool contains(const Vector<D>& x, double tolerance) const;
  /// Positive inside, negative outside: the largest distance along an axis to the nearest voxel of the other
  /// kind; space around the image is outside. Exact up to `exact` voxels; further away one less at most.
  double depth(const Vector<D>& x) const;
  /// The part of a box along the axes: exact but for rounding.
  BoxPart<D> part(const Vector<D>& lower, const Vector<D>& upper) const;

  const Bounds<D>& bounds() const { return bounds_; } ///< of its voxels
  const Index& count() const { return count_; }       ///< of the image
  /// Whether a voxel is in the image and has the value.
  bool has(const Index& voxel) const { return isInImage(voxel) && shell_[at(voxel)] > 0; }

  static constexpr int exact = 8; ///< voxels up to which depths are exact

private:
  bool isInImage(const Index& voxel) const;
  std::size_t at(const Index& voxel) const;
  void measure();
  /// The smallest distance from x to voxels of a kind in a shell around its voxel; infinite if there are
  /// none.
  double nearest(const Vector<D>& x, const Index& voxel, int shell, bool inside) const;

  Index count_;
  /// How many voxels away the nearest one of the other kind is, diagonally as along the axes; negative
  /// outside.
  std::vector<std::int16_t> shell_;
  Bounds<D> bounds_;
};

} // namespace Rhegma::Geometry
