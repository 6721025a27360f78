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

  /// Calls visit(number) for the boxes that are wanted. \param isWanted of bounds: false only if no box in
  /// them is wanted
  template <class IsWanted, class Visit>
  void forEach(const IsWanted& isWanted, const Visit& visit) const;

  /// Calls visit(number) for the boxes whose distance is not above a limit, about the nearest first.
  /// \param distance  of bounds, such as the square of the distance from a point
  /// \param limit     the current limit, which visits may lower
  template <class Distance, class Visit>
  void forNearest(const Distance& distance, const double& limit, const Visit& visit) const;

private:
  struct Keyed
  {
    double key; ///< twice the middle along an axis
    int box;
  };

  /// Orders the boxes of a part of the list, and bounds them. \param keyed for its own use, as long as the
  /// list \return number of the node
  int build(int first, int end, std::vector<Keyed>& keyed);

  struct Node
  {
    Bounds<D> bounds;
    int first, end;  ///< of the list
    int left, right; ///< nodes below, or -1
  };
  std::vector<Bounds<D>> boxes_; ///< in the order of the list
  std::vector<int> list_;        ///< their numbers
  std::vector<Node> nodes_;
  static constexpr int deepest = 64; ///< more than the levels of a tree of as many boxes as an int can count
};

template <int D>
template <class IsWanted, class Visit>
void NearBoxes<D>::forEach(const IsWanted& isWanted, const Visit& visit) const
{
  int pending[deepest], count = 0;
  if (!nodes_.empty() && isWanted(nodes_[0].bounds))
    pending[count++] = 0;
  while (count > 0)
  {
    const Node& node = nodes_[pending[--count]];
    if (node.left < 0)
    {
      for (int k = node.first; k < node.end; ++k)
        if (isWanted(boxes_[k]))
          visit(list_[k]);
      continue;
    }
    for (const int below : {node.left, node.right})
      if (isWanted(nodes_[below].bounds))
        pending[count++] = below;
  }
}

template <int D>
template <class Distance, class Visit>
void NearBoxes<D>::forNearest(const Distance& distance, const double& limit, const Visit& visit) const
{
  struct Pending
  {
    double distance;
    int node;
  };
  Pending pending[deepest];
  int count = 0;
  if (!nodes_.empty())
    pending[count++] = {distance(nodes_[0].bounds), 0};
  while (count > 0)
  {
    const Pending next = pending[--count];
    if (next.distance > limit)
      continue;
    const Node& node = nodes_[next.node];
    if (node.left < 0)
    {
      for (int k = node.first; k < node.end; ++k)
        if (distance(boxes_[k]) <= limit)
          visit(list_[k]);
      continue;
    }
    const Pending left{distance(nodes_[node.left].bounds), node.left};
    const Pending right{distance(nodes_[node.right].bounds), node.right};
    const bool leftFirst = left.distance <= right.distance;
    pending[count++] = leftFirst ? right : left;
    pending[count++] = leftFirst ? left : right;
  }
}

} // namespace Rhegma::Geometry
