#pragma once
/// Edge flips that make a triangulation Delaunay.

#include "surface/Triangulation.hpp"

#include <vector>

namespace Rhegma::surface
{

/// Lawson's flips (Math. Software III (1977) 161) in rounds, in which no triangle changes twice. The next
/// round checks only the triangles that changed and their neighbours: no other edge can have become
/// flippable.
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
  double tinyArea_, tinyCircle_; ///< tolerances for round-off [m2, m4]
  std::vector<std::array<int, 3>> beyond_;
  std::vector<int> candidates_; ///< triangles to check, in their order
  std::vector<char> changed_;   ///< in this round
};

} // namespace Rhegma::surface
