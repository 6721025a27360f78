#pragma once
/// Crack surfaces that become larger.

#include "boundary/MirrorPlanes.hpp"
#include "cracks/GrowingSurface.hpp"
#include "state/State.hpp"

#include <utility>
#include <vector>

namespace Rhegma
{
class Archive;
}

namespace Rhegma::cracks
{

/// Makes the advances that were asked of the front nodes of 3D fronts (CrackSet::advances).
///
/// A front node moves on by its own length in its own direction: the triangles behind it stretch until a row
/// of them is as high as a cell, then a new row begins. Pieces of front longer than 1.5 cells are split,
/// those shorter than half a cell taken away. Ripples of the front are smoothed by giving of what a front
/// node is to advance to its neighbours, at a plane of symmetry to its mirror image too; no front node goes
/// back for that. Whatever happens to the front, the area that the crack gains times the toughness is what
/// CrackFront::budget requires, to the last digit.
///
/// A front node that comes within half a cell of the surface of its body runs on to it and stays there;
/// pieces between two such front nodes become mouths. An end of a front that lies on the surface slides along
/// it. A front node that would come closer than three cells to another crack, or to faces of its own that lie
/// ahead, halts. Belongs between steps.
class SurfaceGrowth
{
public:
  SurfaceGrowth() = default;
  explicit SurfaceGrowth(std::vector<MirrorPlane> mirrors) : mirrors_(std::move(mirrors)) {}

  void grow(State<3>& state);

  /// Energy per area of the last face that each front node of a front made; where one has made none, that of
  /// the nearest front node that has. Without front nodes, as of a front that has ended, one number: that of
  /// the last faces of the front. Zero where nothing has grown [J/m2].
  std::vector<double> toughnessAlong(const CrackSet<3>& set, int front) const;

  /// Saves or loads the surfaces, their fronts and what they have done.
  void keep(State<3>& state, Archive& archive);

private:
  struct Mark
  {
    double toughness = 0.0;
    bool landed = false;
  };
  struct Crack
  {
    GrowingSurface surface;
    std::vector<FrontLines> fronts; ///< in the order of the set's
    std::vector<int> numbers;       ///< of these fronts in the set
    FrontLines ends;                ///< of each front the vertex where it is, or was when it ended
  };

  std::vector<Crack> read(const CrackSet<3>& set);
  void write(CrackSet<3>& set, std::vector<Crack>& cracks, double spacing);
  void growFront(State<3>& state, std::vector<Crack>& cracks, const FrontAdvance<3>& advance);

  std::vector<MirrorPlane> mirrors_;
  std::vector<std::vector<Mark>> marks_; ///< of the front nodes of each front
  std::vector<double> lastToughness_;    ///< of each front, of what it made last [J/m2]
  std::vector<bool> told_,
      toldStopped_; ///< fronts of which it was said that they reached the surface; stopped
};

} // namespace Rhegma::cracks
