#pragma once
/// Directions along a crack in 2D that bends within the disk round its front.

#include "state/State.hpp"

namespace Rhegma::energy_release
{

/// In which direction a node's fraction of the disk is shifted: along the crack at the part of it that is
/// nearest to the node, so that no shift has a component across a face; in the front's own direction ahead of
/// it. Outside of a bend all positions in a wedge have the bend as their nearest: they go with the piece that
/// is nearer to the front, independent of round-off.
struct CrackPath
{
  View<double* [2]> vertex;
  View<int* [2]> simplex;
  int first = 0, count = 0; ///< simplices of the crack in the disk; count 0: it is straight there
  bool forwards = true;     ///< the front is at the last of them
  Vector<2> tip, direction;

  /// Squares of distances are equal if they differ by less than this fraction of the square of a piece.
  static constexpr double same = 1e-10;

  KOKKOS_INLINE_FUNCTION Vector<2> operator()(const Vector<2>& x) const
  {
    // A position whose nearest point is the front itself is shifted like the front.
    double least = 1e300;
    Vector<2> found = direction;
    for (int k = 0; k < count; ++k)
    {
      const int s = forwards ? first + count - 1 - k : first + k;
      const int from = simplex(s, forwards ? 0 : 1), to = simplex(s, forwards ? 1 : 0);
      const Vector<2> a{{vertex(from, 0), vertex(from, 1)}};
      const Vector<2> along{{vertex(to, 0) - a[0], vertex(to, 1) - a[1]}};
      const double square = dot(along, along), at = dot(x - a, along) / square;
      const Vector<2> away = x - a - (at < 0.0 ? 0.0 : (at > 1.0 ? 1.0 : at)) * along;
      const double distance = dot(away, away);
      if (distance < least - same * square)
      {
        least = distance;
        found = (1.0 / std::sqrt(square)) * along;
      }
    }
    return found;
  }
};

/// The path of the crack inside of a disk round its front.
CrackPath crackPathBehind(const State<2>& state, const CrackFront<2>& front, double radius);

} // namespace Rhegma::energy_release
