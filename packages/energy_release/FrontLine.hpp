#pragma once
/// The front of a crack in 3D as lines, and where places lie with respect to it.

#include "state/CrackSet.hpp"

#include <vector>

namespace Rhegma::energy_release
{

/// A piece of front between two stations.
struct FrontPiece
{
  int from, to;      ///< stations
  bool begins, ends; ///< whether its line does so with it, at the surface of the body
  double length;     ///< [m]
};

/// The stations of a front as lines: one, closed or not, or several where the surface of the body divides it.
struct FrontLine
{
  std::vector<FrontStation<3>> stations;
  std::vector<double> arc;  ///< of each station: length of its line up to there [m]
  std::vector<int> line;    ///< of each station
  std::vector<double> loop; ///< of each line: its length if it is closed, else 0 [m]
  std::vector<FrontPiece> pieces;
  double length = 0.0; ///< of all lines [m]

  bool empty() const { return pieces.empty(); }
};

FrontLine lineOf(const CrackFront<3>& front);

/// A place seen from a front.
struct FrontFoot
{
  double distance;     ///< from the front [m]
  int line;            ///< on which the front's nearest point lies
  double arc;          ///< of that point; beyond the ends of an open line it goes on [m]
  double inside;       ///< by how far it lies within the ends of an open line; huge on a closed one [m]
  Vector<3> direction; ///< of the front there
  Vector<3> normal;
};

/// What kernels need to look at places from a front.
struct FrontSight
{
  View<double*[3]> place, direction, normal; ///< of stations
  View<double*> arc, loop;
  View<int*> line;
  View<int* [4]> piece; ///< as FrontPiece
  View<double*> pieceLength;
  double beyond = 0.0; ///< how far an open line goes straight on beyond its ends [m]

  FrontSight() = default;
  FrontSight(const FrontLine& front, double extension);

  KOKKOS_INLINE_FUNCTION FrontFoot look(const Vector<3>& x) const
  {
    double least = 1e300, part = 0.0;
    int found = 0;
    for (int k = 0; k < static_cast<int>(piece.extent(0)); ++k)
    {
      const Vector<3> a = at(place, piece(k, 0)), along = at(place, piece(k, 1)) - a, from = x - a;
      const double length = pieceLength(k), reach = beyond / length;
      const double low = piece(k, 2) != 0 ? -reach : 0.0, high = piece(k, 3) != 0 ? 1.0 + reach : 1.0;
      double t = dot(from, along) / (length * length);
      t = t < low ? low : (t > high ? high : t);
      const Vector<3> away = from - t * along;
      const double square = dot(away, away);
      if (square < least)
      {
        least = square;
        part = t;
        found = k;
      }
    }
    const int a = piece(found, 0), b = piece(found, 1);
    const double share = part < 0.0 ? 0.0 : (part > 1.0 ? 1.0 : part);
    FrontFoot foot;
    foot.distance = std::sqrt(least);
    foot.line = line(a);
    foot.arc = arc(a) + part * pieceLength(found);
    foot.inside = 1e300;
    if (piece(found, 2) != 0)
      foot.inside = part * pieceLength(found);
    if (piece(found, 3) != 0)
    {
      const double rest = (1.0 - part) * pieceLength(found);
      foot.inside = rest < foot.inside ? rest : foot.inside;
    }
    foot.direction = mean(direction, a, b, share);
    foot.normal = mean(normal, a, b, share);
    return foot;
  }

  /// Length of front from a place on it to a station, the shorter way; huge on another line [m].
  KOKKOS_INLINE_FUNCTION double apart(int onLine, double from, int station) const
  {
    if (onLine != line(station))
      return 1e300;
    const double one = std::fabs(from - arc(station)), other = loop(onLine) - one;
    return loop(onLine) > 0.0 && other < one ? std::fabs(other) : one;
  }

private:
  static KOKKOS_INLINE_FUNCTION Vector<3> at(const View<double* [3]>& rows, int k)
  {
    return {rows(k, 0), rows(k, 1), rows(k, 2)};
  }
  static KOKKOS_INLINE_FUNCTION Vector<3> mean(const View<double* [3]>& rows, int a, int b, double share)
  {
    const Vector<3> sum = (1.0 - share) * at(rows, a) + share * at(rows, b);
    return (1.0 / norm(sum)) * sum;
  }
};

/// Weight of a station at a place on its front: a hat of this half width [m] along the front.
KOKKOS_INLINE_FUNCTION double hatOf(const FrontSight& sight, int line, double arc, int station,
                                    double halfWidth)
{
  const double weight = 1.0 - sight.apart(line, arc, station) / halfWidth;
  return weight > 0.0 ? weight : 0.0;
}

} // namespace Rhegma::energy_release
