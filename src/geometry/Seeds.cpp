#include "geometry/Seeds.hpp"

#include "geometry/Slivers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>

namespace Rhegma
{
namespace
{

/// Cells of the lattice, counted from the base shape's lower corner; `first` may be negative.
template <int D>
struct Lattice
{
  Vector<D> origin; ///< own coordinates [m]
  Vector<D> edge;   ///< [m]
  double first[D];
  double count[D];
};

/// Bounds of the whole shape in the base shape's own coordinates; exact where nothing is added.
template <int D>
Geometry::Bounds<D> reach(const Shape<D>& shape)
{
  const Geometry::Part<D>& base = shape.base();
  Geometry::Bounds<D> result = base.ownBounds();
  for (const auto& part : shape.parts())
    if (&part != &base && part.operation == Geometry::Operation::Add)
      for (const auto& corner : part.bounds().corners())
        result.include(base.frame.toOwn(corner));
  return result;
}

/// Whether own coordinates are those of space.
template <int D>
bool isAlongAxes(const Geometry::Frame<D>& frame)
{
  bool found = true;
  for (int d = 0; d < D; ++d)
    found = found && frame.axes[d][d] == 1.0;
  return found;
}

template <int D>
Lattice<D> makeLattice(const Shape<D>& shape, double edge, const std::optional<Vector<D>>& node = {})
{
  const Geometry::Bounds<D> base = shape.base().ownBounds();
  const Geometry::Bounds<D> all = reach(shape);
  Lattice<D> lattice;
  lattice.origin = base.lower;
  for (int d = 0; d < D; ++d)
  {
    // A part that ends on a lattice line must not get an additional row because of rounding.
    const double slack = 1.0e-9;
    if (node && isAlongAxes(shape.base().frame))
    {
      lattice.edge[d] = edge;
      lattice.origin[d] = (*node)[d];
      lattice.first[d] = std::floor((all.lower[d] - (*node)[d]) / edge + slack);
      lattice.count[d] = std::ceil((all.upper[d] - (*node)[d]) / edge - slack) - lattice.first[d];
      continue;
    }
    const double length = base.upper[d] - base.lower[d];
    const double across = std::max(1.0, std::round(length / edge));
    lattice.edge[d] = length / across;
    lattice.first[d] = std::floor((all.lower[d] - base.lower[d]) / lattice.edge[d] + slack);
    const double last = std::ceil((all.upper[d] - base.lower[d]) / lattice.edge[d] - slack);
    lattice.count[d] = last - lattice.first[d];
  }
  return lattice;
}

template <int D>
using Part = Geometry::LatticePart<D>;

/// Smaller fractions of a cell are rounding.
constexpr double tiny = 1e-9;

template <int D>
void refuseMany(const Lattice<D>& lattice, const std::string& section)
{
  double total = 1.0;
  for (int d = 0; d < D; ++d)
    total *= lattice.count[d];
  if (total < std::numeric_limits<int>::max())
    return;
  std::ostringstream message;
  message << section << ": the body would need about " << total << " particles, more than "
          << std::numeric_limits<int>::max() << "; make the cells larger or the body smaller.";
  throw std::invalid_argument(message.str());
}

template <int D>
Vector<D> positionOf(const Lattice<D>& lattice, const double (&index)[3])
{
  Vector<D> own;
  for (int d = 0; d < D; ++d)
    own[d] = lattice.origin[d] + (lattice.first[d] + index[d]) * lattice.edge[d];
  return own;
}

/// The part of a box about `own` that is inside; of the fraction 0 where there is none.
template <int D>
Part<D> partOf(const Vector<D>& edge, const Geometry::Frame<D>& frame, const Vector<D>& own,
               const Geometry::Region<D>& region)
{
  const Geometry::OrientedBox<D> box{frame.toSpace(own), edge, frame.axes};
  const Geometry::BoxPart<D> found = Geometry::partOfBox(box, region);
  Part<D> part{{}, 1.0, own, {}};
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
void addPartOf(const Lattice<D>& lattice, const Geometry::Frame<D>& frame, const Vector<D>& own,
               const Geometry::Region<D>& region, const decltype(Part<D>::cell)& cell,
               std::vector<Part<D>>& parts)
{
  const auto add = [&](Part<D> part)
  {
    part.cell = cell;
    parts.push_back(part);
  };
  const Part<D> whole = partOf(lattice.edge, frame, own, region);
  if (whole.fraction == 0.0)
    return;
  if (whole.fraction == 1.0 || region.depth(frame.toSpace(whole.centroid)) >= 0.0)
    return add(whole);
  for (int k = 0; k < 1 << D; ++k)
  {
    Vector<D> at = own;
    for (int d = 0; d < D; ++d)
      at[d] += (k >> d & 1 ? 0.25 : -0.25) * lattice.edge[d];
    Part<D> part = partOf(0.5 * lattice.edge, frame, at, region);
    part.fraction /= 1 << D;
    if (part.fraction > tiny)
      add(part);
  }
}

/// A body, as the cells of its lattice meet it.
template <int D>
struct Filling
{
  const Geometry::Frame<D>& frame;
  const Geometry::Region<D>& region;
  const SeedRules<D>& rules;
  bool isBox;                 ///< along the lattice
  Geometry::Bounds<D> bounds; ///< of the base shape, along the lattice
};

/// The part of a cell of a lattice that is in a box along the lattice.
template <int D>
struct CellInBox
{
  Vector<D> middle;      ///< own coordinates [m]
  Vector<D> edge;        ///< [m]
  double fraction = 1.0; ///< of the cell; 0: none

  CellInBox(const Vector<D>& own, const Vector<D>& whole, const Geometry::Bounds<D>& box)
      : middle(own), edge(whole)
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
Geometry::Coverage coverageOf(const Filling<D>& body, const Geometry::OrientedBox<D>& box)
{
  Geometry::BoxPoints<D> points;
  points.centre = box.centre;
  points.reach = 0.5 * norm(box.edge);
  for (int k = 0; k < 1 << D; ++k)
  {
    points.corners[k] = box.centre;
    for (int d = 0; d < D; ++d)
      points.corners[k] = points.corners[k] + ((k >> d & 1) != 0 ? 0.5 : -0.5) * box.edge[d] * box.axes[d];
  }
  return body.isBox ? Geometry::Coverage::Whole : body.region.coverage(points);
}

/// Adds the parts of a lattice cell about `own`: one on each side of the surfaces that divide it.
template <int D>
void addParts(const Lattice<D>& lattice, const Filling<D>& body, const Geometry::BoxCuts<D>& cuts,
              const Vector<D>& own, const decltype(Part<D>::cell)& cell, std::vector<Part<D>>& parts)
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
    const Geometry::OrientedBox<D> box{body.frame.toSpace(middle), filled.edge, body.frame.axes};
    const bool whole = coverageOf(body, box) == Geometry::Coverage::Whole;
    for (int sides = 0; sides < 1 << cuts.through.size(); ++sides)
      addPartOf(filled, body.frame, middle, Geometry::onSides(body.region, whole, cuts.through, sides), cell,
                parts);
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

/// Parts of lattices that are finer by a level each.
template <int D>
using PartsOfLevels = std::vector<std::vector<Part<D>>>;

/// Divides the cells of a lattice where `isDivided` says so, and adds their parts.
template <int D>
class Division
{
public:
  Division(const Lattice<D>& lattice, const Filling<D>& body) : body_(body), lattices_{lattice} {}

  void add(const Vector<D>& own, const decltype(Part<D>::cell)& cell) { add(own, cell, 0, 0, -1); }

  PartsOfLevels<D> parts{{}};

private:
  void add(const Vector<D>& own, const decltype(Part<D>::cell)& cell, int level, int lineage, int family)
  {
    const Vector<D> edge = lattices_[level].edge;
    const Geometry::OrientedBox<D> box{body_.frame.toSpace(own), edge, body_.frame.axes};
    Geometry::BoxCuts<D> cuts;
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
    std::vector<Part<D>>& these = parts[level];
    const std::size_t before = these.size();
    addParts(lattices_[level], body_, cuts, own, cell, these);
    for (std::size_t k = before; k < these.size(); ++k)
    {
      these[k].least = cuts.through.empty() ? body_.rules.joinedBelow : body_.rules.cuts.joinedBelow;
      these[k].lineage = lineage;
      these[k].family = these[k].fraction == 1.0 ? family : -1;
    }
  }

  bool isFull(const Vector<D>& own, const Vector<D>& edge) const
  {
    return partOf(edge, body_.frame, own, body_.region).fraction == 1.0;
  }

  void divide(const Vector<D>& own, const decltype(Part<D>::cell)& cell, int level, int lineage, int family)
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

template <int D>
PartsOfLevels<D> partsOf(const Lattice<D>& lattice, const Filling<D>& body)
{
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
        division.add(positionOf(lattice, middle), cell);
      }
  for (std::size_t level = 1; level < division.parts.size(); ++level)
    Geometry::sortByCell<D>(division.parts[level]);
  return std::move(division.parts);
}

/// Joins the parts that are too small and have no neighbour of their size with the nearest part of another
/// level that is no farther away than a cell of the larger of the two.
template <int D>
void joinOverLevels(PartsOfLevels<D>& parts, const Vector<D>& edge, const Geometry::IsSeen<D>& isSeen)
{
  constexpr std::size_t most = 1000; // more are those of thin walls, which stay alone
  std::size_t slivers = 0;
  const auto isSliver = [](const Part<D>& part) { return !part.stands(); };
  for (const std::vector<Part<D>>& these : parts)
    slivers += std::count_if(these.begin(), these.end(), isSliver);
  if (parts.size() < 2 || slivers > most)
    return;
  for (std::size_t level = 0; level < parts.size(); ++level)
  {
    const auto hosted = [&](Part<D> part)
    {
      Part<D>* host = nullptr;
      std::size_t hostLevel = 0;
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t other = 0; other < parts.size() && isSliver(part); ++other)
        for (Part<D>& candidate : parts[other])
        {
          const double distance = norm(candidate.centroid - part.centroid);
          const double within = std::ldexp(norm(edge), -static_cast<int>(std::min(level, other)));
          if (other == level || isSliver(candidate) || distance >= std::min(nearest, within) ||
              !isSeen(part.centroid, candidate.centroid))
            continue;
          host = &candidate;
          hostLevel = other;
          nearest = distance;
        }
      if (host == nullptr)
        return false;
      part.fraction = std::ldexp(part.fraction, D * (static_cast<int>(hostLevel) - static_cast<int>(level)));
      Geometry::join(part, *host);
      return true;
    };
    parts[level].erase(std::remove_if(parts[level].begin(), parts[level].end(), hosted), parts[level].end());
  }
}

template <int D>
Seeds<D> seedsOf(const Lattice<D>& lattice, const Geometry::Frame<D>& frame, const PartsOfLevels<D>& parts)
{
  Seeds<D> seeds;
  seeds.edge = lattice.edge;
  seeds.axes = frame.axes;
  std::map<int, int> firstOf; // of each family
  Vector<D> edge = lattice.edge;
  for (std::size_t level = 0; level < parts.size(); ++level, edge = 0.5 * edge)
  {
    double whole = 1.0;
    for (int d = 0; d < D; ++d)
      whole *= edge[d];
    for (const Part<D>& part : parts[level])
    {
      Vector<D> box;
      for (int d = 0; d < D; ++d)
      {
        box[d] = std::sqrt(12.0 * part.variance[d]);
        if (std::abs(box[d] - edge[d]) < tiny * edge[d])
          box[d] = edge[d];
      }
      const int number = static_cast<int>(seeds.position.size());
      seeds.position.push_back(frame.toSpace(part.centroid));
      seeds.box.push_back(box);
      seeds.volume.push_back(part.fraction * whole);
      seeds.level.push_back(static_cast<int>(level));
      seeds.family.push_back(part.family < 0 ? number : firstOf.emplace(part.family, number).first->second);
      seeds.lineage.push_back(part.family < 0 ? 0 : part.lineage);
    }
  }
  return seeds;
}

} // namespace

template <int D>
double estimateSeeds(const Shape<D>& shape, double cell, int particlesPerCell)
{
  const Lattice<D> lattice = makeLattice(shape, cell / particlesPerCell);
  double total = 1.0;
  for (int d = 0; d < D; ++d)
    total *= lattice.count[d];
  constexpr int samples = 100000;
  if (!(total > samples))
    return total;
  // Fractions of multiples of an irrational number fill the interval evenly (Weyl); square roots of primes do
  // so in each axis without regard to the others.
  const double steps[3] = {std::sqrt(2.0), std::sqrt(3.0), std::sqrt(5.0)};
  int inside = 0;
  for (int k = 1; k <= samples; ++k)
  {
    double index[3] = {};
    for (int d = 0; d < D; ++d)
      index[d] = (k * steps[d] - std::floor(k * steps[d])) * lattice.count[d];
    inside += shape.contains(shape.base().frame.toSpace(positionOf(lattice, index))) ? 1 : 0;
  }
  return total * std::max(inside, 1) / samples;
}

template <int D>
Seeds<D> seedParticles(const Shape<D>& shape, double cell, int particlesPerCell, const std::string& section,
                       const SeedRules<D>& rules)
{
  if (!(cell > 0.0) || particlesPerCell < 1)
    throw std::invalid_argument(section +
                                ": particles need a positive cell size and at least one particle per cell.");
  const Lattice<D> lattice = makeLattice(shape, cell / particlesPerCell, rules.node);
  refuseMany(lattice, section);
  const Geometry::Frame<D>& frame = shape.base().frame;
  const Geometry::Region<D> region{[&](const Vector<D>& x) { return shape.depth(x); },
                                   [&](const Geometry::BoxPoints<D>& box) { return shape.coverage(box); }};
  const bool isBox =
      shape.parts().size() == 1 && std::holds_alternative<Geometry::Box<D>>(shape.base().primitive);
  const Filling<D> body{frame, region, rules, isBox, shape.base().ownBounds()};
  PartsOfLevels<D> parts = partsOf(lattice, body);
  const double slack = -tiny * norm(lattice.edge);
  const Geometry::IsSeen<D> isSeen = [&](const Vector<D>& a, const Vector<D>& b)
  {
    bool seen = !rules.cuts.separate || !rules.cuts.separate(frame.toSpace(a), frame.toSpace(b));
    for (const double s : {0.25, 0.5, 0.75})
      seen = seen && shape.depth(frame.toSpace(a + s * (b - a))) >= slack;
    return seen;
  };
  for (std::size_t level = 0; level < parts.size(); ++level)
    Geometry::joinSlivers<D>(parts[level], std::ldexp(1.0, -static_cast<int>(level)) * lattice.edge, isSeen);
  joinOverLevels<D>(parts, lattice.edge, isSeen);
  bool any = false, stands = false;
  for (const std::vector<Part<D>>& these : parts)
  {
    any = any || !these.empty();
    stands =
        stands || std::any_of(these.begin(), these.end(), [](const Part<D>& part) { return part.stands(); });
  }
  if (!any)
    throw std::invalid_argument(section + ": the body contains no particle; it is fully cut away; cut less.");
  if (!stands)
  {
    std::ostringstream message;
    message << section << ": the body contains no particle; it fills less than half of one ("
            << cell / particlesPerCell << " m) anywhere; make the body larger or the cells smaller.";
    throw std::invalid_argument(message.str());
  }
  return seedsOf(lattice, frame, parts);
}

template double estimateSeeds<2>(const Shape<2>&, double, int);
template double estimateSeeds<3>(const Shape<3>&, double, int);
template Seeds<2> seedParticles<2>(const Shape<2>&, double, int, const std::string&, const SeedRules<2>&);
template Seeds<3> seedParticles<3>(const Shape<3>&, double, int, const std::string&, const SeedRules<3>&);

} // namespace Rhegma
