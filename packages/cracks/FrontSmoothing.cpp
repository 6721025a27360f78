#include "cracks/FrontSmoothing.hpp"

#include <algorithm>
#include <cmath>

namespace Rhegma::cracks
{

namespace
{

using namespace surface;

/// Fraction of a ripple that a step removes; largest fraction of its advance that a point passes on; smallest
/// advance that a point at rest receives [cells], so that no row of faces begins with slivers.
constexpr double smoothing = 0.25, largestGiven = 0.5, leastReceived = 0.01;
/// Smallest ratio of driving force to resistance of a point that is advanced by its neighbours alone.
constexpr double leastDriven = 0.5;

/// Half the curvature of a front at a point [1/m]: how far the point lies ahead of the middle of its
/// neighbours, along its own direction, over the product of its distances from these. The pieces may be of
/// unequal length. At a mirror the other neighbour is the image of the one; 0 at other ends.
double curvatureAt(const GrowingSurface& surface, const FrontLines<3>& lines, std::size_t k, bool mirrored)
{
  const int last = previousPoint(lines, k);
  if (last < 0 || !lines[k].joined)
  {
    if (!mirrored || (last < 0 && !lines[k].joined))
      return 0.0;
    const std::size_t only = last < 0 ? nextPoint(lines, k) : last;
    const Vector<3> from = surface.vertices[lines[k].vertex] - surface.vertices[lines[only].vertex];
    return dot(from, lines[k].direction) / dot(from, from);
  }
  const Vector<3>&a = surface.vertices[lines[last].vertex], &x = surface.vertices[lines[k].vertex],
        &b = surface.vertices[lines[nextPoint(lines, k)].vertex];
  const double u = norm(x - a), w = norm(b - x);
  const Vector<3> middle = (w / (u + w)) * a + (u / (u + w)) * b;
  return dot(x - middle, lines[k].direction) / (u * w);
}

/// Curvature flux: the area that the k-th point of a front passes to the next one; negative if it receives
/// [m2].
///
/// The flux is from the larger curvature to the smaller. This flattens ripples and leaves circles as they are
/// (as surface diffusion does; Mullins, J. Appl. Phys. 28 (1957) 333).
double curvatureFlux(const GrowingSurface& surface, const FrontLines<3>& lines, std::size_t k,
                     const std::vector<double>& curvature, const std::vector<bool>& mirrored)
{
  const std::size_t to = nextPoint(lines, k);
  const bool fromEnd = previousPoint(lines, k) < 0 && !mirrored[k],
             toEnd = !lines[to].joined && !mirrored[to];
  if (!lines[k].joined || fromEnd || toEnd)
    return 0.0;
  // The shortest of the pieces that the two curvatures are of: with a longer one, ripples of short pieces
  // would be overcorrected.
  double piece = surface.pieceAt(lines, k);
  if (const int last = previousPoint(lines, k); last >= 0)
    piece = std::min(piece, surface.pieceAt(lines, last));
  if (lines[to].joined)
    piece = std::min(piece, surface.pieceAt(lines, to));
  return 0.5 * smoothing * piece * piece * piece * (curvature[k] - curvature[to]);
}

} // namespace

void smoothAlongFront(const GrowingSurface& surface, const FrontLines<3>& lines,
                      const std::vector<FrontNode<3>>& nodes, const std::vector<double>& cells,
                      const std::vector<bool>& mirrored, std::vector<FrontNodeAdvance<3>>& advances)
{
  const std::size_t count = lines.size();
  std::vector<double> curvature(count), flux(count), gives(count, 0.0), own(count, 0.0);
  for (std::size_t k = 0; k < count; ++k)
    curvature[k] = curvatureAt(surface, lines, k, mirrored[k]);
  const auto mayReceive = [&](std::size_t from, std::size_t to)
  {
    const FrontPoint<3>& point = lines[to];
    return advances[from].length > 0.0 && !point.landed && !point.stopped &&
           (advances[to].length > 0.0 || nodes[to].driving.release >= leastDriven * advances[to].toughness);
  };
  for (std::size_t k = 0; k < count; ++k)
  {
    const std::size_t to = nextPoint(lines, k);
    flux[k] = curvatureFlux(surface, lines, k, curvature, mirrored);
    const bool forward = flux[k] > 0.0;
    if (forward ? !mayReceive(k, to) : !mayReceive(to, k))
      flux[k] = 0.0;
    gives[forward ? k : to] += std::fabs(flux[k]);
    own[k] = advances[k].length * nodes[k].tributaryLength;
  }
  std::vector<double> area = own, energy(count);
  for (std::size_t k = 0; k < count; ++k)
    energy[k] = own[k] > 0.0 ? own[k] * advances[k].toughness : 0.0;
  for (std::size_t k = 0; k < count; ++k)
  {
    if (flux[k] == 0.0)
      continue;
    const std::size_t to = nextPoint(lines, k);
    const std::size_t giver = flux[k] > 0.0 ? k : to, receiver = flux[k] > 0.0 ? to : k;
    const double most = largestGiven * own[giver], all = gives[giver];
    const double moved = std::fabs(flux[k]) * (all > most ? most / all : 1.0);
    if (own[receiver] == 0.0 && moved < leastReceived * cells[receiver] * nodes[receiver].tributaryLength)
      continue;
    area[giver] -= moved;
    area[receiver] += moved;
    energy[giver] -= moved * advances[giver].toughness;
    energy[receiver] += moved * advances[giver].toughness;
  }
  for (std::size_t k = 0; k < count; ++k)
    if (area[k] > 0.0)
    {
      advances[k].length = area[k] / nodes[k].tributaryLength;
      advances[k].toughness = energy[k] / area[k];
    }
}

} // namespace Rhegma::cracks
