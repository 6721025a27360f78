#include "grid/FineNodes.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

namespace Rhegma
{

namespace
{

template <class Data, class List>
View<Data> viewOf(const std::string& label, const List& list)
{
  View<Data> view(Kokkos::view_alloc(label, Kokkos::WithoutInitializing), list.size());
  const auto host = Kokkos::create_mirror_view(view);
  if (!list.empty())
    std::memcpy(host.data(), list.data(), list.size() * sizeof(list.front()));
  Kokkos::deep_copy(view, host);
  return view;
}

/// Calls visit(offset, k) for the width^D offsets low, low + 1, ... along each axis, the first axis fastest.
template <int D, class Visit>
void forEachOffset(int low, int width, const Visit& visit)
{
  int all = 1;
  for (int d = 0; d < D; ++d)
    all *= width;
  for (int k = 0; k < all; ++k)
  {
    std::array<int, D> offset;
    int rest = k;
    for (int d = 0; d < D; ++d, rest /= width)
      offset[d] = low + rest % width;
    visit(offset, k);
  }
}

/// The content of the views of a tree.
template <int D>
class Builder
{
public:
  explicit Builder(const Branches<D>& branches)
      : branches_(branches), grid_(branches.grid()), leaves_(branches), nodes_(leaves_)
  {
  }

  void fill(Tree<D>& tree) const
  {
    tree.deepest = branches_.depth();
    tree.numFine = nodes_.size();
    ++tree.generation;
    tree.root = viewOf<int*>("rhegma::treeRoot", leaves_.root);
    tree.nearRefined = viewOf<char*>("rhegma::nearRefined", nearRefined());
    tree.child = viewOf<int* [corners_]>("rhegma::treeChild", leaves_.child);
    tree.leafLevel = viewOf<int*>("rhegma::leafLevel", leaves_.level);
    tree.leafCorner = viewOf<double* [D]>("rhegma::leafCorner", leafCorners());
    tree.masterCount = viewOf<int* [corners_]>("rhegma::masterCount", nodes_.masterCount);
    tree.master = viewOf<int* [corners_][Tree<D>::mastersPerCorner]>("rhegma::master", nodes_.master);
    fillSurroundings(tree);
    tree.finePosition = viewOf<double* [D]>("rhegma::finePlace", finePositions());
    fillFine(tree);
    tree.nodeVolume = viewOf<double*>("rhegma::nodeVolume", nodeVolumes());
    tree.nodeLevel = viewOf<int*>("rhegma::nodeLevel", nodeLevels());
  }

private:
  using Cell = std::array<int, D>;
  static constexpr int corners_ = Tree<D>::corners;

  std::vector<char> nearRefined() const
  {
    std::vector<char> near(grid_.numNodes, 0);
    for (const Cell& cell : branches_.cells(0))
      forEachOffset<D>(-1, 3,
                       [&](const Cell& offset, int)
                       {
                         const Cell at = sum(cell, offset);
                         if (branches_.isInside(0, at))
                           near[leaves_.lowestNode(at)] = 1;
                       });
    return near;
  }

  static Cell sum(Cell a, const Cell& b)
  {
    for (int d = 0; d < D; ++d)
      a[d] += b[d];
    return a;
  }

  std::vector<std::array<double, D>> leafCorners() const
  {
    std::vector<std::array<double, D>> all;
    all.reserve(leaves_.size());
    for (int l = 0; l < leaves_.size(); ++l)
      all.push_back(leaves_.position(leaves_.corner(l, 0)));
    return all;
  }

  void fillSurroundings(Tree<D>& tree) const
  {
    std::vector<int> alike(leaves_.size(), 0);
    std::vector<std::array<int, Tree<D>::nodesAround>> around(leaves_.size());
    for (int l = 0; l < leaves_.size(); ++l)
    {
      Neighbours leaf;
      forEachOffset<D>(-1, 3,
                       [&](const Cell& offset, int k)
                       {
                         leaf[k] = leaves_.leafAt(leaves_.level[l], sum(leaves_.cell[l], offset));
                         alike[l] |= leaf[k] >= 0 ? 1 << k : 0;
                       });
      forEachOffset<D>(-1, 4, [&](const Cell& offset, int k) { around[l][k] = adjacentNode(leaf, offset); });
    }
    tree.alike = viewOf<int*>("rhegma::alikeLeaves", alike);
    tree.around = viewOf<int * [Tree<D>::nodesAround]>("rhegma::nodesAround", around);
  }

  /// The leaves of equal size around a leaf, -1 where there is none.
  using Neighbours = std::array<int, D == 2 ? 9 : 27>;

  /// The node `offset` edges from the lowest corner of the leaf in the middle, as in Tree::around.
  int adjacentNode(const Neighbours& leaf, const Cell& offset) const
  {
    for (int k = 0; k < corners_; ++k)
    {
      int which = 0;
      bool exists = true;
      for (int d = D - 1; d >= 0; --d)
      {
        const int from = offset[d] - ((k >> d) & 1) + 1;
        exists = exists && from >= 0 && from < 3;
        which = 3 * which + from;
      }
      const int of = exists ? leaf[which] : -1;
      if (of >= 0)
        return nodes_.masterCount[of][k] == 1 ? nodes_.master[of][k][0] : -2 - (of * corners_ + k);
    }
    return -1;
  }

  std::vector<std::array<double, D>> finePositions() const
  {
    std::vector<std::array<double, D>> all;
    for (const Cell& fine : nodes_.positions())
      all.push_back(leaves_.position(fine));
    return all;
  }

  /// The nodes that are not nodes of the lattice, by the branch of their lattice cell; these branches come
  /// first.
  std::vector<std::vector<int>> fineByRoot() const
  {
    std::vector<std::vector<int>> list(branches_.cells(0).size());
    std::vector<char> listed(nodes_.size(), 0);
    for (int l = 0; l < leaves_.size(); ++l)
      for (int k = 0; k < corners_; ++k)
      {
        const int node = nodes_.master[l][k][0] - grid_.numNodes;
        if (nodes_.masterCount[l][k] > 1 || node < 0 || listed[node] != 0)
          continue;
        listed[node] = 1;
        Cell root;
        for (int d = 0; d < D; ++d)
          root[d] = leaves_.cell[l][d] >> leaves_.level[l];
        list[leaves_.root[leaves_.lowestNode(root)]].push_back(node + grid_.numNodes);
      }
    return list;
  }

  void fillFine(Tree<D>& tree) const
  {
    std::vector<int> begin{0}, all;
    for (const std::vector<int>& nodes : fineByRoot())
    {
      all.insert(all.end(), nodes.begin(), nodes.end());
      begin.push_back(static_cast<int>(all.size()));
    }
    tree.fineBegin = viewOf<int*>("rhegma::fineBegin", begin);
    tree.fineIn = viewOf<int*>("rhegma::fineIn", all);
  }

  /// Calls visit(leaf, node, weight) for the masters of all corners.
  template <class Visit>
  void forEachMaster(const Visit& visit) const
  {
    for (int l = 0; l < leaves_.size(); ++l)
      for (int k = 0; k < corners_; ++k)
        for (int m = 0; m < nodes_.masterCount[l][k]; ++m)
          visit(l, nodes_.master[l][k][m], 1.0 / nodes_.masterCount[l][k]);
  }

  std::vector<double> nodeVolumes() const
  {
    std::vector<double> volume(grid_.numNodes + nodes_.size(), 0.0);
    std::fill(volume.begin(), volume.begin() + grid_.numNodes, 1.0);
    for (const Cell& cell : branches_.cells(0))
      forEachOffset<D>(0, 2,
                       [&](const Cell& offset, int)
                       { volume[leaves_.lowestNode(sum(cell, offset))] -= 1.0 / corners_; });
    forEachMaster([&](int l, int node, double weight)
                  { volume[node] += std::ldexp(weight / corners_, -D * leaves_.level[l]); });
    return volume;
  }

  std::vector<int> nodeLevels() const
  {
    std::vector<int> level(grid_.numNodes + nodes_.size(), 0);
    forEachMaster([&](int l, int node, double) { level[node] = std::max(level[node], leaves_.level[l]); });
    return level;
  }

  const Branches<D>& branches_;
  const Grid<D>& grid_;
  LeafList<D> leaves_;
  FineNodes<D> nodes_;
};

} // namespace

template <int D>
void buildTree(const Branches<D>& branches, Tree<D>& tree)
{
  if (branches.depth() == 0)
  {
    const int generation = tree.generation + 1;
    tree = Tree<D>();
    tree.generation = generation;
    return;
  }
  Builder<D>(branches).fill(tree);
}

template void buildTree(const Branches<2>&, Tree<2>&);
template void buildTree(const Branches<3>&, Tree<3>&);

} // namespace Rhegma
