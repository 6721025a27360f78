#pragma once
/// Which of many boxes are near each other.

#include "geometry/Frame.hpp"

#include <vector>

namespace Rhegma::Geometry
{

/// A tree of boxes (bounding volumes), in which those near a box are found without a look at all.
template <int D>
class NearBoxes
{
public:
  explicit NearBoxes(std::vector<Bounds<D>> boxes);

  /// Numbers of the boxes that come within a distance of a box along every axis, in their order.
  std::vector<int> near(const Bounds<D>& box, double gap) const;

private:
  /// Orders the boxes of a part of the list, and bounds them. \return number of the node
  int build(int first, int end);

  struct Node
  {
    Bounds<D> bounds;
    int first, end;  ///< of the list
    int left, right; ///< nodes below, or -1
  };
  std::vector<Bounds<D>> boxes_;
  std::vector<int> list_;
  std::vector<Node> nodes_;
};

} // namespace Rhegma::Geometry
