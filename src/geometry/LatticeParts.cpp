#include "geometry/LatticeParts.hpp"

#include <algorithm>
#include <array>

namespace Rhegma::Geometry
{

namespace
{

/// The part of a box about `own` that is inside; of the fraction 0 where there is none.
template <int D>
LatticePart<D> partOf(const Vector<D>& edge, const Frame<D>& frame, const Vector<D>& own,
                      const Region<D>& region)
{
  const OrientedBox<D> box{frame.toSpace(own), edge, frame.axes};
  const BoxPart<D> found = region.exact ? region.exact(own, edge) : partOfBox(box, region);
  LatticePart<D> part{{}, 1.0, own, {}};
  const bool whole = found.fraction >= 1.0 - tiny;
  if (!whole)
    part.fraction = found.fraction > tiny ? found.fraction : 0.0;
  for (int d = 0; d < D; ++d)
  {
    part.centroid[d] += whole ? 0.0 : edge[d] * found.centroid[d];
    part.variance[d] = edge[d] * edge[d] * (whole ? 1.0 / 12.0 : found.variance[d]);
  }
  return part;
}

/// Adds a part of a lattice cell about `own` that is in a region. One whose centroid is outside lies on both
/// sides of a slot or round a corner: the parts of the cell's halves along each axis are then added instead.
template <int D>
void addPartOf(const Lattice<D>& lattice, const Frame<D>& frame, const Vector<D>& own,
               const Region<D>& region, const decltype(LatticePart<D>::cell)& cell,
               std::vector<LatticePart<D>>& parts)
{
  const auto add = [&](LatticePart<D> part)
  {
    part.cell = cell;
    parts.push_back(part);
  };
  const LatticePart<D> whole = partOf(lattice.edge, frame, own, region);
  if (whole.fraction == 0.0)
    return;
  if (whole.fraction == 1.0 || region.depth(frame.toSpace(whole.centroid)) >= 0.0)
    return add(whole);
  for (int k = 0; k < 1 << D; ++k)
  {
    Vector<D> at = own;
    for (int d = 0; d < D; ++d)
      at[d] += (k >> d & 1 ? 0.25 : -0.25) * lattice.edge[d];
    LatticePart<D> part = partOf(0.5 * lattice.edge, frame, at, region);
    part.fraction /= 1 << D;
    if (part.fraction > tiny)
      add(part);
  }
}

/// A body, as the cells of its lattice meet it.
template <int D>
struct Filling
{
  const Frame<D>& frame;
  const Region<D>& region;
  const SeedRules<D>& rules;
  bool isBox;       ///< along the lattice
  Bounds<D> bounds; ///< of the base shape, along the lattice
};

/// The part of a cell of a lattice that is in a box along the lattice.
template <int D>
struct CellInBox
{
  Vector<D> middle;      ///< own coordinates [m]
  Vector<D> edge;        ///< [m]
  double fraction = 1.0; ///< of the cell; 0: none

  CellInBox(const Vector<D>& own, const Vector<D>& whole, const Bounds<D>& box) : middle(own), edge(whole)
  {
    for (int d = 0; d < D; ++d)
    {
      const double low = std::max(own[d] - 0.5 * whole[d], box.lower[d]),
                   high = std::min(own[d] + 0.5 * whole[d], box.upper[d]);
      const double along = (high - low) / whole[d];
      if (along >= 1.0 - tiny)
        continue;
      fraction *= along > tiny ? along : 0.0;
      middle[d] = 0.5 * (low + high);
      edge[d] = high - low;
    }
  }
};

template <int D>
Coverage coverageOf(const Filling<D>& body, const OrientedBox<D>& box)
{
  BoxPoints<D> points;
  points.centre = box.centre;
  points.reach = 0.5 * norm(box.edge);
  for (int k = 0; k < 1 << D; ++k)
  {
    points.corners[k] = box.centre;
    for (int d = 0; d < D; ++d)
      points.corners[k] = points.corners[k] + ((k >> d & 1) != 0 ? 0.5 : -0.5) * box.edge[d] * box.axes[d];
  }
  return body.isBox ? Coverage::Whole : body.region.coverage(points);
}

/// Adds the parts of a lattice cell about `own`: one on each side of the surfaces that divide it.
template <int D>
void addParts(const Lattice<D>& lattice, const Filling<D>& body, const BoxCuts<D>& cuts, const Vector<D>& own,
              const decltype(LatticePart<D>::cell)& cell, std::vector<LatticePart<D>>& parts)
{
  constexpr std::size_t most = 4; // more surfaces in one cell: more than 16 parts
  Lattice<D> filled = lattice;
  Vector<D> middle = own;
  double inBox = 1.0; // fraction of the cell
  if (body.isBox)
  {
    const CellInBox<D> part(own, lattice.edge, body.bounds);
    filled.edge = part.edge;
    middle = part.middle;
    inBox = part.fraction;
  }
  if (inBox == 0.0)
    return;
  const std::size_t before = parts.size();
  if (!cuts.through.empty() && cuts.through.size() <= most)
  {
    const OrientedBox<D> box{body.frame.toSpace(middle), filled.edge, body.frame.axes};
    // A cell whose sides lie on the surface may be full although that is not certain at once.
    const bool whole = coverageOf(body, box) == Coverage::Whole ||
                       partOf(filled.edge, body.frame, middle, body.region).fraction == 1.0;
    for (int sides = 0; sides < 1 << cuts.through.size(); ++sides)
      addPartOf(filled, body.frame, middle, onSides(body.region, whole, cuts.through, sides), cell, parts);
  }
  else if (body.isBox)
  {
    Vector<D> variance;
    for (int d = 0; d < D; ++d)
      variance[d] = filled.edge[d] * filled.edge[d] / 12.0;
    parts.push_back({cell, 1.0, middle, variance});
  }
  else
    addPartOf(filled, body.frame, middle, body.region, cell, parts);
  for (std::size_t k = before; k < parts.size(); ++k)
    parts[k].fraction *= inBox;
}

/// Divides the cells of a lattice where `isDivided` says so, and adds their parts.
template <int D>
class Division
{
public:
  Division(const Lattice<D>& lattice, const Filling<D>& body) : body_(body), lattices_{lattice} {}

  void add(const Vector<D>& own, const decltype(LatticePart<D>::cell)& cell) { add(own, cell, 0, 0, -1); }

  PartsOfLevels<D> parts{{}};

private:
  void add(const Vector<D>& own, const decltype(LatticePart<D>::cell)& cell, int level, int lineage,
           int family)
  {
    const Vector<D> edge = lattices_[level].edge;
    const OrientedBox<D> box{body_.frame.toSpace(own), edge, body_.frame.axes};
    BoxCuts<D> cuts;
    if (body_.rules.cuts.ofBox)
      cuts = body_.rules.cuts.ofBox(box);
    const bool isWhole = !cuts.any && (body_.isBox ? CellInBox<D>(own, edge, body_.bounds).fraction == 1.0
                                                   : body_.rules.isDivided && isFull(own, edge));
    // Whole particles of a box can be divided later, exactly.
    const bool divided =
        body_.rules.isDivided && !(isWhole && body_.isBox) && body_.rules.isDivided(box, level);
    if (divided && family < 0) // that of a cell that is not whole has no family
      family = isWhole ? families_++ : -1;
    if (divided)
      return divide(own, cell, level, lineage, family);
    std::vector<LatticePart<D>>& these = parts[level];
    const std::size_t before = these.size();
    addParts(lattices_[level], body_, cuts, own, cell, these);
    for (std::size_t k = before; k < these.size(); ++k)
    {
      these[k].least = cuts.through.empty() ? body_.rules.joinedBelow : body_.rules.joinedBelowAtCuts;
      these[k].lineage = lineage;
      these[k].family = these[k].fraction == 1.0 ? family : -1;
    }
  }

  bool isFull(const Vector<D>& own, const Vector<D>& edge) const
  {
    return partOf(edge, body_.frame, own, body_.region).fraction == 1.0;
  }

  void divide(const Vector<D>& own, const decltype(LatticePart<D>::cell)& cell, int level, int lineage,
              int family)
  {
    const Vector<D> edge = lattices_[level].edge;
    if (static_cast<int>(parts.size()) == level + 1)
    {
      parts.emplace_back();
      lattices_.push_back(lattices_[level]);
      lattices_.back().edge = 0.5 * edge;
    }
    for (int k = 0; k < 1 << D; ++k)
    {
      Vector<D> at = own;
      auto child = cell;
      for (int d = 0; d < D; ++d)
      {
        at[d] += ((k >> d & 1) != 0 ? 0.25 : -0.25) * edge[d];
        child[d] = 2 * cell[d] + (k >> d & 1);
      }
      add(at, child, level + 1, lineage << D | k, family);
    }
  }

  const Filling<D>& body_;
  std::vector<Lattice<D>> lattices_; ///< of each level
  int families_ = 0;
};

} // namespace

template <int D>
PartsOfLevels<D> partsOfCells(const Lattice<D>& lattice, const Shape<D>& shape, const SeedRules<D>& rules)
{
  Region<D> region{[&](const Vector<D>& x) { return shape.depth(x); },
                   [&](const BoxPoints<D>& box) { return shape.coverage(box); }};
  if (shape.parts().size() == 1)
    std::visit(
        [&](const auto& primitive)
        {
          using Kind = std::decay_t<decltype(primitive)>;
          if constexpr (std::is_same_v<Kind, VoxelShape<D>> || std::is_same_v<Kind, FileShape<D>>)
            region.exact = [&primitive](const Vector<D>& own, const Vector<D>& edge)
            { return primitive.part(own, edge); };
        },
        shape.base().primitive);
  const bool isBox = shape.parts().size() == 1 && std::holds_alternative<Box<D>>(shape.base().primitive);
  const Filling<D> body{shape.base().frame, region, rules, isBox, shape.base().ownBounds()};
  Division<D> division(lattice, body);
  long long counts[3] = {1, 1, 1};
  for (int d = 0; d < D; ++d)
    counts[d] = static_cast<long long>(lattice.count[d]);
  for (long long k = 0; k < counts[2]; ++k)
    for (long long j = 0; j < counts[1]; ++j)
      for (long long i = 0; i < counts[0]; ++i)
      {
        const long long index[3] = {i, j, k};
        const double middle[3] = {double(i) + 0.5, double(j) + 0.5, double(k) + 0.5};
        std::array<long long, D> cell;
        std::copy(index, index + D, cell.begin());
        division.add(lattice.positionOf(middle), cell);
      }
  for (std::size_t level = 1; level < division.parts.size(); ++level)
    sortByCell<D>(division.parts[level]);
  return std::move(division.parts);
}

template PartsOfLevels<2> partsOfCells(const Lattice<2>&, const Shape<2>&, const SeedRules<2>&);
template PartsOfLevels<3> partsOfCells(const Lattice<3>&, const Shape<3>&, const SeedRules<3>&);

} // namespace Rhegma::Geometry
