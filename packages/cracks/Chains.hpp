#pragma once
/// Cracks of a 2D scene as chains of vertices, in host memory.

#include "state/State.hpp"

#include <vector>

namespace Rhegma::cracks
{

/// A vertex on the crack and its places on both faces.
struct Link
{
  Vector<2> vertex, face[2];
};

/// A crack from its first end to its last.
struct Chain
{
  std::vector<Link> links;
  bool front[2] = {false, false};  ///< whether its first and its last end are fronts
  bool joined[2] = {false, false}; ///< whether they have ended on another crack
};

/// A vertex where both faces touch.
inline Link closedLink(const Vector<2>& x) { return {x, {x, x}}; }

/// The chains of all cracks.
std::vector<Chain> readChains(const CrackSet<2>& set);

/// Lays the cracks out anew.
void writeChains(CrackSet<2>& set, const std::vector<Chain>& chains, double spacing);

/// Whether a front lies at the first end of its crack.
bool atFirstEnd(const CrackSet<2>& set, const CrackFront<2>& front);

} // namespace Rhegma::cracks
