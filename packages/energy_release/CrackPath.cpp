#include "energy_release/CrackPath.hpp"

namespace Rhegma::energy_release
{

namespace
{

/// Cosine of the turn, six degrees, from which on a crack is not straight: less is the noise of its
/// direction.
constexpr double straight = 0.9945;

} // namespace

CrackPath crackPathBehind(const State<2>& state, const CrackFront<2>& front, double radius)
{
  const CrackSet<2>& set = state.cracks;
  const Crack<2>& crack = set.cracks[front.crack];
  CrackPath path;
  if (crack.numSimplices == 0)
    return path;
  path.vertex = set.vertex;
  path.simplex = set.simplex;
  path.tip = front.position;
  path.direction = front.direction;
  path.forwards = front.vertex != crack.firstVertex;
  const auto vertex = onHost(set.vertex);
  const auto at = [&](int v) { return Vector<2>{{vertex(v, 0), vertex(v, 1)}}; };
  bool turns = false;
  int count = 0;
  double behind = 0.0; // vertices of a crack follow each other
  while (count < crack.numSimplices && behind < 1.5 * radius)
  {
    const int from = path.forwards ? front.vertex - count : front.vertex + count;
    const Vector<2> along = at(from) - at(path.forwards ? from - 1 : from + 1);
    const double length = norm(along);
    turns = turns || dot(along, front.direction) < straight * length;
    behind += length;
    ++count;
  }
  if (!turns)
    return path;
  path.count = count;
  path.first = path.forwards ? crack.firstSimplex + crack.numSimplices - count : crack.firstSimplex;
  return path;
}

} // namespace Rhegma::energy_release
