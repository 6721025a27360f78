#include "energy_release/CrackWay.hpp"

namespace Rhegma::energy_release
{

namespace
{

/// Cosine of the turn, six degrees, from which on a crack is not straight: less is the noise of its
/// direction.
constexpr double straight = 0.9945;

} // namespace

CrackWay wayOf(const State<2>& state, const CrackFront<2>& front, double radius)
{
  const CrackSet<2>& set = state.cracks;
  const Crack<2>& crack = set.cracks[front.crack];
  CrackWay way;
  if (crack.numSimplices == 0)
    return way;
  way.vertex = set.vertex;
  way.simplex = set.simplex;
  way.tip = front.position;
  way.direction = front.direction;
  way.forwards = front.vertex != crack.firstVertex;
  const auto vertex = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, set.vertex);
  const auto at = [&](int v) { return Vector<2>{{vertex(v, 0), vertex(v, 1)}}; };
  bool turns = false;
  int count = 0;
  double behind = 0.0; // vertices of a crack follow each other
  while (count < crack.numSimplices && behind < 1.5 * radius)
  {
    const int from = way.forwards ? front.vertex - count : front.vertex + count;
    const Vector<2> along = at(from) - at(way.forwards ? from - 1 : from + 1);
    const double length = norm(along);
    turns = turns || dot(along, front.direction) < straight * length;
    behind += length;
    ++count;
  }
  if (!turns)
    return way;
  way.count = count;
  way.first = way.forwards ? crack.firstSimplex + crack.numSimplices - count : crack.firstSimplex;
  return way;
}

} // namespace Rhegma::energy_release
