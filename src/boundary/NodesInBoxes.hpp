#pragma once
/// Which of many positions lie in boxes.

#include "geometry/NearBoxes.hpp"

#include <memory>
#include <vector>

namespace Rhegma
{

/// Positions that are asked for many boxes: a tree of them where these are more than a few.
template <int D>
class NodesInBoxes
{
public:
  /// \param positions kept by the caller \param questions how many boxes will be asked for
  NodesInBoxes(const std::vector<Vector<D>>& positions, std::size_t questions) : positions_(positions)
  {
    constexpr std::size_t few = 16; // for which a look at all is cheaper than a tree
    if (questions <= few)
      return;
    std::vector<Geometry::Bounds<D>> points;
    points.reserve(positions.size());
    for (const Vector<D>& x : positions)
      points.push_back({x, x});
    tree_ = std::make_unique<Geometry::NearBoxes<D>>(std::move(points));
  }

  /// Calls see(x) for each position in a box and on its border, in their order. \param outside for those that
  /// are not in it instead
  template <class See>
  void visit(const Geometry::Bounds<D>& box, bool outside, const See& see) const
  {
    if (tree_ && !outside)
      for (const int k : tree_->near(box, 0.0))
        see(positions_[k]);
    else
      for (const Vector<D>& x : positions_)
        if (contains(box, x) != outside)
          see(x);
  }

private:
  static bool contains(const Geometry::Bounds<D>& box, const Vector<D>& x)
  {
    bool in = true;
    for (int d = 0; d < D; ++d)
      in = in && x[d] >= box.lower[d] && x[d] <= box.upper[d];
    return in;
  }

  const std::vector<Vector<D>>& positions_;
  std::unique_ptr<Geometry::NearBoxes<D>> tree_;
};

} // namespace Rhegma
