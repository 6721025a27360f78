#pragma once
/// The front of a crack in 3D as lines, and positions with respect to it.

#include "state/CrackSet.hpp"

#include <vector>

namespace Rhegma::energy_release
{

/// A piece of front between two front nodes.
struct FrontPiece
{
  int from, to;      ///< front nodes
  bool begins, ends; ///< whether its line does so with it, at the surface of the body
  double length;     ///< [m]
};

/// The front nodes of a front as lines: one, closed or not, or several where the surface of the body divides
/// it.
struct FrontLine
{
  std::vector<FrontNode<3>> nodes;
  std::vector<double> arc;  ///< of each front node: length of its line up to there [m]
  std::vector<int> line;    ///< of each front node
  std::vector<double> loop; ///< of each line: its length if it is closed, else 0 [m]
  std::vector<double> open; ///< of each line: its length if it is open, else 0 [m]
  std::vector<FrontPiece> pieces;
  double length = 0.0; ///< of all lines [m]

  bool empty() const { return pieces.empty(); }
};

FrontLine lineOf(const CrackFront<3>& front);

/// A position seen from a front.
struct FrontFoot
{
  double distance;     ///< from the front [m]
  int line;            ///< on which the front's nearest point lies
  double arc;          ///< of that point, continued beyond the ends of an open line [m]
  double inside;       ///< by how far it lies within the ends of an open line; huge on a closed one [m]
  Vector<3> direction; ///< of the front there
  Vector<3> normal;
};

/// Locates positions with respect to a front, in kernels.
struct FrontSight
{
  View<double*[3]> nodePosition, direction, normal; ///< of front nodes
  View<double*> arc, loop, open;
  View<int* [2]> ends; ///< of each line: its first and last front node
  View<int*> line;
  View<int* [4]> piece; ///< as FrontPiece
  View<double*> pieceLength;
  double beyond = 0.0; ///< how far an open line is continued straight beyond its ends [m]

  FrontSight() = default;
  FrontSight(const FrontLine& front, double extension);

  /// A position as far from two pieces that meet, inside of their corner, has its foot at the middle of the
  /// two.
  KOKKOS_INLINE_FUNCTION FrontFoot locate(const Vector<3>& x) const
  {
    const int count = static_cast<int>(piece.extent(0));
    double least = 1e300, part = 0.0;
    int found = 0;
    for (int k = 0; k < count; ++k)
    {
      double t = 0.0;
      const double square = squareTo(k, x, t);
      if (square < least)
      {
        least = square;
        part = t;
        found = k;
      }
    }
    FrontFoot foot = footOn(found, part);
    foot.distance = std::sqrt(least);
    for (int k = 0; k < count; ++k)
    {
      const bool after = piece(found, 1) == piece(k, 0), before = piece(k, 1) == piece(found, 0);
      double t = 0.0;
      if (k != found && (after || before) && squareTo(k, x, t) < least * (1.0 + asFar))
        foot = middle(foot, footOn(k, t));
    }
    const double all = open(foot.line), rest = all - foot.arc;
    foot.inside = all > 0.0 ? (rest < foot.arc ? rest : foot.arc) : 1e300;
    if (all > 0.0)
      alongSurface(x, rest < foot.arc ? 1 : 0, foot);
    return foot;
  }

  /// Length of front from a position on it to a front node, the shorter of both; huge on another line [m].
  KOKKOS_INLINE_FUNCTION double apart(int onLine, double from, int frontNode) const
  {
    if (onLine != line(frontNode))
      return 1e300;
    const double one = std::fabs(from - arc(frontNode)), other = loop(onLine) - one;
    return loop(onLine) > 0.0 && other < one ? std::fabs(other) : one;
  }

private:
  static constexpr double asFar = 1e-9; ///< larger than the round-off of a square

  /// Square of the distance from a piece [m2]. \param part of the piece at the nearest point
  KOKKOS_INLINE_FUNCTION double squareTo(int k, const Vector<3>& x, double& part) const
  {
    const Vector<3> a = at(nodePosition, piece(k, 0)), along = at(nodePosition, piece(k, 1)) - a,
                    from = x - a;
    const double length = pieceLength(k), reach = beyond / length;
    const double low = piece(k, 2) != 0 ? -reach : 0.0, high = piece(k, 3) != 0 ? 1.0 + reach : 1.0;
    const double t = dot(from, along) / (length * length);
    part = t < low ? low : (t > high ? high : t);
    const Vector<3> away = from - part * along;
    return dot(away, away);
  }

  KOKKOS_INLINE_FUNCTION FrontFoot footOn(int k, double part) const
  {
    const int a = piece(k, 0), b = piece(k, 1);
    const double t = part < 0.0 ? 0.0 : (part > 1.0 ? 1.0 : part);
    FrontFoot foot{};
    foot.line = line(a);
    foot.arc = arc(a) + part * pieceLength(k);
    foot.direction = mean(direction, a, b, t);
    foot.normal = mean(normal, a, b, t);
    return foot;
  }

  /// At the surface where a line ends, the direction is that of its end; within the last piece it is
  /// interpolated between that and the direction at the nearest point. A virtual advance must not cross a
  /// surface, as the surface term of the integration by parts is left out; behind an inclined last piece it
  /// would cross the surface with the directions further inside. Where the foot lies further inside than the
  /// position from the front and the last piece is long, the surface is another one: a front that meets a
  /// surface that curves has positions behind it, by the plane through its end, along much of its length.
  KOKKOS_INLINE_FUNCTION void alongSurface(const Vector<3>& x, int last, FrontFoot& foot) const
  {
    const int end = ends(foot.line, last), inner = last != 0 ? end - 1 : end + 1;
    const Vector<3> endDirection = at(direction, end), n = at(normal, end),
                    along = at(nodePosition, inner) - at(nodePosition, end);
    const Vector<3> in = along - dot(along, endDirection) * endDirection - dot(along, n) * n;
    const double depth = dot(x - at(nodePosition, end), in) / dot(in, in);
    if (!(depth < 1.0)) // a piece along the surface-breaking end has no depth
      return;
    const double near = foot.distance + norm(along), fades = foot.inside / near - 1.0;
    const double t = std::fmin(std::fmax(std::fmax(depth, fades), 0.0), 1.0);
    const Vector<3> mean = (1.0 - t) * endDirection + t * foot.direction;
    foot.direction = (1.0 / norm(mean)) * mean;
  }

  KOKKOS_INLINE_FUNCTION FrontFoot middle(FrontFoot one, const FrontFoot& other) const
  {
    const double all = loop(one.line), half = 0.5 * (one.arc + other.arc);
    // Where a closed line begins it is not in the middle of its length.
    const bool over = all > 0.0 && std::fabs(one.arc - other.arc) > 0.5 * all;
    one.arc = over ? (half < 0.5 * all ? half + 0.5 * all : half - 0.5 * all) : half;
    const Vector<3> d = one.direction + other.direction, n = one.normal + other.normal;
    one.direction = (1.0 / norm(d)) * d;
    one.normal = (1.0 / norm(n)) * n;
    return one;
  }

  static KOKKOS_INLINE_FUNCTION Vector<3> at(const View<double* [3]>& rows, int k)
  {
    return {rows(k, 0), rows(k, 1), rows(k, 2)};
  }
  static KOKKOS_INLINE_FUNCTION Vector<3> mean(const View<double* [3]>& rows, int a, int b, double t)
  {
    const Vector<3> sum = (1.0 - t) * at(rows, a) + t * at(rows, b);
    return (1.0 / norm(sum)) * sum;
  }
};

/// Weight of a front node at a position on its front: a hat of this half width [m] along the front.
KOKKOS_INLINE_FUNCTION double hatOf(const FrontSight& sight, int line, double arc, int frontNode,
                                    double halfWidth)
{
  const double weight = 1.0 - sight.apart(line, arc, frontNode) / halfWidth;
  return weight > 0.0 ? weight : 0.0;
}

} // namespace Rhegma::energy_release
