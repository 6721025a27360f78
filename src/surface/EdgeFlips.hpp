#pragma once
/// Edges of a triangulation that are flipped until it is Delaunay's.

#include "surface/Triangulation.hpp"

#include <vector>

namespace Rhegma::surface
{

/// Lawson's flips (Math. Software III (1977) 161) in rounds, in which no triangle changes twice. What a round
/// has changed, and what is next to it, is all that the next one looks at: nothing else can have become worth
/// a flip.
class EdgeFlips
{
public:
  /// \param mesh whose triangles change, its points do not \param spacing length of edges, about [m]
  EdgeFlips(Triangulation& mesh, double spacing);

  /// One round. \return whether any edge was flipped
  bool round();

private:
  bool isWorthIt(int a, int b, int c, int d) const;
  void flip(int t, int i, int u);
  void putBeyond(int t, int old, int now);

  Triangulation& mesh_;
  double tinyArea_, tinyCircle_; ///< below which a number is round-off [m2, m4]
  std::vector<std::array<int, 3>> beyond_;
  std::vector<int> candidates_; ///< triangles to look at, in their order
  std::vector<char> changed_;   ///< in this round
};

} // namespace Rhegma::surface
