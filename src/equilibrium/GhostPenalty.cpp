#include "equilibrium/GhostPenalty.hpp"

namespace Rhegma::equilibrium
{

namespace
{

/// How full cells are, by their lowest node.
struct Filled
{
  std::vector<double> all, plus, minus; ///< of all particles, of those on sides +1 and -1 of cracks [m3]
  std::vector<double> stiff;            ///< Young's modulus times volume [N m]

  explicit Filled(int cells) : all(cells, 0.0), plus(cells, 0.0), minus(cells, 0.0), stiff(cells, 0.0) {}
  double on(int cell, int side) const
  {
    return all[cell] - (side > 0 ? minus[cell] : side < 0 ? plus[cell] : 0.0);
  }
};

template <int D>
Filled fillCells(const State<D>& state)
{
  const Grid<D>& grid = state.mesh.grid;
  Filled filled(grid.numNodes);
  const auto position = state.particles.template real<D>(fields::position);
  const auto volume = state.particles.scalar(fields::volume);
  const auto material = state.particles.integer(fields::material);
  BorrowedView<int*> side;
  if (state.particles.has(fields::side))
    side = state.particles.integer(fields::side);
  for (int p = 0; p < state.particles.size(); ++p)
  {
    int cell = 0;
    for (int d = 0; d < D; ++d)
      cell += grid.stride[d] * static_cast<int>(grid.inCells(position(p, d), d));
    filled.all[cell] += volume(p);
    filled.stiff[cell] += volume(p) * youngModulus(state.materials.properties[material(p)]);
    if (side.extent(0) > 0 && side(p) != 0)
      (side(p) > 0 ? filled.plus : filled.minus)[cell] += volume(p);
  }
  return filled;
}

/// Finds the jumps around nodes.
template <int D>
class Finder
{
public:
  Finder(const State<D>& state, const RowGraph& graph)
      : grid_(state.mesh.grid),
        cracks_(state.cracks),
        graph_(graph),
        filled_(fillCells(state)),
        volume_(std::pow(grid_.spacing, D) * state.method.thickness),
        weight_(ghostFactor * std::pow(grid_.spacing, D - 2) * state.method.thickness / faces)
  {
  }

  /// Adds the jumps across a node along an axis.
  void find(int node, int axis, std::vector<SlopeJump>& jumps) const
  {
    const int step = grid_.stride[axis];
    if (node < step || node + step >= grid_.numNodes)
      return;
    int crack = 0; // whose sides differ here
    for (const int n : {node, node - step, node + step})
      crack = crack == 0 ? std::abs(nodeSide(n)) : crack;
    for (const int side : {crack, -crack})
    {
      const SlopeJump jump{{row(node - step, side), row(node, side), row(node + step, side)},
                           weightOf(node, axis, side)};
      if (jump.weight > 0.0 && jump.row[0] >= 0 && jump.row[1] >= 0 && jump.row[2] >= 0)
        jumps.push_back(jump);
      if (crack == 0)
        break;
    }
  }

private:
  static constexpr int faces = 1 << (D - 1); ///< around a node, normal to an axis

  int nodeSide(int node) const { return cracks_.nodeSide.extent(0) > 0 ? cracks_.nodeSide(node) : 0; }

  /// Row of the field that a particle on a side sees at a node, or -1.
  int row(int node, int side) const
  {
    const int own = nodeSide(node);
    if (side == 0 || own != -side)
      return graph_.rowOf(node);
    const int enriched = cracks_.enrichedField.extent(0) > 0 ? cracks_.enrichedField(node) : -1;
    return enriched < 0 ? -1 : graph_.rowOf(enriched);
  }

  bool isPresent(int cell, int side) const
  {
    for (int corner = 0; corner < (1 << D); ++corner)
    {
      int node = cell;
      for (int d = 0; d < D; ++d)
        node += ((corner >> d) & 1) * grid_.stride[d];
      if (node >= grid_.numNodes || row(node, side) < 0)
        return false;
    }
    return true;
  }

  double weightOf(int node, int axis, int side) const
  {
    double sum = 0.0;
    for (int face = 0; face < faces; ++face)
    {
      int above = node, bit = 0;
      for (int d = 0; d < D; ++d)
        if (d != axis)
          above -= ((face >> bit++) & 1) * grid_.stride[d];
      const int below = above - grid_.stride[axis];
      if (below < 0 || !isPresent(below, side) || !isPresent(above, side))
        continue;
      const double least = std::min(filled_.on(below, side), filled_.on(above, side));
      const double all = filled_.all[below] + filled_.all[above];
      if (least < fullCell * volume_ && all > 0.0)
        sum += weight_ * (filled_.stiff[below] + filled_.stiff[above]) / all;
    }
    return sum;
  }

  const Grid<D>& grid_;
  const CrackSet<D>& cracks_;
  const RowGraph& graph_;
  Filled filled_;
  double volume_, weight_;
};

} // namespace

template <int D>
std::vector<SlopeJump> findSlopeJumps(const State<D>& state, const RowGraph& graph)
{
  std::vector<SlopeJump> jumps;
  const Finder<D> finder(state, graph);
  for (int r = 0; r < graph.rows; ++r)
    if (graph.nodeOf(r) < state.mesh.grid.numNodes)
      for (int axis = 0; axis < D; ++axis)
        finder.find(graph.nodeOf(r), axis, jumps);
  return jumps;
}

template std::vector<SlopeJump> findSlopeJumps(const State<2>&, const RowGraph&);
template std::vector<SlopeJump> findSlopeJumps(const State<3>&, const RowGraph&);

} // namespace Rhegma::equilibrium
