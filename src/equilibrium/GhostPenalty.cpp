#include "equilibrium/GhostPenalty.hpp"

#include "parallel/SendRows.hpp"
#include "state/Subdomain.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace Rhegma::equilibrium
{

namespace
{

/// A smaller weight of a node at a point is rounding of the point's position.
constexpr double leastNodeWeight = 1e-6;

/// Fraction of the ghost penalty between two cells without particles, into which boxes reach. It keeps the
/// matrix regular; more of it is force that a dynamic run which starts from this equilibrium does not have.
constexpr double reached = 0.1;

/// Whether a position lies in a cell of a lattice.
template <int D>
bool isOnLattice(const Grid<D>& grid, const Vector<D>& x)
{
  bool on = true;
  for (int d = 0; d < D; ++d)
  {
    const double at = grid.inCells(x[d], d);
    on = on && at >= 0.0 && at < grid.cells[d];
  }
  return on;
}

/// Numbers of a row of `fillings`.
template <int D>
constexpr int fillingWidth = 2 * D + 3;

/// What a particle fills, a row of numbers: its position, its volume [m3], Young's modulus times volume [N
/// m], its side of a crack, and half of the widths of its box. Those of this rank, then those of other ranks
/// in this rank's window.
template <int D>
std::vector<double> fillings(const State<D>& state)
{
  constexpr int width = fillingWidth<D>;
  constexpr double ofPoint = 1e-9; // a point on a row of nodes counts as in both cells
  const bool boxes = state.method.shape == ShapeKind::Gimp;
  BorrowedView<double* [D]> half;
  if (boxes)
    half = state.particles.template real<D>(fields::box);
  const auto position = state.particles.template real<D>(fields::position);
  const auto volume = state.particles.scalar(fields::volume);
  const auto material = state.particles.integer(fields::material);
  BorrowedView<int*> side;
  if (state.particles.has(fields::side))
    side = state.particles.integer(fields::side);
  std::vector<double> all, sent;
  std::vector<int> to;
  std::vector<Grid<D>> windows;
  for (int r = 0; state.mesh.subdomain && r < state.ranks.size(); ++r)
    windows.push_back(state.mesh.subdomain->division.window(r));
  for (int p = 0; p < state.particles.size(); ++p)
  {
    double row[width];
    Vector<D> x;
    for (int d = 0; d < D; ++d)
      x[d] = row[d] = position(p, d);
    row[D] = volume(p);
    row[D + 1] = volume(p) * youngModulus(state.materials.properties[material(p)]);
    row[D + 2] = side.extent(0) > 0 ? side(p) : 0;
    for (int d = 0; d < D; ++d)
      row[D + 3 + d] = boxes ? half(p, d) : ofPoint * state.mesh.grid.spacing;
    all.insert(all.end(), row, row + width);
    for (int r = 0; r < static_cast<int>(windows.size()); ++r)
      if (r != state.ranks.rank() && isOnLattice(windows[r], x))
      {
        to.push_back(r);
        sent.insert(sent.end(), row, row + width);
      }
  }
  if (!state.mesh.subdomain)
    return all;
  const std::vector<double> received = sendRows(state.ranks, to, sent, width);
  all.insert(all.end(), received.begin(), received.end());
  return all;
}

/// How full leaves are.
struct Filled
{
  std::vector<double> all, plus, minus; ///< of all particles, of those on sides +1 and -1 of cracks [m3]
  std::vector<double> stiff;            ///< Young's modulus times volume [N m]

  explicit Filled(int leaves) : all(leaves, 0.0), plus(leaves, 0.0), minus(leaves, 0.0), stiff(leaves, 0.0) {}
  double on(int leaf, int side) const
  {
    return all[leaf] - (side > 0 ? minus[leaf] : side < 0 ? plus[leaf] : 0.0);
  }
};

/// Finds the jumps at the faces between leaves, each from its smaller leaf.
template <int D>
class Finder
{
public:
  using Leaf = typename TreeSight<D>::Leaf;

  Finder(const State<D>& state, const RowGraph& graph)
      : grid_(state.mesh.grid),
        sight_(state.mesh.grid, state.mesh.tree),
        cracks_(state.cracks),
        graph_(graph),
        depth_(state.method.depth()),
        filled_(grid_.numNodes + static_cast<int>(state.mesh.tree.leafLevel.extent(0)))
  {
    if (state.mesh.subdomain)
      own_ = state.mesh.subdomain->own;
    std::vector<char> listed(filled_.all.size(), 0);
    const std::vector<double> fill = fillings(state);
    for (const double* at = fill.data(); at != fill.data() + fill.size(); at += fillingWidth<D>)
    {
      Vector<D> x;
      std::copy_n(at, D, x.c);
      const Leaf leaf = sight_.leafAt(x);
      const int n = numberOf(leaf);
      if (listed[n] == 0)
        leaves_.push_back(leaf);
      listed[n] = 1;
      filled_.all[n] += at[D];
      filled_.stiff[n] += at[D + 1];
      if (at[D + 2] != 0.0)
        (at[D + 2] > 0.0 ? filled_.plus : filled_.minus)[n] += at[D];
    }
    for (const double* at = fill.data(); at != fill.data() + fill.size(); at += fillingWidth<D>)
      addSpan(at);
    // Boxes of particles reach into leaves around those that hold the particles, over corners too.
    for (int round = 0; round < D; ++round)
      addNeighbours(listed);
  }

  std::vector<SlopeJump> find() const
  {
    std::vector<SlopeJump> jumps;
    Vector<D> middle;
    std::fill_n(middle.c, D, 0.5);
    for (const Leaf& leaf : leaves_)
      for (int axis = 0; axis < D && own_.hold(pointOf(leaf, middle)); ++axis)
        for (const int direction : {-1, 1})
          findAt(leaf, axis, direction, jumps);
    return jumps;
  }

private:
  static constexpr int lines = 1 << (D - 1); ///< of nodes normal to a face, through its corners

  int numberOf(const Leaf& leaf) const
  {
    return leaf.number < 0 ? -1 - leaf.number : grid_.numNodes + leaf.number;
  }

  /// Notes the pairs of leaves in which the box of a particle lies, where one of them has no particles: over
  /// a gap between two bodies, or two faces of a slot, no box reaches, and no jump may hold them together.
  void addSpan(const double* filling)
  {
    constexpr double rounding = 1e-10; // of cells: nodes at which a box ends by rounding have no rows
    constexpr int corners = 1 << D;
    int leaf[corners];
    bool apart = false;
    for (int c = 0; c < corners; ++c)
    {
      Vector<D> x;
      for (int d = 0; d < D; ++d)
        x[d] = filling[d] + ((c >> d & 1) != 0 ? 1.0 : -1.0) *
                                std::max(0.0, filling[D + 3 + d] - rounding * grid_.spacing);
      if (!isOnLattice(grid_, x))
        return;
      leaf[c] = numberOf(sight_.leafAt(x));
      apart = apart || leaf[c] != leaf[0];
    }
    const double young = filling[D + 1] / filling[D];
    for (int a = 0; a < corners && apart; ++a)
      for (int b = 0; b < a; ++b)
        if (leaf[a] != leaf[b] && (filled_.all[leaf[a]] == 0.0 || filled_.all[leaf[b]] == 0.0))
        {
          double& modulus = spanned_[std::minmax(leaf[a], leaf[b])];
          modulus = std::max(modulus, young);
        }
  }

  /// Young's modulus of the particles whose boxes lie in both of two leaves [Pa]; 0 where there are none.
  double modulusAcross(int a, int b) const
  {
    const auto found = spanned_.find(std::minmax(a, b));
    return found == spanned_.end() ? 0.0 : found->second;
  }

  /// Lists the leaves over a face of those that are listed.
  void addNeighbours(std::vector<char>& listed)
  {
    const std::size_t before = leaves_.size();
    for (std::size_t k = 0; k < before; ++k)
      for (int axis = 0; axis < D; ++axis)
        for (const int direction : {-1, 1})
          for (int part = 0; part < lines; ++part) // the leaf over a face may be smaller
          {
            Vector<D> at;
            for (int d = 0, bit = 0; d < D; ++d)
              at[d] = d == axis ? 0.5 + 0.75 * direction : (((part >> bit++) & 1) != 0 ? 0.75 : 0.25);
            const Vector<D> x = pointOf(leaves_[k], at);
            if (!isOnLattice(grid_, x))
              continue;
            const Leaf next = sight_.leafAt(x);
            const int n = numberOf(next);
            if (listed[n] == 0)
              leaves_.push_back(next);
            listed[n] = 1;
          }
  }

  /// A point from the lowest corner of a leaf, in its edges.
  Vector<D> pointOf(const Leaf& leaf, const Vector<D>& at) const
  {
    Vector<D> x;
    for (int d = 0; d < D; ++d)
      x[d] = grid_.origin[d] + (leaf.corner[d] + at[d] * leaf.edge) * grid_.spacing;
    return x;
  }

  void findAt(const Leaf& leaf, int axis, int direction, std::vector<SlopeJump>& jumps) const
  {
    Vector<D> middle;
    for (int d = 0; d < D; ++d)
      middle[d] = d == axis ? 0.5 + direction : 0.5;
    const Vector<D> over = pointOf(leaf, middle);
    if (!isOnLattice(grid_, over))
      return;
    const Leaf next = sight_.leafAt(over);
    if (next.level > leaf.level || (next.level == leaf.level && direction < 0))
      return; // found from the other side
    const int a = numberOf(leaf), b = numberOf(next);
    if ((filled_.all[a] == 0.0 || filled_.all[b] == 0.0) && modulusAcross(a, b) == 0.0)
      return;
    Line found[lines];
    for (int line = 0; line < lines; ++line)
      found[line] = lineAt(leaf, axis, direction, line);
    for (const Line& line : found)
      for (const int side : {line.crack, -line.crack})
      {
        const double weight = weightOf(leaf, next, a, b, side);
        if (weight > 0.0 &&
            std::all_of(found, found + lines, [&](const Line& other) { return isPresent(other.jump, side); }))
          jumps.push_back(onSide(line.jump, side, weight));
        if (line.crack == 0)
          break;
      }
  }

  /// Nodes of three points normal to a face.
  struct Line
  {
    SlopeJump jump; ///< with nodes in place of rows
    int crack = 0;  ///< whose sides differ there, 0: none
  };

  Line lineAt(const Leaf& leaf, int axis, int direction, int line) const
  {
    Line found;
    constexpr double second[] = {1.0, -2.0, 1.0};
    for (int k = 0; k < 3; ++k)
    {
      Vector<D> at;
      for (int d = 0, bit = 0; d < D; ++d)
        at[d] = d == axis ? (direction > 0 ? k : 1 - k) : (line >> bit++) & 1;
      sight_.forEachNode(pointOf(leaf, at), Vector<D>{},
                         [&](int node, double weight, const auto&)
                         {
                           if (weight < leastNodeWeight)
                             return;
                           found.jump.row.push_back(node);
                           found.jump.coefficient.push_back(second[k] * weight);
                           found.crack = std::max(found.crack, std::abs(nodeSide(node)));
                         });
    }
    return found;
  }

  double weightOf(const Leaf& leaf, const Leaf& next, int a, int b, int side) const
  {
    const auto fraction = [&](const Leaf& of, int number)
    { return filled_.on(number, side) / (std::pow(of.edge * grid_.spacing, D) * depthAt(of)); };
    if (std::min(fraction(leaf, a), fraction(next, b)) >= fullCell)
      return 0.0;
    const double both = filled_.all[a] + filled_.all[b];
    const double stiff =
        both > 0.0 ? (filled_.stiff[a] + filled_.stiff[b]) / both : reached * modulusAcross(a, b);
    return ghostFactor * stiff * std::pow(leaf.edge * grid_.spacing, D - 2) * 0.5 *
           (depthAt(leaf) + depthAt(next)) / lines;
  }

  /// Extent of a leaf normal to the plane, at its centre [m]; 1 in 3D.
  double depthAt(const Leaf& leaf) const
  {
    return depth_.at(grid_.origin[0] + (leaf.corner[0] + 0.5 * leaf.edge) * grid_.spacing);
  }

  /// Whether particles on a side see all nodes of a line.
  bool isPresent(const SlopeJump& nodes, int side) const
  {
    return std::all_of(nodes.row.begin(), nodes.row.end(), [&](int node) { return row(node, side) >= 0; });
  }

  SlopeJump onSide(const SlopeJump& nodes, int side, double weight) const
  {
    SlopeJump jump = nodes;
    jump.weight = weight;
    for (int& entry : jump.row)
      entry = row(entry, side);
    return jump;
  }

  int nodeSide(int node) const
  {
    return node < static_cast<int>(cracks_.nodeSide.extent(0)) ? cracks_.nodeSide(node) : 0;
  }

  /// Row of the field that a particle on a side sees at a node, or -1.
  int row(int node, int side) const
  {
    const int own = nodeSide(node);
    if (side == 0 || own != -side)
      return graph_.rowOf(node);
    const int enriched =
        node < static_cast<int>(cracks_.enrichedField.extent(0)) ? cracks_.enrichedField(node) : -1;
    return enriched < 0 ? -1 : graph_.rowOf(enriched);
  }

  const Grid<D>& grid_;
  TreeSight<D> sight_;
  const CrackSet<D>& cracks_;
  const RowGraph& graph_;
  Depth depth_;
  Filled filled_;
  std::map<std::pair<int, int>, double> spanned_; ///< see addSpan
  OwnCells<D> own_;                               ///< all cells on one rank
  std::vector<Leaf> leaves_; ///< those with particles, in the order of the particles, and those around them
};

} // namespace

template <int D>
std::vector<SlopeJump> findSlopeJumps(const State<D>& state, const RowGraph& graph)
{
  return Finder<D>(state, graph).find();
}

template std::vector<SlopeJump> findSlopeJumps(const State<2>&, const RowGraph&);
template std::vector<SlopeJump> findSlopeJumps(const State<3>&, const RowGraph&);

} // namespace Rhegma::equilibrium
