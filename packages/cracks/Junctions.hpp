#pragma once
/// Where a crack ends on the face of another.

#include "cracks/Sides.hpp"
#include "transfer/BlocksInReach.hpp"

#include <vector>

namespace Rhegma
{
class Archive;
}

namespace Rhegma::cracks
{

/// Particles: the side of a second crack near which they are, as fields::side, or 0. Only where cracks may
/// join.
constexpr const char* otherSide = "side_of_other_crack";

/// A crack that has ended on another (2D).
struct Meeting
{
  int crack;    ///< that ended
  bool first;   ///< at its first end
  int other;    ///< crack
  bool atFront; ///< at a front of that, not at its face
};

/// The T junctions of a 2D scene: a crack that has ended on the face of another which goes through. Three
/// pieces of material meet there, and nodes have but two fields. So within two cells of a junction
///
///   - nodes on the side on which the crack ends belong to that crack: their fields are of the two pieces
/// next to
///     it. Particles of the third piece, across the crack that goes through, do not see them;
///   - nodes of the third piece are not seen by particles of the other two.
///
/// The weights of nodes that a particle no longer sees are distributed to the other nodes, in proportion to
/// their shape functions (Shepard): they sum to one, and their slopes to zero, but are not linearly complete
/// there, as in broken cells (Visibility.hpp). Particles next to both cracks know a side of each
/// (`otherSide`).
class Junctions
{
public:
  /// Whether there are any.
  bool empty() const { return all_.empty(); }

  /// Adds one, or joins two cracks, once they are laid out.
  void add(State<2>& state, const Meeting& meeting)
  {
    if (meeting.atFront)
      join(state, meeting.crack, meeting.first, meeting.other);
    else
      add(state, meeting.crack, meeting.first, meeting.other);
  }

  /// Adds one where a front has ended on another crack, once that is laid out: particles next to the last six
  /// cells of the one that ended, on its side of the other, get their side of it. \param ended the crack that
  /// ended \param first whether at its first end \param through the other crack
  void add(State<2>& state, int ended, bool first, int through);

  /// Joins two cracks whose fronts have met, once they are laid out: particles next to one of them near the
  /// other get their side of that. There are two pieces of material, and nodes need no change. \param one a
  /// crack \param first whether it ends at its first end \param two the other
  static void join(State<2>& state, int one, bool first, int two);

  /// Assigns nodes near junctions to the cracks that split them: after the nearest cracks of nodes have been
  /// found, before their sides are.
  void claimNodes(const State<2>& state, const Surroundings& surroundings);

  /// Marks the particles near junctions, whose stencils are to be edited.
  void markParticles(const State<2>& state, const View<int*>& row);

  /// Hides nodes from points, before nodes are replaced by their enriched fields.
  void hideNodes(const State<2>& state, const ObservedPoints<2>& points, const StencilTable<2>& table) const;

  /// Saves or loads them.
  void serialize(Archive& archive);

private:
  struct Junction
  {
    int ended, through;
    bool first;
    int side; ///< of the crack that goes through on which the other ends: 1 or -1
    // In this step:
    Vector<2> position{};
    int endSimplex = 0, throughSimplex = 0;
    double radius = 0.0;       ///< [m]
    BlocksInReach<2> blocks{}; ///< around it
  };
  static void locate(const State<2>& state, Junction& junction);

  std::vector<Junction> all_;
};

} // namespace Rhegma::cracks
