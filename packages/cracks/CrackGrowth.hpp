#pragma once
/// Cracks that grow.

#include "boundary/MirrorPlanes.hpp"
#include "cracks/Encounter.hpp"
#include "cracks/GrowingCrack.hpp"
#include "cracks/Junctions.hpp"

#include <string>
#include <utility>
#include <vector>

namespace Rhegma
{
class Archive;
}

namespace Rhegma::cracks
{

/// Makes the advances of fronts (CrackSet::advances) between steps. A front is a chain of front nodes, in 2D
/// one.
///
/// Each front node moves by its own length in its own direction. In 2D that adds a segment to its crack. In
/// 3D the triangles behind it stretch until a row of them is as high as a cell, then a new row begins; pieces
/// of front longer than 1.5 cells are split, those shorter than half a cell removed; ripples of the front are
/// smoothed by moving a part of the advance of a front node to its neighbours, at a plane of symmetry also to
/// its mirror image, and no node moves back. New faces start closed. Whatever happens to the front, the area
/// that the crack gains times the toughness is the energy that its new faces require, to rounding.
///
/// A front node that comes within half a cell of the surface of its body advances to it and stays there;
/// pieces between two such nodes are surface-breaking. An end of a 3D front that lies on the surface slides
/// along it. A front without remaining nodes has ended. Encounters with other faces: Encounter.hpp. Each of
/// these is kept in the front (CrackFront::stop, arrival), and the first reported in the warnings of the run.
///
/// Particles ahead of a front that turns get a new side of the crack.
template <int D>
class CrackGrowth
{
public:
  CrackGrowth() = default;
  explicit CrackGrowth(std::vector<MirrorPlane> mirrors) : mirrors_(std::move(mirrors)) {}

  /// Makes the advances and empties the list of them. \return the cracks that have ended on others
  std::vector<Meeting> grow(State<D>& state);

  /// Energy per area of the last face that each node of a front made; where one has made none, that of the
  /// nearest node that has. Of a front that has ended one number: that of the last faces of the front. Zero
  /// where nothing has grown [J/m2].
  std::vector<double> toughnessAlong(const CrackSet<D>& set, int front) const;

  /// Saves or loads the history of the fronts, after the cracks themselves (CrackMemory.hpp).
  void serialize(const CrackSet<D>& set, Archive& archive);

private:
  /// A front that advances.
  struct Advancing
  {
    int number; ///< in the set
    CrackFront<D>& front;
    GrowingCrack<D>& crack;
    surface::FrontLines<D>& lines;
    surface::FrontPoint<D>& end;               ///< where it is, or was when it ended
    std::vector<FrontNodeAdvance<D>> advances; ///< of each node, smoothed along the front
    std::vector<double> cells;                 ///< size at each node [m]
    std::vector<bool> lands;                   ///< of each node: it reaches the surface, whatever is ahead
    double energy = 0.0, area = 0.0;           ///< of its new faces [J, m2; m in 2D]
    double swept = 0.0; ///< area by the thickness in 2D: a length, of rings times their radius
    int landed = -1;    ///< the last node that reached a surface or another crack
  };

  /// Whether a plane of symmetry goes through a position, in cells of this size [m].
  bool isMirrored(const Vector<D>& x, double cell) const;
  bool prepare(const State<D>& state, Advancing& f, double& longest) const;
  std::vector<AdvancingNode<D>> findPaths(const State<D>& state, const Advancing& f,
                                          const FrontAdvance<D>& advance) const;
  /// A piece of front by its nodes, of which the inner one is further from the end.
  struct Piece
  {
    std::size_t outer, inner;
    bool forward; ///< the inner node comes after the outer one
  };
  void landOvertaken(const State<D>& state, Advancing& f) const;
  std::vector<Piece> landPieces(const State<D>& state, Advancing& f, const std::vector<Piece>& pieces) const;
  void land(Advancing& f, std::size_t node, double length) const;
  void keepOnSurface(const State<D>& state, const Advancing& f, std::vector<AdvancingNode<D>>& nodes) const;
  bool advanceNode(State<D>& state, std::vector<GrowingCrack<D>>& cracks, Advancing& f,
                   const AdvancingNode<D>& node, std::vector<Meeting>& meetings);
  void endMet(State<D>& state, std::vector<GrowingCrack<D>>& cracks, const Advancing& f, int met);
  void evenPieces(Advancing& f);
  void growFront(State<D>& state, std::vector<GrowingCrack<D>>& cracks, const FrontAdvance<D>& advance,
                 std::vector<Meeting>& meetings);
  void recordArrival(State<D>& state, int front, const std::string& what, const Vector<D>& position);

  std::vector<MirrorPlane> mirrors_;
  FaceToughness toughness_;
  std::vector<double> lastToughness_; ///< of each front, of what it made last [J/m2]
};

} // namespace Rhegma::cracks
