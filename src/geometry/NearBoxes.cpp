#include "geometry/NearBoxes.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace Rhegma::Geometry
{

namespace
{

constexpr int mostInLeaf = 8;

template <int D>
bool areNear(const Bounds<D>& a, const Bounds<D>& b, double gap)
{
  for (int d = 0; d < D; ++d)
    if (a.lower[d] > b.upper[d] + gap || b.lower[d] > a.upper[d] + gap)
      return false;
  return true;
}

} // namespace

template <int D>
NearBoxes<D>::NearBoxes(std::vector<Bounds<D>> boxes) : boxes_(std::move(boxes)), list_(boxes_.size())
{
  std::iota(list_.begin(), list_.end(), 0);
  std::vector<Keyed> keyed(list_.size());
  if (!list_.empty())
    build(0, static_cast<int>(list_.size()), keyed);
  // Boxes of a leaf next to each other: a search among a million waits for memory more than for anything
  // else.
  std::vector<Bounds<D>> ordered;
  ordered.reserve(list_.size());
  for (const int box : list_)
    ordered.push_back(boxes_[box]);
  boxes_ = std::move(ordered);
}

template <int D>
int NearBoxes<D>::build(int first, int end, std::vector<Keyed>& keyed)
{
  Bounds<D> all = emptyBounds<D>();
  for (int k = first; k < end; ++k)
    all.include(boxes_[list_[k]]);
  const int node = static_cast<int>(nodes_.size());
  nodes_.push_back({all, first, end, -1, -1});
  if (end - first <= mostInLeaf)
    return node;
  int axis = 0;
  for (int d = 1; d < D; ++d)
    if (all.upper[d] - all.lower[d] > all.upper[axis] - all.lower[axis])
      axis = d;
  const int middle = (first + end) / 2;
  // Next to their keys, boxes are ordered in about half the time.
  for (int k = first; k < end; ++k)
    keyed[k] = {boxes_[list_[k]].lower[axis] + boxes_[list_[k]].upper[axis], list_[k]};
  std::nth_element(keyed.begin() + first, keyed.begin() + middle, keyed.begin() + end,
                   [](const Keyed& a, const Keyed& b)
                   { return a.key != b.key ? a.key < b.key : a.box < b.box; });
  for (int k = first; k < end; ++k)
    list_[k] = keyed[k].box;
  const int left = build(first, middle, keyed), right = build(middle, end, keyed);
  nodes_[node].left = left;
  nodes_[node].right = right;
  return node;
}

template <int D>
std::vector<int> NearBoxes<D>::near(const Bounds<D>& box, double gap) const
{
  std::vector<int> found, pending;
  if (!nodes_.empty())
    pending.push_back(0);
  while (!pending.empty())
  {
    const Node& node = nodes_[pending.back()];
    pending.pop_back();
    if (!areNear(node.bounds, box, gap))
      continue;
    if (node.left >= 0)
    {
      pending.push_back(node.left);
      pending.push_back(node.right);
    }
    else
      for (int k = node.first; k < node.end; ++k)
        if (areNear(boxes_[k], box, gap))
          found.push_back(list_[k]);
  }
  std::sort(found.begin(), found.end());
  return found;
}

template class NearBoxes<2>;
template class NearBoxes<3>;

} // namespace Rhegma::Geometry
