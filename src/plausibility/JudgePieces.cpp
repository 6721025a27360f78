#include "base/PointText.hpp"
#include "base/ShortNumber.hpp"
#include "plausibility/Judges.hpp"
#include "plausibility/SupportReach.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <vector>

namespace Rhegma
{

namespace
{

using Geometry::Bounds;

/// The particles of one body.
template <int D>
struct Grains
{
  std::vector<Vector<D>> position, box; ///< [m]
  std::vector<double> mass;             ///< [kg]
};

/// A part of a body that touches no other part of it.
template <int D>
struct Piece
{
  double mass = 0.0; ///< [kg]
  Bounds<D> bounds = Geometry::emptyBounds<D>();
  Vector<D> at{}; ///< one of its particles
};

/// Sorts the particles of a body by its pieces: those are connected whose cells in its lattice are no more
/// than a reach apart along each axis. Cells are those of particles that are not split.
template <int D>
class Pieces
{
public:
  Pieces(const Grains<D>& grains, const BodyInfo<D>& body, int reach)
      : reach_(reach), edge_(body.edge), cellOf_(grains.position.size()), pieceOf_(grains.position.size())
  {
    place(grains, body);
    fill();
    for (std::size_t p = 0; p < grains.position.size(); ++p)
    {
      pieceOf_[p] = label_[cellOf_[p]];
      Piece<D>& piece = all_[pieceOf_[p]];
      piece.mass += grains.mass[p];
      piece.at = grains.position[p];
      piece.bounds.include(grains.position[p]);
    }
  }

  const std::vector<Piece<D>>& all() const { return all_; }
  int of(std::size_t particle) const { return pieceOf_[particle]; }

private:
  static constexpr int empty = -2, unseen = -1; ///< labels of cells

  void place(const Grains<D>& grains, const BodyInfo<D>& body)
  {
    std::vector<std::array<long long, D>> cells(grains.position.size());
    std::array<long long, D> low, high;
    low.fill(std::numeric_limits<long long>::max());
    high.fill(std::numeric_limits<long long>::min());
    for (std::size_t p = 0; p < cells.size(); ++p)
      for (int d = 0; d < D; ++d)
      {
        double along = 0.0;
        for (int e = 0; e < D; ++e)
          along += body.axes[d][e] * (grains.position[p][e] - grains.position[0][e]);
        cells[p][d] = std::llround(along / edge_[d]);
        low[d] = std::min(low[d], cells[p][d]);
        high[d] = std::max(high[d], cells[p][d]);
      }
    long long count = 1;
    for (int d = 0; d < D; ++d)
    {
      count_[d] = high[d] - low[d] + 1;
      count *= count_[d];
    }
    label_.assign(count, empty);
    for (std::size_t p = 0; p < cells.size(); ++p)
    {
      long long cell = 0;
      for (int d = D - 1; d >= 0; --d)
        cell = cell * count_[d] + cells[p][d] - low[d];
      cellOf_[p] = cell;
      label_[cell] = unseen;
    }
  }

  void fill()
  {
    for (const long long first : cellOf_)
    {
      if (label_[first] != unseen)
        continue;
      label_[first] = static_cast<int>(all_.size());
      all_.emplace_back();
      std::vector<long long> pending{first};
      while (!pending.empty())
      {
        const long long from = pending.back();
        pending.pop_back();
        forEachNear(from,
                    [&](long long cell)
                    {
                      if (label_[cell] != unseen)
                        return;
                      label_[cell] = label_[first];
                      pending.push_back(cell);
                    });
      }
    }
  }

  template <class Visit>
  void forEachNear(long long cell, const Visit& visit) const
  {
    const int width = 2 * reach_ + 1;
    int cells = 1;
    for (int d = 0; d < D; ++d)
      cells *= width;
    for (int k = 0; k < cells; ++k)
    {
      long long at = 0, stride = 1, rest = cell;
      bool inside = true;
      for (int d = 0, offset = k; d < D; ++d, offset /= width)
      {
        const long long along = rest % count_[d] + offset % width - reach_;
        inside = inside && along >= 0 && along < count_[d];
        at += along * stride;
        stride *= count_[d];
        rest /= count_[d];
      }
      if (inside)
        visit(at);
    }
  }

  int reach_;                        ///< cells
  Vector<D> edge_;                   ///< of the lattice's cells [m]
  std::array<long long, D> count_{}; ///< of cells
  std::vector<long long> cellOf_;    ///< of each particle
  std::vector<int> label_;           ///< of each cell: its piece
  std::vector<int> pieceOf_;         ///< of each particle
  std::vector<Piece<D>> all_;
};

/// Whether particles of two pieces reach one node of the lattice.
template <int D>
bool haveCommonNodes(const Grid<D>& grid, const Grains<D>& grains, const Pieces<D>& pieces)
{
  std::unordered_map<int, int> owner;
  for (std::size_t p = 0; p < grains.position.size(); ++p)
  {
    int first[D], count[D], all = 1;
    for (int d = 0; d < D; ++d)
    {
      const double x = grid.inCells(grains.position[p][d], d);
      const double cells = (1.0 + 0.5 * grains.box[p][d] * grid.inverse) * (1.0 - 1e-9);
      first[d] = std::max(0, static_cast<int>(std::ceil(x - cells)));
      count[d] = std::min(grid.cells[d], static_cast<int>(std::floor(x + cells))) - first[d] + 1;
      all *= std::max(0, count[d]);
    }
    for (int k = 0; k < all; ++k)
    {
      int at[D], rest = k;
      for (int d = 0; d < D; ++d)
      {
        at[d] = first[d] + rest % count[d];
        rest /= count[d];
      }
      if (owner.emplace(grid.nodeIndex(at), pieces.of(p)).first->second != pieces.of(p))
        return true;
    }
  }
  return false;
}

/// The particles of bodies of several parts, by body.
template <int D>
std::vector<Grains<D>> grainsOf(const State<D>& state, const std::vector<char>& wanted)
{
  const auto body = onHost(state.particles.integer(fields::body));
  const auto x = onHost(state.particles.template real<D>(fields::position));
  const auto edge = onHost(state.particles.template real<D>(fields::edge));
  const auto mass = onHost(state.particles.scalar(fields::mass));
  std::vector<Grains<D>> grains(wanted.size());
  for (int p = 0; p < state.particles.size(); ++p)
  {
    if (wanted[body(p)] == 0)
      continue;
    Vector<D> at, box;
    for (int d = 0; d < D; ++d)
    {
      at[d] = x(p, d);
      box[d] = edge(p, d);
    }
    Grains<D>& own = grains[body(p)];
    own.position.push_back(at);
    own.box.push_back(box);
    own.mass.push_back(mass(p));
  }
  return grains;
}

/// Whether no support reaches a piece.
template <int D>
bool isUnsupported(const std::vector<BoundaryRegion>& supports, const Piece<D>& piece, double cell)
{
  return std::none_of(supports.begin(), supports.end(),
                      [&](const BoundaryRegion& support) { return reaches(support, piece.bounds, cell); });
}

} // namespace

template <int D>
Messages judgePieces(const JudgedScene<D>& judged)
{
  Messages messages;
  const Teuchos::ParameterList& section = judged.scene.sublist("Bodies");
  std::vector<char> wanted;
  for (const BodyMeasure<D>& body : judged.bodies)
  {
    const Teuchos::ParameterList& list = section.sublist(body.name);
    wanted.push_back(list.isSublist("Operations") && list.sublist("Operations").numParams() > 0 ? 1 : 0);
  }
  if (std::count(wanted.begin(), wanted.end(), 1) == 0)
    return messages;
  std::vector<BoundaryRegion> supports = boundaryRegions(judged.scene);
  supports.erase(std::remove_if(supports.begin(), supports.end(),
                                [](const BoundaryRegion& region) {
                                  return region.kind == BoundaryRegion::Kind::Force ||
                                         region.kind == BoundaryRegion::Kind::Unknown;
                                }),
                 supports.end());
  const std::vector<Grains<D>> grains = grainsOf(judged.state, wanted);
  const double cell = judged.state.mesh.grid.spacing;
  for (std::size_t b = 0; b < grains.size(); ++b)
  {
    if (grains[b].position.empty())
      continue;
    // Most are one piece by cells that touch; a particle that has joined another reaches over one cell more.
    const BodyInfo<D>& body = judged.state.bodies.info[b];
    if (Pieces<D>(grains[b], body, 1).all().size() < 2)
      continue;
    const Pieces<D> pieces(grains[b], body, 2);
    if (pieces.all().size() < 2)
      continue;
    const auto smallest = std::min_element(pieces.all().begin(), pieces.all().end(),
                                           [](const auto& a, const auto& c) { return a.mass < c.mass; });
    const bool unsupported =
        std::any_of(pieces.all().begin(), pieces.all().end(),
                    [&](const Piece<D>& piece) { return isUnsupported(supports, piece, cell); });
    const bool near = haveCommonNodes(judged.state.mesh.grid, grains[b], pieces);
    if (!unsupported && !near)
      continue;
    messages.push_back(
        "Bodies > " + judged.bodies[b].name + " > Operations: they leave " +
        std::to_string(pieces.all().size()) + " pieces that do not touch, the smallest of " +
        formatShort(smallest->mass) + " kg of " + formatShort(judged.bodies[b].mass) + " kg, such as at " +
        formatPoint(smallest->at) +
        (near ? "; pieces less than two cells apart move as one"
              : "; no support holds one of them, so it moves on its own") +
        ": check positions and sizes of the operations (metres), or write a body for each piece");
  }
  return messages;
}

template Messages judgePieces(const JudgedScene<2>&);
template Messages judgePieces(const JudgedScene<3>&);

} // namespace Rhegma
