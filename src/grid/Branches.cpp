#include "grid/Branches.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace Rhegma
{

namespace
{

constexpr int bitsPerAxis = 21; // 2^21 cells an axis at the finest level

template <int D>
std::array<int, D> halved(const std::array<int, D>& cell)
{
  std::array<int, D> half;
  for (int d = 0; d < D; ++d)
    half[d] = cell[d] >> 1;
  return half;
}

template <class Data, class List>
View<Data> viewOf(const std::string& label, const List& list)
{
  View<Data> view(Kokkos::view_alloc(label, Kokkos::WithoutInitializing), list.size());
  const auto host = Kokkos::create_mirror_view(view);
  using Value = typename View<Data>::non_const_value_type;
  auto* to = reinterpret_cast<Value*>(host.data());
  constexpr std::size_t width = sizeof(typename List::value_type) / sizeof(Value);
  for (std::size_t i = 0; i < list.size(); ++i)
  {
    const auto* from = reinterpret_cast<const Value*>(&list[i]);
    std::copy(from, from + width, to + i * width);
  }
  Kokkos::deep_copy(view, host);
  return view;
}

} // namespace

template <int D>
std::uint64_t Branches<D>::key(const Cell& cell) const
{
  std::uint64_t packed = 0;
  for (int k = 0; k < D; ++k) // the slowest axis of the lattice first
    packed = packed << bitsPerAxis | static_cast<std::uint64_t>(cell[grid_.axisOrder[k]]);
  return packed;
}

template <int D>
typename Branches<D>::Cell Branches<D>::cellOf(std::uint64_t packed) const
{
  Cell cell;
  for (int k = D - 1; k >= 0; --k)
  {
    cell[grid_.axisOrder[k]] = static_cast<int>(packed & ((std::uint64_t(1) << bitsPerAxis) - 1));
    packed >>= bitsPerAxis;
  }
  return cell;
}

template <int D>
bool Branches<D>::isInside(int level, const Cell& cell) const
{
  bool inside = true;
  for (int d = 0; d < D; ++d)
    inside = inside && cell[d] >= 0 && cell[d] < grid_.cells[d] << level;
  return inside;
}

template <int D>
bool Branches<D>::isRefined(int level, const Cell& cell) const
{
  return level < depth() && levels_[level].count(key(cell)) > 0;
}

template <int D>
void Branches<D>::refine(int level, const Cell& cell)
{
  if (depth() <= level)
    levels_.resize(level + 1);
  Cell at = cell;
  for (int l = level; l >= 0; --l)
  {
    if (!levels_[l].insert(key(at)).second)
      return;
    at = halved<D>(at);
  }
}

template <int D>
void Branches<D>::balance()
{
  for (int level = depth() - 1; level > 0; --level)
    for (const Cell& cell : cells(level))
    {
      Cell at;
      int around = 1;
      for (int d = 0; d < D; ++d)
        around *= 3;
      for (int k = 0; k < around; ++k)
      {
        int rest = k;
        for (int d = 0; d < D; ++d, rest /= 3)
          at[d] = cell[d] + rest % 3 - 1;
        if (isInside(level, at))
          refine(level - 1, halved<D>(at));
      }
    }
}

template <int D>
std::vector<typename Branches<D>::Cell> Branches<D>::cells(int level) const
{
  std::vector<std::uint64_t> keys(levels_[level].begin(), levels_[level].end());
  std::sort(keys.begin(), keys.end());
  std::vector<Cell> all;
  all.reserve(keys.size());
  for (const std::uint64_t packed : keys)
    all.push_back(cellOf(packed));
  return all;
}

namespace
{

/// What is found out on the host before it becomes views.
template <int D>
class Builder
{
public:
  explicit Builder(const Branches<D>& branches)
      : branches_(branches), grid_(branches.grid()), depth_(branches.depth())
  {
    numberBranches();
    listLeaves();
    findMasters();
  }

  void fill(Tree<D>& tree) const
  {
    tree.deepest = depth_;
    tree.numFine = static_cast<int>(fine_.size());
    ++tree.generation;
    tree.root = viewOf<int*>("rhegma::treeRoot", root_);
    tree.nearRefined = viewOf<char*>("rhegma::nearRefined", nearRefined());
    tree.child = viewOf<int * [Tree<D>::corners]>("rhegma::treeChild", child_);
    tree.leafLevel = viewOf<int*>("rhegma::leafLevel", level_);
    tree.leafCorner = viewOf<double* [D]>("rhegma::leafCorner", corners());
    tree.masterCount = viewOf<int * [Tree<D>::corners]>("rhegma::masterCount", masterCount_);
    tree.master = viewOf<int * [Tree<D>::corners][Tree<D>::mastersPerCorner]>("rhegma::master", master_);
    tree.finePlace = viewOf<double* [D]>("rhegma::finePlace", finePlaces());
    fillFine(tree);
    tree.share = viewOf<double*>("rhegma::nodeShare", shares());
    tree.nodeLevel = viewOf<int*>("rhegma::nodeLevel", nodeLevels());
  }

private:
  using Cell = std::array<int, D>;
  static constexpr int corners_ = Tree<D>::corners;

  /// The children of branches are branches, numbered level by level, or leaves.
  void numberBranches()
  {
    root_.assign(grid_.numNodes, -1);
    for (int level = 0; level < depth_; ++level)
      for (const Cell& cell : branches_.cells(level))
      {
        number_[{level, cell}] = static_cast<int>(child_.size());
        child_.push_back({});
        cell_.push_back(cell);
        levelOf_.push_back(level);
        if (level == 0)
          root_[nodeOf(cell)] = number_[{level, cell}];
      }
  }

  void listLeaves()
  {
    for (std::size_t b = 0; b < child_.size(); ++b)
      for (int k = 0; k < corners_; ++k)
      {
        Cell part;
        for (int d = 0; d < D; ++d)
          part[d] = 2 * cell_[b][d] + ((k >> d) & 1);
        const auto found = number_.find({levelOf_[b] + 1, part});
        if (found != number_.end())
        {
          child_[b][k] = found->second;
          continue;
        }
        child_[b][k] = -1 - static_cast<int>(leaf_.size());
        leaf_.push_back(part);
        level_.push_back(levelOf_[b] + 1);
      }
  }

  int nodeOf(const Cell& cell) const
  {
    int at[D];
    for (int d = 0; d < D; ++d)
      at[d] = cell[d];
    return grid_.nodeIndex(at);
  }

  /// Edge of a cell in finest cells.
  int edge(int level) const { return 1 << (depth_ - level); }

  /// The corners, in finest cells, between which a place of the finest lattice hangs; itself alone where it
  /// hangs nowhere.
  std::vector<Cell> mastersOf(const Cell& place) const
  {
    for (int k = 0; k < corners_; ++k)
    {
      // The leaf on one of the sides of the place.
      Cell inside;
      bool exists = true;
      for (int d = 0; d < D; ++d)
      {
        inside[d] = place[d] - 1 + ((k >> d) & 1);
        exists = exists && inside[d] >= 0 && inside[d] < grid_.cells[d] << depth_;
      }
      if (!exists)
        continue;
      int level = 0;
      Cell cell;
      for (;; ++level)
      {
        for (int d = 0; d < D; ++d)
          cell[d] = inside[d] >> (depth_ - level);
        if (!branches_.isRefined(level, cell))
          break;
      }
      const int size = edge(level);
      bool hangs = false;
      for (int d = 0; d < D; ++d)
        hangs = hangs || place[d] % size != 0;
      if (!hangs)
        continue;
      std::vector<Cell> masters{place};
      for (int d = 0; d < D; ++d)
        if (place[d] % size != 0)
        {
          const std::size_t count = masters.size();
          for (std::size_t m = 0; m < count; ++m)
          {
            masters.push_back(masters[m]);
            masters[m][d] = cell[d] * size;
            masters.back()[d] = (cell[d] + 1) * size;
          }
        }
      return masters;
    }
    return {place};
  }

  bool onLattice(const Cell& place) const
  {
    bool on = true;
    for (int d = 0; d < D; ++d)
      on = on && place[d] % edge(0) == 0;
    return on;
  }

  Cell onGrid(const Cell& place) const
  {
    Cell node;
    for (int d = 0; d < D; ++d)
      node[d] = place[d] / edge(0);
    return node;
  }

  void findMasters()
  {
    std::map<Cell, std::vector<Cell>> mastersAt;
    for (std::size_t l = 0; l < leaf_.size(); ++l)
      for (int k = 0; k < corners_; ++k)
      {
        const Cell place = cornerOf(l, k);
        if (mastersAt.count(place) == 0)
          mastersAt[place] = mastersOf(place);
      }
    for (const auto& entry : mastersAt)
      for (const Cell& place : entry.second)
        if (!onLattice(place))
          fine_[place] = 0;
    int next = grid_.numNodes;
    for (auto& entry : fine_)
      entry.second = next++;
    masterCount_.resize(leaf_.size());
    master_.resize(leaf_.size());
    for (std::size_t l = 0; l < leaf_.size(); ++l)
      for (int k = 0; k < corners_; ++k)
      {
        const std::vector<Cell>& masters = mastersAt[cornerOf(l, k)];
        masterCount_[l][k] = static_cast<int>(masters.size());
        master_[l][k].fill(0);
        for (std::size_t m = 0; m < masters.size(); ++m)
          master_[l][k][m] = onLattice(masters[m]) ? nodeOf(onGrid(masters[m])) : fine_.at(masters[m]);
      }
  }

  Cell cornerOf(std::size_t leaf, int k) const
  {
    Cell place;
    for (int d = 0; d < D; ++d)
      place[d] = (leaf_[leaf][d] + ((k >> d) & 1)) * edge(level_[leaf]);
    return place;
  }

  std::vector<char> nearRefined() const
  {
    std::vector<char> near(grid_.numNodes, 0);
    int around = 1;
    for (int d = 0; d < D; ++d)
      around *= 3;
    for (const Cell& cell : branches_.cells(0))
      for (int k = 0; k < around; ++k)
      {
        Cell at;
        int rest = k;
        bool exists = true;
        for (int d = 0; d < D; ++d, rest /= 3)
        {
          at[d] = cell[d] + rest % 3 - 1;
          exists = exists && at[d] >= 0 && at[d] < grid_.cells[d];
        }
        if (exists)
          near[nodeOf(at)] = 1;
      }
    return near;
  }

  std::array<double, D> placeOf(const Cell& place) const
  {
    std::array<double, D> x;
    for (int d = 0; d < D; ++d)
      x[d] = grid_.origin[d] + std::ldexp(static_cast<double>(place[d]), -depth_) * grid_.spacing;
    return x;
  }

  std::vector<std::array<double, D>> corners() const
  {
    std::vector<std::array<double, D>> all;
    for (std::size_t l = 0; l < leaf_.size(); ++l)
      all.push_back(placeOf(cornerOf(l, 0)));
    return all;
  }

  std::vector<std::array<double, D>> finePlaces() const
  {
    std::vector<std::array<double, D>> all;
    for (const auto& entry : fine_)
      all.push_back(placeOf(entry.first));
    return all;
  }

  /// The nodes beside the lattice's by the branch that a cell of the lattice is; these come first.
  std::vector<std::vector<int>> fineByRoot() const
  {
    std::vector<std::vector<int>> list(branches_.cells(0).size());
    std::vector<char> listed(fine_.size(), 0);
    for (std::size_t l = 0; l < leaf_.size(); ++l)
      for (int k = 0; k < corners_; ++k)
      {
        const int node = master_[l][k][0] - grid_.numNodes;
        if (masterCount_[l][k] > 1 || node < 0 || listed[node] != 0)
          continue;
        listed[node] = 1;
        Cell root;
        for (int d = 0; d < D; ++d)
          root[d] = leaf_[l][d] >> level_[l];
        list[root_[nodeOf(root)]].push_back(node + grid_.numNodes);
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

  /// Calls work(leaf, node, weight) for the masters of all corners.
  template <class Work>
  void forEachMaster(const Work& work) const
  {
    for (std::size_t l = 0; l < leaf_.size(); ++l)
      for (int k = 0; k < corners_; ++k)
        for (int m = 0; m < masterCount_[l][k]; ++m)
          work(l, master_[l][k][m], 1.0 / masterCount_[l][k]);
  }

  std::vector<double> shares() const
  {
    std::vector<double> share(grid_.numNodes + fine_.size(), 0.0);
    std::fill(share.begin(), share.begin() + grid_.numNodes, 1.0);
    for (const Cell& cell : branches_.cells(0))
      for (int k = 0; k < corners_; ++k)
      {
        Cell corner = cell;
        for (int d = 0; d < D; ++d)
          corner[d] += (k >> d) & 1;
        share[nodeOf(corner)] -= 1.0 / corners_;
      }
    forEachMaster([&](std::size_t l, int node, double weight)
                  { share[node] += std::ldexp(weight / corners_, -D * level_[l]); });
    return share;
  }

  std::vector<int> nodeLevels() const
  {
    std::vector<int> level(grid_.numNodes + fine_.size(), 0);
    forEachMaster([&](std::size_t l, int node, double) { level[node] = std::max(level[node], level_[l]); });
    return level;
  }

  const Branches<D>& branches_;
  const Grid<D>& grid_;
  int depth_;
  std::map<std::pair<int, Cell>, int> number_;
  std::vector<int> root_, levelOf_, level_;
  std::vector<Cell> cell_, leaf_;
  std::vector<std::array<int, corners_>> child_, masterCount_;
  std::vector<std::array<std::array<int, Tree<D>::mastersPerCorner>, corners_>> master_;
  std::map<Cell, int> fine_;
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

template class Branches<2>;
template class Branches<3>;
template void buildTree(const Branches<2>&, Tree<2>&);
template void buildTree(const Branches<3>&, Tree<3>&);

} // namespace Rhegma
