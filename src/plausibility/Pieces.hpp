#pragma once
/// Parts of a body that do not touch each other, by its particles.

#include "geometry/Frame.hpp"
#include "plan/BoundaryType.hpp"
#include "plausibility/CrackWalls.hpp"
#include "state/State.hpp"

#include <array>
#include <set>
#include <vector>

namespace Rhegma
{

/// The particles of one body.
template <int D>
struct Grains
{
  std::vector<Vector<D>> position, box; ///< [m]
  std::vector<double> mass;             ///< [kg]
};

/// The particles of some bodies, by body. \param wanted of each body
template <int D>
std::vector<Grains<D>> grainsOf(const State<D>& state, const std::vector<char>& wanted);

/// A part of a body that touches no other part of it.
template <int D>
struct Piece
{
  double mass = 0.0; ///< [kg]
  Geometry::Bounds<D> bounds = Geometry::emptyBounds<D>();
  Vector<D> at{}; ///< one of its particles
};

/// Sorts the particles of a body by its pieces: those are connected whose cells in its lattice are no more
/// than a reach apart along each axis, unless a crack lies between them. Cells are those of particles that
/// are not split.
template <int D>
class Pieces
{
public:
  /// \param grains one or more \param reach [cells] \param walls none: cracks divide nothing
  Pieces(const Grains<D>& grains, const BodyInfo<D>& body, int reach, const CrackWalls<D>* walls = nullptr);

  /// Whether there were more pairs of particles near cracks than are looked at, as where cells much smaller
  /// than those of the body are refined along them: then there is no piece.
  bool gaveUp() const { return all_.empty(); }

  /// Indices of the cracks that lie between particles of different pieces.
  std::set<int> cutters() const;

  const std::vector<Piece<D>>& all() const { return all_; }
  int of(std::size_t particle) const { return group_[groupOf_[particle]].piece; }

  /// The lightest.
  const Piece<D>& smallest() const;

private:
  /// Particles of a cell: one that is near a crack, or all others.
  struct Group
  {
    int particle, piece, next; ///< that near a crack, or -1; next group of the cell, or -1
    long long cell;
  };
  /// A crack between two groups.
  struct Wall
  {
    int one, other, crack;
  };

  void place(const Grains<D>& grains, const BodyInfo<D>& body, const CrackWalls<D>* walls);
  void addToCell(long long cell, int particle);
  double pairs() const;
  void fill(const Grains<D>& grains, const CrackWalls<D>* walls);
  template <class Visit>
  void forEachNear(long long cell, const Visit& visit) const;

  int reach_;                        ///< cells
  Vector<D> edge_;                   ///< of the lattice's cells [m]
  std::array<long long, D> count_{}; ///< of cells
  std::vector<int> first_;           ///< group of each cell, or -1
  std::vector<Group> group_;
  std::vector<int> groupOf_; ///< of each particle
  std::vector<Wall> walls_;
  std::vector<Piece<D>> all_;
};

/// The regions of a scene in which motion is prescribed, planes of symmetry among them.
std::vector<BoundaryRegion> supportRegions(const Teuchos::ParameterList& scene);

/// Whether no support reaches one of the pieces. \param cell [m]
template <int D>
bool anyUnsupported(const std::vector<BoundaryRegion>& supports, const std::vector<Piece<D>>& pieces,
                    double cell);

} // namespace Rhegma
